// Reads an ESI file: one device, its objects resolved through the file's data types.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/esi/device.hpp>
#include <jauscat/esi/error.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace jauscat::esi {
inline namespace JAUSCAT_WAY {

/// Which device of a file with several. A part that is not given is not compared.
struct device_choice {
    std::optional<std::uint32_t> product{};
    std::optional<std::uint32_t> revision{};
};

/// Reads an ESI document from text; `source` is the file's name in messages. Without a choice the document has one
/// device; a choice fits one of its devices.
[[nodiscard]] JAUSCAT_DECL result<device, error> parse_esi(std::string_view text, std::string source,
                                                           const device_choice& choice = {});

/// Reads an ESI file.
[[nodiscard]] JAUSCAT_DECL result<device, error> read_esi(const std::filesystem::path& path,
                                                          const device_choice& choice = {});

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/esi/impl/read_esi.ipp>
#endif
