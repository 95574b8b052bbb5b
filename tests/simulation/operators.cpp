#include "simulation/operators.hpp"

namespace simulation {
namespace {

using std::chrono::milliseconds;

constexpr jaus::held_control_options control_options{.retry = {.interval = milliseconds{200}, .attempts = 3},
                                                     .renewal = milliseconds{150}};

jaus::set_emergency stop_order(bool with_code) {
    jaus::set_emergency made{};
    if (with_code) made.emergency_code.set(jaus::set_emergency_code::transition_to_emergency);
    return made;
}
jaus::clear_emergency end_order() {
    jaus::clear_emergency made{};
    made.emergency_code.set(jaus::clear_emergency_code::clear_emergency);
    return made;
}

} // namespace

intent next_intent(generator& random, bool has_control, bool holds_emergency, bool has_drives) {
    if (holds_emergency && random.below(4) == 0) return intent::clear_emergency;
    if (!has_control && random.below(3) == 0) return intent::ask_control;
    if (has_drives && random.below(16) == 0) return intent::reset; // of their faults
    struct weighted {
        intent what;
        unsigned weight;
    };
    constexpr std::array all{
        weighted{intent::move, 500},        weighted{intent::stop_moving, 30},   weighted{intent::standby, 40},
        weighted{intent::resume, 150},      weighted{intent::set_emergency, 25}, weighted{intent::clear_emergency, 15},
        weighted{intent::reset, 10},        weighted{intent::shutdown, 2},       weighted{intent::release, 20},
        weighted{intent::query_status, 60}, weighted{intent::query_efforts, 60}, weighted{intent::large_data, 20},
        weighted{intent::ask_control, 10}};
    unsigned sum = 0;
    for (const auto& one : all) sum += one.weight;
    unsigned drawn = random.below(sum);
    for (const auto& one : all) {
        if (drawn < one.weight) return one.what;
        drawn -= one.weight;
    }
    return intent::move;
}

// ---------------------------------------------------------------------------------------------------- of the library

operator_program::operator_program(world& w, network& n, model& m, const std::vector<place>& places, std::size_t which,
                                   const target_unit& target, bool sends_long_data)
    : node_program{w, n, m, places, which},
      id_{.instance = 1, .component = 32, .node = 1, .subsystem = places[which].jausip.subsystem},
      target_{target.id},
      joints_{target.joints},
      account_{m.add_sender(*this, id_)},
      judge_{w, *this, {.id = id_, .target = target_, .control = control_options, .places = most_waiting}},
      sends_long_data_{sends_long_data} {
    world_.in(world_.faults.pause(fault::mute_controller, std::chrono::seconds{5}), *this, to_mute);
}

void operator_program::add_components(net::node_machine& node) {
    memory_ = {};
    control_.emplace(id_, target_, control_options, control_listener_);
    jaus::component_options options{};
    options.acknowledgement.first_number = static_cast<std::uint16_t>(random_.next());
    judge_.starts(options.acknowledgement.first_number);
    core_.emplace(id_, memory_,
                  jaus::component_hooks{.on_delivered = jaus::bound<&operator_program::on_delivered>(*this)}, options,
                  *control_);
    watched_.emplace(*core_, application_);
    watched_->judge = &judge_;
    node.add(*watched_, application_);
    core_->change(jaus::state_event::initialized);
    holds_emergency_ = false;
}

void operator_program::remove_components() {
    model_.sender_dies(account_);
    watched_.reset();
    core_.reset();
    control_.reset();
}

std::optional<std::uint8_t> operator_program::sender_of(const jaus::address& source) const {
    return source == id_ ? std::optional{account_} : std::nullopt;
}

time operator_program::longest_wait() const {
    constexpr jaus::acknowledgement_options defaults{};
    return defaults.retry.total() + milliseconds{100};
}

jaus::message_outcome operator_program::application::operator()(const jaus::header& head, bytes body) const {
    if (head.command_code != large_code) return jaus::message_outcome::unhandled;
    mine.model_.delivers_large(mine, head, body);
    return jaus::message_outcome::handled;
}

void operator_program::changed_control(jaus::control_state state) {
    judge_.changed(state);
    if (state == jaus::control_state::asking) asks_since_ = run_time();
    world_.tell({.what = deed::control, .who = number(), .value = static_cast<std::uint32_t>(state)});
}

void operator_program::on_delivered(const jaus::awaited_message& message, jaus::delivered what) {
    judge_.delivered(message.header, what);
    if (what == jaus::delivered::timed_out) return model_.learns_nothing(account_, message.header);
    model_.learns(account_, message.header, what == jaus::delivered::acknowledged);
    if (what != jaus::delivered::acknowledged) return;
    if (message.header.command_code == jaus::command_code_of<jaus::set_emergency>) holds_emergency_ = true;
    if (message.header.command_code == jaus::command_code_of<jaus::clear_emergency>) holds_emergency_ = false;
}

void operator_program::large_data_done(const jaus::header& head, jaus::delivered what) {
    model_.learns_large(account_, head, what);
}

// What goes to the node's, seen by the judge.
auto operator_program::judged_out() {
    return [this](bytes message) {
        judge_.sends(message);
        node().out(now())(message);
    };
}

template <class Message> void operator_program::command(const Message& message, bool acknowledged) {
    const auto out = node().out(now());
    const jaus::header head{.destination = target_, .source = id_, .sequence_number = plain_number_++};
    if (!acknowledged) return static_cast<void>(jaus::put(head, message, out));
    judge_.begins_message();
    judge_.has_sent(core_->send(head, message, now(), judged_out()), jaus::command_code_of<Message>);
}

void operator_program::move(command_number number, bool acknowledged) {
    if (joints_ != 0) return command(velocities_of(number, joints_), acknowledged);
    command(efforts_of<jaus::set_wrench_effort>(number), acknowledged);
}

void operator_program::query_motion() {
    if (joints_ != 0) return command(jaus::query_joint_velocities{}, false);
    command(query_of_efforts(random_), false);
}

void operator_program::send_large() {
    constexpr std::uint32_t one_in = 4;
    const bool is_long = sends_long_data_ && random_.below(one_in) == 0;
    const std::size_t packets = is_long ? 257 + random_.below(16) : 1;
    large_.resize(packets * jaus::max_body_size + 1 + random_.below(is_long ? jaus::max_body_size : 20'000));
    const auto identity = std::uint64_t{account_} << 32U | ++large_made_;
    fill_large(large_, identity);
    const bool asks = random_.below(4) != 0;
    const jaus::header head{.ack_nak = asks ? jaus::ack_nak::request : jaus::ack_nak::none,
                            .command_code = large_code,
                            .destination = target_,
                            .source = id_};
    if (node().send(head, large_, now())) model_.sends_large(account_, head, identity);
}

// A request that nobody answers comes to an end.
void operator_program::check_control() {
    if (control_->state() != jaus::control_state::asking) return;
    if (run_time() - asks_since_ > 4 * milliseconds{200} + milliseconds{100})
        world_.breaks({.point = contract::s6,
                       .who = number(),
                       .expected = "a request for control ends after three attempts of 200 ms",
                       .found = "it is still asking"});
}

void operator_program::ask_control() {
    const auto authority = static_cast<std::uint8_t>(1 + random_.below(200));
    judge_.asks(authority);
    control_->ask(authority, now(), judged_out());
    judge_.has_done();
}
void operator_program::release_control() {
    judge_.releases();
    control_->release(judged_out());
    judge_.has_done();
}

void operator_program::act() {
    if (watched_->mute) return;
    check_control();
    const bool sure = random_.below(5) < 3;
    const bool has_control = control_->state() == jaus::control_state::held;
    switch (next_intent(random_, has_control, holds_emergency_, joints_ != 0)) {
    case intent::ask_control:
        if (control_->state() == jaus::control_state::asking) return;
        return ask_control();
    case intent::move: return move(model_.new_command(), sure);
    case intent::stop_moving: return move(0, sure);
    case intent::standby: return command(jaus::standby{}, sure);
    case intent::resume: return command(jaus::resume{}, sure);
    case intent::set_emergency: return command(stop_order(random_.below(4) != 0), sure);
    case intent::clear_emergency: return command(end_order(), true);
    case intent::reset: return command(jaus::reset{}, sure);
    case intent::shutdown: return command(jaus::shutdown{}, sure);
    case intent::release:
        if (has_control) release_control();
        return;
    case intent::query_status: return command(jaus::query_component_status{}, false);
    case intent::query_efforts: return query_motion();
    case intent::large_data: return send_large();
    }
}

void operator_program::own_event(std::uint8_t what, std::uint32_t argument) {
    if (what == to_speak) {
        if (argument != life() || !watched_ || !watched_->mute) return;
        watched_->mute = false;
        asks_since_ = run_time();
        model_.speaks(account_);
        judge_.speaks();
        node().wake(now());
        if (running()) rearm();
        return;
    }
    world_.in(world_.faults.pause(fault::mute_controller, std::chrono::seconds{5}), *this, to_mute);
    if (!running() || watched_->mute || !world_.faults.strikes(fault::mute_controller, 100'000)) return;
    watched_->mute = true;
    model_.mutes(account_);
    judge_.mutes();
    world_.tell({.what = deed::goes_mute, .who = number()});
    world_.in(world_.faults.random(fault::mute_controller).between(milliseconds{100}, std::chrono::seconds{5}), *this,
              to_speak, life());
}

// ---------------------------------------------------------------------------------------------------- not of the
// library

foreign_operator::foreign_operator(world& w, network& n, model& m, const jaus::address& self, const target_unit& target,
                                   std::uint8_t target_port, std::string name)
    : process{w, n, std::move(name)},
      model_{m},
      id_{self},
      target_{target.id},
      joints_{target.joints},
      target_port_{target_port},
      account_{m.add_sender(*this, id_, true)} {}

void foreign_operator::boot() {
    all_zero_ = world_.faults.strikes(fault::number_zero, 200'000);
    const bool begins_as_before = !all_zero_ && life() != 1 && world_.faults.strikes(fault::same_numbers, 300'000);
    number_ = static_cast<std::uint16_t>(begins_as_before ? number_ - random_.below(20) : random_.next());
    waiting_ = {};
    controls_ = holds_emergency_ = false;
    renews_ = random_.below(2) == 0;
    renew_at_ = time::max();
    pulse_at_ = local();
}

void foreign_operator::receive(const datagram& one) {
    const auto m = jaus::split(one.content());
    if (!m || m.header.destination != id_ || m.header.source != target_) return;
    const auto& head = m.header;
    if (jaus::is_acknowledgement(head)) {
        jaus::header mine{};
        if (waiting_.size == 0 || !wire::decode_prefix(mine, bytes{waiting_.bytes})) return;
        if (mine.command_code != head.command_code || mine.sequence_number != head.sequence_number) return;
        const bool acknowledged = head.ack_nak == jaus::ack_nak::ack;
        model_.learns(account_, mine, acknowledged);
        waiting_.size = 0;
        if (acknowledged && mine.command_code == jaus::command_code_of<jaus::set_emergency>) holds_emergency_ = true;
        if (acknowledged && mine.command_code == jaus::command_code_of<jaus::clear_emergency>) holds_emergency_ = false;
        return;
    }
    switch (head.command_code) {
    case jaus::command_code_of<jaus::confirm_component_control>: {
        jaus::confirm_component_control answer{};
        controls_ =
            wire::decode(answer, m.body) && answer.response_code == jaus::component_control_response::control_accepted;
        renew_at_ = controls_ && renews_ ? local() + milliseconds{150} : time::max();
        return;
    }
    case jaus::command_code_of<jaus::reject_component_control>:
        controls_ = false;
        renew_at_ = time::max();
        return;
    case jaus::command_code_of<jaus::query_heartbeat_pulse>: return put(head.source, jaus::report_heartbeat_pulse{});
    default: return;
    }
}

void foreign_operator::run() {
    const auto now = local();
    if (now >= pulse_at_) {
        pulse_at_ = now + std::chrono::seconds{1};
        put({.instance = 1, .component = 1, .node = target_.node, .subsystem = target_.subsystem},
            jaus::report_heartbeat_pulse{});
    }
    if (now >= renew_at_) {
        renew_at_ = now + milliseconds{150};
        put(target_, jaus::request_component_control{authority_});
    }
    if (waiting_.size == 0 || now < waiting_.due) return;
    if (waiting_.sent == 4) {
        jaus::header mine{};
        if (wire::decode_prefix(mine, bytes{waiting_.bytes})) model_.learns_nothing(account_, mine);
        waiting_.size = 0;
        return;
    }
    ++waiting_.sent;
    waiting_.due = now + milliseconds{200};
    send(bytes{waiting_.bytes}.first(waiting_.size));
}

std::optional<time> foreign_operator::next() {
    time first = std::min(pulse_at_, renew_at_);
    if (waiting_.size != 0) first = std::min(first, waiting_.due);
    return first;
}

void foreign_operator::send(bytes message) {
    const auto number = model_.hands_over(account_, message);
    network_.send(port(), target_port_, message, number);
    if (!world_.faults.strikes(fault::message_doubled, 50'000)) return;
    network_.send(port(), target_port_, message, number);
}

// Some programs send bodies that are too short or too long, with the size of their header right or wrong.
std::size_t foreign_operator::spoil(std::span<std::byte> message, std::size_t size) {
    if (size == jaus::header_size || !world_.faults.strikes(fault::body_malformed, 20'000)) return size;
    auto& random = world_.faults.random(fault::body_malformed);
    const bool is_short = random.below(2) == 0;
    const auto most = is_short ? size - jaus::header_size : message.size() - size;
    const auto by = 1 + random.below(static_cast<unsigned>(most));
    const auto made = is_short ? size - by : size + by;
    jaus::header head{};
    if (random.below(2) == 0 || !wire::decode_prefix(head, bytes{message})) return made;
    head.data_size = static_cast<std::uint16_t>(made - jaus::header_size);
    static_cast<void>(wire::encode(head, message));
    return made;
}

template <class Message> void foreign_operator::put(const jaus::address& to, const Message& message) {
    static_cast<void>(
        jaus::put({.destination = to, .source = id_, .sequence_number = all_zero_ ? std::uint16_t{} : number_++},
                  message, [this](bytes whole) {
                      std::array<std::byte, 128> made{};
                      std::ranges::copy(whole, made.begin());
                      send(bytes{made}.first(spoil(made, whole.size())));
                  }));
}

template <class Message> void foreign_operator::command(const Message& message, bool acknowledged) {
    if (!acknowledged) {
        world_.faults.note(fault::kinds_mixed);
        return put(target_, message);
    }
    if (waiting_.size != 0) return;
    if (all_zero_) world_.faults.note(fault::number_zero);
    const auto made = jaus::make_message({.ack_nak = jaus::ack_nak::request,
                                          .destination = target_,
                                          .source = id_,
                                          .sequence_number = all_zero_ ? std::uint16_t{} : number_++},
                                         message, waiting_.bytes);
    if (!made) return;
    waiting_.size = spoil(waiting_.bytes, made->size());
    waiting_.sent = 1;
    waiting_.due = local() + milliseconds{200};
    send(bytes{waiting_.bytes}.first(waiting_.size));
}

void foreign_operator::move(command_number number, bool acknowledged) {
    if (joints_ != 0) return command(velocities_of(number, joints_), acknowledged);
    command(efforts_of<jaus::set_wrench_effort>(number), acknowledged);
}

void foreign_operator::query_motion() {
    if (joints_ != 0) return put(target_, jaus::query_joint_velocities{});
    put(target_, query_of_efforts(random_));
}

void foreign_operator::act() {
    const bool sure = random_.below(5) < 3;
    switch (next_intent(random_, controls_, holds_emergency_, joints_ != 0)) {
    case intent::ask_control:
        authority_ = static_cast<std::uint8_t>(1 + random_.below(200));
        return put(target_, jaus::request_component_control{authority_});
    case intent::move:
        if (random_.below(6) == 0) // several at once wait behind one another
            for (unsigned i = 0; i != 2; ++i) move(model_.new_command(), false);
        return move(model_.new_command(), sure);
    case intent::stop_moving: return move(0, sure);
    case intent::standby: return command(jaus::standby{}, sure);
    case intent::resume: return command(jaus::resume{}, sure);
    case intent::set_emergency: return command(stop_order(random_.below(4) != 0), sure);
    case intent::clear_emergency: return command(end_order(), true);
    case intent::reset: return command(jaus::reset{}, sure);
    case intent::shutdown: return command(jaus::shutdown{}, sure);
    case intent::release:
        controls_ = false;
        renew_at_ = time::max();
        return put(target_, jaus::release_component_control{});
    case intent::query_status: return put(target_, jaus::query_component_status{});
    case intent::query_efforts: return query_motion();
    case intent::large_data: return;
    }
}

} // namespace simulation
