// Who sends what operators seldom send: queries of the core service, clock and authority, commands without control,
// in states that refuse them, of codes that the component does not know, and the same message again.
#pragma once

#include "simulation/model.hpp"
#include "simulation/operators.hpp"

#include <array>
#include <vector>

namespace simulation {

/// Has bytes of its own making, and no node.
class inspector final : public process {
  public:
    /// `target_program` has the target; to `bystander`, a component of an operator, it sends answers that nobody asked
    /// for.
    inspector(world& w, network& n, model& m, const jaus::address& self, const target_unit& target,
              std::uint8_t target_port, const process& target_program, const jaus::address& bystander,
              std::uint8_t bystander_port);
    void check() override;

  protected:
    void boot() override;
    void kill() override { model_.sender_dies(account_); }
    void receive(const datagram& one) override;
    void run() override;
    [[nodiscard]] std::optional<time> next() override { return std::min(pulse_at_, again_at_); }
    void act() override;

  private:
    [[nodiscard]] jaus::header new_head();
    struct asked_report {
        std::uint16_t code{}, number{};
        time at{};
    };
    template <class Message> void put(const Message& message);
    template <class Message> void ask(const Message& query);
    template <class Message> void tell_bystander(const Message& message);
    void put_code(std::uint16_t code);
    void send(bytes message);
    void command_state();
    void set_time();
    void move();

    model& model_;
    jaus::address id_, target_;
    std::size_t joints_;
    std::uint8_t target_port_, account_;
    const process& target_program_;
    jaus::address bystander_;
    std::uint8_t bystander_port_;
    std::vector<asked_report> asked_{};
    std::uint16_t number_{};
    bool holds_emergency_{};
    time pulse_at_{}, again_at_{time::max()};
    std::array<std::byte, 128> last_{};
    std::size_t last_size_{};
    std::uint32_t last_number_{}; ///< the model's, of the last message
};

} // namespace simulation
