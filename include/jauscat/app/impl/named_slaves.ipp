// The functions of named_slaves.
#pragma once
#include <jauscat/app/impl/named_slaves.hpp>
#include <jauscat/esi/read_esi.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

// Factors other than 1 of a period, and cycles of SYNC1, are read in several ways: they are not guessed.
inline net::sync_entry sync_of_mode(const net::slave_entry& entry, const esi::device& device) {
    const auto refuse = [&](const std::string& why) {
        throw std::invalid_argument{"slave \"" + entry.name + "\": " + entry.esi + why};
    };
    const auto mode = std::ranges::find(device.clock_modes, entry.sync_mode, &esi::clock_mode::name);
    if (mode == device.clock_modes.end()) {
        std::string all;
        for (const auto& each : device.clock_modes) all += (all.empty() ? "" : ", ") + each.name;
        refuse(" has no OpMode \"" + entry.sync_mode + "\"; it has " + (all.empty() ? "none" : all));
    }
    const bool has_sync1 = (mode->assign_activate & 0x0400) != 0;
    if ((mode->cycle_time_0 == 0 && mode->cycle_factor_0 != 0 && mode->cycle_factor_0 != 1) ||
        (has_sync1 && (mode->cycle_time_1 != 0 || mode->cycle_factor_1 != 0 || mode->shift_time_1 < 0)))
        refuse(": the times of the OpMode \"" + entry.sync_mode + "\" depend on the period; give them as numbers");
    return {.assign_activate = mode->assign_activate,
            .cycle = mode->cycle_time_0,
            .sync1_delay = has_sync1 ? static_cast<std::uint32_t>(mode->shift_time_1) : 0,
            .shift = mode->shift_time_0};
}

/// What the entry does not say is what the file says.
inline void add_timeouts(net::timeout_entry& to, const esi::timeouts& from) {
    const auto add = [](auto& value, std::optional<std::chrono::milliseconds> told) {
        constexpr std::chrono::milliseconds least{1}, most{0xFFFF};
        if (!value && told)
            value = std::chrono::duration_cast<net::timeout_entry::milliseconds>(std::clamp(*told, least, most));
    };
    add(to.pre_op, from.pre_op);
    add(to.safe_op_op, from.safe_op_op);
    add(to.back_to_init, from.back_to_init);
    add(to.back_to_safe_op, from.back_to_safe_op);
    if (from.response) add(to.mailbox, *from.response + from.request.value_or(std::chrono::milliseconds{}));
}

inline void add_esi_identity(net::slave_entry& entry) {
    const auto device = esi::read_esi(entry.esi, {.product = entry.product, .revision = entry.revision});
    if (!device) throw std::invalid_argument{"slave \"" + entry.name + "\": " + device.error().message};
    if (entry.vendor && entry.vendor != device->vendor_id)
        throw std::invalid_argument{"slave \"" + entry.name + "\": " + entry.esi + " is of another vendor"};
    entry.vendor = device->vendor_id;
    entry.product = device->product_code;
    if (!entry.revision) entry.revision = device->revision;
    if (!entry.sync_mode.empty()) entry.sync = sync_of_mode(entry, *device);
    add_timeouts(entry.timeouts, device->timeouts);
}

JAUSCAT_DECL named_slaves::named_slaves(std::vector<net::slave_entry> entries) {
    for (auto& each : entries) {
        if (each.name.empty()) throw std::invalid_argument{"a slave of the bus has no name"};
        if (find(each.name) != nullptr) throw std::invalid_argument{"two slaves have the name \"" + each.name + "\""};
        if (!each.esi.empty()) add_esi_identity(each);
        if (!each.position && !each.alias && !each.identification && !each.vendor && !each.product && !each.serial)
            throw std::invalid_argument{"nothing identifies the slave \"" + each.name + "\""};
        auto& made = all_.emplace_back();
        made.entry = std::move(each);
    }
    for (auto& each : all_)
        for (const auto& object : each.entry.start_up)
            each.start_up.push_back({object.index, object.subindex, object.data});
}
JAUSCAT_DECL named_slave* named_slaves::find(std::string_view name) noexcept {
    const auto found = std::ranges::find_if(all_, [=](const named_slave& each) { return each.entry.name == name; });
    return found == all_.end() ? nullptr : &*found;
}
JAUSCAT_DECL bool named_slaves::has_identification() const noexcept {
    return std::ranges::any_of(all_, [](const named_slave& each) { return each.entry.identification.has_value(); });
}
JAUSCAT_DECL std::vector<ethercat::matched_slave> named_slaves::match(std::vector<ethercat::found_slave> found) const {
    std::vector<ethercat::expected_slave> expected;
    for (const auto& [entry, start_up, station, why, user] : all_)
        expected.push_back({entry.position,
                            entry.alias,
                            entry.identification,
                            {entry.vendor, entry.product, entry.revision, entry.serial}});
    std::vector<ethercat::matched_slave> matches(expected.size());
    static_cast<void>(match_slaves(expected, found, matches));
    std::vector<std::uint16_t> uncounted;
    for (std::size_t i = 0; i != matches.size(); ++i)
        if (all_[i].entry.is_optional && !all_[i].entry.position && matches[i].match == ethercat::slave_match::found)
            uncounted.push_back(found[matches[i].at].position);
    constexpr std::uint16_t no_position = 0xFFFF;
    for (auto& each : found) {
        const auto before = std::ranges::count_if(uncounted, [&](auto other) { return other < each.position; });
        const bool is_counted = std::ranges::count(uncounted, each.position) == 0;
        each.position = is_counted ? static_cast<std::uint16_t>(each.position - before) : no_position;
    }
    static_cast<void>(match_slaves(expected, found, matches));
    return matches;
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
