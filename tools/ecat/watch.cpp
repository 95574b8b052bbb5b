// watch: the inputs of slaves, as they change.
#include "ecat/arguments.hpp"
#include "ecat/object_types.hpp"
#include "ecat/process_objects.hpp"
#include "ecat/value.hpp"
#include <jauscat/net/now.hpp>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <optional>
#include <unistd.h>
#include <utility>

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

bool has_inputs(const ethercat::al_status& al) { return al.state == al_state::safe_op || al.state == al_state::op; }

/// `SAFE-OP ERROR (0x001B: SyncManager watchdog)`
std::string explained(const ethercat::al_status& al) {
    const auto code = al.error ? al_code_text(al) : std::string{};
    return state_text(al) + (code.empty() ? "" : " (" + code + ")");
}

/// The states of the slaves, as the last look has found them. Each change is said on standard error.
class watched_states {
  public:
    void add(std::uint16_t position, const ethercat::al_status& al) { all_.emplace(position, al); }
    [[nodiscard]] const ethercat::al_status& of(std::uint16_t position) const { return all_.at(position); }
    void look(ring& on) {
        for (auto& [position, last] : all_) {
            const auto now = on.read(position, registers::al_status);
            const auto before = std::exchange(last, now);
            const bool is_same =
                now.state == before.state && now.error == before.error && (!now.error || now.code == before.code);
            if (is_same) continue;
            note(on.name_of(position) + ": it is in " + explained(now) + ", it was in " + state_text(before) +
                 (has_inputs(now) ? "" : ": its inputs are not valid"));
        }
    }
    [[nodiscard]] bool all_have_inputs() const {
        return std::ranges::all_of(all_, [](const auto& each) { return has_inputs(each.second); });
    }

  private:
    std::map<std::uint16_t, ethercat::al_status> all_{};
};

/// One look: a row for each entry.
std::vector<record> look(ring& on, const std::vector<input_area>& areas, const watched_states& states) {
    std::vector<record> rows;
    for (const auto& area : areas) {
        const auto& al = states.of(area.position);
        const bool is_valid = has_inputs(al);
        const auto data = is_valid ? inputs_of(on, area) : bytes{};
        for (const auto& each : area.entries) {
            const auto raw = bits_of(data, each.bit_offset, each.bits);
            const auto* const type = type_of(each.type);
            const auto& used = type != nullptr ? *type : guessed_type(raw.size() * 8);
            rows.push_back(
                {{"position", area.position},
                 {"state", state_text(al)},
                 {"object", place_text(each.index, each.subindex)},
                 {"index", hex_value(each.index, 4)},
                 {"subindex", each.subindex},
                 {"name", each.name},
                 {"type", std::string{used.name}},
                 {"value", is_valid ? to_value(used, raw) : value{std::monostate{}, "not valid: " + state_text(al)}}});
        }
    }
    return rows;
}

} // namespace

int watch(const arguments& given) {
    ring on{given.link};
    on.guard();
    std::vector<input_area> areas;
    watched_states states;
    bool is_any_active = false;
    for (const auto position : chosen_slaves(given, on)) {
        const auto& al = on.states()[position].al;
        if (!has_inputs(al)) continue;
        is_any_active = true;
        states.add(position, al);
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
        states.look(on);
        const auto rows = look(on, areas, states);
        if (given.is_json) {
            print_json(list{rows.begin(), rows.end()}, true);
        } else {
            if (is_terminal) std::cout << "\033[H\033[J";
            print_table(rows, {"state", "index", "subindex"});
            std::cout << (is_terminal ? "Ctrl-C ends\n" : "\n") << std::flush;
        }
        due = std::max(due + period, jauscat::net::now());
        if (due >= end) break;
        sleep_until(due);
    }
    return states.all_have_inputs() ? success : failed;
}

} // namespace ecat
