#include "dump.hpp"

#include "support/hex_line.hpp"
#include "support/known_messages.hpp"
#include "support/output.hpp"
#include <jauscat/jaus/message/framing.hpp>
#include <jauscat/jaus/message/ignored_bits.hpp>
#include <jauscat/sae/transport/judp.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/translate/translator.hpp>

#include <iostream>

namespace jausdump {

namespace {

namespace translate = jauscat::translate;
namespace translation_tables = jauscat::translation;

template <class Error> std::string error_name(Error error) { return std::string{text::enumerator_name(error)}; }

/// A fault at a byte that is counted from `first_offset`.
fault fault_of(const wire::diagnosis& why, std::size_t first_offset) {
    return {.error = error_name(why.error),
            .field = text::field_path(why),
            .byte = first_offset + why.offset,
            .what = text::to_text(why, first_offset)};
}

/// Discovery of OpenJAUS 3.2: private codes, from before RA 3.3 had messages for it.
constexpr std::array openjaus_3_2{jaus::catalog_entry{0xD2A4, "Query Identification (OpenJAUS 3.2)"},
                                  jaus::catalog_entry{0xD2A6, "Query Configuration (OpenJAUS 3.2)"},
                                  jaus::catalog_entry{0xD2A7, "Query Services (OpenJAUS 3.2)"},
                                  jaus::catalog_entry{0xD4A5, "Report Identification (OpenJAUS 3.2)"},
                                  jaus::catalog_entry{0xD4A6, "Report Configuration (OpenJAUS 3.2)"},
                                  jaus::catalog_entry{0xD4A7, "Report Services (OpenJAUS 3.2)"},
                                  jaus::catalog_entry{0xD6A8, "Configuration Changed Setup (OpenJAUS 3.2)"},
                                  jaus::catalog_entry{0xD8A8, "Configuration Changed (OpenJAUS 3.2)"}};

std::string name_of(std::uint16_t command_code) {
    if (const auto name = jaus::standard_name(command_code); !name.empty()) return std::string{name};
    const auto found = std::ranges::find(openjaus_3_2, command_code, &jaus::catalog_entry::command_code);
    if (found != openjaus_3_2.end()) return std::string{found->name};
    return is_known(command_code) ? example::message_name(command_code) : "unknown";
}

/// Why a datagram without the prefix is no JAUS message; empty where it may be one. What only has a wrong size is one,
/// if its command code is the standard's: a broken one.
std::string why_no_message(std::span<const std::byte> datagram) {
    jaus::header head{};
    if (!wire::decode_prefix(head, datagram)) return "not JAUS: shorter than a header";
    if (head.version > 2 || head.reserved != 0) return "not JAUS: not the first bytes of a header";
    if (!names_one_component(head.source)) return "not JAUS: no component is the source";
    const bool known = is_known(head.command_code);
    if (head.data_size != datagram.size() - jaus::header_size && !known)
        return "not JAUS: the size in the header is another";
    return {};
}

/// Whether a datagram is a message of SAE JAUS that is shorter than it states.
bool is_cut_sae_message(std::span<const std::byte> datagram) {
    if (!sae::is_judp2(datagram)) return false;
    const auto message = datagram.subspan(1);
    sae::transport_header head{};
    return wire::decode_prefix(head, message) && head.message_type == 0 && head.compression == sae::compression::none &&
           head.size > message.size() && names_one_component(head.source);
}

template <class Table> std::string packet_of(std::span<const std::byte> message) {
    using translator = translate::translator<Table>;
    std::array<std::byte, translator::max_packet_size> packet{};
    const auto translated = translator::to_packet(message, packet);
    return translated ? text::detail::plain_hex(*translated) : error_name(translated.error());
}

/// Header and body again, from the decoded header and the body that was encoded from the decoded values.
std::string encoded_again(jaus::header head, std::span<const std::byte> body) {
    std::vector<std::byte> message(jaus::header_size);
    head.data_size = static_cast<std::uint16_t>(body.size());
    if (const auto result = wire::encode(head, message); !result) return error_name(result.error());
    message.insert(message.end(), body.begin(), body.end());
    return text::detail::plain_hex(message);
}

} // namespace

dump::dump(options how) : options_{std::move(how)} {
    if (!options_.payload_types.empty()) payloads_ = payload_directory{options_.payload_types};
}

void dump::on_line(const std::string& line, std::size_t number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) return;
    record message{.origin = {.place = "line", .number = number}};
    const auto read = example::read_hex_line(line);
    if (!read.error.empty()) {
        message.kind = kind::broken;
        message.error = fault{.error = read.error, .what = "line " + std::to_string(number) + ": " + read.what};
        return tell(message);
    }
    if (options_.sae) return sae_.on_payload(read.bytes, message.origin);
    if (jaus::form_of(read.bytes) == jaus::datagram_form::judp2)
        return sae_.on_messages(std::span{read.bytes}.subspan(1), message.origin);
    if (const auto form = jaus::foreign_form(read.bytes); !form.empty())
        return summary_.skip_foreign(std::string{form});
    take_datagram(read.bytes, message, false);
}

