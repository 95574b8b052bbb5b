// SDO packets, and SDOs on the EtherCAT wire, as text and as members of events.
#pragma once
#include "support/event.hpp"
#include <jauscat/ethercat/code_texts.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/hilscher.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/wire/view.hpp>

#include <cstdint>
#include <span>
#include <string>

namespace example {

/// The fields of an SDO download packet that the translation fills, in decimal, and its data.
inline std::string packet_text(std::span<const std::byte> bytes) {
    using packet = jauscat::hilscher::sdo_download_request;
    packet fields{};
    const auto used = jauscat::wire::decode_prefix(fields, bytes);
    if (!used) return "  not a packet\n";
    const auto number = [](const char* name, std::uint32_t value) {
        return std::string{"  "} + name + " = " + std::to_string(value) + "\n";
    };
    const auto data = bytes.subspan(*used);
    return number("ulDest", fields.head.ul_dest) + number("ulDestId", fields.head.ul_dest_id) +
           number("ulNodeId", fields.ul_node_id) + number("ulIndex", fields.ul_index) +
           number("ulSubIndex", fields.ul_sub_index) + number("ulDataCnt", fields.ul_data_cnt) +
           number("ulLen", fields.head.ul_len) + "  abSdoData, n = " + std::to_string(data.size()) + ": " +
           jauscat::text::hex(data) + "\n";
}

/// The fields of an SDO upload packet that say what is read, in decimal.
inline std::string upload_text(std::span<const std::byte> bytes) {
    jauscat::hilscher::sdo_upload_request fields{};
    if (!jauscat::wire::decode_prefix(fields, bytes)) return "not a packet";
    return "ulNodeId = " + std::to_string(fields.ul_node_id) + ", ulIndex = " + std::to_string(fields.ul_index) +
           ", ulSubIndex = " + std::to_string(fields.ul_sub_index);
}

/// Members of an event about an SDO download packet, or an upload packet.
inline event_members packet_members(std::span<const std::byte> bytes) {
    using packet = jauscat::hilscher::sdo_download_request;
    packet fields{};
    const auto used = jauscat::wire::decode_prefix(fields, bytes);
    if (!used) return {};
    return {{"dest", fields.head.ul_dest},
            {"node_id", fields.ul_node_id},
            {"index", fields.ul_index},
            {"subindex", fields.ul_sub_index},
            {"data_count", fields.ul_data_cnt},
            {"length", fields.head.ul_len},
            {"data", jauscat::text::hex(bytes.subspan(*used))}};
}
inline event_members upload_members(std::span<const std::byte> bytes) {
    jauscat::hilscher::sdo_upload_request fields{};
    if (!jauscat::wire::decode_prefix(fields, bytes)) return {};
    return {{"node_id", fields.ul_node_id}, {"index", fields.ul_index}, {"subindex", fields.ul_sub_index}};
}

/// One line for the SDO that a mailbox holds, or empty if there is none; `members` get what it says.
inline std::string sdo_text(std::span<const std::byte> mailbox, event_members& members) {
    namespace ethercat = jauscat::ethercat;
    ethercat::mailbox_header mail{};
    ethercat::coe_header coe{};
    ethercat::sdo_normal sdo{}; // the longest of the SDO headers; the others share its start
    const auto mail_used = jauscat::wire::decode_prefix(mail, mailbox);
    if (!mail_used || mail.type != ethercat::mailbox_type::coe || mail.length > mailbox.size() - *mail_used) return {};
    const auto body = mailbox.subspan(*mail_used, mail.length);
    const auto coe_used = jauscat::wire::decode_prefix(coe, body);
    if (!coe_used ||
        (coe.service != ethercat::coe_service::sdo_request && coe.service != ethercat::coe_service::sdo_response))
        return {};
    const auto sdo_used = jauscat::wire::decode_prefix(sdo, body.subspan(*coe_used));
    if (!sdo_used) return {};
    const auto& head = sdo.header;
    const bool request = coe.service == ethercat::coe_service::sdo_request;
    members.insert(members.end(), {{"mailbox_length", mail.length}, {"counter", mail.counter}});
    const auto object = std::to_string(head.index) + ":" + std::to_string(head.subindex);
    if (head.specifier == ethercat::sdo_specifier::abort) {
        members.insert(
            members.end(),
            {{"kind", "abort"}, {"index", head.index}, {"subindex", head.subindex}, {"abort_code", sdo.size}});
        return "SDO abort of " + object + ": " + std::string{describe(static_cast<ethercat::abort_code>(sdo.size))};
    }
    using enum ethercat::sdo_specifier;
    const bool segment = request
                             ? head.specifier == download_segment_request || head.specifier == upload_segment_request
                             : head.specifier == upload_segment_response || head.specifier == download_segment_response;
    if (segment) { // names no object
        members.emplace_back("kind", request ? "segment_request" : "segment_response");
        return std::string{"SDO segment "} + (request ? "request" : "response") + ", mailbox length " +
               std::to_string(mail.length) + ", counter " + std::to_string(mail.counter) + "\n    " +
               jauscat::text::hex(body);
    }
    members.insert(members.end(),
                   {{"kind", request ? "request" : "response"}, {"index", head.index}, {"subindex", head.subindex}});
    const bool has_data = head.size_indicated && !head.expedited;
    return std::string{"SDO "} + (request ? "request" : "response") + " for object " + object + ", mailbox length " +
           std::to_string(mail.length) + ", counter " + std::to_string(mail.counter) +
           (has_data ? ", " + std::to_string(sdo.size) + " bytes" : "") + "\n    " + jauscat::text::hex(body);
}

/// Calls `show(station, text, members)` for each SDO in a frame from the master, or in one that has returned to it.
inline void for_each_sdo(std::span<const std::byte> frame, bool is_sent, auto&& show) {
    constexpr std::uint16_t first_ram_address = 0x1000; // registers lie below
    const auto mailbox_command = is_sent ? jauscat::ethercat::command::fpwr : jauscat::ethercat::command::fprd;
    jauscat::ethercat::frame_view datagrams;
    if (!datagrams.parse(frame)) return;
    for (const auto& datagram : datagrams) {
        if (datagram.header.cmd != mailbox_command || datagram.header.ado < first_ram_address) continue;
        if (!is_sent && datagram.working_counter == 0) continue; // a poll
        event_members members{{"station", datagram.header.adp}};
        const auto text = sdo_text(datagram.data, members);
        if (!text.empty()) show(datagram.header.adp, text, members);
    }
}

} // namespace example
