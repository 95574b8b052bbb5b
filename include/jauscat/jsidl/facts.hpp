// Service definitions as a table of facts: one line for each element, with its name, type, unit and limits.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/result.hpp>
#include <jauscat/jsidl/error.hpp>
#include <jauscat/jsidl/service.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::jsidl {
inline namespace JAUSCAT_WAY {

/// The table of the services, which `parse_facts` reads. Each line is a part of the last line with one space less
/// before it:
///
///     service Events urn:jaus:jss:core:Events 1.1
///      inherits transport urn:jaus:jss:core:Transport 1.1
///      input CancelEvent 01F2 command
///       record CancelEventRec
///        number RequestID type=u8 unit=one
[[nodiscard]] JAUSCAT_DECL std::string write_facts(std::span<const service> services);

/// The services of a table. Lines that are empty or begin with # are comments. `source` is the file's name in messages.
[[nodiscard]] JAUSCAT_DECL result<std::vector<service>, error> parse_facts(std::string_view text, std::string source);

/// `parse_facts` for a file.
[[nodiscard]] JAUSCAT_DECL result<std::vector<service>, error> read_facts(const std::filesystem::path& path);

} // namespace JAUSCAT_WAY
} // namespace jauscat::jsidl

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jsidl/impl/facts.ipp>
#endif