void dump::on_datagram(std::span<const std::byte> payload, const origin& from) {
    if (jaus::form_of(payload) == jaus::datagram_form::judp2) {
        if (sae::split(payload.subspan(1)).error == sae::transport_errc::invalid_source)
            return on_skipped("not JAUS: no component is the source");
        return sae_.on_messages(payload.subspan(1), from);
    }
    if (const auto form = jaus::foreign_form(payload); !form.empty()) return summary_.skip_foreign(std::string{form});
    if (jaus::remove_framing(payload).how == jaus::framing::bare)
        if (const auto reason = why_no_message(payload); !reason.empty())
            return is_cut_sae_message(payload) ? sae_.on_messages(payload.subspan(1), from) : on_skipped(reason);
    take_datagram(payload, {.origin = from}, true);
}

void dump::on_serial_frame(const sae::serial_frame& frame, const origin& from) {
    if (frame.error == sae::transport_errc::noise) return on_skipped(std::string{describe(frame.error)});
    if (frame) return sae_.on_messages(frame.message, from);
    sae_.on_message({.error = frame.error}, {}, from);
}

void dump::take_datagram(std::span<const std::byte> datagram, const record& as, bool network) {
    auto part = jaus::remove_framing(datagram);
    for (;; part = jaus::next_message(part)) {
        record message = as;
        // Bytes behind the last message are shown as a broken one.
        const auto bytes = part.message.empty() && !part.rest.empty() ? part.rest : part.message;
        message.bytes.assign(bytes.begin(), bytes.end());
        take_apart(message, network);
        if (part.rest.empty() || part.message.empty()) return;
    }
}

void dump::on_object(std::span<const std::byte> bytes, const origin& from) {
    record message{.origin = from, .bytes = {bytes.begin(), bytes.end()}};
    take_apart(message, true);
}

void dump::on_unreadable_object(std::span<const std::byte> data, translate::errc error, const origin& from) {
    const bool known = error != translate::errc::unknown_subindex;
    tell({.origin = from,
          .kind = known ? kind::broken : kind::unknown,
          .bytes = {data.begin(), data.end()},
          .error = fault{.error = error_name(error), .what = "not a message: " + std::string{describe(error)}}});
}

void dump::on_refused(record message) {
    message.kind = kind::refused;
    message.name = message.head ? name_of(message.head->command_code) : sae_.name_of(message.code());
    if (options_.filter.passes(message)) tell(message);
}

void dump::take_apart(record& message, bool network) {
    jaus::header head{};
    if (!wire::decode_prefix(head, message.bytes)) {
        message.kind = kind::broken;
        message.error = fault_of(wire::diagnose<jaus::header>(message.bytes), 0);
        return tell(message);
    }
    message.head = head;
    message.name = name_of(head.command_code);
    if (!options_.filter.passes(message)) return;
    if (options_.translation == translation::seed)
        message.packet = packet_of<translation_tables::seed_table>(message.bytes);
    if (options_.translation == translation::self_contained)
        message.packet = packet_of<translation_tables::self_contained_table>(message.bytes);
    if (network && head.data_flag != jaus::data_flag::only && head.data_size == message.body().size())
        return add_packet_of_data_set(message);
    decode(message, network);
    tell(message);
}

