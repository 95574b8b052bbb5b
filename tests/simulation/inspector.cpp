#include "simulation/inspector.hpp"

#include <jauscat/jaus/component/component_clock.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

namespace simulation {

using std::chrono::milliseconds;

inspector::inspector(world& w, network& n, model& m, const jaus::address& self, const target_unit& target,
                     std::uint8_t target_port, const process& target_program, const jaus::address& bystander,
                     std::uint8_t bystander_port)
    : process{w, n, "inspector"},
      model_{m},
      id_{self},
      target_{target.id},
      joints_{target.joints},
      target_port_{target_port},
      account_{m.add_sender(*this, id_, true)},
      target_program_{target_program},
      bystander_{bystander},
      bystander_port_{bystander_port} {}

void inspector::boot() {
    number_ = static_cast<std::uint16_t>(random_.next());
    holds_emergency_ = false;
    pulse_at_ = local();
    again_at_ = time::max();
    asked_.clear();
}

void inspector::receive(const datagram& one) {
    const auto m = jaus::split(one.content());
    if (!m || m.header.destination != id_ || m.header.source != target_) return;
    if (!jaus::is_acknowledgement(m.header)) {
        const auto count = std::erase_if(asked_, [&](const asked_report& each) {
            return each.code == m.header.command_code && each.number == m.header.sequence_number;
        });
        if (count != 0) world_.compares(comparison::query_answered);
        return;
    }
    model_.learns(account_, m.header, m.header.ack_nak == jaus::ack_nak::ack);
}

void inspector::run() {
    const auto now = local();
    if (now >= pulse_at_) {
        pulse_at_ = now + std::chrono::seconds{1};
        static_cast<void>(jaus::put({.destination = {1, 1, target_.node, target_.subsystem}, .source = id_},
                                    jaus::report_heartbeat_pulse{},
                                    [this](bytes whole) { network_.send(port(), target_port_, whole, 0); }));
    }
    if (now < again_at_) return;
    again_at_ = time::max();
    network_.send(port(), target_port_, bytes{last_}.first(last_size_), last_number_);
}

void inspector::send(bytes message) {
    last_number_ = model_.hands_over(account_, message);
    network_.send(port(), target_port_, message, last_number_);
}

jaus::header inspector::new_head() {
    jaus::header head{.destination = target_, .source = id_};
    if (random_.below(8) != 0) ++number_; // sometimes the number of the message before
    head.sequence_number = random_.below(16) == 0 ? std::uint16_t{} : number_;
    head.ack_nak = random_.below(2) == 0 ? jaus::ack_nak::request : jaus::ack_nak::none;
    head.experimental = random_.below(40) == 0;
    head.priority = static_cast<std::uint8_t>(random_.below(12));
    return head;
}

template <class Message> void inspector::put(const Message& message) {
    const auto made = jaus::make_message(new_head(), message, last_);
    if (!made) return;
    last_size_ = made->size();
    send(*made);
    if (random_.below(4) == 0) again_at_ = local() + random_.between(time{}, milliseconds{2500});
}

// Of any code, without a body.
void inspector::put_code(std::uint16_t code) {
    auto head = new_head();
    head.command_code = code;
    const auto made = wire::encode(head, last_);
    if (!made) return;
    last_size_ = made->size();
    send(*made);
}

void inspector::move() {
    const auto command = model_.new_command();
    if (joints_ != 0) return put(velocities_of(command, joints_));
    put(efforts_of<jaus::set_wrench_effort>(command));
}

void inspector::command_state() {
    jaus::clear_emergency clear{};
    if (random_.below(4) != 0) clear.emergency_code.set(jaus::clear_emergency_code::clear_emergency);
    if (std::exchange(holds_emergency_, false)) return put(clear);
    switch (random_.below(24)) {
    case 0: {
        jaus::set_emergency order{};
        if (random_.below(4) != 0) order.emergency_code.set(jaus::set_emergency_code::transition_to_emergency);
        holds_emergency_ = true;
        return put(order);
    }
    case 1:
    case 2: return put(clear);
    case 3:
        if (random_.below(8) == 0) return put(jaus::shutdown{});
        return put(jaus::reset{});
    case 4: return put(jaus::reset{});
    case 5:
    case 6:
    case 7: return put(jaus::standby{});
    default: return put(jaus::resume{});
    }
}

// With one stamp or both, and some that are none.
void inspector::set_time() {
    constexpr time start = std::chrono::hours{24} * 365 * 40, most = std::chrono::hours{24} * 60;
    const auto stamps = jaus::stamps_of(jaus::civil_time{start + world_.now() + random_.between(-most, most)});
    jaus::set_time order{stamps.time_stamp, stamps.date_stamp};
    const auto what = random_.below(8);
    if (what == 0) order.time_stamp.reset();
    if (what == 1) order.date_stamp.reset();
    if (what == 2) order.time_stamp->day = 0;
    if (what == 3) order.time_stamp->day = static_cast<std::uint8_t>(1 + random_.below(31));
    if (what == 4) order.date_stamp->month = static_cast<std::uint8_t>(random_.below(16));
    if (what == 5) order.time_stamp->hours = static_cast<std::uint8_t>(random_.below(32));
    if (what == 6) order.time_stamp->seconds = static_cast<std::uint8_t>(random_.below(64));
    put(order);
}

// A query of the core services, which each component answers at once.
template <class Message> void inspector::ask(const Message& query) {
    put(query);
    jaus::header head{};
    if (!wire::decode_prefix(head, bytes{last_}) || head.experimental) return;
    asked_.push_back({static_cast<std::uint16_t>(head.command_code + 0x2000), head.sequence_number, world_.now()});
}

template <class Message> void inspector::tell_bystander(const Message& message) {
    static_cast<void>(jaus::put({.destination = bystander_, .source = id_, .sequence_number = ++number_}, message,
                                [this](bytes whole) { network_.send(port(), bystander_port_, whole, 0); }));
}

void inspector::check() {
    constexpr time to_answer = milliseconds{20}, before = std::chrono::seconds{1};
    while (!asked_.empty() && world_.now() - asked_.front().at > to_answer) {
        const auto one = asked_.front();
        asked_.erase(asked_.begin());
        const bool is_cut = network_.cut_since(port(), target_port_) || network_.cut_since(target_port_, port());
        if (is_cut || !running() || !target_program_.running()) continue;
        const time last =
            std::max({jumped_at(), target_program_.jumped_at(), network_.disturbed_at(port(), target_port_)});
        if (last + before > one.at) continue;
        world_.compares(comparison::query_answered);
        world_.breaks({.point = contract::availability,
                       .who = number(),
                       .expected = "an answer to a query of which nothing was lost",
                       .found = "no report of command code " + std::to_string(one.code)});
    }
}

void inspector::act() {
    constexpr std::array<std::uint16_t, 10> codes{0x0404, 0x0406, 0x0602, 0x0B00, 0x0E01,
                                                  0x0E02, 0x2404, 0x4404, 0xD200, 0x0011};
    switch (random_.below(20)) {
    case 0: return ask(jaus::query_component_control{});
    case 1: return ask(jaus::query_component_authority{});
    case 2: return ask(jaus::query_component_status{});
    case 3:
    case 4: return ask(jaus::query_time{static_cast<std::uint8_t>(random_.below(8))});
    case 5: return set_time();
    case 6: return put(jaus::set_component_authority{static_cast<std::uint8_t>(random_.below(256))});
    case 7: return put(jaus::request_component_control{static_cast<std::uint8_t>(random_.below(256))});
    case 8: return put(jaus::release_component_control{});
    case 9: return put_code(codes[random_.below(codes.size())]);
    case 10: return put(jaus::report_heartbeat_pulse{});
    case 11: return move();
    case 12: return put(query_of_efforts(random_));
    case 13: return ask(jaus::query_identification{jaus::query_type::component_identification});
    case 14: return ask(jaus::query_services{});
    case 15: return ask(jaus::query_heartbeat_pulse{});
    case 16: {
        if (random_.below(3) == 0) return tell_bystander(jaus::reject_component_control{});
        const auto what = random_.below(2) == 0 ? jaus::component_control_response::control_accepted
                                                : jaus::component_control_response::control_not_accepted;
        return tell_bystander(jaus::confirm_component_control{what});
    }
    default: return command_state();
    }
}

} // namespace simulation
