// Cyclic exchange of process data: the frames of a cycle carry all outputs and inputs and, optionally, read each
// slave's state.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/process_image.hpp>
#include <jauscat/ethercat/master/process_plan.hpp>
#include <jauscat/ethercat/master/slave_status.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace jauscat::ethercat {

/// Statistics of the cycles. A cycle has as many frames as the process data need.
struct process_statistics {
    std::uint64_t sent{};        ///< cycles
    std::uint64_t complete{};    ///< every slave took part
    std::uint64_t incomplete{};  ///< all frames returned, one at least with another working counter
    std::uint64_t lost{};        ///< a frame at least did not come back before the next cycle
    std::uint64_t frames{};      ///< frames sent
    std::uint64_t lost_frames{}; ///< frames that did not come back before the next cycle
};

/// Optional content of the frames.
struct process_options {
    /// Each cycle asks every slave for its AL status and whether mail waits: see `status`. The process data of each
    /// slave then have a datagram of their own, so that one slave's failure does not make another's inputs old. That
    /// takes 45 bytes for each slave.
    bool watch_slaves{};
    /// One datagram of each cycle counts the slaves of the ring and reads the states of all, or-ed: see `ring`. It
    /// tells that a slave has come or gone (`locate_slaves` finds out which), and takes 18 bytes.
    bool watch_ring{};
    /// With `watch_slaves`, while every slave of the ring runs: one datagram reads the states of all, as with
    /// `watch_ring`, each slave is polled in every second cycle (all are where there are up to 8), and process data
    /// share datagrams. A cycle with 40 slaves then has one frame instead of three. After a cycle in which a slave did
    /// not take part, each is polled in every cycle again; in that one cycle no slave gets new inputs. Where the polls
    /// of a cycle do not fit into one frame (some 80 slaves), each slave is polled in every cycle.
    bool watch_together{};
    /// That of the master which has configured the slaves.
    std::uint32_t logical_base{};
};

/// Memory for the process data of up to `Slaves` slaves, `Bytes` of outputs and inputs together.
template <std::size_t Slaves, std::size_t Bytes> struct process_memory_for {
    std::array<process_slot, Slaves> slots{};
    std::array<std::byte, Bytes> bytes{};
};

/// Sends the process image when a cycle is due; a frame that has not returned by then is lost, and the next cycle is
/// sent nevertheless, because the newest outputs count. A lost frame makes only the inputs of its own slaves old. Runs
/// beside a master on the same link: pass each received frame to `on_frame` first, and to the master if it was not
/// accepted. `process_data_for` brings its memory along.
class process_data {
  public:
    /// Without slaves. The memory, a slot for each slave and the bytes of all outputs and inputs, outlives it.
    JAUSCAT_FUNCTION process_data(std::span<process_slot> slots, std::span<std::byte> bytes) noexcept;
    process_data(const process_data&) = delete;
    process_data& operator=(const process_data&) = delete;

    /// Exchanges the data of these slaves from the next cycle on, at their places, as `configure` has left them. Slaves
    /// that stay, at the same place, keep outputs, inputs and status; all other outputs are 0. Counts go on. Returns
    /// `fits()`.
    JAUSCAT_FUNCTION bool set_slaves(std::span<const slave_record> slaves,
                                     const process_options& options = {}) noexcept;

    /// Whether the memory holds all data, and each slave's data fit into a frame. If not, no frame is ever sent.
    [[nodiscard]] bool fits() const noexcept { return fits_; }
    /// Frames of each cycle.
    [[nodiscard]] std::size_t frame_count() const noexcept { return plan_.frame_count(); }

    /// The addresses of each slave's data.
    [[nodiscard]] const process_image& image() const noexcept { return image_; }
    /// Outputs of a slave: what is written here goes out with the next cycle.
    [[nodiscard]] JAUSCAT_FUNCTION std::span<std::byte> outputs(const slave_record& slave) noexcept;
    /// Inputs of a slave, as the last cycle brought them in which all slaves of the same datagram took part. Of a slave
    /// that is watched: as the last cycle did in which its own data were exchanged and it was in SAFE-OP or OP;
    /// `status` says when that was.
    [[nodiscard]] JAUSCAT_FUNCTION std::span<const std::byte> inputs(const slave_record& slave) const noexcept;
    /// Status of a slave from the last cycles; `silent` if it is not watched.
    [[nodiscard]] JAUSCAT_FUNCTION const slave_status& status(const slave_record& slave) const noexcept;

    /// All slaves of the ring together; only with `watch_ring`, and while slaves are exchanged.
    [[nodiscard]] const ring_status& ring() const noexcept { return ring_; }

