// Packets that name slaves by handles and read their emergencies.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/hilscher/packet_service.hpp>
#include <jauscat/schema/ethercat/hilscher_state.hpp>

#include <array>

namespace jauscat::ethercat {

/// The handles of the slaves that belong to the bus (configured), have been brought up (active), or belong to it and
/// have not been brought up (faulted). Here a slave's handle is its station address.
class packet_slave_handles
    : public packet_service<hilscher::get_slave_handles_request, hilscher::get_slave_handles_confirmation> {
  public:
    JAUSCAT_FUNCTION service_step begin(master& m, const packet_io& io) noexcept;
    JAUSCAT_FUNCTION service_answer answer(confirmation& out, const master&, const packet_io&) const noexcept;

  private:
    JAUSCAT_FUNCTION void put_active(const master& m, const packet_io& io) noexcept;
    JAUSCAT_FUNCTION void put(std::uint16_t station, const packet_io& io) noexcept;

    std::size_t size_{};
    hilscher::packet_status status_{};
};

/// The emergencies of a slave, with those that wait in its mailbox. A slave without a mailbox has none.
class packet_emergencies
    : public packet_service<hilscher::read_emergencies_request, hilscher::read_emergencies_confirmation> {
  public:
    static constexpr bool one_job = false;
    JAUSCAT_FUNCTION service_step begin(master& m, const packet_io&) noexcept;
    JAUSCAT_FUNCTION service_step next(master& m, const packet_io&) noexcept;
    JAUSCAT_FUNCTION service_answer answer(confirmation& out, const master&, const packet_io& io) const noexcept;

  private:
    [[nodiscard]] std::uint16_t station() const noexcept { return static_cast<std::uint16_t>(asked.ul_slave_handle); }

    emergency_log log_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/hilscher/impl/packet_emergencies.ipp>
#endif
