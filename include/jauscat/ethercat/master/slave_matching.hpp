// Compares the slaves that were found in a ring with those that are expected.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/master/slave_identification.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace jauscat::ethercat {

/// A slave that is expected. Alias, device identification and serial number name it wherever it is; without them it is
/// the slave at its position, or, without a position, the one of its identity.
struct expected_slave {
    std::optional<std::uint16_t> position{};
    std::optional<std::uint16_t> alias{};
    std::optional<std::uint16_t> device_id{};
    identity_check identity{};
};

/// A slave that was found: `identify` gives `is`.
struct found_slave {
    std::uint16_t position{};
    slave_identity is{};
    bool is_foreign{}; ///< result of match_slaves: no expected slave
};

/// Whether an expected slave is there, and if not, why.
enum class slave_match : std::uint8_t {
    found,
    missing, ///< no slave has its name, or its position
    doubled, ///< several slaves have its name
    swapped, ///< it is at the position of another one, or another expected slave is at its position
    foreign, ///< a slave of another identity is in its place
};

/// The match in one line: what happened and what to do.
[[nodiscard]] JAUSCAT_CONSTEXPR std::string_view describe(slave_match match) noexcept;

/// An expected slave's match, and where it is.
struct matched_slave {
    slave_match match{};
    std::size_t at{}; ///< index among the slaves that were found; only if `match` is found, swapped or foreign
};

namespace detail {

/// Whether `wanted` is named by more than its position, and whether `slave` has that name.
[[nodiscard]] JAUSCAT_CONSTEXPR bool has_name(const expected_slave& wanted) noexcept;
[[nodiscard]] JAUSCAT_CONSTEXPR bool is_named(const expected_slave& wanted, const slave_identity& slave) noexcept;

[[nodiscard]] JAUSCAT_CONSTEXPR matched_slave match_named(const expected_slave& wanted,
                                                          std::span<const found_slave> found) noexcept;

[[nodiscard]] JAUSCAT_CONSTEXPR matched_slave match_placed(const expected_slave& wanted,
                                                           std::span<const expected_slave> expected,
                                                           std::span<const found_slave> found) noexcept;

} // namespace detail

/// Matches each of `expected` with one of `found`, into `matches`, which is as long as `expected`, and marks those of
/// `found` that no expected slave is. Returns whether all are found and none is foreign. Each match stands for itself:
/// those that are found can run.
[[nodiscard]] JAUSCAT_CONSTEXPR bool match_slaves(std::span<const expected_slave> expected,
                                                  std::span<found_slave> found,
                                                  std::span<matched_slave> matches) noexcept;

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/slave_matching.ipp>
#endif