    /// A cycle is due: frames of the last one that are not back are lost. Then send what `next_frame` gives, until it
    /// gives nothing.
    JAUSCAT_FUNCTION void begin_cycle() noexcept;
    /// Writes the next frame of the cycle to `out`, which holds 1514 bytes, and returns its size; 0 where all are sent,
    /// or there is nothing to exchange.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t next_frame(std::span<std::byte> out, time_point now) noexcept;

    /// Takes a frame that arrived. False if it is none of ours: it may be the master's.
    JAUSCAT_FUNCTION bool on_frame(std::span<const std::byte> frame) noexcept;

    /// A frame of the cycle is not back yet.
    [[nodiscard]] bool waits() const noexcept { return outstanding_ != 0; }
    /// Every slave took part in the last cycle: its frames have returned, with the expected working counters.
    [[nodiscard]] bool is_complete() const noexcept { return is_complete_; }
    /// Sum of the working counters of all process data in the last cycle whose frames have all returned.
    [[nodiscard]] std::uint16_t working_counter() const noexcept { return working_counter_; }
    /// That sum where every slave takes part.
    [[nodiscard]] JAUSCAT_FUNCTION std::uint16_t expected_working_counter() const noexcept;
    [[nodiscard]] const process_statistics& statistics() const noexcept { return statistics_; }

  private:
    // A datagram as it is sent; without data, zeros.
    struct planned {
        command cmd{};
        std::uint16_t adp{}, ado{};
        std::size_t length{};
        std::span<const std::byte> data{};
    };

    [[nodiscard]] JAUSCAT_FUNCTION bool holds(std::uint32_t address, std::size_t size) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION std::span<std::byte> piece(std::uint32_t address, std::size_t size) const noexcept;
    // Of a slave that came or went, which may be outside the present image.
    JAUSCAT_FUNCTION void clear(const process_place& place) noexcept;

    // The cycle's number: its low byte tags the first datagram, both bytes those that follow.
    [[nodiscard]] std::uint8_t first_tag() const noexcept { return static_cast<std::uint8_t>(cycle_); }
    [[nodiscard]] std::uint8_t rest_tag() const noexcept { return static_cast<std::uint8_t>(cycle_ + (cycle_ >> 8)); }

    JAUSCAT_FUNCTION void forget_frames() noexcept;

    // A datagram alone has one index, which is the same every 256 cycles: a reply that late would be taken for the
    // present one. From then on another datagram carries the rest of the cycle's number.
    [[nodiscard]] JAUSCAT_FUNCTION bool has_filler(const process_frame& frame) const noexcept;

    // In the first frame of a cycle.
    [[nodiscard]] JAUSCAT_FUNCTION bool has_ring(const process_frame& frame) const noexcept;

    [[nodiscard]] bool watches_ring() const noexcept { return options_.watch_ring || options_.watch_together; }
    // Each slave has datagrams of its own.
    [[nodiscard]] bool polls_each() const noexcept { return options_.watch_slaves && !is_together_; }
    // The slaves that are polled in this cycle while the states of all are read together.
    [[nodiscard]] std::size_t polled_count() const noexcept {
        const auto count = plan_.member_count();
        return is_together_ ? std::min(count, std::max(least_polled, (count + 1) / 2)) : 0;
    }
    template <class Visit> void for_each_polled(Visit&& visit) const noexcept {
        for (std::size_t i = 0; i != polled_count(); ++i)
            visit(plan_.member((next_polled_ + i) % plan_.member_count()));
    }
    // Whether the states of all are read together from now on.
    JAUSCAT_FUNCTION void choose_watch() noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION bool all_run() const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION bool cut() noexcept;
    JAUSCAT_FUNCTION void take_ring(const process_frame& frame, const datagram_view& all) noexcept;
    JAUSCAT_FUNCTION void take_together(const process_frame& frame, frame_view::iterator next) noexcept;
    JAUSCAT_FUNCTION static void set_running(process_member& each, time_point sent_at) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION static bool is_running(const al_status& al) noexcept;
    // Takes the answers of a polled slave. Returns how many slaves have answered for its state.
    JAUSCAT_FUNCTION static std::uint16_t take_poll(process_member& each, frame_view::iterator& next) noexcept;

