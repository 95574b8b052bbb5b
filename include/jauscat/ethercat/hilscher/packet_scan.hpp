// Packets that scan the bus and ask what the scan has found.
#pragma once

#include <jauscat/base/compilation.hpp>
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

    JAUSCAT_FUNCTION service_step next(master& m, const packet_io& io) noexcept;
    JAUSCAT_FUNCTION service_answer answer(confirmation& out, const master&, const packet_io&) const noexcept;

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
    JAUSCAT_FUNCTION service_step begin(master& m, const packet_io& io) noexcept;
    JAUSCAT_FUNCTION service_step next(master& m, const packet_io&) noexcept;
    JAUSCAT_FUNCTION service_answer answer(confirmation& out, const master&, const packet_io&) const noexcept;

  private:
    [[nodiscard]] JAUSCAT_FUNCTION const slave_record* find(const master& m) const noexcept;
    JAUSCAT_FUNCTION service_step read_ports(master& m) noexcept;

    std::uint16_t position_{};
    bool reads_ports_{};
    sii_identity identity_{};
    std::array<std::byte, wire::max_size<esc_word>> read_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/hilscher/impl/packet_scan.ipp>
#endif
