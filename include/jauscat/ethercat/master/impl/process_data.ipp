// The functions of process_data.
#pragma once
#include <jauscat/ethercat/master/process_data.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION process_data::process_data(std::span<process_slot> slots, std::span<std::byte> bytes) noexcept
    : plan_{slots}, bytes_{bytes} {
    std::ranges::fill(bytes_, std::byte{});
}

JAUSCAT_FUNCTION bool process_data::set_slaves(std::span<const slave_record> slaves,
                                               const process_options& options) noexcept {
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
    is_together_ = false;
    good_cycles_ = 0;
    next_polled_ = 0;
    if (fits_) fits_ = cut();
    next_ = plan_.frame_count();
    return fits_;
}

JAUSCAT_FUNCTION bool process_data::cut() noexcept {
    const auto ring = watches_ring() ? ring_size : 0;
    return plan_.cut(polls_each(), ring + polled_count() * process_plan::watch_size(true));
}

JAUSCAT_FUNCTION void process_data::choose_watch() noexcept {
    const bool is_good = is_complete_ && all_run();
    good_cycles_ = is_good ? good_cycles_ + 1 : 0;
    if (is_together_ ? is_good : good_cycles_ < cycles_alone) return;
    is_together_ = !is_together_;
    good_cycles_ = 0;
    ring_slaves_ = ring_.slaves;
    if (cut()) return;
    is_together_ = options_.watch_together = false; // the polls do not fit into one frame
    static_cast<void>(cut());                       // as before
}

JAUSCAT_FUNCTION bool process_data::all_run() const noexcept {
    if (is_together_) return is_ring_running_ && is_each_certain_;
    for (std::size_t i = 0; i != plan_.member_count(); ++i)
        if (plan_.member(i).status.condition != slave_condition::running) return false;
    return is_running(ring_.all);
}

JAUSCAT_FUNCTION std::span<std::byte> process_data::outputs(const slave_record& slave) noexcept {
    return piece(slave.process_data.output_address, slave.process_data.output_size);
}

JAUSCAT_FUNCTION std::span<const std::byte> process_data::inputs(const slave_record& slave) const noexcept {
    return piece(slave.process_data.input_address, slave.process_data.input_size);
}

JAUSCAT_FUNCTION const slave_status& process_data::status(const slave_record& slave) const noexcept {
    static constexpr slave_status unknown{};
    const auto* const found = plan_.find(slave.station, slave.process_data);
    return found != nullptr ? found->status : unknown;
}

JAUSCAT_FUNCTION void process_data::begin_cycle() noexcept {
    if (outstanding_ != 0) {
        ++statistics_.lost;
        statistics_.lost_frames += outstanding_;
        is_complete_ = false;
    }
    forget_frames();
    if (is_together_) next_polled_ = (next_polled_ + polled_count()) % plan_.member_count();
    if (options_.watch_slaves && options_.watch_together) choose_watch();
    is_ring_running_ = false;
    is_each_certain_ = true;
    next_ = 0;
    returned_ = 0;
    counting_ = 0;
    is_counting_complete_ = true;
    if (plan_.frame_count() != 0) ++cycle_;
}

