// Executes a request packet of a Hilscher card with the master.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/hilscher/packet_emergencies.hpp>
#include <jauscat/ethercat/hilscher/packet_info.hpp>
#include <jauscat/ethercat/hilscher/packet_scan.hpp>
#include <jauscat/ethercat/hilscher/packet_state.hpp>
#include <jauscat/ethercat/hilscher/packet_transfer.hpp>

#include <concepts>
#include <variant>

namespace jauscat::ethercat {

/// A packet in, its confirmation out. Both spans and the job itself stay in place until `finish`, and do not overlap.
///
///     packet_job job{request, confirmation};
///     for (bool runs = job.start(master); runs; runs = job.next(master)) ...; // drive the master until it is idle
///     const auto size = job.finish(master);
///
/// Services: SDO download and upload, OD list, object and entry description, get and set state, bus scan and its
/// results, slave handles and emergencies. Any other command is confirmed with unknown_command.
class packet_job {
  public:
    /// Bytes of confirmation that any request can do with.
    static constexpr std::size_t confirmation_size =
        wire::max_size<hilscher::packet_header> + hilscher::max_packet_body;

    /// Executes `request`; the answer is written to `confirmation`. Both must outlive this.
    JAUSCAT_FUNCTION packet_job(std::span<const std::byte> request, std::span<std::byte> confirmation,
                                const packet_options& options = {}) noexcept;

    /// Starts the requested service. If it returns false, no job of the master runs: call `finish`.
    [[nodiscard]] JAUSCAT_FUNCTION bool start(master& m) noexcept;

    /// The master's job has ended. True if another one runs now.
    [[nodiscard]] JAUSCAT_FUNCTION bool next(master& m) noexcept;

    /// Writes the confirmation and returns its size, 40 to 1596 bytes; 0 where the request is no request packet or the
    /// confirmation has no room. A service of several jobs that `next` has not seen through has failed.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t finish(const master& m) noexcept;
    /// The same where no job could be started, and why.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t finish(const master& m, const master_error& error) noexcept;

    /// Why the first job of the master that failed has done so; ok if none has. It has more detail than the status.
    [[nodiscard]] const master_error& error() const noexcept { return error_; }

  private:
    using packet_status = hilscher::packet_status;
    using packet_command = hilscher::packet_command;
    static constexpr std::size_t head_size = wire::max_size<hilscher::packet_header>;

    [[nodiscard]] JAUSCAT_FUNCTION static bool is_answer(const hilscher::packet_header& head) noexcept;

    [[nodiscard]] JAUSCAT_FUNCTION packet_status check_header() const noexcept;

    template <class Service> bool begin(master& m) noexcept {
        auto& service = service_.emplace<Service>();
        const auto fields = wire::decode_prefix(service.asked, io_.request);
        if (head_.ul_len < Service::least_length || (!fields && Service::least_length != 0))
            status_ = packet_status::invalid_packet_length;
        else if (io_.confirmation.size() < Service::fields_size)
            status_ = packet_status::out_of_memory;
        else
            return take(service.begin(m, io_));
        return false;
    }

    JAUSCAT_FUNCTION bool take(const service_step& step) noexcept;

    template <class Service> service_step next_of(Service& service, master& m) noexcept {
        if constexpr (std::is_same_v<Service, std::monostate>)
            return {};
        else
            return service.next(m, io_);
    }

    template <class Service> std::size_t confirm(Service& service, const master& m) noexcept {
        if constexpr (std::is_same_v<Service, std::monostate>) {
            return refuse(0);
        } else {
            if (runs_ && !Service::one_job && status_ == packet_status::ok)
                status_ = packet_status::fail; // not driven on
            if (status_ != packet_status::ok) return refuse(Service::repeated);
            typename Service::confirmation out{};
            const auto answer = service.answer(out, m, io_);
            status_ = answer.status;
            if (status_ != packet_status::ok) return refuse(Service::repeated);
            out.head = head_;
            out.head.ul_sta = status_;
            out.head.ul_len = static_cast<std::uint32_t>(Service::fields_size - head_size + answer.size);
            return wire::encode(out, io_.confirmation)->size() + answer.size;
        }
    }

    // A confirmation with an error: the header and the front of the request's body, zeros where the request has none.
    JAUSCAT_FUNCTION std::size_t refuse(std::size_t repeated) noexcept;

    static constexpr std::uint32_t channel_in_use = 0x20, last_channel = 4, sequence_bits = 0xC0;

    packet_io io_;
    hilscher::packet_header head_{};
    std::variant<std::monostate, packet_download, packet_upload, packet_od_list, packet_object, packet_entry,
                 packet_get_state, packet_set_state, packet_start_scan, packet_scan_info, packet_slave_handles,
                 packet_emergencies>
        service_{};
    packet_status status_{};
    master_error error_{};
    bool runs_{};    // a job of the master with an end not yet passed to `next`
    bool has_run_{}; // a job of the master was started
};

/// Executes a request packet and returns its confirmation, the front of `confirmation`; empty where packet_job::finish
/// gives none. `run()` drives the master until it is idle:
/// `execute_packet(master, request, confirmation, [&] { return net::run(link, master); })`.
template <std::invocable Run>
std::span<std::byte> execute_packet(master& m, std::span<const std::byte> request, std::span<std::byte> confirmation,
                                    Run&& run, const packet_options& options = {}) {
    packet_job job{request, confirmation, options};
    for (bool runs = job.start(m); runs; runs = job.next(m)) static_cast<void>(run());
    return confirmation.first(job.finish(m));
}

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/hilscher/impl/packet_job.ipp>
#endif
