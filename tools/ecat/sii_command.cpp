// sii: the SII memory of a slave, decoded, as bytes, or to a file.
#include "ecat/arguments.hpp"
#include "ecat/object_types.hpp"
#include "ecat/sii.hpp"
#include "ecat/value.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>

namespace ecat {

namespace {

const char* use_text(ethercat::sii_sync_manager_use use) {
    switch (use) {
    case ethercat::sii_sync_manager_use::none: return "none";
    case ethercat::sii_sync_manager_use::mailbox_out: return "mailbox out";
    case ethercat::sii_sync_manager_use::mailbox_in: return "mailbox in";
    case ethercat::sii_sync_manager_use::outputs: return "outputs";
    case ethercat::sii_sync_manager_use::inputs: return "inputs";
    }
    return "other";
}
const char* use_text(ethercat::sii_fmmu_use use) {
    switch (use) {
    case ethercat::sii_fmmu_use::none: return "none";
    case ethercat::sii_fmmu_use::outputs: return "outputs";
    case ethercat::sii_fmmu_use::inputs: return "inputs";
    case ethercat::sii_fmmu_use::mailbox_state: return "mailbox state";
    }
    return "other";
}

record decoded_memory(std::uint16_t position, const sii_content& sii) {
    list categories, strings, fmmus, managers, pdos;
    for (const auto& each : sii.parts)
        categories.emplace_back(record{{"category", static_cast<std::uint16_t>(each.category)},
                                       {"name", category_name(each.category)},
                                       {"word", hex_value(each.word, 4)},
                                       {"bytes", each.data.size()}});
    for (const auto& each : sii.strings) strings.emplace_back(record{{"number", strings.size() + 1}, {"text", each}});
    for (const auto each : sii.fmmus) fmmus.emplace_back(record{{"fmmu", fmmus.size()}, {"use", use_text(each)}});
    for (const auto& each : sii.sync_managers)
        managers.emplace_back(record{{"sync_manager", managers.size()},
                                     {"use", use_text(each.use)},
                                     {"start", hex_value(each.start, 4)},
                                     {"bytes", each.length},
                                     {"control", hex_value(each.control, 2)},
                                     {"enabled", (each.enable & 1) != 0}});
    for (const auto& pdo : sii.pdos)
        for (const auto& each : pdo.entries)
            pdos.emplace_back(record{{"pdo", hex_value(pdo.pdo.index, 4)},
                                     {"pdo_name", pdo.name},
                                     {"direction", pdo.is_output ? "output" : "input"},
                                     {"sync_manager", pdo.pdo.sync_manager},
                                     {"index", hex_value(each.is.index, 4)},
                                     {"subindex", each.is.subindex},
                                     {"type", type_text(each.is.data_type)},
                                     {"bits", each.is.bits},
                                     {"name", each.name}});
    const auto& words = sii.configuration;
    record made{
        {"position", position},
        {"configuration", record{{"pdi_control", hex_value(words.pdi_control, 4)},
                                 {"pdi_configuration", hex_value(words.pdi_configuration, 4)},
                                 {"sync_impulse_length", words.sync_impulse_length},
                                 {"station_alias", words.station_alias},
                                 {"checksum", hex_value(words.checksum & 0xFFu, 2)},
                                 {"checksum_is_right", sii.is_checksum_right}}},
        {"identity", record{{"vendor", hex_value(sii.identity.vendor, 8)},
                            {"product", hex_value(sii.identity.product, 8)},
                            {"revision", hex_value(sii.identity.revision, 8)},
                            {"serial", sii.identity.serial}}},
        {"mailbox", record{{"receive_offset", hex_value(sii.mailbox.receive_offset, 4)},
                           {"receive_size", sii.mailbox.receive_size},
                           {"send_offset", hex_value(sii.mailbox.send_offset, 4)},
                           {"send_size", sii.mailbox.send_size},
                           {"aoe", sii.mailbox.aoe},
                           {"eoe", sii.mailbox.eoe},
                           {"coe", sii.mailbox.coe},
                           {"foe", sii.mailbox.foe},
                           {"soe", sii.mailbox.soe},
                           {"voe", sii.mailbox.voe}}},
        {"memory", record{{"bytes", sii.memory_size()}, {"used", sii.used}, {"version", sii.size.version}}},
    };
    if (sii.general)
        made.emplace_back("general", record{{"group", sii.string(sii.general->group)},
                                            {"order", sii.string(sii.general->order)},
                                            {"name", sii.string(sii.general->name)},
                                            {"sdo_information", sii.general->sdo_information},
                                            {"pdo_assign", sii.general->pdo_assign},
                                            {"pdo_configuration", sii.general->pdo_configuration},
                                            {"complete_access", sii.general->complete_access},
                                            {"ebus_current_ma", sii.general->ebus_current}});
    made.emplace_back("categories", categories);
    made.emplace_back("strings", strings);
    made.emplace_back("sync_managers", managers);
    made.emplace_back("fmmus", fmmus);
    made.emplace_back("pdos", pdos);
    return made;
}

std::string hex_lines(const bytes& data) {
    constexpr std::size_t in_a_line = 16;
    std::string text;
    for (std::size_t at = 0; at < data.size(); at += in_a_line) {
        text += hex(at, 4).substr(2) + " ";
        const auto end = std::min(at + in_a_line, data.size());
        std::string characters;
        for (auto i = at; i != end; ++i) {
            text += ' ' + hex_bytes({data[i]});
            const auto c = static_cast<char>(data[i]);
            characters += c < ' ' || c > '~' ? '.' : c;
        }
        text += std::string(3 * (at + in_a_line - end) + 2, ' ') + characters + "\n";
    }
    return text;
}

} // namespace

int sii(const arguments& given) {
    ring on{given.link};
    on.guard();
    const auto position = chosen_slave(given, on);
    sii_content content;
    bytes image;
    {
        progress_line progress;
        sii_reader reader{on, position};
        std::size_t accesses = 0;
        reader.on_access = [&] { progress.show("SII: " + std::to_string(++accesses) + " reads"); };
        content = read_sii(reader, sii_depth::all);
        constexpr std::size_t largest = 65'536;
        const auto size = std::min(content.memory_size(), largest);
        if (!given.output.empty() || given.raw) image = reader.read(0, size);
    }
    for (const auto& each : content.problems) note(on.name_of(position) + ": SII: " + each);
    if (!given.output.empty()) {
        std::ofstream file{given.output, std::ios::binary};
        file.write(reinterpret_cast<const char*>(image.data()), static_cast<std::streamsize>(image.size()));
        if (!file.flush()) throw failure{given.output + ": cannot be written"};
        note(std::to_string(image.size()) + " bytes of the SII of " + on.name_of(position) + " are in " + given.output);
    }
    if (given.raw && given.is_json)
        print_json(list{record{{"position", position}, {"bytes", hex_bytes(image)}}});
    else if (given.raw)
        std::cout << hex_lines(image);
    else if (given.is_json)
        print_json(list{decoded_memory(position, content)});
    else if (given.output.empty())
        print_record(decoded_memory(position, content));
    return success;
}

} // namespace ecat
