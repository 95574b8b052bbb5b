#include "decoder.hpp"

#include "message_kinds/message_kinds.hpp"
#include <jauscat/text/print.hpp>

namespace jausdump {

namespace {

/// Decodes into memory for the lists of one message. It grows to what messages need, up to a limit.
jauscat::result<std::size_t, wire::errc> decode_into(void* message, const message_kind& kind,
                                                     std::span<const std::byte> body) {
    constexpr std::size_t most = std::size_t{1} << 28;
    static std::vector<std::byte> bytes(1 << 16);
    for (;;) {
        wire::arena memory{bytes};
        const auto result = kind.decode(message, body, memory);
        if (result.error() != wire::errc::arena_full || bytes.size() >= most) return result;
        bytes.resize(bytes.size() * 2);
    }
}

/// The members that payload data elements have in both of their messages.
struct payload_members {
    const payload_interfaces* interfaces;
    std::size_t count;
    wire::blob elements;
    const char* number_name;
};
payload_members members_of(const jaus::set_payload_data_element& m, const decoding& how) {
    return {how.payloads.commands(how.head.destination), m.number_of_payload_command_elements, m.element,
            "command_interface_number"};
}
payload_members members_of(const jaus::report_payload_data_element& m, const decoding& how) {
    return {how.payloads.measurements(how.head.source), m.number_of_payload_information_elements, m.element,
            "information_interface_number"};
}

/// A value that is a single one without the object around it.
std::string value_text(const json& value) {
    return (value.size() == 1 && value.contains("value") ? value.at("value") : value).dump();
}

json value_of(const jaus::payload_element& element, const payload_interfaces& interfaces) {
    json value = text::to_json(element.value).at("value");
    if (!jaus::is_scaled(element.value.type_code)) return value;
    json scaled;
    if (element.interface_number <= interfaces.limits.size()) {
        const auto [min, max] = interfaces.limits[element.interface_number - 1u];
        if (const auto real = jaus::real_value(element.value, min, max)) scaled["value"] = *real;
    }
    scaled["raw"] = value.at("value");
    return scaled;
}

/// Puts the elements' values in place of their bytes, if their types are known.
void tell_payload(decoded_body& body, const payload_members& members, std::size_t bytes_before) {
    if (members.interfaces == nullptr) return;
    jaus::payload_reader reader{members.count, members.elements, members.interfaces->types};
    std::vector<jaus::payload_element> elements;
    json told = json::array();
    std::string lines;
    for (jaus::payload_element one{}; reader.next(one); elements.push_back(one)) {
        told.push_back({{members.number_name, one.interface_number}, {"value", value_of(one, *members.interfaces)}});
        lines += std::string(text_indent, ' ') + "element[" + std::to_string(elements.size()) + "]: interface " +
                 std::to_string(one.interface_number) + " = " + value_text(told.back().at("value")) + "\n";
    }
    if (reader.error() != wire::errc::ok) {
        body.fault = {.error = reader.error(), .field = "element", .offset = bytes_before + reader.offset()};
        body.fault.path[0] = {"element", elements.size()};
        body.fault.depth = 1;
        return;
    }
    std::vector<std::byte> bytes(members.elements.size());
    const auto written = jaus::encode_payload_elements(elements, bytes);
    body.encoded.resize(bytes_before);
    body.encoded.insert(body.encoded.end(), bytes.begin(),
                        bytes.begin() + static_cast<std::ptrdiff_t>(written ? written->size() : 0));
    if (!body.fields.is_null()) body.fields["element"] = std::move(told);
    body.text += lines;
}

/// What is done for a message of the type `T` alone.
template <class T> const T* as(const void* message, const message_kind& kind) {
    return kind.command_code == jaus::command_code_of<T> ? static_cast<const T*>(message) : nullptr;
}

} // namespace

bool is_known(std::uint16_t command_code) { return find_kind(command_code) != nullptr; }

decoded_body decode_body(std::span<const std::byte> bytes, const decoding& how) {
    const auto& kind = *find_kind(how.head.command_code);
    decoded_body body{};
    const auto message = kind.make();
    const void* const value = message.get();
    if (const auto result = decode_into(message.get(), kind, bytes); !result) {
        body.fault = kind.diagnose(bytes);
        if (body.fault) body.fault.error = result.error(); // a matter of memory
        return body;
    }
    if (auto encoded = kind.encode(value)) body.encoded = *std::move(encoded);
    if (how.text) {
        body.text = text::to_text(*kind.fields, value, text_indent);
    } else {
        body.presence_vector = text::presence_vector_of(*kind.fields, value);
        body.fields = text::to_json(*kind.fields, value);
    }
    const auto tell = [&](const payload_members& members) {
        tell_payload(body, members, bytes.size() - members.elements.size());
    };
    if (const auto* const command = as<jaus::set_payload_data_element>(value, kind)) tell(members_of(*command, how));
    if (const auto* const report = as<jaus::report_payload_data_element>(value, kind)) tell(members_of(*report, how));
    if (const auto* const types = as<jaus::report_payload_interface>(value, kind); types && how.learn_payloads)
        how.payloads.learn(how.head.source, *types);
    return body;
}

} // namespace jausdump
