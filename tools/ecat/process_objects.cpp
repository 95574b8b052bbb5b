#include "ecat/process_objects.hpp"

#include "ecat/mailbox.hpp"
#include "ecat/sii.hpp"
#include "ecat/value.hpp"
#include <jauscat/ethercat/master/sii_survey.hpp>

#include <algorithm>
#include <map>

namespace ecat {

namespace {

// Offsets count from the first PDO of a SyncManager.
void set_offsets(process_objects& all) {
    std::map<std::uint8_t, std::size_t> ends;
    for (auto& pdo : all.pdos)
        for (auto& each : pdo.entries) {
            each.bit_offset = ends[pdo.sync_manager];
            ends[pdo.sync_manager] += each.bits;
        }
}

process_objects from_sii(ring& on, std::uint16_t position) {
    sii_reader reader{on, position};
    process_objects made{.source = "sii"};
    for (const auto& pdo : read_sii(reader, sii_depth::all).pdos) {
        assigned_pdo one{
            .index = pdo.pdo.index, .name = pdo.name, .is_output = pdo.is_output, .sync_manager = pdo.pdo.sync_manager};
        for (const auto& each : pdo.entries)
            one.entries.push_back({.index = each.is.index,
                                   .subindex = each.is.subindex,
                                   .bits = each.is.bits,
                                   .type = each.is.data_type,
                                   .name = each.name});
        made.pdos.push_back(std::move(one));
    }
    return made;
}

std::string name_of_object(coe_mailbox& mailbox, std::uint16_t index) {
    if (!mailbox.try_describe(index, 0)) return {};
    try {
        return mailbox.describe(index).name;
    } catch (const coe_failure&) {
        return {};
    }
}

process_objects from_objects(ring& on, std::uint16_t position) {
    constexpr std::uint16_t manager_types = 0x1C00, assignments = 0x1C10;
    constexpr std::uint8_t outputs = 3, inputs = 4;
    coe_mailbox mailbox{on, position};
    std::uint64_t objects = 0;
    const auto take = [&](std::uint64_t more) {
        objects += more;
        if (objects > ethercat::max_process_objects)
            throw failure{on.name_of(position) + ": object " + hex(assignments, 4) +
                          " and up: its process data have more than " + std::to_string(ethercat::max_process_objects) +
                          " PDOs and entries: check the slave"};
    };
    process_objects made{.source = "coe"};
    auto managers = static_cast<std::uint8_t>(std::min<std::uint64_t>(mailbox.number(manager_types, 0), 32));
    const bool are_typed = managers != 0;
    if (!are_typed) managers = 4;
    for (std::uint8_t manager = 2; manager < managers; ++manager) {
        const auto type = are_typed ? mailbox.number(manager_types, static_cast<std::uint8_t>(manager + 1))
                                    : std::uint64_t{manager == 2 ? outputs : inputs};
        if (type != outputs && type != inputs) continue;
        const auto assignment = static_cast<std::uint16_t>(assignments + manager);
        const auto pdos = std::min<std::uint64_t>(mailbox.number(assignment, 0), 255);
        take(pdos);
        for (unsigned i = 1; i <= pdos; ++i) {
            if (stop_requested()) throw failure{"interrupted"};
            const auto index = static_cast<std::uint16_t>(mailbox.number(assignment, static_cast<std::uint8_t>(i)));
            if (index == 0) continue;
            assigned_pdo one{.index = index,
                             .name = name_of_object(mailbox, index),
                             .is_output = type == outputs,
                             .sync_manager = manager};
            const auto entries = std::min<std::uint64_t>(mailbox.number(index, 0), 255);
            take(entries);
            for (unsigned k = 1; k <= entries; ++k) {
                if (stop_requested()) throw failure{"interrupted"};
                const auto mapped = mailbox.number(index, static_cast<std::uint8_t>(k));
                mapped_entry entry{.index = static_cast<std::uint16_t>(mapped >> 16),
                                   .subindex = static_cast<std::uint8_t>(mapped >> 8),
                                   .bits = static_cast<std::uint8_t>(mapped)};
                if (entry.index != 0)
                    if (const auto about = mailbox.try_describe(entry.index, entry.subindex)) {
                        entry.type = about->is.data_type;
                        entry.name = about->name;
                    }
                one.entries.push_back(std::move(entry));
            }
            made.pdos.push_back(std::move(one));
        }
    }
    return made;
}

/// For slaves that do not describe their objects.
void add_names(process_objects& to, const process_objects& from) {
    for (auto& pdo : to.pdos) {
        const auto known = std::ranges::find(from.pdos, pdo.index, &assigned_pdo::index);
        if (known == from.pdos.end()) continue;
        if (pdo.name.empty()) pdo.name = known->name;
        for (auto& each : pdo.entries) {
            const auto same = std::ranges::find_if(known->entries, [&](const mapped_entry& one) {
                return one.index == each.index && one.subindex == each.subindex && one.bits == each.bits;
            });
            if (same == known->entries.end() || each.index == 0) continue;
            if (each.name.empty()) each.name = same->name;
            if (each.type == 0) each.type = same->type;
        }
    }
}

} // namespace

process_objects read_process_objects(ring& on, std::uint16_t position, bool may_use_mailbox) {
    process_objects made;
    if (may_use_mailbox && has_coe(on, position)) made = from_objects(on, position);
    const auto stored = from_sii(on, position);
    if (made.pdos.empty())
        made = stored; // a slave may have a mailbox without such objects
    else
        add_names(made, stored);
    set_offsets(made);
    return made;
}

} // namespace ecat
