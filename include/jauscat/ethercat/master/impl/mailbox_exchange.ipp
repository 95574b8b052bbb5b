// The functions of mailbox_exchange.
#pragma once
#include <jauscat/ethercat/master/mailbox_exchange.hpp>

#include <utility>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION mailbox_exchange::mailbox_exchange(slave_record& slave) noexcept
    : step_{slave.awaits_late_answer ? step::look_taken
            : slave.drained          ? step::write
                                     : step::drain},
      counter_before_{slave.last_counter},
      may_write_{!slave.awaits_late_answer} {
    slave.last_counter = after(slave.last_counter);
}

JAUSCAT_FUNCTION mailbox_exchange mailbox_exchange::collect() noexcept {
    mailbox_exchange exchange;
    exchange.step_ = exchange.resume_ = step::collect;
    exchange.asks_ = false;
    return exchange;
}

JAUSCAT_FUNCTION bool mailbox_exchange::is_repeatable() const noexcept {
    return step_ != step::drain && step_ != step::collect && step_ != step::read;
}

JAUSCAT_FUNCTION void mailbox_exchange::lost(slave_record& slave) noexcept {
    slave.drained = false;
    if (std::exchange(is_writing_, false)) unsure_ = true;
    if (is_repeatable()) return;
    resume_ = step_;
    step_ = step::look;
}

JAUSCAT_FUNCTION void mailbox_exchange::abandon(slave_record& slave) const noexcept {
    slave.drained = false;
    if (!asks_) return;
    if (has_asked())
        slave.awaits_late_answer = true;
    else
        slave.last_counter = counter_before_; // a slave may drop a message with the counter of the one before
}

JAUSCAT_FUNCTION progress mailbox_exchange::go(step next) noexcept {
    step_ = next;
    return progress::send;
}

JAUSCAT_FUNCTION progress mailbox_exchange::fail(const master_error& error, slave_record& slave) noexcept {
    abandon(slave);
    result_ = error;
    return progress::done;
}

JAUSCAT_FUNCTION mailbox_exchange::envelope mailbox_exchange::open(std::span<const std::byte> data,
                                                                   slave_record& slave) noexcept {
    envelope reply{};
    static_cast<void>(wire::decode_prefix(reply.header, data));
    const auto body = data.subspan(wire::max_size<mailbox_header>);
    if (reply.header.length <= body.size()) reply.message = body.first(reply.header.length);
    slave.last_reply_mark = mark_of(reply);
    return reply;
}

JAUSCAT_FUNCTION std::uint32_t mailbox_exchange::mark_of(const envelope& reply) noexcept {
    constexpr std::size_t telling = 16;
    std::uint32_t mark = reply.header.counter * 65'536u + reply.header.length;
    for (const std::byte byte : reply.message.first(std::min(telling, reply.message.size())))
        mark = mark * 31u + std::to_integer<std::uint32_t>(byte);
    return mark;
}

JAUSCAT_FUNCTION void mailbox_exchange::note_emergency(const envelope& reply, slave_record& slave) noexcept {
    coe_header coe{};
    const auto used = wire::decode_prefix(coe, reply.message);
    coe_emergency emergency{};
    if (reply.header.type == mailbox_type::coe && used && coe.service == coe_service::emergency &&
        wire::decode_prefix(emergency, reply.message.subspan(*used)))
        slave.emergencies.note(emergency);
}

} // namespace jauscat::ethercat
