// pdos: the process data of slaves.
#include "ecat/arguments.hpp"
#include "ecat/object_types.hpp"
#include "ecat/process_objects.hpp"
#include "ecat/value.hpp"

#include <iostream>
#include <utility>

namespace ecat {

namespace {

std::string offset_text(std::size_t bits) {
    return std::to_string(bits / 8) + (bits % 8 != 0 ? "." + std::to_string(bits % 8) : "");
}
value manager_value(std::uint8_t number) { return number == 255 ? value{number, "none"} : value{number}; }

} // namespace

int pdos(const arguments& given) {
    ring on{given.link};
    on.guard();
    list slaves;
    std::vector<record> rows;
    progress_line progress;
    bool is_complete = true;
    for (const auto position : chosen_slaves(given, on)) {
        progress.show("slave " + std::to_string(position) + " of " + std::to_string(on.slaves()));
        const auto found = read_process_objects(on, position, true);
        list all;
        for (const auto& pdo : found.pdos) {
            list entries;
            const auto direction = pdo.is_output ? "output" : "input";
            const auto row = [&](value byte, value bits, value object, value type, value name) {
                rows.push_back({{"position", position},
                                {"direction", direction},
                                {"sync_manager", manager_value(pdo.sync_manager)},
                                {"pdo", hex_value(pdo.index, 4)},
                                {"byte", std::move(byte)},
                                {"bits", std::move(bits)},
                                {"object", std::move(object)},
                                {"type", std::move(type)},
                                {"name", std::move(name)}});
            };
            const std::string none;
            if (!pdo.error.empty()) {
                is_complete = false;
                row(none, none, "error", none, pdo.error);
            }
            for (const auto& each : pdo.entries) {
                const auto type = each.type != 0 ? type_text(each.type) : none;
                entries.emplace_back(record{{"index", each.index},
                                            {"subindex", each.subindex},
                                            {"name", each.name},
                                            {"type", type},
                                            {"bits", each.bits},
                                            {"bit_offset", each.bit_offset}});
                row(value{each.bit_offset, offset_text(each.bit_offset)}, each.bits,
                    each.index != 0 ? place_text(each.index, each.subindex) : "gap", type, each.name);
            }
            record one{{"index", pdo.index},
                       {"name", pdo.name},
                       {"direction", direction},
                       {"sync_manager", manager_value(pdo.sync_manager)},
                       {"entries", entries}};
            if (!pdo.error.empty()) one.emplace_back("error", pdo.error);
            all.emplace_back(std::move(one));
        }
        slaves.emplace_back(record{{"position", position}, {"source", found.source}, {"pdos", all}});
    }
    if (given.is_json)
        print_json(slaves);
    else if (rows.empty())
        std::cout << "no process data\n";
    else
        print_table(rows);
    if (!is_complete) throw failure{"PDOs are assigned that the slave does not have"};
    return success;
}

} // namespace ecat
