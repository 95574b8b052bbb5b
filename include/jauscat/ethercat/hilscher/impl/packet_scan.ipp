// The functions of packet_scan.
#pragma once
#include <jauscat/ethercat/hilscher/packet_scan.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION service_step packet_start_scan::next(master& m, const packet_io& io) noexcept {
    if (!counted_) {
        const auto slaves = m.result<scan>();
        if (!slaves) return service_step::done(hilscher::status_of(slaves.error()));
        counted_ = true;
        found_ = *slaves;
    } else if (is_of_link(m.error().code)) {
        return service_step::done(hilscher::status_of(m.error()));
    }
    if (position_ == std::min(found_, m.capacity())) return service_step::done();
    const auto position = static_cast<std::uint16_t>(position_++);
    return service_step::started(m.start(bring_up{position, scan_station(io, position)}));
}

JAUSCAT_FUNCTION service_answer packet_start_scan::answer(confirmation& out, const master&,
                                                          const packet_io&) const noexcept {
    out.ul_found_slaves = static_cast<std::uint32_t>(found_);
    return {};
}

JAUSCAT_FUNCTION service_step packet_scan_info::begin(master& m, const packet_io& io) noexcept {
    position_ = static_cast<std::uint16_t>(0u - asked.us_auto_inc_addr);
    if (find(m) != nullptr) return read_ports(m);
    return service_step::started(m.start(bring_up{position_, scan_station(io, position_)}));
}

JAUSCAT_FUNCTION service_step packet_scan_info::next(master& m, const packet_io&) noexcept {
    const auto& error = m.error();
    if (error.code == master_errc::no_slave) return service_step::done(hilscher::packet_status::coe_invalid_index);
    if (error != master_error{}) return service_step::done(hilscher::status_of(error));
    if (!reads_ports_) return read_ports(m);
    const bool was_read = *m.result<exchange_datagram>() != 0;
    return service_step::done(was_read ? hilscher::packet_status::ok : hilscher::packet_status::coe_invalid_index);
}

JAUSCAT_FUNCTION service_answer packet_scan_info::answer(confirmation& out, const master&,
                                                         const packet_io&) const noexcept {
    esc_word ports{};
    static_cast<void>(wire::decode(ports, read_));
    out.ul_vendor_id = identity_.vendor;
    out.ul_product_code = identity_.product;
    out.ul_revision_number = identity_.revision;
    out.ul_serial_number = identity_.serial;
    out.ul_port_state = ports.value;
    return {};
}

JAUSCAT_FUNCTION const slave_record* packet_scan_info::find(const master& m) const noexcept {
    const auto found = std::ranges::find(m.slaves(), position_, &slave_record::position);
    return found == m.slaves().end() ? nullptr : &*found;
}

JAUSCAT_FUNCTION service_step packet_scan_info::read_ports(master& m) noexcept {
    identity_ = find(m)->identity;
    reads_ports_ = true;
    return service_step::started(
        m.start(exchange_datagram{command::aprd, asked.us_auto_inc_addr, esc_registers::dl_status.address, read_}));
}

} // namespace jauscat::ethercat
