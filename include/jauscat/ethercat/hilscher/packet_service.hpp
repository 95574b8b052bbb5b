// Base of the services that execute packets.
#pragma once

#include <jauscat/ethercat/hilscher/packet_options.hpp>
#include <jauscat/ethercat/hilscher/packet_status.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// A packet that is executed: what a service gets to see of it.
struct packet_io {
    std::span<const std::byte> request{};
    std::span<std::byte> confirmation{};
    packet_options options{}; ///< options of the execution

    /// The confirmation's bytes from `offset` on.
    [[nodiscard]] std::span<std::byte> room(std::size_t offset) const noexcept {
        return confirmation.subspan(std::min(offset, confirmation.size()));
    }
};

/// State of a service: a job of the master is running, or the service has ended with `status`.
struct service_step {
    bool runs{};
    hilscher::packet_status status{};

    /// For what master::start returns.
    static constexpr service_step started(const master_result<>& start) noexcept {
        return start ? service_step{.runs = true} : service_step{.status = hilscher::packet_status::service_in_use};
    }
    static constexpr service_step done(hilscher::packet_status status = hilscher::packet_status::ok) noexcept {
        return {.status = status};
    }
};

/// Bytes of data behind a confirmation's fields, or why there is no such confirmation.
struct service_answer {
    std::size_t size{};
    hilscher::packet_status status{};
};

/// A service: begins with `asked`, goes on whenever a job of the master has ended, and fills its confirmation in the
/// end. Here is what most of them need: one job, whose result is the service's. `Repeated` bytes of the request's body
/// stand in a confirmation with an error.
template <class Request, class Confirmation, std::size_t Repeated = 0> struct packet_service {
    using request = Request;
    using confirmation = Confirmation;
    static constexpr std::size_t head_size = wire::max_size<hilscher::packet_header>;
    static constexpr std::size_t fields_size = wire::max_size<Confirmation>;
    static constexpr std::size_t repeated = Repeated;
    /// Least ulLen of a request.
    static constexpr std::size_t least_length = wire::max_size<Request> - head_size;
    /// The service consists of one job.
    static constexpr bool one_job = true;

    Request asked{};

    static service_step next(master& m, const packet_io&) noexcept {
        return service_step::done(hilscher::status_of(m.error()));
    }
};

/// A service that uses the mailbox of a slave. If the slave does not answer, its state gives the reason.
template <class Request, class Confirmation, std::size_t Repeated = 0>
struct packet_coe_service : packet_service<Request, Confirmation, Repeated> {
    using base = packet_service<Request, Confirmation, Repeated>;
    using base::asked;

    service_step next(master& m, const packet_io&) noexcept {
        using hilscher::packet_status;
        if (failed_ == packet_status::ok) {
            const auto& error = m.error();
            failed_ = hilscher::status_of(error);
            const bool silent = error.code == master_errc::working_counter || error.code == master_errc::mailbox_full ||
                                error.code == master_errc::mailbox_timeout;
            if (!silent) return service_step::done(failed_);
            return service_step::started(
                m.start(exchange_datagram{command::fprd, station(), esc_registers::al_status.address, read_}));
        }
        const auto counter = m.result<exchange_datagram>();
        if (!counter) return service_step::done(failed_);
        if (*counter == 0) return service_step::done(packet_status::coe_slave_not_addressable);
        al_status status{};
        static_cast<void>(wire::decode(status, read_));
        const bool has_mailbox = is_known(status.state) && status.state != al_state::init;
        return service_step::done(has_mailbox ? failed_ : packet_status::coe_invalid_communication_state);
    }

  protected:
    /// Checks the address of a request; `ok` or the error.
    [[nodiscard]] hilscher::packet_status check_target() const noexcept {
        using hilscher::packet_status;
        if (asked.ul_node_id > 0xFFFF) return packet_status::coe_invalid_slave_id;
        if constexpr (requires { asked.ul_index; })
            if (asked.ul_index > 0xFFFF) return packet_status::invalid_parameter;
        if constexpr (requires { asked.ul_sub_index; })
            if (asked.ul_sub_index > 0xFF) return packet_status::invalid_parameter;
        return packet_status::ok;
    }
    // The station address that check_target has found.
    [[nodiscard]] std::uint16_t station() const noexcept { return static_cast<std::uint16_t>(asked.ul_node_id); }
    [[nodiscard]] std::uint16_t index() const noexcept { return static_cast<std::uint16_t>(asked.ul_index); }
    [[nodiscard]] std::uint8_t subindex() const noexcept { return static_cast<std::uint8_t>(asked.ul_sub_index); }

  private:
    hilscher::packet_status failed_{}; // what the state of the slave is to explain
    std::array<std::byte, wire::max_size<al_status>> read_{};
};

} // namespace jauscat::ethercat
