#include "sdo_reader.hpp"

#include <jauscat/ethercat/code_texts.hpp>
#include <jauscat/ethercat/sdo_segment.hpp>

namespace jausdump {

namespace {

namespace ethercat = jauscat::ethercat;
using ethercat::sdo_specifier;

using bytes = std::span<const std::byte>;

constexpr const char* cut = "CoE message that breaks off";
constexpr const char* headless = "SDO message of a transfer that began before the capture";

bool names(const ethercat::sdo_header& header, const object_transfer& object) {
    return header.index == object.index && header.subindex == object.subindex;
}

} // namespace

void sdo_reader::read(const mailbox_message& message) {
    if (message.type == ethercat::mailbox_type::error && !message.to_slave) return take_mailbox_error(message);
    if (message.type != ethercat::mailbox_type::coe)
        return listener_.skipped("EtherCAT mailbox message of another protocol than CoE");
    ethercat::coe_header coe{};
    const auto used = wire::decode_prefix(coe, message.body);
    if (!used) return listener_.skipped(cut);
    const bool is_request = coe.service == ethercat::coe_service::sdo_request;
    if (!is_request && coe.service != ethercat::coe_service::sdo_response)
        return listener_.skipped("CoE message that is not an SDO");
    const auto sdo = message.body.subspan(*used);
    message.to_slave ? read_request(message.slave, sdo) : read_response(message.slave, sdo);
}

void sdo_reader::finish() {
    while (!transfers_.empty()) lose(transfers_.begin()->first);
}

void sdo_reader::read_request(const slave_address& slave, bytes sdo) {
    ethercat::sdo_segment_header first{}; // its specifier is where that of any SDO message is
    if (!wire::decode_prefix(first, sdo)) return listener_.skipped(cut);
    switch (first.specifier) {
    case sdo_specifier::download_request:
        if (auto* const begun = begin(slave, sdo, true)) take_initial(*begun, sdo);
        return;
    case sdo_specifier::upload_request: begin(slave, sdo, false); return;
    case sdo_specifier::download_segment_request: return take_segment(slave, sdo, true);
    case sdo_specifier::upload_segment_request: return;
    case sdo_specifier::abort: return take_abort(slave, sdo, "master");
    }
    listener_.skipped("SDO message of an unknown kind");
}

void sdo_reader::read_response(const slave_address& slave, bytes sdo) {
    ethercat::sdo_segment_header first{};
    if (!wire::decode_prefix(first, sdo)) return listener_.skipped(cut);
    switch (first.specifier) {
    case sdo_specifier::upload_response: {
        auto* const asked = find_asked(slave, sdo); // else it answers an abandoned request
        const bool expected = asked != nullptr && !asked->object.download;
        if (auto* const begun = expected ? asked : begin(slave, sdo, false)) take_initial(*begun, sdo);
        return;
    }
    case sdo_specifier::upload_segment_response: return take_segment(slave, sdo, false);
    case sdo_specifier::download_response: return confirm(find_asked(slave, sdo));
    case sdo_specifier::download_segment_response: return confirm(find(slave));
    case sdo_specifier::abort: return take_abort(slave, sdo, "slave");
    }
    listener_.skipped("SDO message of an unknown kind");
}

/// A new transfer, which replaces an abandoned one.
sdo_reader::transfer* sdo_reader::begin(const slave_address& slave, bytes sdo, bool download) {
    lose(slave);
    ethercat::sdo_header header{};
    if (!wire::decode_prefix(header, sdo)) {
        listener_.skipped(cut);
        return nullptr;
    }
    auto& begun = transfers_[slave];
    begun.object = {.slave = slave,
                    .download = download,
                    .index = header.index,
                    .subindex = header.subindex,
                    .complete_access = header.complete_access};
    return &begun;
}

/// The data of a download request or an upload response.
void sdo_reader::take_initial(transfer& begun, bytes sdo) {
    ethercat::sdo_expedited expedited{};
    ethercat::sdo_normal normal{};
    const auto used = wire::decode_prefix(normal, sdo);
    if (!used || !wire::decode_prefix(expedited, sdo)) {
        listener_.skipped(cut);
        transfers_.erase(slave_address{begun.object.slave});
        return;
    }
    auto data = sdo.subspan(*used);
    const auto& header = normal.header;
    if (header.expedited) {
        const std::size_t unused = header.size_indicated ? header.unused : 0u;
        data = bytes{expedited.data}.first(expedited.data.size() - unused);
        normal.size = static_cast<std::uint32_t>(data.size());
    } else if (!header.size_indicated && normal.size < data.size()) {
        normal.size = static_cast<std::uint32_t>(data.size()); // some masters leave the size out: this is all
    }
    data = data.first(std::min<std::size_t>(data.size(), normal.size));
    begun.object.data.assign(data.begin(), data.end());
    begun.announced = normal.size;
    begun.in_segments = begun.open = data.size() < normal.size;
    if (begun.open) return;
    listener_.carried(begun.object);
    if (!begun.object.download) transfers_.erase(slave_address{begun.object.slave});
}

void sdo_reader::take_segment(const slave_address& slave, bytes sdo, bool download) {
    auto* const begun = find(slave);
    if (begun == nullptr || !begun->open || begun->object.download != download) return listener_.skipped(headless);
    ethercat::sdo_segment_header header{};
    static_cast<void>(wire::decode_prefix(header, sdo)); // its specifier was read from it
    const auto segment = ethercat::segment_data(header, sdo);
    auto& data = begun->object.data;
    const std::size_t size = data.size() + segment.size();
    const bool fits = header.last ? size == begun->announced : size <= begun->announced;
    if (header.toggle != begun->toggle || !fits) return lose(slave);
    data.insert(data.end(), segment.begin(), segment.end());
    begun->toggle = !begun->toggle;
    if (!header.last) return;
    begun->open = false;
    listener_.carried(begun->object);
    if (!download) transfers_.erase(slave);
}

void sdo_reader::take_abort(const slave_address& slave, bytes sdo, const char* by) {
    ethercat::sdo_abort abort{};
    if (!wire::decode_prefix(abort, sdo)) return listener_.skipped(cut);
    // In answer to a segment, which names no object, some slaves do not name it either.
    const auto* const known = find(slave);
    if (known == nullptr || (!known->in_segments && !names(abort.header, known->object)))
        return listener_.skipped(headless);
    listener_.refused(known->object, {.by = by,
                                      .what = "SDO abort",
                                      .code = text::hex_number(static_cast<std::uint32_t>(abort.code), 8),
                                      .text = std::string{describe(abort.code)}});
    transfers_.erase(slave);
}

void sdo_reader::take_mailbox_error(const mailbox_message& message) {
    ethercat::mailbox_error_reply error{};
    const auto* const known = find(message.slave);
    if (!wire::decode_prefix(error, message.body) || known == nullptr)
        return listener_.skipped("EtherCAT mailbox error that answers no SDO");
    listener_.refused(known->object, {.by = "slave",
                                      .what = "mailbox error",
                                      .code = text::hex_number(static_cast<std::uint16_t>(error.code), 4),
                                      .text = std::string{describe(error.code)}});
    transfers_.erase(message.slave);
}

/// A download, or a part of one, was accepted.
void sdo_reader::confirm(const transfer* known) {
    if (known != nullptr && known->object.download && !known->open)
        transfers_.erase(slave_address{known->object.slave});
}

/// Drops the slave's transfer, and reports missing data.
void sdo_reader::lose(const slave_address& slave) {
    const auto node = transfers_.extract(slave);
    if (!node.empty() && node.mapped().open) listener_.lost(node.mapped().object);
}

/// The slave's transfer, if it is of the object that the message names.
sdo_reader::transfer* sdo_reader::find_asked(const slave_address& slave, bytes sdo) {
    ethercat::sdo_header header{};
    auto* const known = find(slave);
    const bool same = known != nullptr && wire::decode_prefix(header, sdo) && names(header, known->object);
    return same ? known : nullptr;
}

sdo_reader::transfer* sdo_reader::find(const slave_address& slave) {
    const auto found = transfers_.find(slave);
    return found != transfers_.end() ? &found->second : nullptr;
}

} // namespace jausdump
