// Checks an ESI file against what configuration tools require of it.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/esi/error.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::esi {
inline namespace JAUSCAT_WAY {

/// Result of one check.
struct finding {
    std::string what{};    ///< path of the element, or a rule for several
    std::string reason{};  ///< the source of the requirement
    std::string problem{}; ///< empty if the requirement is met; else `line n: problem`

    /// Whether the requirement is met.
    [[nodiscard]] bool met() const noexcept { return problem.empty(); }
};

/// Checks all requirements of configuration tools; one finding each, in a fixed order. `source` is the file's
/// name in messages. Errors: not_xml, not_esi.
[[nodiscard]] JAUSCAT_DECL result<std::vector<finding>, error> check_esi_text(std::string_view text,
                                                                              const std::string& source);

/// The same for a file. Error, also: unreadable.
[[nodiscard]] JAUSCAT_DECL result<std::vector<finding>, error> check_esi(const std::filesystem::path& path);

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/esi/impl/check_esi.ipp>
#endif
