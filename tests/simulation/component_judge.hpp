// Judges a component by the messages that it gets: what it sends, its state and its controller have to be those of a
// reference, made from the tables of docs/jaus-node.md and docs/safety.md and apart from the library.
#pragma once

#include "simulation/messages.hpp"
#include "simulation/process.hpp"
#include "simulation/unit_judge.hpp"
#include <jauscat/jaus/component/component_control.hpp>
#include <jauscat/jaus/component/component_outcome.hpp>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simulation {

/// How a judged component is made.
struct judged_component {
    jaus::address id{};
    std::uint8_t number{};                     ///< of the actor
    time timeout{};                            ///< of a silent controller
    std::span<const std::uint16_t> harmless{}; ///< private messages that move nothing
    std::size_t remembered{};                  ///< messages that it can remember
    bool has_slaves{};                         ///< a bridge's: it executes later, fails and returns by itself
    /// What the application makes of a message that is not the core's; nothing where that is not followed.
    std::function<std::optional<jaus::component_outcome>(const jaus::header&, bytes)> application{};
};

class component_judge final : public unit_judge {
  public:
    component_judge(world& w, const process& program, judged_component what)
        : world_{w}, program_{program}, what_{std::move(what)} {}

    /// Its program begins: it knows nothing of an earlier life.
    void starts();

    // What the component does between a call and its `has_...` is compared then.
    void gets(const jaus::header& head, bytes body) override;
    void has_handled(jaus::component_outcome what) override;
    void runs() override;
    void has_run() override;
    void loses(const jaus::address& who) override;
    void has_lost() override;
    /// The application says that it is initialized, or ends the emergency for a person at the machine.
    void initializes();
    void ends_emergency();
    void has_changed();

    // What the component does.
    void sends(bytes message) override;
    void enters(jaus::primary_status_code from, jaus::primary_status_code to);
    void controlled(const std::optional<jaus::controller>& now, jaus::control_change why);

    /// Whether a sender is silent without a query of its pulse, or without its loss.
    void check();

  private:
    using state_code = jaus::primary_status_code;
    enum class phase : std::uint8_t { none, message, run, loss, application };
    struct watch {
        time heard{};
        std::int64_t asked{}; ///< quarters of the timeout
        unsigned pulses{};    ///< queried and not yet received
    };
    struct mover {
        jaus::address id{};
        watch life{};
    };
    struct reference {
        state_code state{}, before{};
        std::vector<jaus::address> holders{};
        bool is_anyones{}; ///< the emergency of a holder that is lost
        std::optional<jaus::controller> controller{};
        watch life{};
        std::optional<mover> moved_by{}; ///< whose motion command is in force
        std::uint8_t authority{};
        std::optional<time> clock{}; ///< JAUS time at local time 0
        bool has_time{}, has_date{};
    };
    struct transition {
        state_code from{}, to{};
        friend bool operator==(const transition&, const transition&) = default;
    };
    struct control_call {
        std::optional<jaus::controller> now{};
        jaus::control_change why{};
        friend bool operator==(const control_call&, const control_call&) = default;
    };
    using message_bytes = std::vector<std::byte>;
    struct expectation {
        std::optional<jaus::component_outcome> outcome{};
        std::vector<message_bytes> replies{};
        std::optional<transition> entered{};
        std::optional<control_call> control{};
        bool is_repeat{};
        bool may_be_repeat{}; ///< its number does not tell
        std::optional<jaus::ack_nak> answer_before{};
    };
    /// A message that asked for an acknowledgement.
    struct remembered_message {
        jaus::address source{};
        std::uint16_t code{}, number{};
        std::uint64_t digest{};
        time at{}; ///< of its answer
        bool is_pending{};
        jaus::ack_nak answer{};
    };
    struct sent_message {
        jaus::header head{};
        message_bytes whole{};
        std::size_t after{}; ///< how many changes had been told before it
    };
    struct unsure_source {
        jaus::address id{};
        time until{};
    };

    void begin(phase what);
    void compare(bool is_whole);
    void compare_replies();
    void compare_answer(jaus::component_outcome what);
    void compare_changes();
    void settle(const jaus::header& answer);
    void handle(const jaus::header& head, bytes body);
    void take_state_command(const jaus::header& head, bytes body);
    void take_control_message(const jaus::header& head, bytes body);
    void take_time(const jaus::header& head, bytes body);
    void enter(state_code to);
    void hear(const jaus::header& head, bytes body);
    void look_at_silence(watch& life, const jaus::address& who, auto&& lose);
    [[nodiscard]] std::optional<jaus::component_outcome> refused_by_rule(const jaus::header& head) const;
    [[nodiscard]] bool controls(const jaus::address& who) const;
    [[nodiscard]] bool is_motion(std::uint16_t code) const;
    [[nodiscard]] bool is_tracked(const jaus::header& head) const;
    void look_for_repeat(const jaus::header& head, bytes body);
    void expect_reply(const jaus::header& head, const auto& body);
    [[nodiscard]] bool is_own_change(const transition& one) const;
    [[nodiscard]] bool has_capacity() const;
    void breaks(contract point, std::string expected, std::string found);

    world& world_;
    const process& program_;
    judged_component what_;
    reference is_{}, next_{};
    phase phase_{};
    jaus::header head_{};
    std::uint64_t digest_{};
    expectation expected_{};
    std::vector<sent_message> sent_{};
    std::vector<transition> entered_{};
    std::vector<control_call> control_{};
    std::vector<remembered_message> remembered_{};
    std::vector<unsure_source> unsure_{};
    std::optional<time> late_since_{}; ///< something is due
};

} // namespace simulation
