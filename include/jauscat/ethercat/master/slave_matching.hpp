// Compares the slaves that were found in a ring with those that are expected.
#pragma once

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
[[nodiscard]] constexpr std::string_view describe(slave_match match) noexcept {
    switch (match) {
    case slave_match::found: return "the slave is there";
    case slave_match::missing: return "the slave is missing: check cabling, power and its alias";
    case slave_match::doubled: return "several slaves have this alias or identification: change it in all but one";
    case slave_match::swapped: return "the slave is at another place: exchange the cables, or correct the position";
    case slave_match::foreign:
        return "another device is in the place of the slave: check vendor, product, revision, serial";
    }
    return "unknown match";
}

/// An expected slave's match, and where it is.
struct matched_slave {
    slave_match match{};
    std::size_t at{}; ///< index among the slaves that were found; only if `match` is found, swapped or foreign
};

namespace detail {

/// Whether `wanted` is named by more than its position, and whether `slave` has that name.
[[nodiscard]] constexpr bool has_name(const expected_slave& wanted) noexcept {
    return wanted.alias || wanted.device_id || wanted.identity.serial || !wanted.position;
}
[[nodiscard]] constexpr bool is_named(const expected_slave& wanted, const slave_identity& slave) noexcept {
    if (wanted.alias && *wanted.alias != slave.alias) return false;
    if (wanted.device_id && wanted.device_id != slave.device_id) return false;
    // A serial number is one only together with the device.
    return wanted.alias || wanted.device_id || wanted.identity.accepts(slave.identity);
}

[[nodiscard]] constexpr matched_slave match_named(const expected_slave& wanted,
                                                  std::span<const found_slave> found) noexcept {
    std::size_t count = 0, at = 0;
    for (std::size_t i = 0; i != found.size(); ++i) {
        if (!is_named(wanted, found[i].is)) continue;
        ++count;
        at = i;
    }
    if (count != 1) return {.match = count == 0 ? slave_match::missing : slave_match::doubled};
    if (!wanted.identity.accepts(found[at].is.identity)) return {.match = slave_match::foreign, .at = at};
    const bool is_elsewhere = wanted.position && *wanted.position != found[at].position;
    return {.match = is_elsewhere ? slave_match::swapped : slave_match::found, .at = at};
}

[[nodiscard]] constexpr matched_slave match_placed(const expected_slave& wanted,
                                                   std::span<const expected_slave> expected,
                                                   std::span<const found_slave> found) noexcept {
    std::size_t at = 0;
    while (at != found.size() && found[at].position != wanted.position) ++at;
    if (at == found.size()) return {.match = slave_match::missing};
    if (wanted.identity.accepts(found[at].is.identity)) return {.match = slave_match::found, .at = at};
    // Another one's device, which is then not in its place.
    const auto is_of = [&](const expected_slave& other) {
        return &other != &wanted && !has_name(other) && other.identity.product &&
               other.identity.accepts(found[at].is.identity);
    };
    const bool is_expected = std::ranges::any_of(expected, is_of);
    return {.match = is_expected ? slave_match::swapped : slave_match::foreign, .at = at};
}

} // namespace detail

/// Matches each of `expected` with one of `found`, into `matches`, which is as long as `expected`, and marks those of
/// `found` that no expected slave is. Returns whether all are found and none is foreign. Each match stands for itself:
/// those that are found can run.
[[nodiscard]] constexpr bool match_slaves(std::span<const expected_slave> expected, std::span<found_slave> found,
                                          std::span<matched_slave> matches) noexcept {
    for (auto& each : found) each.is_foreign = true;
    bool is_right = true;
    for (std::size_t i = 0; i != expected.size(); ++i) {
        matches[i] = detail::has_name(expected[i]) ? detail::match_named(expected[i], found)
                                                   : detail::match_placed(expected[i], expected, found);
        is_right = is_right && matches[i].match == slave_match::found;
        if (matches[i].match == slave_match::found || matches[i].match == slave_match::swapped)
            found[matches[i].at].is_foreign = false;
        if (matches[i].match == slave_match::doubled)
            for (auto& each : found)
                if (detail::is_named(expected[i], each.is)) each.is_foreign = false;
    }
    return is_right && std::ranges::none_of(found, &found_slave::is_foreign);
}

} // namespace jauscat::ethercat
