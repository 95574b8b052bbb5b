#include "printer.hpp"

#include "decoder.hpp"

#include <array>
#include <cstdio>
#include <ctime>

namespace jausdump {

namespace {

/// `text`, filled up with spaces.
std::string padded(std::string text, std::size_t width, bool right = false) {
    if (text.size() < width) text.insert(right ? 0 : text.size(), width - text.size(), ' ');
    return text;
}

std::string time_text(std::chrono::nanoseconds since_1970, const char* format) {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(since_1970);
    const auto microseconds = std::chrono::floor<std::chrono::microseconds>(since_1970 - seconds).count();
    const auto count = static_cast<std::time_t>(seconds.count());
    std::tm utc{};
    gmtime_r(&count, &utc);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), format, &utc);
    const std::string digits = std::to_string(1000000 + microseconds); // six of them behind the 1
    return std::string{text.data()} + '.' + digits.substr(1);
}

/// "12.345678"
std::string seconds_text(std::chrono::nanoseconds time) {
    const auto microseconds = std::chrono::round<std::chrono::microseconds>(time).count();
    std::string digits = std::to_string(microseconds < 0 ? -microseconds : microseconds);
    if (digits.size() < 7) digits.insert(0, 7 - digits.size(), '0');
    return (microseconds < 0 ? "-" : "") + digits.insert(digits.size() - 6, 1, '.');
}

const char* title_of(time_display display) {
    switch (display) {
    case time_display::absolute: return "time (UTC)";
    case time_display::relative: return "time (s)";
    case time_display::delta: return "delta (s)";
    case time_display::none: break;
    }
    return "";
}

std::string columns(const std::string& number, const std::string& time, const std::string& code,
                    const std::string& name, const std::string& size, const std::string& from, const std::string& to,
                    const std::string& sequence) {
    return padded(number, 7, true) + "  " + padded(time, 15) + "  " + padded(code, 6) + "  " + padded(name, 38) +
           padded(size, 6, true) + "  " + padded(from, 15) + " -> " + padded(to, 15) + "  " + sequence;
}

std::string flags_text(const jaus::header& head) {
    std::string flags;
    const auto add = [&](bool set, const std::string& what) {
        if (set) flags += ", " + what;
    };
    add(head.ack_nak == jaus::ack_nak::request, "wants ACK");
    add(head.ack_nak == jaus::ack_nak::ack, "ACK");
    add(head.ack_nak == jaus::ack_nak::nak, "NAK");
    add(head.service_connection, "service connection");
    add(head.experimental, "experimental");
    add(head.data_flag != jaus::data_flag::only, "packet: " + text::to_text(head.data_flag));
    add(head.version != 2, "version " + std::to_string(head.version));
    add(head.priority != 6, "priority " + std::to_string(head.priority));
    return flags;
}

std::string flags_text(const sae::transport_header& head) {
    std::string flags;
    const auto add = [&](bool set, const std::string& what) {
        if (set) flags += ", " + what;
    };
    add(head.acknowledgement == sae::acknowledgement::request, "wants ACK");
    add(head.acknowledgement == sae::acknowledgement::ack, "ACK");
    add(head.acknowledgement == sae::acknowledgement::nak, "NAK");
    add(head.broadcast != sae::broadcast::none, "broadcast: " + text::to_text(head.broadcast));
    add(head.fragment_flag != sae::fragment_flag::single, "packet: " + text::to_text(head.fragment_flag));
    add(head.compression != sae::compression::none, "header compression: " + text::to_text(head.compression));
    add(head.message_type != 0, "message type " + std::to_string(head.message_type));
    add(head.priority != sae::priority::standard, "priority: " + text::to_text(head.priority));
    return flags;
}

std::string code_text(const record& message) {
    const auto code = message.code();
    return code ? text::hex_number(*code, 4) : "-";
}

json address_object(const jaus::address& id) {
    return {{"subsystem", id.subsystem}, {"node", id.node}, {"component", id.component}, {"instance", id.instance}};
}

json header_object(const jaus::header& head, std::size_t data_size) {
    return {{"priority", head.priority},
            {"ack_nak", static_cast<int>(head.ack_nak)},
            {"service_connection", static_cast<int>(head.service_connection)},
            {"experimental", static_cast<int>(head.experimental)},
            {"version", head.version},
            {"reserved", head.reserved},
            {"destination", address_object(head.destination)},
            {"source", address_object(head.source)},
            {"data_flag", static_cast<int>(head.data_flag)},
            {"data_size", data_size},
            {"sequence_number", head.sequence_number}};
}

json address_object(const sae::jaus_id& id) {
    return {{"subsystem", id.subsystem}, {"node", id.node}, {"component", id.component}};
}

json header_object(const sae::transport_header& head, std::uint16_t sequence_number, std::size_t size) {
    return {{"message_type", head.message_type},
            {"compression", static_cast<int>(head.compression)},
            {"size", size},
            {"priority", static_cast<int>(head.priority)},
            {"broadcast", static_cast<int>(head.broadcast)},
            {"acknowledgement", static_cast<int>(head.acknowledgement)},
            {"fragment_flag", static_cast<int>(head.fragment_flag)},
            {"destination", address_object(head.destination)},
            {"source", address_object(head.source)},
            {"sequence_number", sequence_number}};
}

