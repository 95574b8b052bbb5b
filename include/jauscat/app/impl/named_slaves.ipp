// The functions of named_slaves.
#pragma once
#include <jauscat/app/impl/named_slaves.hpp>
#include <jauscat/esi/read_esi.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

inline void add_esi_identity(net::slave_entry& entry) {
    const auto device = esi::read_esi(entry.esi, {.product = entry.product, .revision = entry.revision});
    if (!device) throw std::invalid_argument{"slave \"" + entry.name + "\": " + device.error().message};
    if (entry.vendor && entry.vendor != device->vendor_id)
        throw std::invalid_argument{"slave \"" + entry.name + "\": " + entry.esi + " is of another vendor"};
    entry.vendor = device->vendor_id;
    entry.product = device->product_code;
    entry.revision = device->revision;
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
