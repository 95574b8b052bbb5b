// Judges the component of an operator: its requests for control and its repeats of messages have to be those of a
// reference, made from docs/jaus-node.md and apart from the library.
#pragma once

#include "simulation/process.hpp"
#include "simulation/unit_judge.hpp"
#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/jaus/component/held_control.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace simulation {

/// How a judged operator is made.
struct judged_operator {
    jaus::address id{}, target{};
    jaus::held_control_options control{};
    jaus::acknowledgement_options acknowledgement{};
    std::size_t places{}; ///< messages that wait at a time
};

class operator_judge final : public unit_judge {
  public:
    operator_judge(world& w, const process& program, const judged_operator& what)
        : world_{w}, program_{program}, what_{what} {}

    /// Its program begins; `first_number`: of the messages that it sends.
    void starts(std::uint16_t first_number);

    void gets(const jaus::header& head, bytes body) override;
    void has_handled(jaus::component_outcome) override { compare(); }
    void runs() override;
    void has_run() override { compare(); }
    void loses(const jaus::address& who) override;
    void has_lost() override { compare(); }
    void sends(bytes message) override;

    /// Its user requests or releases control.
    void asks(std::uint8_t authority);
    void releases();
    void has_done() { compare(); }
    /// Its user sends a message that asks for an acknowledgement.
    void begins_message();
    void has_sent(const jaus::send_result& result, std::uint16_t code);

    void changed(jaus::control_state to);
    void delivered(const jaus::header& head, jaus::delivered what);

    /// Its component does nothing any more, while its node goes on; and the end of that.
    void mutes() { is_mute_ = true; }
    void speaks() {
        is_mute_ = false;
        spoke_at_ = world_.now();
    }

    /// Whether a repeat or a renewal is missing.
    void check();

  private:
    using state = jaus::control_state;
    using message_bytes = std::vector<std::byte>;
    struct waiting_message {
        jaus::header head{};
        message_bytes whole{};
        unsigned sent{};
        time due{}, until{};
    };
    struct outcome {
        jaus::header head{};
        jaus::delivered what{};
        friend bool operator==(const outcome&, const outcome&) = default;
    };

    void begin();
    void compare();
    void enter(state to);
    void request();
    void end_message(std::size_t i, jaus::delivered what);
    void expect(const jaus::header& head, const auto& body);
    [[nodiscard]] bool is_wanted() const { return state_ == state::held || state_ == state::asking; }
    [[nodiscard]] std::optional<time> control_due() const;
    void breaks(contract point, std::string expected, std::string found);

    world& world_;
    const process& program_;
    judged_operator what_;
    state state_{};
    std::uint8_t authority_{};
    unsigned asked_{}, releases_left_{};
    time at_{};
    std::uint16_t next_number_{};
    std::vector<waiting_message> waiting_{};
    bool is_open_{}; ///< what happens is compared at its end
    bool is_mute_{};
    time spoke_at_{};
    std::vector<message_bytes> expected_{}, sent_{};
    std::vector<state> changes_expected_{}, changes_{};
    std::vector<outcome> outcomes_expected_{}, outcomes_{};
};

} // namespace simulation
