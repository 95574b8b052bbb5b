// The simulated EtherCAT ring: a cable, slaves behind one another, and what goes wrong with them.
#pragma once

#include "simulation/arm_unit.hpp"
#include "simulation/drive_unit.hpp"
#include "simulation/world.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace simulation {

/// What of the ring is told; `value` as the comment says.
enum class ring_deed : std::uint16_t {
    frame_lost,     ///< 0: before the slaves, 1: on its way back
    frame_delayed,  ///< microseconds
    cable_out,      //
    cable_back,     //
    freezes,        ///< milliseconds
    goes_on,        //
    restarts,       ///< milliseconds that it is away
    comes_back,     //
    aborts_next,    ///< how many writes
    falls_back,     ///< AL state that is asked for
    recounts,       //
    taken,          ///< by another master
    odd_watchdog,   ///< divider << 16 | time
    al_state,       ///< the slave is in it
    unknown_state,  ///< milliseconds that its state cannot be read
    frame_doubled,  ///< microseconds until it comes again
    frame_damaged,  ///< bytes that are left of it; 0: a slave discards it
    swapped,        ///< the actor with which it changes places
    doubled,        ///< the actor whose station address it gets
    drive_fault,    ///< milliseconds that its cause is there
    unpowered,      ///< milliseconds that the power stage has no supply
    deaf,           ///< milliseconds that it ignores controlwords
    keeps_watchdog, ///< milliseconds that it keeps its watchdog registers, whatever is written
    slow,           ///< milliseconds that it takes for each message
    reports_error,  ///< milliseconds that it reports SAFE-OP with an error, or until it changes its state
    repaired,       //
    emergency,      ///< a message of its own; its number
};

/// Who sends frames and gets them back.
class frame_user {
  public:
    frame_user() = default;
    frame_user(const frame_user&) = delete;
    frame_user& operator=(const frame_user&) = delete;
    virtual ~frame_user() = default;
    virtual void frame_returns(bytes frame) = 0;
};

/// What is wrong with a slave, and since when; a lost slave is brought to rest by itself.
struct trouble {
    const char* what{};
    time since{};
};

/// The registers 0400h and 0420h of a slave.
struct watchdog_registers {
    std::uint16_t divider{}, units{};
};

/// A message of a slave of its own.
struct sent_emergency {
    std::uint32_t number{};
    time at{};
    ethercat::coe_emergency what{};
};

/// A slave and where it stands.
struct ring_place {
    std::uint8_t number{}; ///< of the actor
    std::uint16_t station{};
    bool cyclic{};
    std::unique_ptr<device> unit{};
    arm_unit* arm{};     ///< nullptr: it is none
    drive_unit* drive{}; ///< nullptr: it is none
    bool frozen{}, away{}, state_is_unknown{}, has_drive_fault{};
    bool keeps_watchdog{};   ///< its registers keep `kept_watchdog`
    bool refuses_watchdog{}; ///< and it does not count such writes in the working counter
    watchdog_registers kept_watchdog{};
    bool reports_error{};            ///< SAFE-OP with an error, in place of its state
    ethercat::al_state error_from{}; ///< its state when it began to
    time slow{};                     ///< it works off its mailbox once in this time; 0: with each frame
    time mailbox_written_at{};       ///< when it has last got a message
    time left_at{};                  ///< when it has last left a state in which it works
    time shared_at{};                ///< when another slave has got its station address
    time held_up_at{};               ///< when a transfer to it was given up, whose rest its slow mailbox works off
    time watchdog{};                 ///< when it went to OP; 0: it has none
    std::uint8_t recount{};          ///< added to the mailbox counter of its new messages
    std::array<std::byte, 16> last_reply{};
    std::uint8_t last_reply_recount{}; ///< a message that is asked for again is the same
    time unfrozen_at{}, restarted_at{}, passed_at{}, recounted_at{};
    time disturbed_at{}; ///< when something last happened to it that may delay a stop order
    time missed_at{};    ///< when a frame was last lost before it
    ethercat::al_state told_state{};
    std::optional<time> unreachable_since{}, left_state_since{}, taken_since{}, unknown_since{};
    std::array<time, 16> seen_in{};            ///< when it was last in each AL state
    time error_told_at{}, unknown_told_at{};   ///< when it has last shown an error in place of its state, or none
    std::vector<sent_emergency> emergencies{}; ///< the last ones
};

