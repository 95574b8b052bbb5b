// The functions of packet_emergencies.
#pragma once
#include <jauscat/ethercat/hilscher/packet_emergencies.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION service_step packet_slave_handles::begin(master& m, const packet_io& io) noexcept {
    using hilscher::handle_list;
    const auto configured = io.options.slaves;
    switch (asked.ul_param) {
    case handle_list::configured:
        for (const auto& slave : configured) put(slave.station, io);
        if (configured.empty()) put_active(m, io);
        break;
    case handle_list::active: put_active(m, io); break;
    case handle_list::faulted:
        for (const auto& slave : configured)
            if (m.find(slave.station) == nullptr) put(slave.station, io);
        break;
    default: return service_step::done(hilscher::packet_status::invalid_parameter);
    }
    return service_step::done(status_);
}

JAUSCAT_FUNCTION service_answer packet_slave_handles::answer(confirmation& out, const master&,
                                                             const packet_io&) const noexcept {
    out.ul_param = asked.ul_param;
    return {.size = size_};
}

JAUSCAT_FUNCTION void packet_slave_handles::put_active(const master& m, const packet_io& io) noexcept {
    for (const auto& slave : m.slaves()) put(slave.station, io);
}

JAUSCAT_FUNCTION void packet_slave_handles::put(std::uint16_t station, const packet_io& io) noexcept {
    const auto used = wire::encode(hilscher::slave_handle{station}, io.room(fields_size + size_));
    if (used)
        size_ += used->size();
    else
        status_ = hilscher::packet_status::out_of_memory;
}

JAUSCAT_FUNCTION service_step packet_emergencies::begin(master& m, const packet_io&) noexcept {
    if (asked.ul_slave_handle > 0xFFFF || m.find(station()) == nullptr)
        return service_step::done(hilscher::packet_status::unknown_handle);
    return service_step::started(m.start(collect_emergencies{station()}));
}

JAUSCAT_FUNCTION service_step packet_emergencies::next(master& m, const packet_io&) noexcept {
    const auto& error = m.error();
    if (error != master_error{} && error.code != master_errc::no_mailbox && error.code != master_errc::no_coe)
        return service_step::done(hilscher::status_of(error));
    if (const auto* slave = m.find(station())) log_ = slave->emergencies;
    if (asked.f_delete_emergency != 0) m.clear_emergencies(station());
    return service_step::done();
}

JAUSCAT_FUNCTION service_answer packet_emergencies::answer(confirmation& out, const master&,
                                                           const packet_io& io) const noexcept {
    static_assert(emergency_log::capacity == hilscher::emergency_buffer_records);
    out.ul_slave_handle = asked.ul_slave_handle;
    out.f_delete_emergency = asked.f_delete_emergency;
    out.f_overflow_occured = log_.overflow() ? 1 : 0;
    std::size_t size = 0;
    for (std::size_t i = 0; i != hilscher::emergency_buffer_records; ++i) {
        const auto record = i < log_.kept().size() ? log_.kept()[i] : coe_emergency{};
        const auto used = wire::encode(record, io.room(fields_size + size));
        if (!used) return {.status = hilscher::packet_status::out_of_memory};
        size += used->size();
    }
    return {.size = size};
}

} // namespace jauscat::ethercat
