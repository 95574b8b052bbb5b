// Cyclic exchange of process data: one frame per cycle carries all outputs and inputs and, optionally, reads each
// slave's state.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/outstanding_frame.hpp>
#include <jauscat/ethercat/master/process_image.hpp>
#include <jauscat/ethercat/master/slave_status.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Frame statistics of the cycles.
struct process_statistics {
    std::uint64_t sent{};
    std::uint64_t complete{};   ///< every slave took part
    std::uint64_t incomplete{}; ///< returned with a smaller or larger working counter: the inputs are the previous ones
    std::uint64_t lost{};       ///< did not come back before the next cycle
};

/// Optional content of a cycle's frame.
struct process_options {
    /// Each frame asks every slave for its AL status and whether mail waits: see `status`. The process data of each
    /// slave then have a datagram of their own, so that one slave's failure does not make another's inputs old. That
    /// takes 45 bytes of the frame for each slave.
    bool watch_slaves{};
    /// That of the master which has configured the slaves.
    std::uint32_t logical_base{};
};

/// Sends the process image when a cycle is due; a frame that has not returned by then is lost, and the next one is sent
/// nevertheless, because the newest outputs count. Runs beside a master on the same link: pass each received frame to
/// `on_frame` first, and to the master if it was not accepted.
class process_data {
  public:
    process_data() noexcept = default;
    /// The slaves' places, as `configure` has left them. All outputs are 0.
    explicit process_data(std::span<const slave_record> slaves, const process_options& options = {}) noexcept
        : image_{process_image::of(slaves)}, watches_{options.watch_slaves}, base_{options.logical_base} {
        fits_ = slaves.size() <= members_.size() && image_.size <= bytes_.size();
        if (!fits_) image_ = {};
        if (!fits_) return;
        if (!watches_) add_part(0, image_.size, image_);
        for (const auto& slave : slaves) add_member(slave);
        fits_ = datagrams_size() <= max_datagrams_size;
    }

    /// Takes the place of `before`, for other slaves on the same link: counts go on, and a frame of `before` that is
    /// still under way is known, and passed over.
    void follow(const process_data& before) noexcept {
        outstanding_ = before.outstanding_;
        outstanding_.forget();
        cycle_ = before.cycle_;
        statistics_ = before.statistics_;
    }

    /// Whether one frame holds all data. If not, no frame is ever sent.
    [[nodiscard]] bool fits() const noexcept { return fits_; }

    /// The addresses of each slave's data.
    [[nodiscard]] const process_image& image() const noexcept { return image_; }
    /// Outputs of a slave: what is written here goes out with the next cycle.
    [[nodiscard]] std::span<std::byte> outputs(const slave_record& slave) noexcept {
        return piece(slave.process_data.output_address, slave.process_data.output_size);
    }
    /// Inputs of a slave, as the last complete cycle brought them. Of a slave that is watched: as the last cycle did in
    /// which its own data were exchanged and it was in SAFE-OP or OP; `status` says when that was.
    [[nodiscard]] std::span<const std::byte> inputs(const slave_record& slave) const noexcept {
        const auto& place = slave.process_data;
        return holds(place.input_address, place.input_size)
                   ? std::span{bytes_}.subspan(place.input_address, place.input_size)
                   : std::span<const std::byte>{};
    }
    /// Status of a slave from the last cycles; `silent` if it is not watched.
    [[nodiscard]] const slave_status& status(const slave_record& slave) const noexcept {
        static constexpr slave_status unknown{};
        const auto found = std::ranges::find(members(), slave.station, &member::station);
        return found != members().end() ? found->status : unknown;
    }

