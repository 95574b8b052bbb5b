// Cyclic exchange of process data: the frames of a cycle carry all outputs and inputs and, optionally, read each
// slave's state.
#pragma once

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
    process_data(std::span<process_slot> slots, std::span<std::byte> bytes) noexcept : plan_{slots}, bytes_{bytes} {
        std::ranges::fill(bytes_, std::byte{});
    }
    process_data(const process_data&) = delete;
    process_data& operator=(const process_data&) = delete;

    /// Exchanges the data of these slaves from the next cycle on, at their places, as `configure` has left them. Slaves
    /// that stay, at the same place, keep outputs, inputs and status; all other outputs are 0. Counts go on. Returns
    /// `fits()`.
    bool set_slaves(std::span<const slave_record> slaves, const process_options& options = {}) noexcept {
        forget_frames();
        options_ = options;
        image_ = process_image::of(slaves);
        is_complete_ = false;
        working_counter_ = 0;
        fits_ = slaves.size() <= plan_.capacity() && image_.size <= bytes_.size();
        if (!fits_) {
            image_ = {};
            slaves = {};
        }
        const auto is = [](const process_member& member, const slave_record& slave) {
            return member.station == slave.station && member.place == slave.process_data;
        };
        plan_.remove_unless([&](const process_member& each) {
            if (std::ranges::any_of(slaves, [&](const slave_record& slave) { return is(each, slave); })) return true;
            clear(each.place);
            return false;
        });
        const auto stay = plan_.member_count();
        for (const auto& slave : slaves) {
            std::size_t i = 0;
            while (i != stay && !is(plan_.member(i), slave)) ++i;
            if (i != stay) continue;
            plan_.add(slave);
            clear(slave.process_data);
        }
        if (fits_) fits_ = plan_.cut(options_.watch_slaves, options_.watch_ring ? ring_size : 0);
        next_ = plan_.frame_count();
        return fits_;
    }

    /// Whether the memory holds all data, and each slave's data fit into a frame. If not, no frame is ever sent.
    [[nodiscard]] bool fits() const noexcept { return fits_; }
    /// Frames of each cycle.
    [[nodiscard]] std::size_t frame_count() const noexcept { return plan_.frame_count(); }

    /// The addresses of each slave's data.
    [[nodiscard]] const process_image& image() const noexcept { return image_; }
    /// Outputs of a slave: what is written here goes out with the next cycle.
    [[nodiscard]] std::span<std::byte> outputs(const slave_record& slave) noexcept {
        return piece(slave.process_data.output_address, slave.process_data.output_size);
    }
    /// Inputs of a slave, as the last cycle brought them in which all slaves of the same datagram took part. Of a slave
    /// that is watched: as the last cycle did in which its own data were exchanged and it was in SAFE-OP or OP;
    /// `status` says when that was.
    [[nodiscard]] std::span<const std::byte> inputs(const slave_record& slave) const noexcept {
        return piece(slave.process_data.input_address, slave.process_data.input_size);
    }
    /// Status of a slave from the last cycles; `silent` if it is not watched.
    [[nodiscard]] const slave_status& status(const slave_record& slave) const noexcept {
        static constexpr slave_status unknown{};
        const auto* const found = plan_.find(slave.station, slave.process_data);
        return found != nullptr ? found->status : unknown;
    }

    /// All slaves of the ring together; only with `watch_ring`, and while slaves are exchanged.
    [[nodiscard]] const ring_status& ring() const noexcept { return ring_; }

    /// A cycle is due: frames of the last one that are not back are lost. Then send what `next_frame` gives, until it
    /// gives nothing.
    void begin_cycle() noexcept {
        if (outstanding_ != 0) {
            ++statistics_.lost;
            statistics_.lost_frames += outstanding_;
            is_complete_ = false;
        }
        forget_frames();
        next_ = 0;
        returned_ = 0;
        counting_ = 0;
        is_counting_complete_ = true;
        if (plan_.frame_count() != 0) ++cycle_;
    }
    /// Writes the next frame of the cycle to `out`, which holds 1514 bytes, and returns its size; 0 where all are sent,
    /// or there is nothing to exchange.
    [[nodiscard]] std::size_t next_frame(std::span<std::byte> out, time_point now) noexcept {
        if (next_ == plan_.frame_count()) return 0;
        auto& each = plan_.frame(next_);
        frame_builder frame{out, first_tag()};
        frame.tag_rest(rest_tag());
        walk(each, [&](const planned& datagram) {
            if (datagram.data.empty())
                frame.add(datagram.cmd, datagram.adp, datagram.ado, datagram.length);
            else
                frame.add(datagram.cmd, datagram.adp, datagram.ado, datagram.data);
            return true;
        });
        const auto finished = frame.finish();
        if (!finished) return 0;
        if (next_++ == 0) ++statistics_.sent;
        ++statistics_.frames;
        each.waits = true;
        each.sent_at = now;
        ++outstanding_;
        if (now - missing_sent_at_ > longest_delay) missing_ = 0;
        return finished->size();
    }

    /// Takes a frame that arrived. False if it is none of ours: it may be the master's.
    bool on_frame(std::span<const std::byte> frame) noexcept {
        frame_view view;
        if (!view.parse(frame) || !begins_as_ours(view)) return false;
        auto* const found = find(view);
        if (found != nullptr && found->waits && answers(*found, view)) {
            take(*found, view);
            return true;
        }
        // A late one, or a second copy.
        if (missing_ == 0) return found != nullptr;
        --missing_;
        return true;
    }

    /// A frame of the cycle is not back yet.
    [[nodiscard]] bool waits() const noexcept { return outstanding_ != 0; }
    /// Every slave took part in the last cycle: its frames have returned, with the expected working counters.
    [[nodiscard]] bool is_complete() const noexcept { return is_complete_; }
    /// Sum of the working counters of all process data in the last cycle whose frames have all returned.
    [[nodiscard]] std::uint16_t working_counter() const noexcept { return working_counter_; }
    [[nodiscard]] const process_statistics& statistics() const noexcept { return statistics_; }

  private:
    // A datagram as it is sent; without data, zeros.
    struct planned {
        command cmd{};
        std::uint16_t adp{}, ado{};
        std::size_t length{};
        std::span<const std::byte> data{};
    };

    [[nodiscard]] bool holds(std::uint32_t address, std::size_t size) const noexcept {
        return size <= image_.size && address <= image_.size - size;
    }
    [[nodiscard]] std::span<std::byte> piece(std::uint32_t address, std::size_t size) const noexcept {
        return holds(address, size) ? bytes_.subspan(address, size) : std::span<std::byte>{};
    }
    // Of a slave that came or went, which may be outside the present image.
    void clear(const process_place& place) noexcept {
        if (place.end() > bytes_.size()) return;
        std::ranges::fill(bytes_.subspan(place.output_address, place.output_size), std::byte{});
        std::ranges::fill(bytes_.subspan(place.input_address, place.input_size), std::byte{});
    }

    // The cycle's number: its low byte tags the first datagram, both bytes those that follow.
    [[nodiscard]] std::uint8_t first_tag() const noexcept { return static_cast<std::uint8_t>(cycle_); }
    [[nodiscard]] std::uint8_t rest_tag() const noexcept { return static_cast<std::uint8_t>(cycle_ + (cycle_ >> 8)); }

    void forget_frames() noexcept {
        for (std::size_t i = 0; i != plan_.frame_count(); ++i) {
            auto& each = plan_.frame(i);
            if (!each.waits) continue;
            each.waits = false;
            missing_sent_at_ = each.sent_at;
            ++missing_;
        }
        outstanding_ = 0;
    }

    // A datagram alone has one index, which is the same every 256 cycles: a reply that late would be taken for the
    // present one. From then on another datagram carries the rest of the cycle's number.
    [[nodiscard]] bool has_filler(const process_frame& frame) const noexcept {
        const bool is_alone = !has_ring(frame) && frame.parts == 1 && !plan_.part(frame.first_part).counters.no_lrw &&
                              !options_.watch_slaves;
        return cycle_ > 0xFF && is_alone &&
               frame.size + datagram_overhead + process_plan::filler_size <= max_datagrams_size;
    }

    // In the first frame of a cycle.
    [[nodiscard]] bool has_ring(const process_frame& frame) const noexcept {
        return options_.watch_ring && frame.first_member == 0;
    }

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
        for (std::size_t i = 0; options_.watch_slaves && i != frame.members; ++i) {
            const auto& member = plan_.member(frame.first_member + i);
            const auto read = [&](const auto& at) {
                return visit(planned{.cmd = command::fprd,
                                     .adp = member.station,
                                     .ado = at.address,
                                     .length = wire::max_size<typename std::decay_t<decltype(at)>::value_type>});
            };
            if (!read(esc_registers::al_status)) return false;
            if (member.has_mailbox && !read(sync_manager_handshake_of(1))) return false;
        }
        constexpr planned ring{
            .cmd = command::brd, .ado = esc_registers::al_status.address, .length = wire::max_size<al_status>};
        if (has_ring(frame) && !visit(ring)) return false;
        return !has_filler(frame) || visit(filler);
    }

    // A master's frames begin with none of them: without this a frame that only looks at a state would be taken for its
    // own.
    [[nodiscard]] static bool begins_as_ours(const frame_view& frame) noexcept {
        const auto cmd = (*frame.begin()).header.cmd;
        return cmd == command::lrw || cmd == command::lwr || cmd == command::nop;
    }
    static bool is_return_of(const planned& sent, const datagram_header& back) noexcept {
        const bool is_same = back.cmd == sent.cmd && back.ado == sent.ado && back.length == sent.length;
        return is_same && (back.adp == sent.adp || sent.cmd == command::brd); // which counts slaves in it
    }
    // The frame of this or an earlier cycle that begins like this one, up to the first datagram that does something.
    [[nodiscard]] process_frame* find(const frame_view& view) const noexcept {
        for (std::size_t i = 0; i != plan_.frame_count(); ++i) {
            auto at = view.begin();
            bool is_same = true;
            walk(plan_.frame(i), [&](const planned& sent) {
                is_same = at != view.end() && is_return_of(sent, (*at).header);
                if (is_same) ++at;
                return is_same && sent.cmd == command::nop;
            });
            if (is_same) return &plan_.frame(i);
        }
        return nullptr;
    }
    // Whether all datagrams are those of this cycle.
    [[nodiscard]] bool answers(const process_frame& frame, const frame_view& view) const noexcept {
        auto at = view.begin();
        auto tag = first_tag();
        const bool is_same = walk(frame, [&](const planned& sent) {
            if (at == view.end()) return false;
            const auto header = (*at).header;
            ++at;
            const bool has_tag = header.index == tag;
            tag = rest_tag();
            return has_tag && is_return_of(sent, header);
        });
        return is_same && at == view.end();
    }

    void take(process_frame& frame, const frame_view& view) noexcept {
        frame.waits = false;
        --outstanding_;
        auto data = view.begin();
        if (frame.parts == 0) ++data;
        auto watched = data;
        for (std::size_t i = 0; i != frame.parts; ++i)
            for (int n = plan_.part(frame.first_part + i).counters.no_lrw ? 2 : 1; n != 0; --n) ++watched;
        std::size_t member = frame.first_member;
        const auto end = frame.first_member + frame.members;
        for (std::size_t i = 0; i != frame.parts; ++i) {
            const auto& part = plan_.part(frame.first_part + i);
            const bool is_exchanged = is_complete(part, data);
            is_counting_complete_ = is_counting_complete_ && is_exchanged;
            const auto back = (*data++).data;
            for (const auto last = member + part.members; member != last; ++member) {
                auto& each = plan_.member(member);
                const bool is_open = !options_.watch_slaves || watch(each, is_exchanged, frame.sent_at, watched);
                if (is_open && is_exchanged)
                    take_inputs(each.place, back.subspan(each.place.output_address - part.address));
            }
        }
        for (; options_.watch_slaves && member != end; ++member)
            watch(plan_.member(member), true, frame.sent_at, watched);
        if (has_ring(frame)) {
            const auto all = *watched;
            ring_ = {all.working_counter, all.value(esc_registers::al_status), frame.sent_at};
        }
        if (++returned_ != plan_.frame_count()) return;
        is_complete_ = is_counting_complete_;
        working_counter_ = counting_;
        ++(is_complete_ ? statistics_.complete : statistics_.incomplete);
    }
    // Checks the working counters; `next` is then at the datagram with the inputs.
    [[nodiscard]] bool is_complete(const process_part& part, frame_view::iterator& next) noexcept {
        const auto& counters = part.counters;
        const bool is_written = !counters.no_lrw || (*next++).working_counter == counters.write;
        const auto counter = (*next).working_counter;
        counting_ = static_cast<std::uint16_t>(counting_ + counter);
        return is_written && counter == (counters.no_lrw ? counters.read : counters.read_write);
    }
    // `back` begins with the slave's place.
    void take_inputs(const process_place& place, std::span<const std::byte> back) noexcept {
        std::ranges::copy(back.subspan(place.input_address - place.output_address, place.input_size),
                          piece(place.input_address, place.input_size).begin());
    }

    // Evaluates the registers of a slave. Returns whether its inputs are valid.
    static bool watch(process_member& each, bool is_exchanged, time_point sent_at,
                      frame_view::iterator& next) noexcept {
        auto& status = each.status;
        status.last_frame = sent_at;
        const auto state = *next++;
        if (state.working_counter == 1) status.al = state.value(esc_registers::al_status);
        status.reply_waiting = false;
        if (each.has_mailbox) {
            const auto reply = *next++;
            const auto mailbox = reply.value(sync_manager_handshake_of(1));
            status.reply_waiting = reply.working_counter == 1 && mailbox.enable && mailbox.full;
        }
        status.condition = condition_of(state.working_counter, status.al.state, is_exchanged);
        if (status.condition == slave_condition::running) status.last_running = status.last_frame;
        const bool is_open = status.al.state == al_state::op || status.al.state == al_state::safe_op;
        const bool counts = is_exchanged && is_open && state.working_counter == 1;
        if (counts) status.last_inputs = status.last_frame;
        return counts;
    }
    static slave_condition condition_of(unsigned answers, al_state state, bool is_exchanged) noexcept {
        if (answers == 0) return slave_condition::absent;
        if (answers > 1) return slave_condition::duplicate;
        if (state != al_state::op) return slave_condition::not_in_op;
        return is_exchanged ? slave_condition::running : slave_condition::incomplete;
    }

    static constexpr std::size_t ring_size = datagram_overhead + wire::max_size<al_status>;
    static constexpr std::chrono::nanoseconds longest_delay = std::chrono::seconds{10};

    process_plan plan_;
    std::span<std::byte> bytes_;
    process_image image_{};
    process_options options_{};
    ring_status ring_{};
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
