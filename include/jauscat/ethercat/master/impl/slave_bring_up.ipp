// The functions of slave_bring_up.
#pragma once
#include <jauscat/ethercat/master/slave_bring_up.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION slave_bring_up::slave_bring_up(std::uint16_t position, std::uint16_t station,
                                                const identity_check& expected, bool may_be_taken,
                                                const slave_timeouts& timeouts) noexcept
    : may_be_taken_{may_be_taken}, expected_{expected}, change_{state_change::to_init(station, timeouts)} {
    slave_.position = position;
    slave_.station = station;
    slave_.timeouts = timeouts;
}

JAUSCAT_FUNCTION void slave_bring_up::request(frame_builder& frame) noexcept {
    const auto station = slave_.station;
    switch (step_) {
    case step::count: frame.add(command::brd, 0, esc_registers::type.address, std::size_t{1}); break;
    case step::assign: assign(frame); break;
    case step::clear: // an alias that equals the address, too; then this slave alone gets it
        frame.add(command::fpwr, station, esc_registers::dl_control.address + alias_byte, std::size_t{1});
        frame.write(station, esc_registers::station_address, {});
        assign(frame);
        break;
    case step::verify:
        frame.add(command::fprd, station, esc_registers::station_addresses.address,
                  std::size_t{esc_registers::station_addresses.size});
        break;
    case step::take_sii: ethercat::take_sii(frame, station); break;
    case step::read_identity:
    case step::read_mailbox: sii_.request(frame, station); break;
    case step::configure: // a SyncManager can be changed only while it is off
        frame.write(station, esc_registers::mailbox_managers, {});
        frame.write(station, esc_registers::mailbox_managers, managers());
        break;
    case step::give_sii: ethercat::give_sii(frame, station); break;
    case step::to_init:
    case step::to_pre_op: change_.request(frame); break;
    }
}

JAUSCAT_FUNCTION progress slave_bring_up::reply(replies datagrams, time_point now,
                                                const master_config& config) noexcept {
    if (failure_ != master_error{}) return fail(failure_); // the SII is given back
    const auto counter = datagrams.front().working_counter;
    switch (step_) {
    case step::count:
        return counter > slave_.position ? go(step::assign) : fail({.code = master_errc::no_slave, .slaves = counter});
    case step::assign:
        return counter == 1 ? go(step::verify) : fail({.code = master_errc::no_slave, .slaves = counter});
    case step::to_init:
    case step::to_pre_op: return finish(change_, change_.reply(datagrams, now, config));
    case step::verify:
        if (counter == 0) return fail({.code = master_errc::wrong_station, .station = slave_.station});
        // An earlier master has left the address at another slave. Where it stays there, it is reported.
        if (counter > 1 && std::exchange(may_be_taken_, false)) return go(step::clear);
        break;
    case step::clear:
        if (datagrams.back().working_counter != 1) return fail({.code = master_errc::no_slave});
        return go(step::verify);
    default: break;
    }
    if (result_ = executed_by_one(datagrams); !result_) return progress::done;
    switch (step_) {
    case step::verify: return verified(datagrams.front());
    case step::take_sii: return read(step::read_identity, sii_words::identity, identity_);
    case step::read_identity:
    case step::read_mailbox: return finish(sii_, sii_.reply(datagrams.front(), now, config));
    case step::configure: return go(step::give_sii);
    default: break; // give_sii
    }
    change_ = state_change::step_up(slave_.station, al_state::init, slave_.timeouts);
    return go(step::to_pre_op);
}

JAUSCAT_FUNCTION void slave_bring_up::assign(frame_builder& frame) const noexcept {
    const auto position = static_cast<std::uint16_t>(-slave_.position);
    frame.add(command::apwr, position, esc_registers::station_address.address, esc_word{slave_.station});
}

JAUSCAT_FUNCTION progress slave_bring_up::go(step next) noexcept {
    step_ = next;
    return progress::send;
}

JAUSCAT_FUNCTION progress slave_bring_up::read(step next, std::uint32_t word, std::span<std::byte> into) noexcept {
    sii_ = sii_read{word, into};
    return go(next);
}

JAUSCAT_FUNCTION progress slave_bring_up::fail(const master_error& error) noexcept {
    result_ = error;
    return progress::done;
}

JAUSCAT_FUNCTION progress slave_bring_up::give_back(const master_error& why) noexcept {
    failure_ = why;
    return go(step::give_sii);
}

JAUSCAT_FUNCTION progress slave_bring_up::verified(const datagram_view& datagram) noexcept {
    esc_word address{}, alias{};
    static_cast<void>(wire::decode_prefix(address, datagram.data));
    static_cast<void>(wire::decode_prefix(alias, datagram.data.subspan(wire::max_size<esc_word>)));
    slave_.alias = alias.value;
    return address.value == slave_.station ? go(step::to_init)
                                           : fail({.code = master_errc::wrong_station, .station = slave_.station});
}

JAUSCAT_FUNCTION progress slave_bring_up::identified() noexcept {
    static_cast<void>(wire::decode(slave_.identity, identity_));
    if (!expected_.accepts(slave_.identity))
        return give_back({.code = master_errc::wrong_identity, .product = slave_.identity.product});
    return read(step::read_mailbox, sii_words::mailbox, mailbox_);
}

JAUSCAT_FUNCTION progress slave_bring_up::mailbox_read() noexcept {
    auto& mailbox = slave_.mailbox;
    static_cast<void>(wire::decode(mailbox, mailbox_));
    if (mailbox.receive_size == 0 && mailbox.send_size == 0) return go(step::give_sii); // a slave without one
    const auto usable = [](std::uint16_t size) { return size >= min_mailbox_size && size <= max_mailbox_size; };
    if (!usable(mailbox.receive_size) || !usable(mailbox.send_size))
        return give_back({.code = master_errc::no_mailbox});
    return go(step::configure);
}

JAUSCAT_FUNCTION mailbox_managers slave_bring_up::managers() const noexcept {
    return {.out = {.start = slave_.mailbox.receive_offset,
                    .length = slave_.mailbox.receive_size,
                    .mode = sync_manager_mode::mailbox,
                    .direction = sync_manager_direction::master_writes,
                    .pdi_interrupt = true,
                    .enable = true},
            .in = {.start = slave_.mailbox.send_offset,
                   .length = slave_.mailbox.send_size,
                   .mode = sync_manager_mode::mailbox,
                   .direction = sync_manager_direction::master_reads,
                   .pdi_interrupt = true,
                   .enable = true}};
}

} // namespace jauscat::ethercat