class ring final : public actor {
  public:
    /// `moved(slave, axis, command)`: the efforts in force of a slave are set. `is_rough`: its slaves are swapped and
    /// get addresses of others, its frames are damaged and doubled.
    ring(world& w, std::function<void(std::size_t, std::size_t, command_number)> moved, bool is_rough)
        : world_{w}, moved_{std::move(moved)}, is_rough_{is_rough} {}

    /// The next slave; before `start`.
    void add_arm(std::string name, std::uint16_t station, bool cyclic, const arm_settings& what);
    /// `first_joint`: the number in its arm of the first of 1 or 2 axes.
    void add_drive(std::string name, std::uint16_t station, std::size_t axes, std::size_t first_joint,
                   const std::optional<ethercat::clock_error>& clock);
    [[nodiscard]] static constexpr std::uint32_t serial_of(std::size_t i) noexcept {
        return 1000 + static_cast<std::uint32_t>(i);
    }
    /// Emergencies carry a number each.
    [[nodiscard]] static std::uint32_t number_of(const ethercat::coe_emergency& what) noexcept;
    void start(frame_user& user);

    void send(bytes frame);

    [[nodiscard]] bool is_rough() const noexcept { return is_rough_; }
    [[nodiscard]] std::size_t size() const noexcept { return places_.size(); }
    [[nodiscard]] const ring_place& operator[](std::size_t i) const noexcept { return places_[i]; }
    /// A transfer to it was given up.
    void note_given_up(std::size_t i) noexcept {
        if (places_[i].slow != time{}) places_[i].held_up_at = world_.now();
    }
    /// Whatever is wrong with a slave for longest; nothing where it can be commanded, and stops by itself if it is not.
    [[nodiscard]] std::optional<trouble> trouble_of(std::size_t i) const;
    /// Frames lost, delayed, doubled or damaged: when the last one was, and how many of the last 64.
    [[nodiscard]] time frames_disturbed_at() const noexcept;
    [[nodiscard]] std::ptrdiff_t frames_disturbed_since(time then) const noexcept;
    /// Whether another slave is where it was at the start.
    [[nodiscard]] bool is_elsewhere(std::size_t i) const noexcept { return order_[i] != i; }

    void on_event(std::uint8_t what, std::uint32_t argument) override;

  private:
    enum : std::uint8_t { returns, tick, trial, repair };
    static constexpr std::uint32_t is_copy = 1U << 31U; ///< of the argument of `returns`
    struct flight {
        std::size_t size{};
        std::array<std::byte, ethercat::max_frame_size> bytes{};
    };

    void add(std::string name, std::uint16_t station, bool cyclic);
    void tell(std::size_t place, ring_deed what, std::uint32_t value = 0);
    /// Until the place in the ring where the frame is damaged.
    void pass(std::span<std::byte> frame, std::size_t end);
    void alter(ring_place& at, std::span<std::byte> frame);
    void look(ring_place& at);
    [[nodiscard]] std::size_t position_of(std::size_t i) const noexcept;
    [[nodiscard]] bool is_reachable(std::size_t i) const noexcept;
    void try_later(fault kind);
    void suffer(fault kind);
    void send_emergency(std::size_t i);
    void suffer_of_drive(fault kind, std::size_t i, time some);
    void swap(std::size_t i, std::size_t other);
    void mend(fault kind, std::size_t i);
    void write(ring_place& at, std::uint16_t address, std::uint16_t value);
    void give_odd_watchdog(std::size_t i);
    void let_keep_watchdog(std::size_t i);
    void keep_watchdog(ring_place& at, const ethercat::basic_datagram<std::byte>& write);
    [[nodiscard]] time watchdog_of(ring_place& at);
    /// Whether it does what the bridge has asked for.
    [[nodiscard]] static bool works(const ring_place& at);

    world& world_;
    std::function<void(std::size_t, std::size_t, command_number)> moved_;
    bool is_rough_;
    bool has_clocks_{};
    std::array<time, 64> frames_disturbed_at_{};
    std::size_t disturbed_frames_{};
    std::uint32_t emergency_count_{};
    frame_user* user_{};
    std::vector<ring_place> places_{};
    std::vector<std::size_t> order_{}; ///< which slave is at each place of the cable
    std::optional<std::size_t> cable_out_before_{};
    std::vector<std::unique_ptr<flight>> flights_{};
    std::vector<std::uint32_t> free_{};
};

} // namespace simulation
