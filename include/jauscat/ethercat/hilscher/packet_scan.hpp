// Packets that scan the bus and ask what the scan has found.
#pragma once

#include <jauscat/ethercat/hilscher/packet_service.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/hilscher_state.hpp>

#include <array>

namespace jauscat::ethercat {

/// The station address of the slave at `position`: the configured one, else 1 for the first in the ring.
[[nodiscard]] constexpr std::uint16_t scan_station(const packet_io& io, std::uint16_t position) noexcept {
    const auto configured = std::ranges::find(io.options.slaves, position, &bus_slave::position);
    return configured != io.options.slaves.end() ? configured->station : static_cast<std::uint16_t>(position + 1);
}

/// Takes all slaves to INIT, counts them, and brings each one up to PRE-OP, as many as the master has memory for: SDO
/// packets then reach them. Those that refuse are counted too; get_bus_scan_info reports their errors. The caller,
/// which drives the master's jobs, implements ulTimeout.
class packet_start_scan
    : public packet_service<hilscher::start_bus_scan_request, hilscher::start_bus_scan_confirmation> {
  public:
    static constexpr bool one_job = false;
    static constexpr std::size_t least_length = 0; // a manual has no timeout in it

    static service_step begin(master& m, const packet_io&) noexcept { return service_step::started(m.start(scan{})); }

    service_step next(master& m, const packet_io& io) noexcept {
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
    service_answer answer(confirmation& out, const master&, const packet_io&) const noexcept {
        out.ul_found_slaves = static_cast<std::uint32_t>(found_);
        return {};
    }

  private:
    [[nodiscard]] static constexpr bool is_of_link(master_errc error) noexcept {
        return error == master_errc::not_sent || error == master_errc::no_reply || error == master_errc::timeout ||
               error == master_errc::no_space;
    }

    bool counted_{};
    std::size_t found_{};
    std::size_t position_{}; // of the slave that is next
};

/// Identity of a slave and state of its ports. A slave that no scan has brought up is brought up first.
class packet_scan_info
    : public packet_service<hilscher::get_bus_scan_info_request, hilscher::get_bus_scan_info_confirmation> {
  public:
    static constexpr bool one_job = false;
    service_step begin(master& m, const packet_io& io) noexcept {
        position_ = static_cast<std::uint16_t>(0u - asked.us_auto_inc_addr);
        if (find(m) != nullptr) return read_ports(m);
        return service_step::started(m.start(bring_up{position_, scan_station(io, position_)}));
    }
    service_step next(master& m, const packet_io&) noexcept {
        const auto& error = m.error();
        if (error.code == master_errc::no_slave) return service_step::done(hilscher::packet_status::coe_invalid_index);
        if (error != master_error{}) return service_step::done(hilscher::status_of(error));
        if (!reads_ports_) return read_ports(m);
        const bool was_read = *m.result<exchange_datagram>() != 0;
        return service_step::done(was_read ? hilscher::packet_status::ok : hilscher::packet_status::coe_invalid_index);
    }
    service_answer answer(confirmation& out, const master&, const packet_io&) const noexcept {
        esc_word ports{};
        static_cast<void>(wire::decode(ports, read_));
        out.ul_vendor_id = identity_.vendor;
        out.ul_product_code = identity_.product;
        out.ul_revision_number = identity_.revision;
        out.ul_serial_number = identity_.serial;
        out.ul_port_state = ports.value;
        return {};
    }

  private:
    [[nodiscard]] const slave_record* find(const master& m) const noexcept {
        const auto found = std::ranges::find(m.slaves(), position_, &slave_record::position);
        return found == m.slaves().end() ? nullptr : &*found;
    }
    service_step read_ports(master& m) noexcept {
        identity_ = find(m)->identity;
        reads_ports_ = true;
        return service_step::started(
            m.start(exchange_datagram{command::aprd, asked.us_auto_inc_addr, esc_registers::dl_status.address, read_}));
    }

    std::uint16_t position_{};
    bool reads_ports_{};
    sii_identity identity_{};
    std::array<std::byte, wire::max_size<esc_word>> read_{};
};

} // namespace jauscat::ethercat
