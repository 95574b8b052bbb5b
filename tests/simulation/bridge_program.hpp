// The program with the bridge: a JAUS node for each slave, the components in front of them, and the ring.
#pragma once

#include "simulation/model.hpp"
#include "simulation/node_program.hpp"
#include "simulation/ring.hpp"
#include <jauscat/bridge/ring.hpp>
#include <jauscat/bridge/wrench_effort_part.hpp>

#include <deque>
#include <memory>

namespace simulation {

namespace bridging = jauscat::bridging;

/// A slave's port on the network, which belongs to the bridge's process.
class side_port final : public port_user {
  public:
    side_port(process& whose, network& n) : whose_{whose}, port_{n.add(*this)} {}
    bool arrives(datagram& one) override { return whose_.arrives(one); }
    [[nodiscard]] std::uint8_t number() const noexcept override { return whose_.number(); }
    [[nodiscard]] std::uint8_t port() const noexcept { return port_; }

  private:
    process& whose_;
    std::uint8_t port_;
};

/// What a bridge is made with.
struct bridge_settings {
    std::vector<bool> cyclic{}; ///< for each slave
    time period{std::chrono::milliseconds{10}};
    /// Within which an actuator is at rest after something is lost; robot_controller's defaults.
    [[nodiscard]] time limit() const;
    [[nodiscard]] bridging::bridge_options options() const;
};

class bridge_program final : public process, public frame_user {
  public:
    /// The first places are those of the slaves' nodes; the ring has the slaves.
    bridge_program(world& w, network& n, model& m, const std::vector<place>& places, ring& wire,
                   const bridge_settings& what);
    ~bridge_program() override;

    /// The efforts of a slave are set.
    void moved(std::size_t slave, command_number command);
    void frame_returns(bytes frame) override;

  protected:
    void boot() override;
    void kill() override;
    void receive(const datagram& one) override;
    void run() override;
    [[nodiscard]] std::optional<time> next() override;
    void act() override;
    [[nodiscard]] time act_interval() const override { return std::chrono::seconds{1}; }
    void own_event(std::uint8_t what, std::uint32_t argument) override;

  private:
    enum : std::uint8_t { to_end = first_own_event, to_kill };
    struct unit;
    struct life_data;

    void pump();
    void send_frames();
    void put(bytes message);
    void look_after(unit& one);

    model& model_;
    const std::vector<place>& places_;
    ring& wire_;
    bridge_settings settings_;
    std::vector<std::unique_ptr<side_port>> side_ports_{};
    std::vector<std::uint8_t> accounts_{};
    std::unique_ptr<life_data> data_{};
    std::array<std::byte, ethercat::max_frame_size> frame_{};
};

} // namespace simulation
