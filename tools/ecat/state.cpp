// state: shows the states of slaves, or changes them.
#include "ecat/arguments.hpp"
#include "ecat/mailbox.hpp"
#include "ecat/sii.hpp"
#include "ecat/value.hpp"
#include <jauscat/net/link/run_master.hpp>

#include <algorithm>

namespace ecat {

namespace registers = ethercat::esc_registers;
using ethercat::al_state;

namespace {

al_state parse_goal(std::string text) {
    std::erase_if(text, [](char c) { return c == '-' || c == '_' || c == ' '; });
    std::ranges::transform(text, text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    if (text == "init") return al_state::init;
    if (text == "preop") return al_state::pre_op;
    if (text == "boot") return al_state::boot;
    if (text == "safeop") return al_state::safe_op;
    if (text == "op") return al_state::op;
    throw usage_error{"'" + text + "' is no state: expected init, pre-op, boot, safe-op or op"};
}

/// By way of INIT; process data are set up by the master, which needs a station address for the time.
void to_safe_op(ring& on, std::uint16_t position) {
    std::uint16_t station = 1000;
    const auto is_taken = [&](std::uint16_t one) {
        return std::ranges::any_of(on.states(),
                                   [&](const slave_state& s) { return s.station == one || s.alias == one; });
    };
    while (is_taken(station)) ++station;
    const auto before = on.read(position, registers::station_address);
    // Each slave has logical addresses of its own, by which watch can read its inputs.
    ethercat::master_for<1> master{
        {.frame_timeout = on.options().frame_timeout, .logical_base = std::uint32_t{position} << 16}};
    const auto require = [&](const auto& result, const char* what) {
        if (!result) throw failure{on.name_of(position) + ": " + what + ": " + reason_text(result.error())};
    };
    try {
        auto& link = on.link();
        require(jauscat::net::run(link, master, ethercat::bring_up{.position = position, .station = station}),
                "to PRE-OP");
        require(jauscat::net::run(link, master, ethercat::configure{.station = station}), "its process data");
        require(jauscat::net::run(link, master, ethercat::change_state{station, al_state::safe_op}), "to SAFE-OP");
    } catch (...) {
        on.write(position, registers::station_address, before);
        throw;
    }
    on.write(position, registers::station_address, before);
}

void request(ring& on, std::uint16_t position, al_state goal) {
    const auto now = on.read(position, registers::al_status);
    if (now.state == goal && !now.error) return;
    if (goal == al_state::safe_op && now.state != al_state::op) return to_safe_op(on, position);
    if (goal == al_state::op) {
        if (now.state != al_state::safe_op || now.error) to_safe_op(on, position);
        if (on.has_outputs(position))
            throw failure{on.name_of(position) +
                          ": it has outputs: in OP they would be in force without a master that keeps them, until the "
                          "slave leaves OP. It is in SAFE-OP, where watch shows its inputs; cyclic holds slaves in OP "
                          "with outputs of 0"};
    }
    if (goal == al_state::boot || (goal == al_state::pre_op && !is_known(now.state)))
        if (now.state != al_state::init) on.change_state(position, al_state::init);
    if (goal == al_state::pre_op && (now.state == al_state::init || now.state == al_state::boot)) {
        if (now.state == al_state::boot) on.change_state(position, al_state::init);
        ethercat::sii_mailbox mailbox;
        {
            sii_reader reader{on, position};
            mailbox = reader.read<ethercat::sii_mailbox>(ethercat::sii_words::mailbox);
        }
        if (mailbox.receive_size != 0) set_up_mailbox(on, position, mailbox);
    }
    if (goal == al_state::boot) { // words 14h to 17h have the mailbox of BOOT
        sii_reader reader{on, position};
        constexpr std::uint32_t boot_mailbox = 0x14;
        const auto mailbox = decoded<ethercat::sii_mailbox>([&] {
            auto made = reader.read(boot_mailbox, 8);
            made.resize(10);
            return made;
        }());
        if (mailbox.receive_size != 0) set_up_mailbox(on, position, mailbox);
    }
    on.change_state(position, goal);
}

record row_of(ring& on, std::uint16_t position) {
    const auto al = on.read(position, registers::al_status);
    return {{"position", position},
            {"station", on.states()[position].station},
            {"state", state_text(al)},
            {"al_status_code", value{static_cast<std::uint16_t>(al.code),
                                     al_code_text(al).empty() ? std::string{"0"} : al_code_text(al)}}};
}

} // namespace

int state(const arguments& given) {
    const bool changes = !given.words.empty();
    const auto goal = changes ? parse_goal(given.words.front()) : al_state::init;
    ring on{given.link};
    on.guard();
    const auto slaves = chosen_slaves(given, on);
    bool is_done = true;
    if (changes) {
        const auto which = slaves.size() == 1 ? on.name_of(slaves.front())
                                              : std::to_string(slaves.size()) + " slaves on " + given.link.link;
        confirm(given, "Take " + which + " to " + state_name(goal) + "?");
        progress_line progress;
        for (const auto position : slaves) {
            progress.show("slave " + std::to_string(position) + " of " + std::to_string(on.slaves()));
            if (stop_requested()) throw failure{"interrupted"};
            try {
                request(on, position, goal);
            } catch (const failure& error) {
                note(error.what());
                is_done = false;
            }
        }
    }
    std::vector<record> rows;
    for (const auto position : slaves) rows.push_back(row_of(on, position));
    if (given.is_json)
        print_json(list{rows.begin(), rows.end()});
    else
        print_table(rows);
    return is_done ? success : failed;
}

} // namespace ecat
