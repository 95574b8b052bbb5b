// Checks service definitions: what a file can say but no peer could send, and what no schema can express.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/jsidl/error.hpp>
#include <jauscat/jsidl/service.hpp>

#include <span>
#include <string>
#include <string_view>

namespace jauscat::jsidl {
inline namespace JAUSCAT_WAY {

/// The largest number of an unsigned type; of a signed or floating-point one, that of the unsigned type of its size.
[[nodiscard]] JAUSCAT_DECL std::uint64_t most_of(scalar type) noexcept;

/// The last but one part of a service's URI, as an identifier: `core` of urn:jaus:jss:core:Events. Empty if the URI has
/// no such part.
[[nodiscard]] JAUSCAT_DECL std::string set_of(std::string_view service_id);

/// Throws `jsidl_error` for what the definitions cannot mean, and for what no schema says.
JAUSCAT_DECL void check_services(std::span<const service> services);

} // namespace JAUSCAT_WAY
} // namespace jauscat::jsidl

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jsidl/impl/check.ipp>
#endif
