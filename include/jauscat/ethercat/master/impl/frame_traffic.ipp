// The functions of frame_traffic.
#pragma once
#include <jauscat/ethercat/master/frame_traffic.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION void frame_traffic::begin() noexcept {
    losses_ = 0;
    repeats_ = false;
    not_before_ = time_point::min();
}

JAUSCAT_FUNCTION void frame_traffic::sent(std::span<const std::byte> frame, time_point now) noexcept {
    outstanding_.sent(frame, now);
    ++statistics_.sent;
}

JAUSCAT_FUNCTION replies frame_traffic::take(std::span<const std::byte> frame, bool was_refused) noexcept {
    frame_view view;
    const bool is_first = outstanding_.waits();
    if ((!is_first && !was_refused) || !view.parse(frame)) return {};
    const auto datagrams = outstanding_.match(view);
    if (datagrams.empty() || (!is_first && datagrams.front().working_counter == 0)) return {};
    ++statistics_.received;
    if (datagrams.front().header.circulating) ++statistics_.circulated;
    if (config_.frames_may_be_copied) unsettled_until_ = saturating_add(outstanding_.sent_at(), config_.frame_lifetime);
    losses_ = 0;
    repeats_ = false;
    return datagrams;
}

JAUSCAT_FUNCTION bool frame_traffic::claim(std::span<const std::byte> frame) noexcept {
    frame_view view;
    return view.parse(frame) && outstanding_.claim(view);
}

JAUSCAT_FUNCTION void frame_traffic::ignore(std::span<const std::byte> frame) noexcept {
    frame_view view;
    ++statistics_.ignored;
    if (view.parse(frame) && !outstanding_.claim(view)) ++statistics_.foreign;
}

JAUSCAT_FUNCTION bool frame_traffic::is_late(time_point now) const noexcept {
    return outstanding_.waits() && now - outstanding_.sent_at() >= config_.frame_timeout;
}

JAUSCAT_FUNCTION bool frame_traffic::lose(bool repeats) noexcept {
    ++statistics_.lost;
    give_up();
    repeats_ = repeats;
    return ++losses_ <= config_.retries;
}

JAUSCAT_FUNCTION void frame_traffic::give_up() noexcept {
    if (!outstanding_.waits()) return;
    unsettled_until_ = saturating_add(outstanding_.sent_at(), config_.frame_lifetime);
    outstanding_.forget();
}

JAUSCAT_FUNCTION time_point frame_traffic::next_event() const noexcept {
    return outstanding_.waits() ? saturating_add(outstanding_.sent_at(), config_.frame_timeout) : next_send();
}

JAUSCAT_FUNCTION time_point frame_traffic::next_send() const noexcept {
    return repeats_ ? not_before_ : std::max(not_before_, unsettled_until_);
}

} // namespace jauscat::ethercat
