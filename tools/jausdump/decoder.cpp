#include "decoder.hpp"

#include "support/known_messages.hpp"
#include <jauscat/catalogue/json.hpp>

namespace jausdump {

namespace {

namespace catalogue = jauscat::catalogue;

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
    std::vector<std::byte> all(members.elements.size());
    const auto written = jaus::encode_payload_elements(elements, all);
    body.encoded.resize(bytes_before);
    body.encoded.insert(body.encoded.end(), all.begin(),
                        all.begin() + static_cast<std::ptrdiff_t>(written ? written->size() : 0));
    if (!body.fields.is_null()) body.fields["element"] = std::move(told);
    body.text += lines;
}

} // namespace

bool is_known(std::uint16_t command_code) { return example::known_messages().find(command_code) != nullptr; }

decoded_body decode_body(std::span<const std::byte> bytes, const decoding& how) {
    decoded_body body{};
    const auto message = example::known_messages().find(how.head.command_code)->decode(bytes, wire::tolerate_values);
    if (!message) {
        body.fault = message.error();
        return body;
    }
    body.outside_values = message->outside_values();
    if (auto encoded = message->encode(wire::tolerate_values)) body.encoded = *std::move(encoded);
    if (how.text) {
        body.text = message->to_text(text_indent);
    } else {
        body.presence_vector = catalogue::presence_vector_of(*message);
        body.fields = catalogue::to_json(*message);
    }
    const auto tell = [&](const payload_members& members) {
        tell_payload(body, members, bytes.size() - members.elements.size());
    };
    if (const auto* const command = message->as<jaus::set_payload_data_element>()) tell(members_of(*command, how));
    if (const auto* const report = message->as<jaus::report_payload_data_element>()) tell(members_of(*report, how));
    if (const auto* const types = message->as<jaus::report_payload_interface>(); types && how.learn_payloads)
        how.payloads.learn(how.head.source, *types);
    return body;
}

} // namespace jausdump
