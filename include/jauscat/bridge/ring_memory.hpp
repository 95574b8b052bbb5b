// What a ring keeps in memory of the user.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/bridge/message_lane.hpp>
#include <jauscat/bridge/slave_front.hpp>
#include <jauscat/ethercat/master/clock_record.hpp>
#include <jauscat/ethercat/master/jobs.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::bridging {

/// A slave of a ring; the ring's own.
struct ring_place {
    enum class phase : std::uint8_t {
        absent,     // next: bring_up
        pre_op,     // cyclic: next is configure
        configured, // next: SAFE-OP, or its clock is set up
        has_clock,  // ... which then comes to follow the reference clock; next: its SYNC signals
        has_sync,   // next: SAFE-OP
        safe_op,    // next: OP; its process data are exchanged from here on
        in_state,   // in which it is to work; next: whether it is still at its place
        settling,   // cyclic: in OP, until its inputs are there; else until its state has been read
        up,
    };

    slave_front* front{};
    phase at{};
    ethercat::master_error bring_up{};
    bool is_slow{}; // a step of it has timed out since it was up
    time_point next_try = time_point::min();
    time_point next_keep_alive{};
    time_point up_since{};
    duration silence{}; // cycles that did not find it in a state in which it can be commanded, in a row
    time_point settling_until{};
    time_point next_look{}; // at how far its clock is from the reference clock
    bool clock_is_set{};
    unsigned good_looks{}; // in a row
    bool takes_keep_alive{true};
    bool has_reply{};
    std::size_t last_unit{};               // of its components: whose message was carried last
    std::optional<time_point> looked_at{}; // the frame that said so
    std::size_t start_up_object{};         // the next one in PRE-OP
    enum class start_up_step : std::uint8_t { read, write, verify } start_up{};
    std::size_t checked_parts{};    // can work with its process data
    std::span<std::byte> outputs{}; // in data_, if it is exchanged
    std::span<const std::byte> inputs{};
    const ethercat::slave_status* status{};
};

/// What a ring keeps in memory of the user, for as many slaves as each span has elements.
struct ring_memory {
    std::span<ring_place> places{};
    std::span<ethercat::slave_record> records{};
    std::span<ethercat::slave_record> exchanged{}; ///< those in the process data
    std::span<ethercat::process_slot> slots{};
    std::span<std::byte> image{};    ///< all outputs and inputs, up to 64 KiB
    std::span<message_lane> lanes{}; ///< 1 at least: so many slaves get messages by mailbox at the same time
    /// Two for each slave of the bus, also for those that are not the ring's; none: without distributed clocks.
    std::span<ethercat::clock_record> clock_records{};
    // Slaves that are not up go to PRE-OP, are configured, and go to SAFE-OP and OP at once; none: one after the other.
    std::span<ethercat::bring_up_place> bring_ups{};
    std::span<ethercat::configure_place> configurations{};
    std::span<ethercat::state_place> state_changes{};
    std::span<ethercat::position_place> positions{};
};

/// Memory for up to `Slaves` slaves and `Bytes` of process data, `Lanes` messages by mailbox at the same time, and
/// distributed clocks on a bus of up to `Clocks` slaves.
template <std::size_t Slaves, std::size_t Bytes, std::size_t Lanes = std::min<std::size_t>(Slaves, 16),
          std::size_t Clocks = 0>
struct ring_memory_for {
    std::array<ring_place, Slaves> places{};
    std::array<ethercat::slave_record, Slaves> records{}, exchanged{};
    std::array<ethercat::process_slot, Slaves> slots{};
    std::array<std::byte, Bytes> image{};
    std::array<message_lane, Lanes> lanes{};
    std::array<ethercat::clock_record, 2 * Clocks> clock_records{};
    std::array<ethercat::bring_up_place, Slaves> bring_ups{};
    std::array<ethercat::configure_place, Slaves> configurations{};
    std::array<ethercat::state_place, Slaves> state_changes{};
    std::array<ethercat::position_place, Slaves> positions{};

    [[nodiscard]] ring_memory spans() noexcept {
        return {places,        records,   exchanged,      slots,         image,    lanes,
                clock_records, bring_ups, configurations, state_changes, positions};
    }
};

} // namespace jauscat::bridging
