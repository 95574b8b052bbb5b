// What ought to be: who sent what, who may command, what an actuator really does. Written apart from the library, from
// what can be seen from outside: bytes that programs hand over, bytes that they are given, efforts in force.
#pragma once

#include "simulation/large_data.hpp"
#include "simulation/messages.hpp"
#include "simulation/process.hpp"
#include "simulation/ring.hpp"
#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/jaus/component/component_options.hpp>
#include <jauscat/jaus/component/component_outcome.hpp>

#include <array>
#include <map>
#include <vector>

namespace simulation {

/// A message that a program has sent, whatever number of copies.
struct sent_message {
    std::uint32_t number{};
    std::uint8_t sender{}; ///< index of the account
    std::uint32_t life{};  ///< of the sender's process
    jaus::address source{}, destination{};
    std::uint16_t code{}, sequence_number{};
    bool wants_acknowledgement{};
    bool was_refused{};  ///< at once, as it came
    bool is_malformed{}; ///< a motion command whose body is none
    std::uint64_t digest{};
    time at{};
    command_number command{};
    // What became of it:
    bool stopped_it{};      ///< it has taken its actuator out of Ready, or into an emergency
    bool state_was_right{}; ///< of the component, when it had the message
    bool done{};            ///< the actuator has done what it says
    unsigned executed{};    ///< how often, in one life of the actuator
    time executed_at{};
    time arrived_at{};
    bool acknowledged{}; ///< by its actuator
    bool closed{};       ///< its sender has the outcome
};

/// A large data set that a program has sent.
struct sent_large {
    std::uint64_t identity{};
    jaus::address destination{};
    std::uint16_t code{};
    std::uint32_t life{};
    bool wants_acknowledgement{};
    time at{};
    bool closed{};
    unsigned delivered{};
    time delivered_at{};
};

/// Who sends.
struct sender_account {
    const process* program{};
    jaus::address id{};
    bool repeats_late{};                   ///< also what receivers need not remember any more
    std::array<std::uint32_t, 128> last{}; ///< numbers of messages
    std::uint32_t count{};
    std::vector<std::pair<std::uint32_t, time>> open{}; ///< message, and run time when there must be an outcome
    std::optional<time> mute_since{};
    std::vector<sent_large> large{}; ///< the last ones
};

/// Who has set an emergency.
struct emergency_holder {
    jaus::address id{};
    time since{};
    bool may_be_lost{}; ///< the actuator may have given it up
};

/// An axis of an actuator that slaves of a ring are: a drive's, or a whole arm.
struct axis_account {
    std::size_t slave{};      ///< of the ring
    std::size_t axis{};       ///< of the slave
    command_number command{}; ///< in force; 0: at rest
    time left_seen{};         ///< ring_place::left_at that was checked
};

/// An actuator, as far as it shows.
struct actuator_account {
    const process* program{};
    jaus::address id{};
    std::uint8_t port{};
    std::uint8_t number{}; ///< of the actor
    // Where it is one slave of a ring or several:
    const ring* wire{};
    std::vector<axis_account> axes{};
    time at_rest_in{}; ///< how long after it is lost, or told to stop, it must be at rest
    time noticed_in{}; ///< how long after a slave is lost its component is not Ready
    time fresh_for{};  ///< how old a reported value may be
    time two_cycles{}; ///< until the loss of an address or a state is noticed
    time reset_at{};   ///< it has got Reset
    time cycle{};      ///< between two frames with process data; 0: efforts are reported by mailbox
    // How it is made:
    time controller_limit{}; ///< how long after its controller is lost it must be at rest
    time control_timeout{};  ///< after which a silent controller is lost
    // What was seen:
    jaus::primary_status_code state{};
    command_number command{};                 ///< in force; 0: at rest
    std::uint8_t commander{};                 ///< account of who sent it
    std::optional<std::uint8_t> controller{}; ///< account
    std::optional<time> orphaned_since{}; ///< the efforts in force: their controller is lost, and has control no more
    std::uint8_t authority{};
    std::vector<emergency_holder> holders{};
    // The message that is being handled:
    std::uint32_t current{};
    jaus::header head{};
    bool acknowledged{}, refused{}, was_repeat{};
    std::vector<std::uint32_t> arrived{}; ///< messages that request acknowledgement, see note_arrival
    // What was in force, and when:
    time failed_since{}, not_ready_since{}, rest_seen_at{}, emergency_seen_at{}, controlled_since{};
    time entered_at{};       ///< its state
    time lost_since{};       ///< its slave, or a drive has had a fault
    time controller_heard{}; ///< it has got a message of its controller
    time controller_gone{};  ///< its node no longer hears its controller
    time troubled_at{};      ///< one of its slaves could not be commanded
    std::array<std::pair<time, command_number>, 32> efforts{};
    std::uint32_t effort_count{};
};

/// See actuator_account.
struct ring_times {
    time at_rest_in{}, noticed_in{}, fresh_for{}, two_cycles{}, cycle{}, control_timeout{};
};

class model {
  public:
    model(world& w, network& n) : world_{w}, network_{n} {}