json error_object(const fault& error) {
    json object{{"error", error.error}, {"field", nullptr}, {"byte", nullptr}, {"text", error.what}};
    if (!error.field.empty()) object["field"] = error.field;
    if (error.byte) object["byte"] = *error.byte;
    return object;
}

json refusal_object(const refusal& why) {
    return {{"by", why.by}, {"what", why.what}, {"code", why.code}, {"text", why.text}};
}

/// "SDO abort 0x06020000: no such object in the dictionary"
std::string reason_of(const refusal& why) { return why.what + " " + why.code + ": " + why.text; }

/// "EtherCAT: download to station 2, object 0x1B15:26"
std::string access_text(const origin& from) {
    const auto direction = from.from == "master" ? "download to " + from.to : "upload from " + from.from;
    return "EtherCAT: " + direction + ", object " + from.object;
}

std::string dump_line(const json& object) { return object.dump(-1, ' ', false, json::error_handler_t::replace) + "\n"; }

} // namespace

std::string heading(const palette& colour, time_display display) {
    return colour.bold +
           columns("number", title_of(display), "code", "message", "body", "source", "destination", "sequence") +
           colour.end + "\n";
}

std::string to_text(const record& message, const time_stamp& stamp, const palette& colour, bool with_bytes) {
    const auto& from = message.origin;
    const std::string indent(text_indent, ' ');
    const auto number = std::to_string(from.number);
    std::string time;
    if (stamp.value)
        time =
            stamp.display == time_display::absolute ? time_text(*stamp.value, "%H:%M:%S") : seconds_text(*stamp.value);
    std::string text;
    if (message.is_message()) {
        const auto name = message.data_set.empty() ? message.name : message.name + " (" + message.data_set + ")";
        std::string source, destination, sequence;
        if (message.head) {
            const auto& head = *message.head;
            source = text::to_text(head.source);
            destination = text::to_text(head.destination);
            sequence = std::to_string(head.sequence_number) + flags_text(head);
        } else if (message.sae->header) {
            const auto& head = *message.sae->header;
            source = sae::jaus_id_text{head.source}.view();
            destination = sae::jaus_id_text{head.destination}.view();
            sequence = std::to_string(message.sae->sequence_number) + flags_text(head);
        }
        text = columns(number, time, code_text(message), name, std::to_string(message.body().size()), source,
                       destination, sequence);
        if (const auto at = text.find(name); !name.empty() && at != std::string::npos)
            text.insert(at + name.size(), colour.end).insert(at, colour.bold);
    } else {
        text = columns(number, time, "-", "not a message", std::to_string(message.bytes.size()), "", "", "");
    }
    text += "\n";
    if (!from.object.empty()) text += indent + access_text(from) + "\n";
    text += message.text;
    if (message.refusal)
        text += indent + colour.bad + (message.refusal->by == "master" ? "aborted by the master: " : "refused: ") +
                reason_of(*message.refusal) + colour.end + "\n";
    if (message.head && message.head->experimental && jaus::is_standard(message.head->command_code))
        text += indent + "experimental: the header says that it is not the standard's message of this code\n";
    if (message.ignored_bits != 0)
        text += indent + "presence bits without a field, ignored: " + text::hex_number(message.ignored_bits, 1) + "\n";
    if (message.dropped != 0)
        text += indent + std::to_string(message.dropped) +
                " bytes dropped: of presence bits that the standard's layout does not have\n";
    if (message.error) text += indent + colour.bad + message.error->what + colour.end + "\n";
    if (with_bytes || message.kind == kind::unknown || message.kind == kind::broken)
        text += colour.faint + text::hex_dump(message.bytes, indent) + colour.end;
    if (message.hex) text += indent + "encoded again: " + *message.hex + "\n";
    if (message.packet) text += indent + "SDO packet: " + *message.packet + "\n";
    return text;
}

