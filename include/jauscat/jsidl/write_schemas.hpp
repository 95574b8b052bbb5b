// Writes service definitions as schema headers.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/result.hpp>
#include <jauscat/jsidl/error.hpp>
#include <jauscat/jsidl/service.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>

namespace jauscat::jsidl {
inline namespace JAUSCAT_WAY {

struct schema_options {
    std::string name_space{"jauscat::sae"};           ///< of the headers; each set has a namespace in it
    std::string include_prefix{"jauscat/schema/sae"}; ///< folder of the headers, for programs that include them
    std::optional<std::size_t> capacity{}; ///< of lists inside the messages; none: lists in memory of the caller
    /// Capacities of single lists, by `Message.List` or `List`. A capacity of 0 is memory of the caller.
    std::map<std::string, std::size_t> capacities{};
};

/// Headers by their path below `include_prefix`: one for each service, such as core/events.hpp; core/shared.hpp with
/// what several services of a set have; core.hpp with the list of the set's messages; ranges.hpp. The same services
/// make the same texts, whatever their order.
using schema_headers = std::map<std::string, std::string>;

/// `services` are as `read_jsidl` or `read_facts` returns them. Errors: names that cannot be told apart, a capacity for
/// a list that does not exist.
[[nodiscard]] JAUSCAT_DECL result<schema_headers, error> write_schemas(std::span<const service> services,
                                                                       const schema_options& options = {});

} // namespace JAUSCAT_WAY
} // namespace jauscat::jsidl

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jsidl/impl/write_schemas.ipp>
#endif
