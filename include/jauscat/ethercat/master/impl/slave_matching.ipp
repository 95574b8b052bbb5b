// The functions of slave_matching.
#pragma once
#include <jauscat/ethercat/master/slave_matching.hpp>

namespace jauscat::ethercat {

JAUSCAT_CONSTEXPR std::string_view describe(slave_match match) noexcept {
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

} // namespace jauscat::ethercat

namespace jauscat::ethercat::detail {

JAUSCAT_CONSTEXPR bool has_name(const expected_slave& wanted) noexcept {
    return wanted.alias || wanted.device_id || wanted.identity.serial || !wanted.position;
}

JAUSCAT_CONSTEXPR bool is_named(const expected_slave& wanted, const slave_identity& slave) noexcept {
    if (wanted.alias && *wanted.alias != slave.alias) return false;
    if (wanted.device_id && wanted.device_id != slave.device_id) return false;
    // A serial number is one only together with the device.
    return wanted.alias || wanted.device_id || wanted.identity.accepts(slave.identity);
}

JAUSCAT_CONSTEXPR matched_slave match_named(const expected_slave& wanted, std::span<const found_slave> found) noexcept {
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

JAUSCAT_CONSTEXPR matched_slave match_placed(const expected_slave& wanted, std::span<const expected_slave> expected,
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

} // namespace jauscat::ethercat::detail

namespace jauscat::ethercat {

JAUSCAT_CONSTEXPR bool match_slaves(std::span<const expected_slave> expected, std::span<found_slave> found,
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
