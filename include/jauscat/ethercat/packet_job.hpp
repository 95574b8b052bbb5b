// One SDO request packet executed by the master instead of by the card that the packet is made for.
#pragma once

#include <jauscat/ethercat/master.hpp>
#include <jauscat/ethercat/packet_status.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// A packet in, its confirmation out. Both spans stay in place until `finish`.
///
///     packet_job job{request, confirmation};
///     if (job.start(master)) ...;                       // drive the master until it is idle
///     const auto size = job.finish(master.result());
class packet_job {
  public:
    /// Bytes of confirmation that any request can do with.
    static constexpr std::size_t confirmation_size =
        wire::max_size<hilscher::sdo_upload_confirmation> + hilscher::max_sdo_data;

    /// `options` are for downloads: the packets cannot say them.
    packet_job(std::span<const std::byte> request, std::span<std::byte> confirmation,
               const download_options& options = {}) noexcept
        : request_{request}, confirmation_{confirmation}, options_{options} {}

    /// Starts what the request asks for. False if nothing runs: `finish` then says why, whatever result it is given.
    bool start(master& m) noexcept {
        status_ = begin(m);
        return status_ == hilscher::packet_status::ok;
    }

    /// Writes the confirmation and returns its size, 40 to 1596 bytes; 0 where the request is no packet or the
    /// confirmation has no room. `result` is how the master's job ended.
    std::size_t finish(const outcome& result) noexcept {
        hilscher::packet_header head{};
        if (!wire::decode_prefix(head, request_)) return 0;
        if (status_ == hilscher::packet_status::ok) status_ = hilscher::status_of(result);
        head.ul_sta = status_;
        head.ul_cmd = static_cast<hilscher::packet_command>(static_cast<std::uint32_t>(head.ul_cmd) + 1);
        if (head.ul_cmd == hilscher::packet_command::sdo_upload_cnf) return finish_upload(head, result.size);
        head.ul_len = 0;
        return wire::encode(head, confirmation_).size();
    }

  private:
    using packet_status = hilscher::packet_status;
    using packet_command = hilscher::packet_command;
    static constexpr std::size_t head_size = wire::max_size<hilscher::packet_header>;
    static constexpr std::size_t upload_size = wire::max_size<hilscher::sdo_upload_confirmation>;

    packet_status begin(master& m) noexcept {
        hilscher::packet_header head{};
        if (!wire::decode_prefix(head, request_)) return packet_status::invalid_packet_length;
        switch (head.ul_cmd) {
        case packet_command::sdo_download_req: return begin_download(m);
        case packet_command::sdo_upload_req: return begin_upload(m);
        default: return packet_status::unknown_command;
        }
    }

    packet_status begin_download(master& m) noexcept {
        hilscher::sdo_download_request fields{};
        const auto used = wire::decode_prefix(fields, request_);
        if (!used || fields.ul_data_cnt > request_.size() - used.size() ||
            fields.head.ul_len < used.size() - head_size + fields.ul_data_cnt)
            return packet_status::invalid_packet_length;
        if (const auto wrong = check_target(fields); wrong != packet_status::ok) return wrong;
        return started(m.download(static_cast<std::uint16_t>(fields.ul_node_id),
                                  static_cast<std::uint16_t>(fields.ul_index),
                                  static_cast<std::uint8_t>(fields.ul_sub_index),
                                  request_.subspan(used.size(), fields.ul_data_cnt), options_));
    }

    packet_status begin_upload(master& m) noexcept {
        hilscher::sdo_upload_request fields{};
        const auto used = wire::decode_prefix(fields, request_);
        if (!used || fields.head.ul_len < used.size() - head_size) return packet_status::invalid_packet_length;
        if (const auto wrong = check_target(fields); wrong != packet_status::ok) return wrong;
        if (confirmation_.size() < upload_size) return packet_status::out_of_memory;
        const auto room = confirmation_.subspan(upload_size);
        return started(m.upload(
            static_cast<std::uint16_t>(fields.ul_node_id), static_cast<std::uint16_t>(fields.ul_index),
            static_cast<std::uint8_t>(fields.ul_sub_index), room.first(std::min(room.size(), hilscher::max_sdo_data))));
    }

    [[nodiscard]] static packet_status check_target(const auto& fields) noexcept {
        if (fields.ul_node_id > 0xFFFF) return packet_status::coe_invalid_slave_id;
        return fields.ul_index > 0xFFFF || fields.ul_sub_index > 0xFF ? packet_status::invalid_parameter
                                                                      : packet_status::ok;
    }
    [[nodiscard]] static packet_status started(bool yes) noexcept {
        return yes ? packet_status::ok : packet_status::service_in_use;
    }

    // The data are there already. After an error the packet ends with the fields that repeat the request's.
    std::size_t finish_upload(const hilscher::packet_header& head, std::size_t size) noexcept {
        hilscher::sdo_upload_request asked{};
        static_cast<void>(wire::decode_prefix(asked, request_));
        if (head.ul_sta != packet_status::ok) {
            asked.head = head;
            asked.head.ul_len = static_cast<std::uint32_t>(wire::max_size<hilscher::sdo_upload_request> - head_size);
            return wire::encode(asked, confirmation_).size();
        }
        hilscher::sdo_upload_confirmation answer{.head = head,
                                                 .ul_node_id = asked.ul_node_id,
                                                 .ul_index = asked.ul_index,
                                                 .ul_sub_index = asked.ul_sub_index,
                                                 .ul_data_cnt = static_cast<std::uint32_t>(size)};
        answer.head.ul_len = static_cast<std::uint32_t>(upload_size - head_size + size);
        return wire::encode(answer, confirmation_).size() + size;
    }

    std::span<const std::byte> request_;
    std::span<std::byte> confirmation_;
    download_options options_{};
    hilscher::packet_status status_{};
};

} // namespace jauscat::ethercat
