// The functions of slave_identification.
#pragma once
#include <jauscat/ethercat/master/slave_identification.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION void slave_identification::request(frame_builder& frame) const noexcept {
    switch (step_) {
    case step::read_registers:
        frame.read(station_, esc_registers::station_alias);
        frame.read(station_, esc_registers::al_status);
        break;
    case step::take_sii: ethercat::take_sii(frame, station_); break;
    case step::read_alias:
    case step::read_identity: sii_.request(frame, station_); break;
    case step::give_sii: ethercat::give_sii(frame, station_); break;
    case step::ask_id:
        frame.write(station_, esc_registers::al_control, {.state = state_, .request_device_id = true});
        break;
    case step::wait_id: frame.read(station_, esc_registers::al_status); break;
    case step::end_id: frame.write(station_, esc_registers::al_control, {.state = state_});
    }
}

JAUSCAT_FUNCTION progress slave_identification::reply(replies datagrams, time_point now,
                                                      const master_config& config) noexcept {
    if (failure_ != master_error{}) return fail(failure_); // the SII is given back
    if (result_ = executed_by_one(datagrams); !result_) return progress::done;
    switch (step_) {
    case step::read_registers: {
        found_.alias = datagrams[0].value(esc_registers::station_alias).value;
        const auto status = datagrams[1].value(esc_registers::al_status);
        state_ = status.state;
        // With an error its code is in the place of the identification.
        wants_device_id_ = wants_device_id_ && !status.error && is_known(state_);
        return go(step::take_sii);
    }
    case step::take_sii: return read(step::read_alias, sii_words::station_alias, std::span{alias_});
    case step::read_alias:
    case step::read_identity: return sii_reply(datagrams.front(), now, config);
    case step::give_sii: return wants_device_id_ ? go(step::ask_id) : progress::done;
    case step::ask_id: return go(step::wait_id);
    case step::wait_id: {
        const auto status = datagrams.front().value(esc_registers::al_status);
        if (status.device_id_loaded && !status.error)
            found_.device_id = static_cast<std::uint16_t>(status.code);
        else if (!status.error && !timeout_.expired(now, config.sii_timeout))
            return progress::wait;
        return go(step::end_id);
    }
    default: return progress::done; // end_id
    }
}

JAUSCAT_FUNCTION progress slave_identification::go(step next) noexcept {
    step_ = next;
    return progress::send;
}

JAUSCAT_FUNCTION progress slave_identification::fail(const master_error& error) noexcept {
    result_ = error;
    return progress::done;
}

JAUSCAT_FUNCTION progress slave_identification::give_back(const master_error& why) noexcept {
    failure_ = why;
    return go(step::give_sii);
}

JAUSCAT_FUNCTION progress slave_identification::read(step next, std::uint32_t word,
                                                     std::span<std::byte> into) noexcept {
    sii_ = sii_read{word, into};
    return go(next);
}

JAUSCAT_FUNCTION progress slave_identification::sii_reply(const datagram_view& datagram, time_point now,
                                                          const master_config& config) noexcept {
    const auto after = sii_.reply(datagram, now, config);
    if (after != progress::done) return after;
    if (!sii_.result()) return give_back(sii_.result().error());
    if (step_ == step::read_alias) {
        esc_word alias{};
        static_cast<void>(wire::decode_prefix(alias, alias_));
        found_.stored_alias = alias.value;
        return read(step::read_identity, sii_words::identity, std::span{identity_});
    }
    static_cast<void>(wire::decode(found_.identity, identity_));
    return go(step::give_sii);
}

} // namespace jauscat::ethercat