    std::uint8_t add_sender(const process& program, const jaus::address& id, bool repeats_late = false) {
        senders_.push_back({.program = &program, .id = id, .repeats_late = repeats_late});
        return static_cast<std::uint8_t>(senders_.size() - 1);
    }
    std::uint8_t add_actuator(const process& program, const jaus::address& id, std::uint8_t number, time limit) {
        actuators_.push_back({.program = &program,
                              .id = id,
                              .port = program.port(),
                              .number = number,
                              .controller_limit = limit,
                              .control_timeout = limit});
        return static_cast<std::uint8_t>(actuators_.size() - 1);
    }
    /// The actuator is these axes of slaves, behind a component at this port.
    void stands_behind(std::uint8_t which, std::uint8_t port, const ring& wire, std::vector<axis_account> axes,
                       const ring_times& times) {
        auto& a = actuators_[which];
        a.port = port;
        a.wire = &wire;
        a.axes = std::move(axes);
        a.at_rest_in = times.at_rest_in;
        a.noticed_in = times.noticed_in;
        a.fresh_for = times.fresh_for;
        a.two_cycles = times.two_cycles;
        a.cycle = times.cycle;
        a.control_timeout = times.control_timeout;
    }
    [[nodiscard]] const actuator_account& actuator(std::uint8_t which) const { return actuators_[which]; }
    /// For how long nothing has happened to a slave of its ring, a frame or its program; 0 where something lasts.
    [[nodiscard]] time quiet_for(std::uint8_t which) const;

    /// For a new motion command.
    command_number new_command() noexcept { return commands_ = commands_ % (numbers_of_commands - 1) + 1; }

    // ---- what senders do
    /// A program hands a message over; `must_end_in`: it has to learn the outcome. Returns the message's number, 0
    /// where the model does not follow it.
    std::uint32_t hands_over(std::uint8_t sender, bytes message, time must_end_in = {});
    /// A program learns what became of one of its messages.
    void learns(std::uint8_t sender, const jaus::header& head, bool acknowledged);
    void learns_nothing(std::uint8_t sender, const jaus::header& head);
    void sender_dies(std::uint8_t sender) {
        senders_[sender].open.clear();
        senders_[sender].mute_since.reset();
    }
    /// Its component does nothing any more, while its node goes on; and the end of that.
    void mutes(std::uint8_t sender) {
        senders_[sender].open.clear();
        senders_[sender].mute_since = world_.now();
    }
    void speaks(std::uint8_t sender) { sender_dies(sender); }

    // ---- large data sets
    void sends_large(std::uint8_t sender, const jaus::header& head, std::uint64_t identity);
    void learns_large(std::uint8_t sender, const jaus::header& head, jaus::delivered what);
    /// A component gets a whole one.
    void delivers_large(const process& at, const jaus::header& head, bytes body);

    // ---- what an actuator's component is given and gives
    void starts(std::uint8_t which);
    void arrives(std::uint8_t which, std::uint32_t message, const jaus::header& head);
    void answers(std::uint8_t which, bytes message);
    void handled(std::uint8_t which, jaus::component_outcome what = jaus::component_outcome::handled);
    /// A command is not executed; `why`: a literal.
    void drops(std::uint8_t which, const jaus::header& head, const char* why);
    /// A command is merged with the one before, which the slave has not executed.
    void merges(std::uint8_t which, const jaus::header& head);
    /// What its motors do: the application got a command, or has brought them to rest.
    void executes(std::uint8_t which, command_number command);
    void rests(std::uint8_t which);
    /// Of an axis of a ring: the efforts of this command are in force now.
    void moves_to(std::uint8_t which, std::size_t axis, command_number command);
    /// Its program ends, which was told to at `told`.
    void ends(std::uint8_t which, time told);
    void enters(std::uint8_t which, jaus::primary_status_code from, jaus::primary_status_code to);
    void controlled(std::uint8_t which, const std::optional<jaus::address>& now);
    /// Its node no longer hears somebody.
    void hears_lost(std::uint8_t which, const jaus::address& who);
    /// Somebody at the machine ends the emergency.
    void person_clears(std::uint8_t which);

