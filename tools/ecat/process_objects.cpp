#include "ecat/process_objects.hpp"

#include "ecat/mailbox.hpp"
#include "ecat/object_types.hpp"
#include "ecat/sii.hpp"
#include "ecat/value.hpp"
#include <jauscat/ethercat/master/sii_survey.hpp>

#include <algorithm>
#include <functional>
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

assigned_pdo as_assigned(const sii_pdo_description& pdo) {
    assigned_pdo made{
        .index = pdo.pdo.index, .name = pdo.name, .is_output = pdo.is_output, .sync_manager = pdo.pdo.sync_manager};
    for (const auto& each : pdo.entries)
        made.entries.push_back({.index = each.is.index,
                                .subindex = each.is.subindex,
                                .bits = each.is.bits,
                                .type = each.is.data_type,
                                .name = each.name});
    return made;
}

process_objects from_sii(const sii_content& content) {
    process_objects made{.source = "sii"};
    for (const auto& pdo : content.pdos) made.pdos.push_back(as_assigned(pdo));
    return made;
}

/// The SyncManagers with process data, as the master chooses them.
std::vector<ethercat::process_manager> managers_of(const sii_content& content) {
    std::vector<ethercat::process_manager> made;
    for (std::size_t i = 0; i != content.sync_managers.size(); ++i) {
        ethercat::process_manager one{.number = static_cast<std::uint8_t>(i), .description = content.sync_managers[i]};
        if (ethercat::may_carry_process_data(one.description)) made.push_back(one);
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

/// The entries of a PDO, or why there are none.
void read_entries(coe_mailbox& mailbox, assigned_pdo& pdo, const std::function<void(std::uint64_t)>& take) {
    const auto missing = [&](unsigned subindex) {
        pdo.error = "the slave does not have " + place_text(pdo.index, static_cast<std::uint8_t>(subindex));
    };
    const auto entries = mailbox.try_number(pdo.index, 0);
    if (!entries) return missing(0);
    take(std::min<std::uint64_t>(*entries, 255));
    for (unsigned k = 1; k <= std::min<std::uint64_t>(*entries, 255); ++k) {
        if (stop_requested()) throw failure{"interrupted"};
        const auto mapped = mailbox.try_number(pdo.index, static_cast<std::uint8_t>(k));
        if (!mapped) return missing(k);
        mapped_entry entry{.index = static_cast<std::uint16_t>(*mapped >> 16),
                           .subindex = static_cast<std::uint8_t>(*mapped >> 8),
                           .bits = static_cast<std::uint8_t>(*mapped)};
        if (entry.index != 0)
            if (const auto about = mailbox.try_describe(entry.index, entry.subindex)) {
                entry.type = about->is.data_type;
                entry.name = about->name;
            }
        pdo.entries.push_back(std::move(entry));
    }
}

/// A SyncManager without an assignment object has the PDOs of the SII.
process_objects from_objects(ring& on, std::uint16_t position, const sii_content& content) {
    constexpr std::uint16_t assignments = 0x1C10;
    coe_mailbox mailbox{on, position};
    std::uint64_t objects = 0;
    const auto take = [&](std::uint64_t more) {
        objects += more;
        if (objects > ethercat::max_process_objects)
            throw failure{on.name_of(position) + ": object " + hex(assignments, 4) +
                          " and up: its process data have more than " + std::to_string(ethercat::max_process_objects) +
                          " PDOs and entries: check the slave"};
    };
    process_objects made{.source = "sii"};
    for (auto& manager : managers_of(content)) {
        const auto assignment = static_cast<std::uint16_t>(assignments + manager.number);
        const auto pdos = mailbox.try_number(assignment, 0);
        if (!pdos) {
            for (const auto& pdo : content.pdos)
                if (pdo.pdo.sync_manager == manager.number) made.pdos.push_back(as_assigned(pdo));
            continue;
        }
        made.source = "coe";
        take(std::min<std::uint64_t>(*pdos, 255));
        for (unsigned i = 1; i <= std::min<std::uint64_t>(*pdos, 255); ++i) {
            if (stop_requested()) throw failure{"interrupted"};
            const auto index =
                static_cast<std::uint16_t>(mailbox.try_number(assignment, static_cast<std::uint8_t>(i)).value_or(0));
            if (index == 0) continue;
            manager.carries_pdo(index);
            assigned_pdo one{.index = index,
                             .name = name_of_object(mailbox, index),
                             .is_output = manager.is_output(),
                             .sync_manager = manager.number};
            read_entries(mailbox, one, take);
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
    const auto content = [&] {
        sii_reader reader{on, position};
        return read_sii(reader, sii_depth::all);
    }();
    auto made = from_sii(content);
    if (may_use_mailbox && has_coe(on, position)) {
        try {
            auto objects = from_objects(on, position, content);
            add_names(objects, made);
            made = std::move(objects);
        } catch (const coe_failure& error) { // a mailbox may say that it does not know CoE after all
            if (error.error.code != ethercat::master_errc::mailbox_error) throw;
        }
    }
    set_offsets(made);
    return made;
}

} // namespace ecat