    /// A cycle is due: writes its frame to `out`, which holds 1514 bytes, and returns its size; 0 where there is
    /// nothing to exchange, and where it does not fit.
    [[nodiscard]] std::size_t next_frame(std::span<std::byte> out, time_point now) noexcept {
        if (outstanding_.waits()) {
            ++statistics_.lost;
            is_complete_ = false;
        }
        outstanding_.forget();
        if (!fits_ || datagrams_size() == 0) return 0;
        ++cycle_;
        const auto low = static_cast<std::uint8_t>(cycle_), high = static_cast<std::uint8_t>(cycle_ >> 8);
        frame_builder frame{out, low};
        frame.tag_rest(static_cast<std::uint8_t>(low + high));
        if (part_count_ == 0) frame.add(command::nop, 0, 0, filler_size);
        for (const auto& each : parts()) request(frame, each);
        for (const auto& each : members())
            if (watches_) request(frame, each);
        if (high != 0 && has_filler()) frame.add(command::nop, 0, 0, filler_size);
        const auto finished = frame.finish();
        if (!finished) return 0;
        outstanding_.sent(*finished, now);
        ++statistics_.sent;
        return finished->size();
    }

    /// Takes a frame that arrived. False if it is none of ours: it may be the master's.
    bool on_frame(std::span<const std::byte> frame) noexcept {
        frame_view view;
        if (!view.parse(frame) || !begins_as_ours(view)) return false;
        const auto datagrams = outstanding_.waits() ? outstanding_.match(view) : replies{};
        if (datagrams.empty()) return outstanding_.claim(view);
        auto next = datagrams.begin() + (part_count_ == 0 ? 1 : 0);
        std::array<exchanged, slave_capacity> back{};
        working_counter_ = 0;
        is_complete_ = true;
        for (std::size_t i = 0; i != part_count_; ++i) {
            back[i] = take(parts_[i], next);
            is_complete_ = is_complete_ && back[i].is_complete;
        }
        ++(is_complete_ ? statistics_.complete : statistics_.incomplete);
        for (auto& each : members()) {
            const auto data = each.part == no_part ? exchanged{} : back[each.part];
            const bool is_open = !watches_ || watch(each, data.is_complete, next);
            if (is_open && data.is_complete) take_inputs(each, data.bytes);
        }
        return true;
    }

    /// The cycle's frame is not back yet.
    [[nodiscard]] bool waits() const noexcept { return outstanding_.waits(); }
    /// Every slave took part in the last cycle: its frame has returned, with the expected working counter.
    [[nodiscard]] bool is_complete() const noexcept { return is_complete_; }
    /// Working counter of the process data in the last reply; the sum if each slave has its own datagram.
    [[nodiscard]] std::uint16_t working_counter() const noexcept { return working_counter_; }
    [[nodiscard]] const process_statistics& statistics() const noexcept { return statistics_; }

  private:
    /// A piece of the image that has datagrams of its own, and the working counters that these have to have.
    struct part {
        std::uint32_t address{};
        std::size_t size{};
        std::uint16_t write{}, read{};
    };
    /// Reply of a part.
    struct exchanged {
        std::span<const std::byte> bytes{};
        bool is_complete{true};
    };
    static constexpr std::size_t no_part = slave_capacity;
    struct member {
        std::uint16_t station{};
        bool has_mailbox{};
        std::uint32_t input_address{};
        std::uint16_t input_size{};
        std::size_t part{no_part}; ///< that has its process data
        slave_status status{};
    };

    static constexpr std::size_t filler_size = 1;
    static constexpr std::size_t max_datagrams = slave_capacity * 4; // LWR, LRD, AL status, reply mailbox

    [[nodiscard]] std::span<const part> parts() const noexcept { return std::span{parts_}.first(part_count_); }
    [[nodiscard]] std::span<const member> members() const noexcept { return std::span{members_}.first(member_count_); }
    [[nodiscard]] std::span<member> members() noexcept { return std::span{members_}.first(member_count_); }

    [[nodiscard]] bool holds(std::uint32_t address, std::size_t size) const noexcept {
        return size <= image_.size && address <= image_.size - size;
    }
    [[nodiscard]] std::span<std::byte> piece(std::uint32_t address, std::size_t size) noexcept {
        return holds(address, size) ? std::span{bytes_}.subspan(address, size) : std::span<std::byte>{};
    }

    void add_part(std::uint32_t address, std::size_t size, const process_image& counters) noexcept {
        if (size != 0) parts_[part_count_++] = {address, size, counters.write, counters.read};
    }
    void add_member(const slave_record& slave) noexcept {
        const auto& place = slave.process_data;
        if (watches_) add_part(place.output_address, place.size(), process_image::of({&slave, 1}));
        members_[member_count_++] = {.station = slave.station,
                                     .has_mailbox = slave.mailbox.send_size != 0,
                                     .input_address = place.input_address,
                                     .input_size = place.input_size,
                                     .part = place.size() != 0 ? part_count_ - 1 : no_part};
    }