std::string to_json_line(const record& message, const time_stamp& time) {
    json object{{"message", nullptr},
                {"code", nullptr},
                {"header", nullptr},
                {"presence_vector", nullptr},
                {"fields", nullptr}};
    if (message.head) {
        object["message"] = message.name;
        object["code"] = text::hex_number(message.head->command_code, 4);
        // What was put together has a size that its header need not be able to say.
        object["header"] = header_object(*message.head, message.data_set == "reassembled" ? message.body().size()
                                                                                          : message.head->data_size);
    }
    if (message.sae && message.is_message()) {
        const auto& sae = *message.sae;
        object["message"] = message.name;
        if (message.code()) object["code"] = code_text(message);
        if (sae.header)
            object["header"] =
                header_object(*sae.header, sae.sequence_number,
                              message.data_set == "reassembled" ? message.bytes.size() : sae.header->size);
    }
    object["presence_vector"] = message.presence_vector;
    object["fields"] = message.fields;
    if (message.hex) object["hex"] = *message.hex;
    if (message.packet) object["packet"] = *message.packet;
    if (message.refusal) object["refusal"] = refusal_object(*message.refusal);
    if (message.error) object["error"] = error_object(*message.error);
    if (message.kind == kind::unknown || message.kind == kind::broken)
        object["bytes"] = text::detail::plain_hex(message.bytes);
    if (!message.outside_values.empty()) object["outside_values"] = message.outside_values;
    if (message.ignored_bits != 0) object["ignored_presence_bits"] = text::hex_number(message.ignored_bits, 1);
    if (message.dropped != 0) object["dropped"] = message.dropped;
    if (message.sae) {
        object["generation"] = "SAE";
        object["payload_size"] = message.body().size();
    }
    if (!message.data_set.empty()) object["data_set"] = message.data_set;
    json from{{message.origin.place, message.origin.number}};
    if (time.value && time.display == time_display::absolute)
        from["time"] = time_text(*time.value, "%Y-%m-%dT%H:%M:%S") + "Z";
    else if (time.value)
        from["time"] = std::stod(seconds_text(*time.value));
    if (!message.origin.from.empty()) from["from"] = message.origin.from;
    if (!message.origin.to.empty()) from["to"] = message.origin.to;
    if (!message.origin.object.empty()) from["object"] = message.origin.object;
    object["origin"] = std::move(from);
    return dump_line(object);
}

void summary::add(const record& message) {
    if (message.refusal) {
        ++refused_[message.name + ": " + reason_of(*message.refusal)];
        return;
    }
    const bool bad = message.kind == kind::unknown || message.kind == kind::broken;
    auto& line = by_type_[{code_text(message), message.is_message() ? message.name : "not a message"}];
    ++line.count;
    line.bytes += message.bytes.size();
    line.not_decoded += bad ? 1 : 0;
    ++by_kind_[message.kind];
}

bool summary::something_did_not_decode() const {
    return (by_kind_.empty() && !foreign_.empty()) || lost_ != 0 || lost_transfers_ != 0 ||
           by_kind_.contains(kind::unknown) || by_kind_.contains(kind::broken);
}

std::string summary::text(const palette& colour) const {
    std::string text = std::string{"\n"} + colour.bold;
    text += padded("code", 8) + padded("message", 38) + padded("count", 8, true) + padded("bytes", 12, true) +
            padded("not decoded", 13, true) + colour.end + "\n";
    std::size_t total = 0;
    for (const auto& [type, line] : by_type_) {
        text += padded(type.first, 8) + padded(type.second, 38) + padded(std::to_string(line.count), 8, true) +
                padded(std::to_string(line.bytes), 12, true);
        if (line.not_decoded != 0) text += colour.bad + padded(std::to_string(line.not_decoded), 13, true) + colour.end;
        text += "\n";
        total += line.count;
    }
    text += std::to_string(total) + (total == 1 ? " message" : " messages");
    std::string parts;
    for (const auto& [what, name] : {std::pair{kind::decoded, "decoded"},
                                     {kind::acknowledgement, "acknowledgements"},
                                     {kind::part, "packets of large data sets"},
                                     {kind::unknown, "unknown"},
                                     {kind::broken, "broken"}})
        if (const auto found = by_kind_.find(what); found != by_kind_.end())
            parts += (parts.empty() ? ": " : ", ") + std::to_string(found->second) + " " + name;
    text += parts + "\n";
    if (lost_ != 0) text += std::to_string(lost_) + " incomplete large data sets\n";
    if (lost_transfers_ != 0) text += std::to_string(lost_transfers_) + " incomplete SDO transfers of messages\n";
    for (const auto& [reason, count] : refused_) text += std::to_string(count) + " refused: " + reason + "\n";
    for (const auto& [reason, count] : skipped_) text += std::to_string(count) + " skipped: " + reason + "\n";
    for (const auto& [form, count] : foreign_)
        text += (by_kind_.empty() ? "no message was decoded: " : "") + std::to_string(count) +
                (count == 1 ? " datagram is " : " datagrams are ") + form + "\n";
    return text;
}

json summary::object() const {
    json types = json::array();
    for (const auto& [type, line] : by_type_)
        types.push_back({{"code", type.first},
                         {"message", type.second},
                         {"count", line.count},
                         {"bytes", line.bytes},
                         {"not_decoded", line.not_decoded}});
    const auto count_of = [&](kind what) {
        const auto found = by_kind_.find(what);
        return found == by_kind_.end() ? std::size_t{0} : found->second;
    };
    return {{"messages", std::move(types)},
            {"decoded", count_of(kind::decoded)},
            {"acknowledgements", count_of(kind::acknowledgement)},
            {"packets_of_large_data_sets", count_of(kind::part)},
            {"unknown", count_of(kind::unknown)},
            {"broken", count_of(kind::broken)},
            {"incomplete_large_data_sets", lost_},
            {"incomplete_transfers", lost_transfers_},
            {"refused", refused_},
            {"skipped", skipped_},
            {"other_forms", foreign_}};
}

} // namespace jausdump