JAUSCAT_FUNCTION std::size_t process_data::next_frame(std::span<std::byte> out, time_point now) noexcept {
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

JAUSCAT_FUNCTION bool process_data::on_frame(std::span<const std::byte> frame) noexcept {
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

JAUSCAT_FUNCTION bool process_data::holds(std::uint32_t address, std::size_t size) const noexcept {
    return size <= image_.size && address <= image_.size - size;
}

JAUSCAT_FUNCTION std::span<std::byte> process_data::piece(std::uint32_t address, std::size_t size) const noexcept {
    return holds(address, size) ? bytes_.subspan(address, size) : std::span<std::byte>{};
}

JAUSCAT_FUNCTION void process_data::clear(const process_place& place) noexcept {
    if (place.end() > bytes_.size()) return;
    std::ranges::fill(bytes_.subspan(place.output_address, place.output_size), std::byte{});
    std::ranges::fill(bytes_.subspan(place.input_address, place.input_size), std::byte{});
}

JAUSCAT_FUNCTION void process_data::forget_frames() noexcept {
    for (std::size_t i = 0; i != plan_.frame_count(); ++i) {
        auto& each = plan_.frame(i);
        if (!each.waits) continue;
        each.waits = false;
        missing_sent_at_ = each.sent_at;
        ++missing_;
    }
    outstanding_ = 0;
}

JAUSCAT_FUNCTION bool process_data::has_filler(const process_frame& frame) const noexcept {
    const bool is_alone =
        !has_ring(frame) && frame.parts == 1 && !plan_.part(frame.first_part).counters.no_lrw && !polls_each();
    return cycle_ > 0xFF && is_alone &&
           frame.size + datagram_overhead + process_plan::filler_size <= max_datagrams_size;
}

JAUSCAT_FUNCTION bool process_data::has_ring(const process_frame& frame) const noexcept {
    return watches_ring() && frame.first_member == 0;
}

JAUSCAT_FUNCTION bool process_data::begins_as_ours(const frame_view& frame) noexcept {
    const auto cmd = (*frame.begin()).header.cmd;
    return cmd == command::lrw || cmd == command::lwr || cmd == command::nop;
}

JAUSCAT_FUNCTION bool process_data::is_return_of(const planned& sent, const datagram_header& back) noexcept {
    const bool is_same = back.cmd == sent.cmd && back.ado == sent.ado && back.length == sent.length;
    return is_same && (back.adp == sent.adp || sent.cmd == command::brd); // which counts slaves in it
}

JAUSCAT_FUNCTION process_frame* process_data::find(const frame_view& view) const noexcept {
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

JAUSCAT_FUNCTION bool process_data::answers(const process_frame& frame, const frame_view& view) const noexcept {
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

JAUSCAT_FUNCTION void process_data::take(process_frame& frame, const frame_view& view) noexcept {
    frame.waits = false;
    --outstanding_;
    auto data = view.begin();
    if (frame.parts == 0) ++data;
    auto watched = data;
    for (std::size_t i = 0; i != frame.parts; ++i)
        for (int n = plan_.part(frame.first_part + i).counters.no_lrw ? 2 : 1; n != 0; --n) ++watched;
    if (is_together_ && has_ring(frame)) take_together(frame, watched);
    is_each_certain_ = is_each_certain_ && is_ring_running_;
    std::size_t member = frame.first_member;
    const auto end = frame.first_member + frame.members;
    for (std::size_t i = 0; i != frame.parts; ++i) {
        const auto& part = plan_.part(frame.first_part + i);
        const bool is_exchanged = is_complete(part, data);
        is_counting_complete_ = is_counting_complete_ && is_exchanged;
        const auto back = (*data++).data;
        for (const auto last = member + part.members; member != last; ++member) {
            auto& each = plan_.member(member);
            bool is_open = !is_together_ || is_ring_running_;
            if (polls_each()) is_open = watch(each, is_exchanged, frame.sent_at, watched);
            if (!is_open || !is_exchanged) continue;
            take_inputs(each.place, back.subspan(each.place.output_address - part.address));
            if (is_together_) set_running(each, frame.sent_at);
        }
    }
    for (; polls_each() && member != end; ++member) watch(plan_.member(member), true, frame.sent_at, watched);
    if (!is_together_ && has_ring(frame)) take_ring(frame, *watched);
    if (++returned_ != plan_.frame_count()) return;
    is_complete_ = is_counting_complete_;
    working_counter_ = counting_;
    ++(is_complete_ ? statistics_.complete : statistics_.incomplete);
}

JAUSCAT_FUNCTION void process_data::take_ring(const process_frame& frame, const datagram_view& all) noexcept {
    ring_ = {all.working_counter, all.value(esc_registers::al_status), frame.sent_at};
}

JAUSCAT_FUNCTION void process_data::take_together(const process_frame& frame, frame_view::iterator next) noexcept {
    take_ring(frame, *next++);
    is_ring_running_ = ring_.slaves == ring_slaves_ && is_running(ring_.all);
    for (std::size_t i = 0; i != plan_.member_count(); ++i) plan_.member(i).status.reply_waiting = false;
    for_each_polled([&](process_member& each) {
        const bool is_there = take_poll(each, next) == 1;
        is_ring_running_ = is_ring_running_ && is_there && is_running(each.status.al);
    });
    for (std::size_t i = 0; is_ring_running_ && i != plan_.member_count(); ++i)
        if (plan_.member(i).place.size() == 0) set_running(plan_.member(i), frame.sent_at);
}

JAUSCAT_FUNCTION void process_data::set_running(process_member& each, time_point sent_at) noexcept {
    auto& status = each.status;
    status.condition = slave_condition::running;
    status.al = {.state = al_state::op};
    status.last_frame = status.last_running = status.last_inputs = sent_at;
}

JAUSCAT_FUNCTION bool process_data::is_running(const al_status& al) noexcept {
    return al.state == al_state::op && !al.error;
}

JAUSCAT_FUNCTION std::uint16_t process_data::take_poll(process_member& each, frame_view::iterator& next) noexcept {
    const auto state = *next++;
    if (state.working_counter == 1) each.status.al = state.value(esc_registers::al_status);
    each.status.reply_waiting = false;
    if (each.has_mailbox) {
        const auto reply = *next++;
        const auto mailbox = reply.value(sync_manager_handshake_of(1));
        each.status.reply_waiting = reply.working_counter == 1 && mailbox.enable && mailbox.full;
    }
    return state.working_counter;
}

JAUSCAT_FUNCTION bool process_data::is_complete(const process_part& part, frame_view::iterator& next) noexcept {
    const auto& counters = part.counters;
    const bool is_written = !counters.no_lrw || (*next++).working_counter == counters.write;
    const auto counter = (*next).working_counter;
    counting_ = static_cast<std::uint16_t>(counting_ + counter);
    return is_written && counter == (counters.no_lrw ? counters.read : counters.read_write);
}

JAUSCAT_FUNCTION std::uint16_t process_data::expected_working_counter() const noexcept {
    std::uint16_t sum = 0;
    for (std::size_t i = 0; i != plan_.frame_count(); ++i) {
        const auto& frame = plan_.frame(i);
        for (std::size_t k = 0; k != frame.parts; ++k) {
            const auto& counters = plan_.part(frame.first_part + k).counters;
            sum = static_cast<std::uint16_t>(sum + (counters.no_lrw ? counters.read : counters.read_write));
        }
    }
    return sum;
}

JAUSCAT_FUNCTION void process_data::take_inputs(const process_place& place, std::span<const std::byte> back) noexcept {
    std::ranges::copy(back.subspan(place.input_address - place.output_address, place.input_size),
                      piece(place.input_address, place.input_size).begin());
}

JAUSCAT_FUNCTION bool process_data::watch(process_member& each, bool is_exchanged, time_point sent_at,
                                          frame_view::iterator& next) noexcept {
    auto& status = each.status;
    status.last_frame = sent_at;
    const auto answers = take_poll(each, next);
    status.condition = condition_of(answers, status.al.state, is_exchanged);
    if (status.condition == slave_condition::running) status.last_running = status.last_frame;
    const bool is_open = status.al.state == al_state::op || status.al.state == al_state::safe_op;
    const bool counts = is_exchanged && is_open && answers == 1;
    if (counts) status.last_inputs = status.last_frame;
    return counts;
}

JAUSCAT_FUNCTION slave_condition process_data::condition_of(unsigned answers, al_state state,
                                                            bool is_exchanged) noexcept {
    if (answers == 0) return slave_condition::absent;
    if (answers > 1) return slave_condition::duplicate;
    if (state != al_state::op) return slave_condition::not_in_op;
    return is_exchanged ? slave_condition::running : slave_condition::incomplete;
}

} // namespace jauscat::ethercat
