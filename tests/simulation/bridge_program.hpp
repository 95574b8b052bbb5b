// The program with the bridge: components, a JAUS node for each, and the ring with their slaves.
#pragma once

#include "simulation/component_judge.hpp"
#include "simulation/direct_user.hpp"
#include "simulation/model.hpp"
#include "simulation/node_program.hpp"
#include "simulation/order_judge.hpp"
#include "simulation/ring.hpp"
#include "simulation/slave_judge.hpp"
#include <jauscat/bridge/ring.hpp>
#include <jauscat/bridge/wrench_effort_part.hpp>

#include <deque>
#include <memory>

namespace simulation {

namespace bridging = jauscat::bridging;

/// A component's port on the network, which belongs to the bridge's process.
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

/// A component of a bridge: an arm of the examples, or an arm of drives.
struct unit_settings {
    std::vector<std::size_t> slaves{}; ///< of the ring
    bool cyclic{};
    std::size_t axes{}; ///< of each drive, 1 or 2; 0: it is no drive
    time limit{};       ///< within which it is at rest after something is lost; robot_controller's defaults
    [[nodiscard]] std::size_t joints() const noexcept { return slaves.size() * axes; }
};
/// What a bridge is made with.
struct bridge_settings {
    std::vector<unit_settings> units{};
    time period{std::chrono::milliseconds{10}};
    bool has_clocks{};             ///< drives have SYNC signals, each period
    bool is_shared{};              ///< its application uses the master, too
    bool checks_serials{};         ///< a slave at the place of another is not brought up
    std::size_t lanes{most_lanes}; ///< so many slaves get messages by mailbox at the same time
    bool is_one_by_one{};          ///< slaves are brought up one after the other
    static constexpr std::size_t most_lanes = 16;
    [[nodiscard]] bridging::bridge_options options(const unit_settings& of) const;
    [[nodiscard]] ring_times times(const unit_settings& of) const;
};

class bridge_program final : public process, public frame_user {
  public:
    /// The first places are those of the components' nodes; the ring has the slaves.
    bridge_program(world& w, network& n, model& m, const std::vector<place>& places, ring& wire,
                   const bridge_settings& what);
    ~bridge_program() override;

    /// The efforts of an axis of a slave are set.
    void moved(std::size_t slave, std::size_t axis, command_number command);
    void frame_returns(bytes frame) override;
    void check() override;

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
    enum : std::uint8_t { to_end = first_own_event, to_kill, to_give_up, to_look };
    struct unit;
    struct life_data;

    void pump();
    void send_frames();
    void put(bytes message);
    void look_at_cycle(bytes frame);
    void look_at_image(bytes frame);
    void look_at_job();
    /// Turns in which nothing is due.
    void drive_idle(bool with_nodes);
    void look_at_idle_turn();
    void has_work() { has_more_ = is_woken_ = true; }
    /// A literal, and what it is about.
    void does(const char* what, std::string_view about = {}) {
        ++deeds_;
        last_deed_ = what;
        world_.sees(what, about);
    }
    /// What they have done; a literal, nullptr: nothing.
    [[nodiscard]] const char* drive_nodes();
    void look_after(unit& one);

    model& model_;
    const std::vector<place>& places_;
    ring& wire_;
    bridge_settings settings_;
    std::vector<std::unique_ptr<side_port>> side_ports_{};
    std::vector<std::uint8_t> accounts_{};
    std::vector<std::unique_ptr<order_judge>> orders_{};                   ///< of each account
    std::vector<std::unique_ptr<component_judge>> judges_{};               ///< of each account
    std::vector<std::unique_ptr<slave_judge>> slaves_{};                   ///< of each slave
    std::vector<std::pair<std::uint8_t, std::size_t>> places_of_slaves_{}; ///< account and first axis of each
    std::optional<direct_user> application_{};
    std::unique_ptr<life_data> data_{};
    std::array<std::byte, ethercat::max_frame_size> frame_{};
    time cycle_at_{}; ///< when process data were last sent
    generator idle_random_;
    std::uint64_t frames_of_jobs_{};
    std::optional<jauscat::time_point> cycle_begun_{};
    jaus::hook<void()> on_work_{jaus::bound<&bridge_program::has_work>(*this)};
    bool is_woken_{};             ///< a component has something to do that its node does not know of
    bool has_more_{};             ///< something has happened that the next turn goes on with
    bool is_settled_{};           ///< nothing follows from the last turn
    const char* last_deed_{};     ///< a literal
    std::uint64_t deeds_{};       ///< what the program has done that shows outside of it
    std::uint64_t windows_{};     ///< of the process images of the last lives, 16 bits for each
    bool has_window_{};           ///< this life has one
    unsigned cycles_of_others_{}; ///< since process data were last sent
};

} // namespace simulation