void dump::decode(record& message, bool network) {
    const jaus::header& head = *message.head;
    const auto body = message.body();
    if (body.empty() && jaus::is_acknowledgement(head)) {
        message.kind = kind::acknowledgement;
        if (options_.reencode) message.hex = encoded_again(head, {});
    } else if (!is_known(head.command_code)) {
        message.kind = kind::unknown;
        message.error = fault{.error = "unknown_command_code",
                              .field = "command_code",
                              .byte = 2,
                              .what = "unknown: command code " + text::hex_number(head.command_code, 4) +
                                      " is not one of the standard's"};
        return;
    } else {
        auto decoded = decode_body(body, {.head = head,
                                          .payloads = payloads_,
                                          .learn_payloads = network,
                                          .text = options_.format == format::text_lines});
        message.presence_vector = std::move(decoded.presence_vector);
        message.fields = std::move(decoded.fields);
        message.text = std::move(decoded.text);
        message.outside_values = std::move(decoded.outside_values);
        if (!decoded.fault) message.error = fault_of(decoded.fault, jaus::header_size);
        if (decoded.fault) message.ignored_bits = jaus::ignored_presence_bits(head.command_code, body);
        if (body.size() > decoded.encoded.size() && decoded.fault)
            message.dropped = body.size() - decoded.encoded.size();
        const bool one_packet = decoded.encoded.size() <= jaus::max_body_size;
        if (options_.reencode && decoded.fault && one_packet) message.hex = encoded_again(head, decoded.encoded);
    }
    if (!message.error && message.data_set.empty() && head.data_size != body.size())
        message.error =
            fault{.error = error_name(jaus::errc::wrong_size),
                  .field = "data_size",
                  .byte = 12,
                  .what = std::string{describe(jaus::errc::wrong_size)} + ": data_size at byte 12 is " +
                          std::to_string(head.data_size) + ", " + std::to_string(body.size()) + " bytes follow"};
    if (message.error) message.kind = kind::broken;
}

void dump::add_packet_of_data_set(record& message) {
    message.kind = kind::part;
    std::optional<record> whole;
    const auto take = [&](jaus::header head, std::span<const std::byte> body) {
        // The size of a body of more than 4080 bytes does not fit a header, so that there are no such bytes on a wire.
        head.data_flag = jaus::data_flag::only;
        head.data_size = static_cast<std::uint16_t>(body.size() <= jaus::max_body_size ? body.size() : 0);
        whole = record{.origin = message.origin, .head = head, .name = message.name, .data_set = "reassembled"};
        whole->bytes.resize(jaus::header_size);
        static_cast<void>(wire::encode(head, whole->bytes)); // all of it was decoded from one
        whole->bytes.insert(whole->bytes.end(), body.begin(), body.end());
    };
    const auto lost = [&](const jaus::partial_data_set&) { summary_.lose_data_set(); };
    const jauscat::time_point now{message.origin.time.value_or(jauscat::duration{})};
    const auto result = data_sets_.on_packet(*message.head, message.body(), now, take, lost);
    message.data_set = error_name(result);
    if (result == jaus::reassembled::no_capacity || result == jaus::reassembled::too_large) {
        message.kind = kind::broken;
        message.error = fault{.error = message.data_set,
                              .what = result == jaus::reassembled::no_capacity
                                          ? "no room: too many large data sets at a time"
                                          : "too large: a data set of more than 1 MiB or 4096 packets"};
    }
    tell(message);
    if (!whole) return;
    decode(*whole, true);
    tell(*whole);
}

void dump::tell(const record& message) {
    // Without a header there is nothing to choose by.
    if (!message.head && !options_.filter.passes(message)) return;
    summary_.add(message);
    if (options_.on_message) options_.on_message();
    if (options_.watcher) options_.watcher(message);
    if (options_.receiver) return options_.receiver(message);
    if (options_.summary_only || options_.quiet) return;
    const auto time = time_stamps_.next(message.origin.time);
    if (options_.format == format::json_lines) {
        std::cout << to_json_line(message, time);
    } else {
        if (!std::exchange(heading_printed_, true)) std::cout << heading(options_.colours, options_.time);
        std::cout << to_text(message, time, options_.colours, options_.hex);
    }
    if (!std::cout) example::require_output(); // not only at the end of what never ends
}

bool dump::finish() {
    sae_.finish();
    for (const auto& set : data_sets_.places())
        if (set.packets != 0) summary_.lose_data_set();
    if (options_.quiet) return !summary_.something_did_not_decode();
    if (options_.format == format::text_lines)
        std::cout << summary_.text(options_.colours);
    else if (options_.summary_only)
        std::cout << summary_.object().dump() << "\n";
    example::require_output();
    return !summary_.something_did_not_decode();
}

} // namespace jausdump
