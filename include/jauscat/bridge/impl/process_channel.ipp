// The functions of process_channel.
#pragma once
#include <jauscat/bridge/process_channel.hpp>

namespace jauscat::bridging {

JAUSCAT_FUNCTION process_channel::process_channel(process_part& part, std::span<slave_front* const> slaves) noexcept
    : part_{part} {
    for (auto* const each : slaves.first(std::min(slaves.size(), group_capacity))) fronts_[count_++] = each;
}

JAUSCAT_FUNCTION bool process_channel::takes(const jaus::header& head) const {
    return head.data_flag == jaus::data_flag::only && !jaus::is_acknowledgement(head) && part_.takes(head.command_code);
}

JAUSCAT_FUNCTION bool process_channel::has_slaves() noexcept {
    return std::ranges::any_of(slaves(), [](const slave_data& each) { return !each.outputs.empty(); });
}

JAUSCAT_FUNCTION bool process_channel::has_inputs_within(duration limit, time_point now) const noexcept {
    return std::ranges::all_of(
        fronts(), [&](const slave_front* each) { return each->data().status.has_inputs_within(limit, now); });
}

JAUSCAT_FUNCTION result<void, translate::errc> process_channel::start(const process_times& times) {
    has_rest_outputs_ = false;
    misfit_ = part_.use_times(times);
    const auto were_absent = std::exchange(is_absent_, {});
    const auto started = part_.start(slaves(), times.period);
    is_started_ = static_cast<bool>(started);
    has_begun_ = has_begun_ || is_started_;
    if (is_started_)
        waiting_count_ = 0; // a stop order to those slaves that were not lost
    else
        is_absent_ = were_absent;
    return started;
}

JAUSCAT_FUNCTION void process_channel::leave_out(const slave_front& lost) noexcept {
    for (std::size_t i = 0; i != count_; ++i) is_absent_[i] = is_absent_[i] || fronts_[i] == &lost;
}

JAUSCAT_FUNCTION std::optional<drive_fault> process_channel::step(time_point now) {
    const auto fault = part_.step(slaves(), now);
    return misfit_.empty() ? fault : drive_fault{.reason = misfit_};
}

JAUSCAT_FUNCTION bool process_channel::has_command_of_others(const jaus::address& sender) const noexcept {
    return std::ranges::any_of(std::span{waiting_}.first(waiting_count_),
                               [&](const waiting& each) { return !each.stop && each.header.source != sender; });
}

JAUSCAT_FUNCTION std::optional<jaus::header> process_channel::make_room() noexcept {
    if (waiting_count_ < waiting_.size()) return std::nullopt;
    return drop_first();
}

JAUSCAT_FUNCTION std::optional<jaus::header> process_channel::drop_overdue(time_point now) {
    const bool is_overdue = waiting_count_ > 1 && waiting_.front().asked_until.is_reached(now);
    if (!is_overdue || !part_.is_preparing()) return std::nullopt;
    return drop_first();
}

JAUSCAT_FUNCTION jaus::header process_channel::drop_first() noexcept {
    const auto first = waiting_.front().header;
    std::shift_left(waiting_.begin(), waiting_.end(), 1);
    --waiting_count_;
    return first;
}

JAUSCAT_FUNCTION result<std::uint32_t, translate::errc> process_channel::command(const jaus::header& head, bytes body,
                                                                                 duration limit, time_point now) {
    const auto number = part_.command(head, body, slaves(), now);
    if (!number) return number;
    has_rest_outputs_ = false;
    waiting_[waiting_count_++] = {head, *number, limit, deadline{now, limit}, deadline{now, limit}, {}};
    return number;
}

JAUSCAT_FUNCTION std::optional<stop_order> process_channel::waiting_stop() const noexcept {
    return waiting_count_ == 0 ? std::nullopt : waiting_[0].stop;
}

JAUSCAT_FUNCTION std::optional<process_channel::ended> process_channel::next_ended(time_point now) {
    if (waiting_count_ == 0) return std::nullopt;
    const auto last = part_.executed(slaves());
    const auto waits = std::span{waiting_}.first(waiting_count_);
    const bool is_preparing = part_.is_preparing();
    for (waiting& each : waits) {
        const auto goes_on = [&] {
            return each.until.is_reached(now) && !has_reached(each.number, last) && part_.is_braking(slaves());
        };
        if (each.stop ? goes_on() : is_preparing) each.until = deadline{now, each.limit};
    }
    const auto found = std::ranges::find_if(
        waits, [&](const waiting& each) { return has_reached(each.number, last) || each.until.is_reached(now); });
    if (found == waits.end()) return std::nullopt;
    const waiting over = *found;
    std::copy(found + 1, waits.end(), found);
    --waiting_count_;
    const auto how = over.number == last               ? outcome::executed
                     : !has_reached(over.number, last) ? outcome::late
                     : over.stop                       ? outcome::executed
                                                       : outcome::superseded;
    return ended{over.header, how, over.stop};
}

JAUSCAT_FUNCTION result<std::span<std::byte>, translate::errc>
process_channel::answer(const jaus::header& query, bytes body, std::span<std::byte> out) {
    return part_.answer(query, body, slaves(), out);
}

JAUSCAT_FUNCTION slave_group process_channel::slaves() noexcept {
    for (std::size_t i = 0; i != count_; ++i) data_[i] = is_absent_[i] ? slave_data{} : fronts_[i]->data();
    return std::span{std::as_const(data_)}.first(count_);
}

} // namespace jauscat::bridging
