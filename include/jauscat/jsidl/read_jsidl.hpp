// Reads service definitions from JSIDL files, versions 1.0 (AS5684) and 1.1 (AS5684B). Types and constants that are
// declared elsewhere are resolved among the files that are given.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/result.hpp>
#include <jauscat/jsidl/error.hpp>
#include <jauscat/jsidl/service.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace jauscat::jsidl {
inline namespace JAUSCAT_WAY {

/// The text of a JSIDL file. `source` is its name in messages.
struct jsidl_text {
    std::string text{};
    std::string source{};
};

/// The services that the files define, ordered by URI. Files with type sets and constants define none.
///
///     const auto services = jsidl::read_jsidl({{"Sonar.xml", "SonarTypes.xml"}});
///     if (!services) return std::cerr << describe(services.error()) << '\n', 1;
[[nodiscard]] JAUSCAT_DECL result<std::vector<service>, error> read_jsidl(std::span<const std::filesystem::path> files);

/// The same for texts in memory.
[[nodiscard]] JAUSCAT_DECL result<std::vector<service>, error> parse_jsidl(std::span<const jsidl_text> texts);

} // namespace JAUSCAT_WAY
} // namespace jauscat::jsidl

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jsidl/impl/read_jsidl.ipp>
#endif