    // Calls `visit` for each datagram of a frame, in order, until it returns false. Returns whether it never did.
    template <class Visit> bool walk(const process_frame& frame, Visit&& visit) const noexcept {
        constexpr planned filler{.cmd = command::nop, .length = process_plan::filler_size};
        if (frame.parts == 0 && !visit(filler)) return false;
        for (std::size_t i = 0; i != frame.parts; ++i) {
            const auto& part = plan_.part(frame.first_part + i);
            const auto address = options_.logical_base + part.address;
            planned datagram{.cmd = command::lrw,
                             .adp = static_cast<std::uint16_t>(address),
                             .ado = static_cast<std::uint16_t>(address >> 16),
                             .length = part.size,
                             .data = bytes_.subspan(part.address, part.size)};
            if (part.counters.no_lrw) {
                datagram.cmd = command::lwr;
                if (!visit(datagram)) return false;
                datagram.cmd = command::lrd;
                datagram.data = {};
            }
            if (!visit(datagram)) return false;
        }
        const auto poll = [&](const process_member& member) {
            const auto read = [&](const auto& at) {
                return visit(planned{.cmd = command::fprd,
                                     .adp = member.station,
                                     .ado = at.address,
                                     .length = wire::max_size<typename std::decay_t<decltype(at)>::value_type>});
            };
            return read(esc_registers::al_status) && (!member.has_mailbox || read(sync_manager_handshake_of(1)));
        };
        for (std::size_t i = 0; polls_each() && i != frame.members; ++i)
            if (!poll(plan_.member(frame.first_member + i))) return false;
        if (has_ring(frame)) {
            constexpr planned ring{
                .cmd = command::brd, .ado = esc_registers::al_status.address, .length = wire::max_size<al_status>};
            if (!visit(ring)) return false;
            bool is_whole = true;
            for_each_polled([&](const process_member& member) { is_whole = is_whole && poll(member); });
            if (!is_whole) return false;
        }
        return !has_filler(frame) || visit(filler);
    }

    // A master's frames begin with none of them: without this a frame that only looks at a state would be taken for its
    // own.
    [[nodiscard]] JAUSCAT_FUNCTION static bool begins_as_ours(const frame_view& frame) noexcept;
    JAUSCAT_FUNCTION static bool is_return_of(const planned& sent, const datagram_header& back) noexcept;
    // The frame of this or an earlier cycle that begins like this one, up to the first datagram that does something.
    [[nodiscard]] JAUSCAT_FUNCTION process_frame* find(const frame_view& view) const noexcept;
    // Whether all datagrams are those of this cycle.
    [[nodiscard]] JAUSCAT_FUNCTION bool answers(const process_frame& frame, const frame_view& view) const noexcept;

    JAUSCAT_FUNCTION void take(process_frame& frame, const frame_view& view) noexcept;
    // Checks the working counters; `next` is then at the datagram with the inputs.
    [[nodiscard]] JAUSCAT_FUNCTION bool is_complete(const process_part& part, frame_view::iterator& next) noexcept;
    // `back` begins with the slave's place.
    JAUSCAT_FUNCTION void take_inputs(const process_place& place, std::span<const std::byte> back) noexcept;

    // Evaluates the registers of a slave. Returns whether its inputs are valid.
    JAUSCAT_FUNCTION static bool watch(process_member& each, bool is_exchanged, time_point sent_at,
                                       frame_view::iterator& next) noexcept;
    JAUSCAT_FUNCTION static slave_condition condition_of(unsigned answers, al_state state, bool is_exchanged) noexcept;

    static constexpr std::size_t ring_size = datagram_overhead + wire::max_size<al_status>;
    static constexpr std::chrono::nanoseconds longest_delay = std::chrono::seconds{10};
    static constexpr unsigned cycles_alone = 10; // in which each slave runs, before states are read together
    static constexpr std::size_t least_polled = 8;

    process_plan plan_;
    std::span<std::byte> bytes_;
    process_image image_{};
    process_options options_{};
    ring_status ring_{};
    bool is_together_{};
    bool is_ring_running_{}; // in this cycle, read together
    bool is_each_certain_{}; // no frame of it came before the one that says so
    unsigned good_cycles_{};
    std::uint16_t ring_slaves_{}; // when states were first read together
    std::size_t next_polled_{};   // the first member that is polled in this cycle
    bool fits_{true};
    std::uint16_t cycle_{};
    std::size_t next_{};        // frame to be sent
    std::size_t outstanding_{}; // frames that are under way
    std::size_t returned_{};    // frames of this cycle
    std::uint16_t counting_{};  // working counters of this cycle
    bool is_counting_complete_{};
    std::uint16_t working_counter_{};
    bool is_complete_{};
    std::uint64_t missing_{};      // frames that have not come back
    time_point missing_sent_at_{}; // the last of these
    process_statistics statistics_{};
};

/// Process data with memory for up to `Slaves` slaves and `Bytes` of outputs and inputs together:
/// `process_data_for<6, 600> data{master.slaves(), {.watch_slaves = true}}`.
template <std::size_t Slaves, std::size_t Bytes>
class process_data_for : private process_memory_for<Slaves, Bytes>, public process_data {
    using memory = process_memory_for<Slaves, Bytes>;

  public:
    /// Without slaves.
    process_data_for() noexcept : process_data{memory::slots, memory::bytes} {}
    /// See `set_slaves`.
    explicit process_data_for(std::span<const slave_record> slaves, const process_options& options = {}) noexcept
        : process_data_for{} {
        set_slaves(slaves, options);
    }
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/process_data.ipp>
#endif
