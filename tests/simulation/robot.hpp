// A program whose component is an actuator itself: a Primitive Driver whose motors it drives directly.
#pragma once

#include "simulation/component_judge.hpp"
#include "simulation/node_program.hpp"
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/events/service_connections.hpp>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace simulation {

/// The Primitive Driver. What it must do by itself is to bring its motors to rest whenever it is told to.
class actuator {
  public:
    actuator(const jaus::address& self, node_program& program, model& m, std::uint8_t account, time controller_timeout);
    actuator(const actuator&) = delete;
    actuator& operator=(const actuator&) = delete;

    jaus::message_outcome operator()(const jaus::header& head, bytes body);

    static constexpr std::array<std::uint16_t, 1> harmless{large_code};
    component_judge* judge{};

  private:
    void on_state(jaus::primary_status_code from, jaus::primary_status_code to);
    void on_controller(const std::optional<jaus::controller>& now, jaus::control_change why);
    void rest();
    void report_efforts(const jaus::header& query, std::uint16_t presence_vector);

    node_program& program_;
    model& model_;
    std::uint8_t account_;
    command_number command_{};
    std::array<std::byte, 256> report_{};
    struct filler {
        actuator& mine;
        std::optional<std::size_t> operator()(std::uint16_t, std::uint32_t, std::span<std::byte> body) const;
    } filler_{*this};
    static constexpr std::array<jaus::connectable_report, 1> reports{{{0x2405, 1, 50}}};
    jaus::service_connections<8> connections_;
    jaus::component_memory<8, 256, 256> memory_{};

  public:
    jaus::component<jaus::service_connections<8>> core;
};

/// The program around it: in half of the runs with two actuators, whose components differ in the instance.
class robot final : public node_program {
  public:
    robot(world& w, network& n, model& m, const std::vector<place>& places, std::size_t which);

    [[nodiscard]] std::size_t instances() const noexcept { return seats_.size(); }
    void check() override;

  protected:
    void add_components(net::node_machine& node) override;
    void remove_components() override;
    [[nodiscard]] std::optional<std::uint8_t> sender_of(const jaus::address&) const override { return std::nullopt; }
    void act() override;
    [[nodiscard]] time act_interval() const override { return std::chrono::seconds{1}; }

  private:
    static constexpr time timeout = std::chrono::milliseconds{500};

    struct seat {
        jaus::address id{};
        std::uint8_t account{};
        std::optional<actuator> unit{};
        std::optional<watched_component<decltype(actuator::core), actuator>> watched{};
        time stuck_since{};
        std::optional<component_judge> judge{};
        void initialize();
    };
    [[nodiscard]] static std::optional<jaus::component_outcome> outcome_of(const jaus::header& head, bytes body);
    void look_after(seat& one);

    std::vector<std::unique_ptr<seat>> seats_{};
};

} // namespace simulation