    /// After each step.
    void check();

  private:
    [[nodiscard]] sent_message* find(std::uint32_t number) noexcept {
        auto& one = sent_[number % sent_.size()];
        return number != 0 && one.number == number ? &one : nullptr;
    }
    [[nodiscard]] std::optional<std::uint8_t> account_of(const jaus::address& id) const noexcept;
    [[nodiscard]] std::optional<time> unreachable_since(std::uint8_t sender, const actuator_account& to) const;
    void note_arrival(actuator_account& a, std::uint32_t message);
    void tell_choice(const actuator_account& a, const sent_message& sent, jaus::component_outcome what);
    void acknowledged(actuator_account& a, std::uint32_t number);
    void later_acknowledged(actuator_account& a, const jaus::header& head);
    [[nodiscard]] bool has_effect(const actuator_account& a, const sent_message& sent) const;
    [[nodiscard]] static bool state_is_right(const actuator_account& a, std::uint16_t code);
    void look(actuator_account& a) const;
    void note_efforts(actuator_account& a, command_number command);
    [[nodiscard]] bool has_address_of_another(const actuator_account& a) const;
    void obeys(actuator_account& a, const sent_message* sent, command_number command);
    [[nodiscard]] static const arm_unit* arm_of(const actuator_account& a);
    [[nodiscard]] static bool was_told_to_rest(const actuator_account& a, time since);
    [[nodiscard]] static bool any_slave(const actuator_account& a, auto&& is) {
        return std::ranges::any_of(a.axes, [&](const axis_account& each) { return is((*a.wire)[each.slave]); });
    }
    // Whether `says(command)` was true of the efforts at some time since.
    template <class Says>
    [[nodiscard]] bool were_in_force(const actuator_account& a, time since, const Says& says) const;
    [[nodiscard]] bool is_like_one_before(const sent_message& sent) const;
    [[nodiscard]] bool was_on_its_way(const actuator_account& a, const sent_message& sent, time changed,
                                      time limit) const;
    [[nodiscard]] static time last_disturbance(const actuator_account& a);
    void check_asked_for(const actuator_account& a, const jaus::header& answer);
    void check_efforts(const actuator_account& a, bytes body);
    void check_told(actuator_account& a);
    void check_ready(const actuator_account& a, time since);
    void check_control_is_kept(const actuator_account& a);
    void check_large(const sender_account& account);
    /// Nothing has happened to the two programs and between them since a second before it was sent.
    [[nodiscard]] bool is_undisturbed(const sender_account& account, const sent_large& one) const;
    void check_known(const actuator_account& a);
    void check_cause(const actuator_account& a, const char* of);
    void check_kept(actuator_account& a);
    void check_watchdog(const actuator_account& a);
    void check_return(const actuator_account& a);
    [[nodiscard]] static time sent_unaware_since(const actuator_account& a);
    void check_axis(const actuator_account& a, const axis_account& axis);
    void check_stop(const actuator_account& a, const axis_account& axis, const char* why, time since, time limit);
    void check_velocities(const actuator_account& a, bytes body);
    void confirmed(actuator_account& a, const jaus::header& head, bytes body);
    void take_emergency_codes(actuator_account& a, const sent_message& sent);
    void reported(const actuator_account& a, const jaus::header& head, bytes body);
    void tell(std::uint8_t which, deed what, const jaus::header& head, const char* why);
    void breaks(contract point, const actuator_account& a, std::uint32_t message, std::string expected,
                std::string found);
    void breaks(contract point, const sender_account& s, std::uint32_t message, std::string expected,
                std::string found);
    [[nodiscard]] bool has_not_paused(const jaus::address& source) const;
    [[nodiscard]] bool must_be_remembered(const actuator_account& a, const sent_message& sent) const;
    void check_senders();
    void check_actuator(actuator_account& a);
    void look_for_lost_holders(actuator_account& a);

    world& world_;
    network& network_;
    std::vector<sender_account> senders_{};
    std::vector<actuator_account> actuators_{};
    std::vector<sent_message> sent_ = std::vector<sent_message>(std::size_t{1} << 14U);
    std::vector<std::uint32_t> of_command_ = std::vector<std::uint32_t>(std::size_t{1} << 14U);
    std::uint32_t numbers_{};
    command_number commands_{};
    time checked_{};
};

} // namespace simulation
