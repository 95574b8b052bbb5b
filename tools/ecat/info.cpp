// info: registers and SII of a slave.
#include "ecat/arguments.hpp"
#include "ecat/sii.hpp"
#include "ecat/value.hpp"

#include <array>

namespace ecat {

namespace registers = ethercat::esc_registers;

namespace {

const char* port_kind(unsigned bits) {
    switch (bits) {
    case 0: return "not there";
    case 1: return "not configured";
    case 2: return "EBUS";
    default: return "MII";
    }
}

list ports_of(const ethercat::esc_description& esc, const ethercat::dl_status& status) {
    list made;
    const auto links = status.ports();
    for (unsigned port = 0; port != 4; ++port) {
        const auto kind = esc.ports >> 2 * port & 3u;
        if (kind == 0) continue;
        made.emplace_back(record{{"port", port},
                                 {"kind", port_kind(kind)},
                                 {"link", links[port].link},
                                 {"loop_closed", links[port].closed},
                                 {"communication", links[port].communication}});
    }
    return made;
}

list protocols_of(const ethercat::sii_mailbox& mailbox) {
    list made;
    for (const auto& [is, name] : {std::pair{mailbox.aoe, "AoE"},
                                   {mailbox.eoe, "EoE"},
                                   {mailbox.coe, "CoE"},
                                   {mailbox.foe, "FoE"},
                                   {mailbox.soe, "SoE"},
                                   {mailbox.voe, "VoE"}})
        if (is) made.emplace_back(name);
    return made;
}

std::string joined(const list& names) {
    std::string text;
    for (const auto& each : names) text += (text.empty() ? "" : " ") + each.text();
    return text.empty() ? "none" : text;
}

record describe(ring& on, std::uint16_t position) {
    const auto esc = on.read(position, registers::description);
    const auto dl_status = on.read(position, registers::dl_status);
    const auto& is = on.states()[position];
    sii_content sii;
    {
        sii_reader reader{on, position};
        sii = read_sii(reader, sii_depth::all);
    }
    for (const auto& each : sii.problems) note(on.name_of(position) + ": SII: " + each);
    list managers, mappings;
    for (std::size_t i = 0; i != std::min<std::size_t>(esc.sync_managers, 16); ++i) {
        const auto sm = on.read(position, ethercat::nth(registers::sync_manager, i));
        if (sm.length == 0) continue;
        managers.emplace_back(
            record{{"sync_manager", i},
                   {"start", hex_value(sm.start, 4)},
                   {"bytes", sm.length},
                   {"mode", sm.mode == ethercat::sync_manager_mode::mailbox ? "mailbox" : "buffered"},
                   {"direction",
                    sm.direction == ethercat::sync_manager_direction::master_writes ? "master writes" : "master reads"},
                   {"enabled", sm.enable}});
    }
    for (std::size_t i = 0; i != std::min<std::size_t>(esc.fmmus, 16); ++i) {
        const auto one = on.read(position, ethercat::nth(registers::fmmu, i));
        if (!one.enable) continue;
        mappings.emplace_back(record{{"fmmu", i},
                                     {"logical", hex_value(one.logical_start, 8)},
                                     {"bytes", one.length},
                                     {"physical", hex_value(one.physical_start, 4)},
                                     {"direction", one.write ? "outputs" : "inputs"}});
    }
    const auto protocols = protocols_of(sii.mailbox);
    return {
        {"position", position},
        {"name", sii.name()},
        {"vendor", hex_value(sii.identity.vendor, 8)},
        {"product", hex_value(sii.identity.product, 8)},
        {"revision", hex_value(sii.identity.revision, 8)},
        {"serial", sii.identity.serial},
        {"order", sii.general ? sii.string(sii.general->order) : std::string{}},
        {"group", sii.general ? sii.string(sii.general->group) : std::string{}},
        {"station", is.station},
        {"alias", is.alias},
        {"state", state_text(is.al)},
        {"al_status_code",
         value{static_cast<std::uint16_t>(is.al.code), al_code_text(is.al).empty() ? "0" : al_code_text(is.al)}},
        {"controller", record{{"type", hex_value(esc.type, 2)},
                              {"revision", esc.revision},
                              {"build", esc.build},
                              {"ram_kib", esc.ram},
                              {"fmmus", esc.fmmus},
                              {"sync_managers", esc.sync_managers},
                              {"distributed_clocks", esc.dc ? (esc.dc_64 ? "64 bits" : "32 bits") : "none"},
                              {"lrw", !esc.no_lrw}}},
        {"mailbox", record{{"protocols", value{protocols, joined(protocols)}},
                           {"receive_offset", hex_value(sii.mailbox.receive_offset, 4)},
                           {"receive_size", sii.mailbox.receive_size},
                           {"send_offset", hex_value(sii.mailbox.send_offset, 4)},
                           {"send_size", sii.mailbox.send_size}}},
        {"ports", ports_of(esc, dl_status)},
        {"sync_managers", managers},
        {"fmmus", mappings},
    };
}

} // namespace

int info(const arguments& given) {
    ring on{given.link};
    on.guard();
    list all;
    for (const auto position : chosen_slaves(given, on)) all.emplace_back(describe(on, position));
    if (given.is_json) {
        print_json(all);
        return success;
    }
    for (const auto& each : all) print_record(std::get<record>(each.data()));
    return success;
}

} // namespace ecat
