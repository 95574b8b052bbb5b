#include "ecat/ring.hpp"

#include "ecat/value.hpp"
#include <jauscat/ethercat/code_texts.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/net/now.hpp>

#include <algorithm>
#include <array>
#include <iostream>
#include <thread>
#include <unistd.h>

namespace ecat {

using ethercat::command;
using std::chrono::milliseconds;
namespace registers = ethercat::esc_registers;

namespace {

constexpr std::size_t frame_room = ethercat::max_frame_size;

std::unique_ptr<jauscat::net::any_link> open(const std::string& where) {
    try {
        return jauscat::net::open_link(where);
    } catch (const std::exception& error) {
        throw failure{where + ": " + error.what()};
    }
}

bool is_udp(const std::string& link) { return link.starts_with("udp:"); }

} // namespace

std::string state_name(ethercat::al_state state) {
    if (ethercat::is_known(state)) return std::string{describe(state)};
    return "UNKNOWN " + std::to_string(static_cast<unsigned>(state));
}
std::string state_text(const ethercat::al_status& al) { return state_name(al.state) + (al.error ? " ERROR" : ""); }
std::string al_code_text(const ethercat::al_status& al) {
    if (al.code == ethercat::al_status_code::none) return {};
    return hex(static_cast<std::uint16_t>(al.code), 4) + ": " + std::string{describe(al.code)};
}

ring::ring(const ring_options& options)
    : options_{options}, link_{open(options.link)}, index_{static_cast<std::uint8_t>(::getpid() * 37)} {}

std::string ring::name_of(std::uint16_t position) const {
    return "slave " + std::to_string(position) + " on " + options_.link;
}

bool ring::send_and_wait(std::span<const std::byte> out, std::span<std::byte> in, std::size_t& size,
                         std::chrono::nanoseconds limit) {
    // Commands and positions change on the way; tag, register address and length return unchanged.
    const auto is_reply = [](std::span<const std::byte> ours, std::span<const std::byte> theirs) {
        ethercat::frame_view a, b;
        if (!a.parse(ours) || !b.parse(theirs)) return false;
        auto one = a.begin(), other = b.begin();
        for (; one != a.end() && other != b.end(); ++one, ++other) {
            const auto x = (*one).header, y = (*other).header;
            if (x.cmd != y.cmd || x.index != y.index || x.ado != y.ado || x.length != y.length) return false;
        }
        return one == a.end() && other == b.end();
    };
    problem_.clear();
    if (!link_->send(out)) {
        problem_ = link_->problem();
        if (!is_udp(options_.link)) throw failure{options_.link + ": a frame was not sent: " + problem_};
        ++sent, ++lost;
        return false;
    }
    ++sent;
    const auto end = jauscat::net::now() + limit;
    for (auto left = limit; left > left.zero(); left = end - jauscat::net::now()) {
        size = link_->receive(in, left);
        if (size == 0) {
            if (problem_ = link_->problem(); !problem_.empty()) break;
            continue;
        }
        if (is_reply(out, in.first(size))) return true;
        ethercat::frame_view other;
        // A late return of an own frame has one of the tags that were sent last.
        if (other.parse(in.first(size)) && static_cast<std::uint8_t>(index_ - (*other.begin()).header.index) > 32)
            ++foreign;
    }
    ++lost;
    return false;
}

bool ring::try_exchange(std::span<datagram> all, std::chrono::nanoseconds limit) {
    std::array<std::byte, frame_room> out{}, in{};
    ethercat::frame_builder builder{out, ++index_};
    for (const auto& each : all) builder.add(each.cmd, each.adp, each.ado, std::span{each.data});
    const auto frame = builder.finish();
    if (!frame) throw failure{"a frame of " + std::to_string(all.size()) + " datagrams is too long"};
    std::size_t size{};
    if (!send_and_wait(*frame, in, size, limit)) return false;
    ethercat::frame_view view;
    static_cast<void>(view.parse(std::span<const std::byte>{in}.first(size)));
    auto to = all.begin();
    for (const auto each : view) {
        to->data.assign(each.data.begin(), each.data.end());
        to->working_counter = each.working_counter;
        ++to;
    }
    return true;
}

bool ring::try_exchange_at(std::uint16_t position, std::span<std::byte> frame, std::size_t& size,
                           std::chrono::nanoseconds limit) {
    ethercat::mutable_frame_view view;
    static_cast<void>(view.parse(frame.first(size)));
    ++index_;
    for (const auto each : view) {
        auto header = each.header;
        header.cmd = header.cmd == command::fprd ? command::aprd : command::apwr;
        header.adp = position_address(position);
        header.index = index_;
        static_cast<void>(jauscat::wire::encode(header, each.bytes));
    }
    std::array<std::byte, frame_room> in{};
    std::size_t received{};
    if (!send_and_wait(frame.first(size), in, received, limit)) return false;
    std::ranges::copy(std::span{in}.first(received), frame.begin());
    size = received;
    return true;
}

void ring::exchange(std::span<datagram> all) {
    for (unsigned tries = 0; tries <= options_.retries; ++tries) {
        if (try_exchange(all, options_.frame_timeout)) return;
        if (stop_requested()) throw failure{"interrupted"};
        if (!problem_.empty() && tries >= 2) break;
    }
    no_return();
}

void ring::no_return() const {
    if (!problem_.empty())
        throw failure{options_.link + ": " + problem_ +
                      (is_udp(options_.link) ? "; check host and port, and start it" : "")};
    throw failure{options_.link +
                  ": frames do not return: check the cable, the power of the first slave, and that this "
                  "is the right " +
                  (is_udp(options_.link) ? "host and port" : "interface")};
}

bytes ring::read(std::uint16_t position, std::uint16_t address, std::size_t size) {
    datagram one = read_of(position, address, size);
    exchange({&one, 1});
    if (one.working_counter == 1) return one.data;
    throw failure{name_of(position) + ": the read of register " + hex(address, 4) +
                  " was not executed: check that the slave is there"};
}

void ring::write(std::uint16_t position, std::uint16_t address, const bytes& data) {
    datagram one{command::apwr, position_address(position), address, data};
    exchange({&one, 1});
    if (one.working_counter == 1) return;
    throw failure{name_of(position) + ": the write of register " + hex(address, 4) +
                  " was not executed: check that the slave is there"};
}

bool ring::has_outputs(std::uint16_t position) {
    const auto managers = std::min<std::size_t>(read(position, registers::description).sync_managers, 16);
    for (std::size_t i = 0; i != managers; ++i) {
        const auto sm = read(position, ethercat::nth(registers::sync_manager, i));
        if (sm.enable && sm.length != 0 && sm.mode != ethercat::sync_manager_mode::mailbox &&
            sm.direction == ethercat::sync_manager_direction::master_writes)
            return true;
    }
    return false;
}

ethercat::al_status ring::wait_for_state(std::uint16_t position,
                                         const std::function<bool(const ethercat::al_status&)>& is_it) {
    const auto end = jauscat::net::now() + options_.state_timeout;
    for (;;) {
        const auto now = read(position, registers::al_status);
        if (is_it(now) || jauscat::net::now() >= end || stop_requested()) return now;
        ::usleep(500);
    }
}

void ring::change_state(std::uint16_t position, ethercat::al_state goal) {
    const auto before = read(position, registers::al_status);
    if (before.error) {
        const auto from = is_known(before.state) ? before.state : ethercat::al_state::init;
        write(position, registers::al_control, {.state = from, .acknowledge = true});
        const auto now = wait_for_state(position, [](const auto& al) { return !al.error; });
        if (now.error)
            throw failure{name_of(position) + ": the error of AL status code " + al_code_text(now) +
                          " cannot be acknowledged; the slave is in " + state_text(now)};
    }
    write(position, registers::al_control, {.state = goal});
    const auto now = wait_for_state(position, [&](const auto& al) { return al.error || al.state == goal; });
    if (now.error)
        throw failure{name_of(position) + ": the state " + state_name(goal) + " was refused: AL status code " +
                      al_code_text(now) + "; the slave is in " + state_text(now)};
    if (now.state != goal)
        throw failure{name_of(position) + ": the state " + state_name(goal) + " was not reached in " +
                      std::to_string(options_.state_timeout.count()) + " ms; the slave is in " + state_text(now)};
}

void ring::refuse(const std::string& why) const {
    throw failure{options_.link + ": " + why + "; nothing was changed. Stop that master, or use --force", bus_in_use};
}

void ring::listen() {
    if (is_udp(options_.link)) return; // a slave answers to the sender alone
    std::array<std::byte, frame_room> in{};
    const auto end = jauscat::net::now() + milliseconds{100};
    for (auto now = jauscat::net::now(); now < end; now = jauscat::net::now())
        if (link_->receive(in, end - now) != 0) ++foreign;
    if (foreign != 0 && !options_.force)
        refuse("another master uses the link: " + std::to_string(foreign) + " of its frames were heard in 100 ms");
}

void ring::read_states() {
    datagram count{command::brd, 0, registers::type.address, bytes(1)};
    exchange({&count, 1});
    if (count.working_counter == 0)
        throw failure{options_.link + ": frames return, but no slave has taken part: check the cable and the power of "
                                      "the slaves"};
    constexpr std::uint16_t in_a_frame = 20;
    states_.clear();
    for (std::uint16_t first = 0; first < count.working_counter; first += in_a_frame) {
        std::vector<datagram> all;
        const auto end = std::min<std::uint16_t>(count.working_counter, first + in_a_frame);
        for (auto i = first; i != end; ++i) {
            all.push_back(read_of(i, registers::station_address.address, 4));
            all.push_back(read_of(i, registers::al_status.address, 6));
        }
        exchange(all);
        for (std::size_t i = 0; i != all.size(); i += 2) {
            if (all[i].working_counter != 1 || all[i + 1].working_counter != 1)
                throw failure{name_of(static_cast<std::uint16_t>(first + i / 2)) +
                              ": it does not answer to its position: check the cables behind it"};
            const std::span data{all[i].data};
            states_.push_back({decoded<ethercat::esc_word>(data).value,
                               decoded<ethercat::esc_word>(data.subspan(2)).value,
                               decoded<ethercat::al_status>(all[i + 1].data)});
        }
    }
}

bool ring::mailboxes_move() {
    // A mailbox that is filled or emptied changes the status byte of its SyncManager.
    constexpr std::uint16_t status = registers::sync_manager.address + 5, between = registers::sync_manager.size;
    std::vector<std::byte> before;
    const auto end = jauscat::net::now() + milliseconds{250};
    while (jauscat::net::now() < end && !stop_requested()) {
        std::array all{datagram{command::brd, 0, status, bytes(1)},
                       datagram{command::brd, 0, status + between, bytes(1)}};
        exchange(all);
        const std::vector now{all[0].data.front(), all[1].data.front()};
        if (!before.empty() && now != before) return true;
        before = now;
    }
    return false;
}

void ring::guard() {
    listen();
    read_states();
    if (options_.force) return;
    // Slaves that this program has taken to a state have no station address.
    const auto is_configured = [](const slave_state& one) {
        return one.al.state != ethercat::al_state::init && one.station != 0;
    };
    for (std::uint16_t i = 0; i != slaves(); ++i) {
        const auto& one = states_[i];
        if ((one.al.state == ethercat::al_state::op && (one.station != 0 || has_outputs(i))) ||
            (one.al.state == ethercat::al_state::safe_op && !one.al.error && one.station != 0))
            refuse("slave " + std::to_string(i) + " is in " + state_text(one.al) + ": a master seems to run it");
    }
    const auto found = std::ranges::find_if(states_, is_configured);
    if (found == states_.end()) return;
    const auto which = "slave " + std::to_string(found - states_.begin()) + " is in " + state_text(found->al) +
                       " and has the station address " + std::to_string(found->station);
    if (mailboxes_move()) refuse(which + ", and its mailbox is in use: a master runs it");
    if (foreign != 0) refuse("another master uses the link: its frames were heard");
    note(which + ": a program has left it so, and none uses it now");
}

void sleep_until(jauscat::time_point due) {
    for (auto now = jauscat::net::now(); now < due && !stop_requested(); now = jauscat::net::now())
        std::this_thread::sleep_for(std::min<jauscat::duration>(due - now, milliseconds{50}));
}

void note(std::string_view text) { std::cerr << "jauscat-ecat: " << text << "\n"; }

progress_line::~progress_line() {
    if (is_shown_) std::cerr << "\r\033[K" << std::flush;
}
void progress_line::show(const std::string& text) {
    static const bool is_terminal = ::isatty(STDERR_FILENO) == 1;
    const auto now = std::chrono::steady_clock::now();
    if (!is_terminal || now - last_ < milliseconds{200}) return;
    last_ = now;
    is_shown_ = true;
    std::cerr << "\r\033[K" << text << std::flush;
}

} // namespace ecat
