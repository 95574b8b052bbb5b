// Checks an ESI file against what the schema demands, the standard advises and the emulated device needs.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/esi/error.hpp>
#include <jauscat/esi/requirements.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::esi {
inline namespace JAUSCAT_WAY {

/// Result of one check. Of a file with several devices, `problem` is that of the first one that has it.
struct finding {
    demand by{};           ///< who requires it
    std::string what{};    ///< path of the element, or a rule for several
    std::string reason{};  ///< the source of the requirement
    std::string problem{}; ///< empty if the requirement is met; else `line n: problem`

    /// Whether the requirement is met.
    [[nodiscard]] bool met() const noexcept { return problem.empty(); }
};

/// Checks all requirements on all devices of a file; one finding each, in a fixed order. `source` is the file's name in
/// messages. Errors: not_xml, not_esi.
[[nodiscard]] JAUSCAT_DECL result<std::vector<finding>, error> check_esi_text(std::string_view text,
                                                                              const std::string& source);

/// The same for a file. Error, also: unreadable.
[[nodiscard]] JAUSCAT_DECL result<std::vector<finding>, error> check_esi(const std::filesystem::path& path);

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/esi/impl/check_esi.ipp>
#endif
