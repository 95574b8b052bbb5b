// Decoding by a message's type. Included by the sources that compile it for a part of the 158 messages each, so that
// they can be built side by side.
#pragma once
#include "decoder.hpp"
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/text/print.hpp>
#include <jauscat/wire/encode.hpp>

namespace jausdump {

namespace detail {

/// Memory for the lists of one message. Grows to what messages need, up to a limit.
class list_memory {
  public:
    template <class T> jauscat::result<std::size_t, wire::errc> decode(T& message, std::span<const std::byte> body) {
        constexpr std::size_t most = std::size_t{1} << 28;
        for (;;) {
            wire::arena memory{bytes_};
            const auto result = wire::decode(message, body, memory);
            if (result.error() != wire::errc::arena_full || bytes_.size() >= most) return result;
            bytes_.resize(bytes_.size() * 2);
        }
    }

  private:
    std::vector<std::byte> bytes_ = std::vector<std::byte>(1 << 16);
};

template <class T> jauscat::result<std::size_t, wire::errc> decode(T& message, std::span<const std::byte> body) {
    static list_memory memory;
    return memory.decode(message, body);
}

template <class T> std::vector<std::byte> encoded(const T& message) {
    std::vector<std::byte> bytes(wire::encoded_size(message));
    const auto written = wire::encode(message, bytes);
    bytes.resize(written ? written->size() : 0);
    return bytes;
}

/// The members that payload data elements have in both of their messages.
struct payload_members {
    const payload_interfaces* interfaces;
    std::size_t count;
    wire::blob elements;
    const char* number_name;
};
inline payload_members members_of(const jaus::set_payload_data_element& m, const decoding& how) {
    return {how.payloads.commands(how.head.destination), m.number_of_payload_command_elements, m.element,
            "command_interface_number"};
}
inline payload_members members_of(const jaus::report_payload_data_element& m, const decoding& how) {
    return {how.payloads.measurements(how.head.source), m.number_of_payload_information_elements, m.element,
            "information_interface_number"};
}

/// A value that is a single one without the object around it.
inline std::string value_text(const json& value) {
    return (value.size() == 1 && value.contains("value") ? value.at("value") : value).dump();
}

inline json value_of(const jaus::payload_element& element, const payload_interfaces& interfaces) {
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
inline void tell_payload(decoded_body& body, const payload_members& members, std::size_t bytes_before) {
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

template <class T> decoded_body decode_as(std::span<const std::byte> bytes, const decoding& how) {
    decoded_body body{};
    T message{};
    if (const auto result = decode(message, bytes); !result) {
        body.fault = wire::diagnose<T>(bytes);
        if (body.fault) body.fault.error = result.error(); // a matter of memory
        return body;
    }
    body.encoded = encoded(message);
    if (how.text) {
        body.text = text::to_text(message, text_indent);
    } else {
        body.presence_vector = text::presence_vector_of(message);
        body.fields = text::to_json(message);
    }
    if constexpr (requires { members_of(message, how); }) {
        const auto members = members_of(message, how);
        tell_payload(body, members, bytes.size() - members.elements.size());
    }
    if constexpr (std::is_same_v<T, jaus::report_payload_interface>)
        if (how.learn_payloads) how.payloads.learn(how.head.source, message);
    return body;
}

struct entry {
    std::uint16_t command_code{};
    body_decoder decode{};
};

template <std::uint16_t First, std::uint16_t Last, class T> consteval entry entry_of() {
    if constexpr (jaus::command_code_of<T> >= First && jaus::command_code_of<T> <= Last)
        return {jaus::command_code_of<T>, &decode_as<T>};
    else
        return {};
}
template <std::uint16_t First, std::uint16_t Last, class... Messages>
consteval auto entries_of(jaus::message_list<Messages...>) {
    return std::array{entry_of<First, Last, Messages>()...};
}

} // namespace detail

/// The decoder for a command code between `First` and `Last`, for which they are compiled.
template <std::uint16_t First, std::uint16_t Last> body_decoder find_decoder_between(std::uint16_t command_code) {
    static constexpr auto entries = detail::entries_of<First, Last>(jaus::messages{});
    const auto found = std::ranges::find(entries, command_code, &detail::entry::command_code);
    return found == entries.end() ? nullptr : found->decode;
}

} // namespace jausdump
