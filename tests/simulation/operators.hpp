// Who commands: an operator made with the library, and one that was not, with the habits of such programs.
#pragma once

#include "simulation/node_program.hpp"
#include "simulation/operator_judge.hpp"
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/component/held_control.hpp>

#include <array>

namespace simulation {

/// What an operator does next; both kinds do the same things.
enum class intent : std::uint8_t {
    ask_control,
    move,
    stop_moving,
    standby,
    resume,
    set_emergency,
    clear_emergency,
    reset,
    shutdown,
    release,
    query_status,
    query_efforts,
    large_data
};
/// Draws one: mostly motion, and what is needed for it.
[[nodiscard]] intent next_intent(generator& random, bool has_control, bool holds_emergency, bool has_drives);

/// Whom it commands.
struct target_unit {
    jaus::address id{};
    std::size_t joints{}; ///< 0: it takes Set Wrench Effort
};

/// An operator with a node of the library. One component, which holds control of one actuator.
class operator_program final : public node_program {
  public:
    operator_program(world& w, network& n, model& m, const std::vector<place>& places, std::size_t which,
                     const target_unit& target, bool sends_long_data = false);
    void check() override { judge_.check(); }

  protected:
    void add_components(net::node_machine& node) override;
    void remove_components() override;
    [[nodiscard]] std::optional<std::uint8_t> sender_of(const jaus::address& source) const override;
    [[nodiscard]] time longest_wait() const override;
    void large_data_done(const jaus::header& head, jaus::delivered what) override;
    void act() override;
    void own_event(std::uint8_t what, std::uint32_t argument) override;

  private:
    enum : std::uint8_t { to_mute = first_own_event, to_speak };
    struct unit;

    void changed_control(jaus::control_state state);
    void on_delivered(const jaus::awaited_message& message, jaus::delivered what);
    void send_large();
    template <class Message> void command(const Message& message, bool acknowledged);
    void move(command_number number, bool acknowledged);
    void query_motion();
    void ask_control();
    void release_control();
    [[nodiscard]] auto judged_out();
    void check_control();

    jaus::address id_, target_;
    std::size_t joints_;
    std::uint8_t account_;
    operator_judge judge_;
    struct control_listener {
        operator_program& mine;
        void operator()(jaus::control_state state) const { mine.changed_control(state); }
    } control_listener_{*this};
    struct application {
        operator_program& mine;
        jaus::message_outcome operator()(const jaus::header& head, bytes body) const;
    } application_{*this};
    static constexpr std::size_t most_waiting = 8;
    jaus::component_memory<most_waiting, 64, 64> memory_{};
    std::optional<jaus::held_control> control_{};
    std::optional<jaus::component<jaus::held_control>> core_{};
    std::optional<watched_component<jaus::component<jaus::held_control>, application>> watched_{};
    bool holds_emergency_{};
    std::uint16_t plain_number_{};
    time asks_since_{};
    bool sends_long_data_; ///< also sets of more than 256 packets
    std::uint64_t large_made_{};
    std::vector<std::byte> large_{};
};

/// An operator with bytes of its own making: it numbers as it likes, and does not know the library's care.
class foreign_operator final : public process {
  public:
    foreign_operator(world& w, network& n, model& m, const jaus::address& self, const target_unit& target,
                     std::uint8_t target_port, std::string name);

  protected:
    void boot() override;
    void kill() override { model_.sender_dies(account_); }
    void receive(const datagram& one) override;
    void run() override;
    [[nodiscard]] std::optional<time> next() override;
    void act() override;

  private:
    struct waiting_message {
        std::array<std::byte, 128> bytes{};
        std::size_t size{};
        unsigned sent{};
        time due{};
    };
    template <class Message> void command(const Message& message, bool acknowledged);
    void move(command_number number, bool acknowledged);
    void query_motion();
    void send(bytes message);
    [[nodiscard]] std::size_t spoil(std::span<std::byte> message, std::size_t size);
    template <class Message> void put(const jaus::address& to, const Message& message);

    model& model_;
    jaus::address id_, target_;
    std::size_t joints_;
    std::uint8_t target_port_;
    std::uint8_t account_;
    bool all_zero_{};
    std::uint16_t number_{};
    waiting_message waiting_{};
    bool controls_{}, holds_emergency_{};
    bool renews_{}; ///< it requests control again and again; if not, its messages keep it
    std::uint8_t authority_{};
    time renew_at_{}, pulse_at_{};
};

} // namespace simulation
