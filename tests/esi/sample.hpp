// The slave that these tests describe, and its ESI file.
#pragma once
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/esi/make_device.hpp>
#include <jauscat/esi/write_esi.hpp>
#include <jauscat/schema/ethercat/data_types.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/schema/translation/seed_table.hpp>

#include <array>
#include <stdexcept>
#include <string>

namespace jauscat::test {

/// Accepts a command, a query and a report.
template <class Table>
inline constexpr std::array sample_components{
    bridging::object_list<Table, 33, jaus::query_wrench_effort, jaus::report_wrench_effort,
                          jaus::set_wrench_effort>::description,
    bridging::object_list<Table, 255, jaus::set_travel_speed>::description};

inline constexpr ethercat::slave_description sample_slave{
    .vendor = 0x6A5, .product = 0x21, .revision = 0x10002, .station_alias = 0x1234, .name = "arm <1>"};

inline const esi::device_texts sample_texts{
    .vendor_name = "Makers & Co", .group_type = "arms", .group_name = "Robot arms", .type = "A-1"};

template <class Table = translation::seed_table>
esi::device sample_device(const ethercat::slave_description& slave = sample_slave, bool segmented_sdo = true) {
    return esi::make_device(slave, sample_texts, sample_components<Table>, segmented_sdo);
}

template <class Table = translation::seed_table> std::string sample_esi() {
    return esi::write_esi(sample_device<Table>());
}

/// Modes of a distributed clock.
inline constexpr std::array sample_clock_modes{
    ethercat::clock_mode{.name = "Free run", .description = "not synchronized"},
    ethercat::clock_mode{.name = "DC",
                         .description = "SYNC0 and SYNC1",
                         .assign_activate = 0x700,
                         .cycle_time_0 = 250'000,
                         .shift_time_0 = -1000,
                         .shift_time_1 = 2000,
                         .cycle_factor_0 = 1,
                         .cycle_factor_1 = -2}};

/// The same slave with process data and a distributed clock.
inline std::string sample_esi_with_pdos() {
    static constexpr std::array entries{ethercat::pdo_entry{0x7000, 1, 8, ethercat::data_types::unsigned8, "level"},
                                        ethercat::pdo_entry{.bits = 8}};
    auto slave = sample_slave;
    slave.outputs = slave.inputs = entries;
    slave.clock_modes = sample_clock_modes;
    return esi::write_esi(sample_device(slave));
}

/// `text` with its first `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    if (at == text.npos) throw std::logic_error{"the text has no " + from};
    return text.replace(at, from.size(), to);
}

} // namespace jauscat::test