    // A datagram alone has one index, which is the same every 256 cycles: a reply that late would be taken for the
    // present one. From then on another datagram carries the rest of the cycle's number.
    [[nodiscard]] bool has_filler() const noexcept {
        const bool is_alone = part_count_ == 1 && !image_.no_lrw && !watches_;
        return is_alone && datagrams_size() + datagram_overhead + filler_size <= max_datagrams_size;
    }
    // Size of all datagrams of a cycle.
    [[nodiscard]] std::size_t datagrams_size() const noexcept {
        if (part_count_ == 0 && (!watches_ || member_count_ == 0)) return 0;
        std::size_t size = part_count_ == 0 ? datagram_overhead + filler_size : 0;
        for (const auto& each : parts()) size += (datagram_overhead + each.size) * (image_.no_lrw ? 2 : 1);
        for (const auto& each : members()) {
            if (!watches_) break;
            size += datagram_overhead + wire::max_size<al_status>;
            if (each.has_mailbox) size += datagram_overhead + wire::max_size<sync_manager_handshake>;
        }
        return size;
    }

    // A master's frames begin with neither: without this a frame that only looks at a state would be taken for its own.
    [[nodiscard]] static bool begins_as_ours(const frame_view& frame) noexcept {
        const auto cmd = (*frame.begin()).header.cmd;
        return cmd == command::lrw || cmd == command::lwr || cmd == command::lrd || cmd == command::nop;
    }
    void request(frame_builder& frame, const part& each) const noexcept {
        const auto data = std::span{bytes_}.subspan(each.address, each.size);
        const auto address = base_ + each.address;
        const auto low = static_cast<std::uint16_t>(address), high = static_cast<std::uint16_t>(address >> 16);
        if (!image_.no_lrw) return frame.add(command::lrw, low, high, data);
        frame.add(command::lwr, low, high, data);
        frame.add(command::lrd, low, high, each.size);
    }
    void request(frame_builder& frame, const member& each) const noexcept {
        frame.read(each.station, esc_registers::al_status);
        if (each.has_mailbox) frame.read(each.station, sync_manager_handshake_of(1));
    }

    exchanged take(const part& each, replies::iterator& next) noexcept {
        const bool written = !image_.no_lrw || next++->working_counter == each.write;
        const auto& last = *next++;
        working_counter_ = static_cast<std::uint16_t>(working_counter_ + last.working_counter);
        const int expected = image_.no_lrw ? each.read : each.read + 2 * each.write;
        return {last.data, written && last.working_counter == expected};
    }

    void take_inputs(const member& each, std::span<const std::byte> data) noexcept {
        if (each.input_size == 0) return;
        const auto offset = each.input_address - parts_[each.part].address;
        std::ranges::copy(data.subspan(offset, each.input_size), piece(each.input_address, each.input_size).begin());
    }

    // Evaluates the registers of a slave. Returns whether its inputs are valid.
    bool watch(member& each, bool is_exchanged, replies::iterator& next) noexcept {
        auto& status = each.status;
        status.last_frame = outstanding_.sent_at();
        const auto& state = *next++;
        if (state.working_counter == 1) status.al = state.value(esc_registers::al_status);
        status.reply_waiting = false;
        if (each.has_mailbox) {
            const auto& reply = *next++;
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

    process_image image_{};
    bool watches_{};
    std::uint32_t base_{};
    bool fits_{true};
    std::array<std::byte, max_process_image> bytes_{};
    std::array<part, slave_capacity> parts_{};
    std::size_t part_count_{};
    std::array<member, slave_capacity> members_{};
    std::size_t member_count_{};
    outstanding_frame<max_datagrams> outstanding_{};
    std::uint16_t cycle_{}; // its low byte tags the first datagram, its high byte those that follow
    std::uint16_t working_counter_{};
    bool is_complete_{};
    process_statistics statistics_{};
};

} // namespace jauscat::ethercat
