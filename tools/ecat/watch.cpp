// watch: the inputs of slaves, as they change.
#include "ecat/arguments.hpp"
#include "ecat/object_types.hpp"
#include "ecat/process_objects.hpp"
#include "ecat/value.hpp"
#include <jauscat/net/now.hpp>

#include <algorithm>
#include <array>
#include <iostream>
#include <optional>
#include <unistd.h>

namespace ecat {

namespace registers = ethercat::esc_registers;
using ethercat::al_state;

namespace {

/// A SyncManager with inputs, and what is in it.
struct input_area {
    std::uint16_t position{};
    std::uint16_t start{};
    std::uint16_t length{};
    std::optional<std::uint32_t> logical{}; ///< where an FMMU has it
    std::vector<mapped_entry> entries{};
};

bytes bits_of(const bytes& data, std::size_t from, std::size_t count) {
    bytes made((count + 7) / 8);
    for (std::size_t i = 0; i != count; ++i) {
        const auto at = from + i;
        if (at / 8 >= data.size()) break;
        const auto bit = std::to_integer<unsigned>(data[at / 8]) >> at % 8 & 1u;
        made[i / 8] |= static_cast<std::byte>(bit << i % 8);
    }
    return made;
}

std::optional<std::uint32_t> logical_address(ring& on, std::uint16_t position, const ethercat::sync_manager& sm) {
    const auto fmmus = std::min<std::size_t>(on.read(position, registers::description).fmmus, 16);
    for (std::size_t i = 0; i != fmmus; ++i) {
        const auto one = on.read(position, ethercat::nth(registers::fmmu, i));
        if (one.enable && one.read && one.first_bit == 0 && one.physical_bit == 0 && one.physical_start == sm.start &&
            one.length == sm.length)
            return one.logical_start;
    }
    return {};
}

/// Some emulated slaves have process data at logical addresses only.
bytes inputs_of(ring& on, const input_area& area) {
    std::array both{read_of(area.position, area.start, area.length), datagram{}};
    const auto logical = area.logical.value_or(0);
    both[1] = {ethercat::command::lrd, static_cast<std::uint16_t>(logical & 0xFFFF),
               static_cast<std::uint16_t>(logical >> 16), bytes(area.length)};
    on.exchange({both.data(), 1});
    if (both[0].working_counter == 1) return both[0].data;
    if (area.logical) on.exchange({&both[1], 1});
    if (both[1].working_counter == 1) return both[1].data;
    throw failure{on.name_of(area.position) + ": its inputs at " + hex(area.start, 4) +
                  " cannot be read: check that the slave is there"};
}

std::vector<input_area> areas_of(ring& on, std::uint16_t position) {
    std::vector<input_area> made;
    // A master that runs uses the mailbox.
    const auto found = read_process_objects(on, position, !on.options().force);
    for (const auto& pdo : found.pdos) {
        if (pdo.is_output || pdo.sync_manager > 15) continue;
        const auto sm = on.read(position, ethercat::nth(registers::sync_manager, pdo.sync_manager));
        if (!sm.enable || sm.length == 0 || sm.length > 1400) continue;
        auto area = std::ranges::find_if(made, [&](const auto& one) { return one.start == sm.start; });
        if (area == made.end())
            area = made.insert(made.end(), {position, sm.start, sm.length, logical_address(on, position, sm), {}});
        for (const auto& each : pdo.entries)
            if (each.index != 0) area->entries.push_back(each);
    }
    return made;
}

/// One look: a row for each entry.
std::vector<record> look(ring& on, const std::vector<input_area>& areas) {
    std::vector<record> rows;
    for (const auto& area : areas) {
        const auto data = inputs_of(on, area);
        for (const auto& each : area.entries) {
            const auto raw = bits_of(data, each.bit_offset, each.bits);
            const auto* const type = type_of(each.type);
            const auto& used = type != nullptr ? *type : guessed_type(raw.size() * 8);
            rows.push_back({{"position", area.position},
                            {"object", place_text(each.index, each.subindex)},
                            {"index", hex_value(each.index, 4)},
                            {"subindex", each.subindex},
                            {"name", each.name},
                            {"type", std::string{used.name}},
                            {"value", to_value(used, raw)}});
        }
    }
    return rows;
}

} // namespace

int watch(const arguments& given) {
    ring on{given.link};
    on.guard(intent::change);
    std::vector<input_area> areas;
    bool is_any_active = false;
    for (const auto position : chosen_slaves(given, on)) {
        const auto state = on.states()[position].al.state;
        if (state != al_state::safe_op && state != al_state::op) continue;
        is_any_active = true;
        std::ranges::move(areas_of(on, position), std::back_inserter(areas));
    }
    if (!is_any_active)
        throw failure{given.link.link +
                      ": no chosen slave is in SAFE-OP or OP, where inputs are valid: jauscat-ecat state safe-op"};
    if (areas.empty()) throw failure{given.link.link + ": the chosen slaves have no inputs"};

    const auto period = given.period == given.period.zero() ? std::chrono::microseconds{200'000} : given.period;
    const bool is_terminal = ::isatty(STDOUT_FILENO) == 1 && !given.is_json;
    const auto end = jauscat::net::now() + std::chrono::duration_cast<std::chrono::nanoseconds>(
                                               std::chrono::duration<double>{given.seconds.value_or(1e8)});
    for (auto due = jauscat::net::now(); !stop_requested();) {
        const auto rows = look(on, areas);
        if (given.is_json) {
            print_json(list{rows.begin(), rows.end()}, true);
        } else {
            if (is_terminal) std::cout << "\033[H\033[J";
            print_table(rows, {"index", "subindex"});
            std::cout << (is_terminal ? "Ctrl-C ends\n" : "\n") << std::flush;
        }
        due = std::max(due + period, jauscat::net::now());
        if (due >= end) break;
        sleep_until(due);
    }
    return success;
}

} // namespace ecat
