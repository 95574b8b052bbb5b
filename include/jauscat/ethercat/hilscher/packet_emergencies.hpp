// Packets that name slaves by handles and read their emergencies.
#pragma once

#include <jauscat/ethercat/hilscher/packet_service.hpp>
#include <jauscat/schema/ethercat/hilscher_state.hpp>

#include <array>

namespace jauscat::ethercat {

/// The handles of the slaves that belong to the bus (configured), have been brought up (active), or belong to it and
/// have not been brought up (faulted). Here a slave's handle is its station address.
class packet_slave_handles
    : public packet_service<hilscher::get_slave_handles_request, hilscher::get_slave_handles_confirmation> {
  public:
    service_step begin(master& m, const packet_io& io) noexcept {
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
    service_answer answer(confirmation& out, const master&, const packet_io&) const noexcept {
        out.ul_param = asked.ul_param;
        return {.size = size_};
    }

  private:
    void put_active(const master& m, const packet_io& io) noexcept {
        for (const auto& slave : m.slaves()) put(slave.station, io);
    }
    void put(std::uint16_t station, const packet_io& io) noexcept {
        const auto used = wire::encode(hilscher::slave_handle{station}, io.room(fields_size + size_));
        if (!used) status_ = hilscher::packet_status::out_of_memory;
        size_ += used->size();
    }

    std::size_t size_{};
    hilscher::packet_status status_{};
};

/// The emergencies of a slave, with those that wait in its mailbox. A slave without a mailbox has none.
class packet_emergencies
    : public packet_service<hilscher::read_emergencies_request, hilscher::read_emergencies_confirmation> {
  public:
    static constexpr bool one_job = false;
    service_step begin(master& m, const packet_io&) noexcept {
        if (asked.ul_slave_handle > 0xFFFF || m.find(station()) == nullptr)
            return service_step::done(hilscher::packet_status::unknown_handle);
        return service_step::started(m.start(collect_emergencies{station()}));
    }
    service_step next(master& m, const packet_io&) noexcept {
        const auto& error = m.error();
        if (error != master_error{} && error.code != master_errc::no_mailbox && error.code != master_errc::no_coe)
            return service_step::done(hilscher::status_of(error));
        if (const auto* slave = m.find(station())) log_ = slave->emergencies;
        if (asked.f_delete_emergency != 0) m.clear_emergencies(station());
        return service_step::done();
    }
    service_answer answer(confirmation& out, const master&, const packet_io& io) const noexcept {
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

  private:
    [[nodiscard]] std::uint16_t station() const noexcept { return static_cast<std::uint16_t>(asked.ul_slave_handle); }

    emergency_log log_{};
};

} // namespace jauscat::ethercat
