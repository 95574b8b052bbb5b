// The exchange of SDO packets that carries one JAUS message to a slave and, after a query, its report back. The caller
// has the packets executed, by a card or by the master (packet_job.hpp).
#pragma once

#include <jauscat/bridge/delivery.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/ethercat/hilscher.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::bridging {

/// State of an exchange after a step.
enum class exchange_progress : std::uint8_t {
    ignored, ///< not the confirmation that is waited for: nothing has changed
    request, ///< the next request packet is in the buffer: have it executed
    done,    ///< the slave has accepted the message; after a query the buffer has its report, a JAUS message
    failed,  ///< see `status()` and `error()`
};

/// Result of a step, and the number of bytes written to the front of the buffer.
struct exchange_step {
    exchange_progress what{}; ///< next action
    std::size_t size{};
};

/// One exchange at a time, under a translation table between jaus::header and the SDO download request:
///
///     auto step = exchange.begin(message, buffer);
///     while (step.what == exchange_progress::request)
///         step = exchange.on_confirmation(execute(std::span{buffer}.first(step.size)), buffer);
///     if (step.what == exchange_progress::done && step.size != 0) send(std::span{buffer}.first(step.size)); // report
///     if (const auto size = exchange.acknowledgement(buffer)) send(std::span{buffer}.first(size));
///
/// A message becomes an SDO download. A query is downloaded to its own subindex, because an upload has no body for its
/// fields; the slave prepares the report, and an SDO upload of the report's subindex returns it.
template <class Table> class packet_exchange {
  public:
    using delivery = bridging::delivery<Table>;
    using translator = typename delivery::translator;
    using packet = typename delivery::packet;
    /// Bytes of buffer that every step can do with: the largest packet or message.
    static constexpr std::size_t buffer_size = std::max(translator::max_packet_size, translator::max_message_size);

    /// `slave` replaces octets of 255 ("all") of the destination.
    constexpr explicit packet_exchange(const slave_identity& slave) noexcept : slave_{slave} {}

    /// Starts to deliver a JAUS message: writes its download request to `buffer`; fields set by the caller, such as a
    /// packet number, come from `given`. Fails with the errors of translator::to_packet, and of delivery:
    /// fragment_to_slave, broadcast_names_no_slave.
    constexpr exchange_step begin(std::span<const std::byte> message, std::span<std::byte> buffer,
                                  const packet& given = {}) noexcept {
        *this = packet_exchange{slave_};
        given_ = given;
        if (!wire::decode_prefix(head_, message)) return fail(translate::errc::truncated);
        if (const auto error = delivery::deliverable(head_); error != translate::errc::ok) return fail(error);
        const auto translated = translator::to_packet(message, buffer, given_);
        if (!translated) return fail(translated.error());
        awaited_ = hilscher::packet_command::sdo_download_cnf;
        return {exchange_progress::request, translated->size()};
    }

    /// Processes a confirmation packet. The next packet or message is written to `buffer`, which does not overlap it
    /// and has buffer_size bytes. Fails if the packet reports an error, and if the uploaded object is not a report:
    /// errors of translator::from_packet, and wrong_packet.
    constexpr exchange_step on_confirmation(std::span<const std::byte> confirmation,
                                            std::span<std::byte> buffer) noexcept {
        hilscher::packet_header answer{};
        if (!wire::decode_prefix(answer, confirmation) || !is_awaited(answer)) return {};
        status_ = answer.ul_sta;
        if (status_ != hilscher::packet_status::ok) return fail(translate::errc::ok);
        if (awaited_ == hilscher::packet_command::sdo_upload_cnf) return take_report(confirmation, buffer);
        const auto report = jaus::report_code_of(head_.command_code);
        if (report == 0) return finish(0);
        return ask_for(report, buffer);
    }

    /// Writes the requested ACK or NAK to `out` and returns its size, 16. 0 while the exchange is running, if none was
    /// requested, and if its source would be 255 ("all").
    [[nodiscard]] constexpr std::size_t acknowledgement(std::span<std::byte> out) const noexcept {
        if (end_ == exchange_progress::ignored || head_.ack_nak != jaus::ack_nak::request) return 0;
        jaus::header request = head_;
        request.destination = slave_.answering_as(head_.destination);
        if (!jaus::names_one_component(request.destination)) return 0;
        const bool done = end_ == exchange_progress::done;
        return jaus::make_acknowledgement(request, done ? jaus::ack_nak::ack : jaus::ack_nak::nak, out)->size();
    }

    /// ulSta of the last confirmation that was processed.
    [[nodiscard]] constexpr hilscher::packet_status status() const noexcept { return status_; }
    /// Error of the translation of message or report; `ok` if the last confirmation has the error.
    [[nodiscard]] constexpr translate::errc error() const noexcept { return error_; }

  private:
    using packet_command = hilscher::packet_command;
    static constexpr packet_command nothing{};

    // A confirmation repeats the sender fields of its request.
    [[nodiscard]] constexpr bool is_awaited(const hilscher::packet_header& answer) const noexcept {
        return awaited_ != nothing && answer.ul_cmd == awaited_ && answer.ul_src == given_.head.ul_src &&
               answer.ul_src_id == given_.head.ul_src_id && answer.ul_id == given_.head.ul_id;
    }

    // The upload request for the subindex of the message `code`, addressed as a download of that message would be.
    constexpr exchange_step ask_for(std::uint16_t code, std::span<std::byte> buffer) noexcept {
        jaus::header report = head_;
        report.command_code = code;
        report.data_size = 0;
        std::array<std::byte, jaus::header_size> message{};
        static_cast<void>(wire::encode(report, message)); // was decoded: fits
        const auto packet_bytes = translator::to_packet(message, buffer, given_);
        if (!packet_bytes) return fail(packet_bytes.error());
        packet download{};
        static_cast<void>(wire::decode_prefix(download, buffer));
        upload_.head = download.head;
        upload_.head.ul_len = hilscher::sdo_upload_request{}.head.ul_len;
        upload_.head.ul_cmd = packet_command::sdo_upload_req;
        upload_.ul_node_id = download.ul_node_id;
        upload_.ul_index = download.ul_index;
        upload_.ul_sub_index = download.ul_sub_index;
        awaited_ = packet_command::sdo_upload_cnf;
        return {exchange_progress::request, wire::encode(upload_, buffer)->size()};
    }

    constexpr exchange_step take_report(std::span<const std::byte> confirmation, std::span<std::byte> buffer) noexcept {
        hilscher::sdo_upload_confirmation answer{};
        const auto used = wire::decode_prefix(answer, confirmation);
        if (!used || answer.ul_data_cnt > confirmation.size() - *used) return fail(translate::errc::truncated);
        if (answer.ul_node_id != upload_.ul_node_id || answer.ul_index != upload_.ul_index ||
            answer.ul_sub_index != upload_.ul_sub_index)
            return fail(translate::errc::wrong_packet);
        const auto restored = delivery::message_of({.station = static_cast<std::uint16_t>(answer.ul_node_id),
                                                    .index = static_cast<std::uint16_t>(answer.ul_index),
                                                    .subindex = static_cast<std::uint8_t>(answer.ul_sub_index),
                                                    .data = confirmation.subspan(*used, answer.ul_data_cnt)},
                                                   slave_, buffer);
        if (!restored) return fail(restored.error());

        // The slave's object has the slave's addresses: the answer is sent from the queried component to the asker.
        jaus::header report{};
        static_cast<void>(wire::decode_prefix(report, buffer));
        report.source = slave_.answering_as(head_.destination, report.source.component);
        if (!jaus::names_one_component(report.source)) return fail(translate::errc::out_of_range);
        report.destination = head_.source;
        report.sequence_number = head_.sequence_number;
        static_cast<void>(wire::encode(report, buffer));
        return finish(restored->size());
    }

    constexpr exchange_step finish(std::size_t size) noexcept {
        awaited_ = nothing;
        end_ = exchange_progress::done;
        return {end_, size};
    }
    constexpr exchange_step fail(translate::errc error) noexcept {
        awaited_ = nothing;
        error_ = error;
        end_ = exchange_progress::failed;
        return {end_, 0};
    }

    slave_identity slave_;
    jaus::header head_{};
    packet given_{};
    hilscher::sdo_upload_request upload_{};
    packet_command awaited_{}; // the confirmation that is waited for
    hilscher::packet_status status_{};
    translate::errc error_{};
    exchange_progress end_{}; // done or failed, once it is
};

} // namespace jauscat::bridging
