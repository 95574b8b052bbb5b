// Messages of a catalogue as JSON and back, in the form of text/json.hpp. Needs nlohmann-json.
#pragma once
#include <jauscat/catalogue/any_message.hpp>
#include <jauscat/text/json.hpp>

namespace jauscat::catalogue {

[[nodiscard]] inline text::json to_json(const any_message& message) {
    return text::to_json(message.type().fields(), message.object());
}

/// `"0x7A"`, as wide as the vector; null where the message has none.
[[nodiscard]] inline text::json presence_vector_of(const any_message& message) {
    return text::presence_vector_of(message.type().fields(), message.object());
}

[[nodiscard]] inline result<any_message, text::error> from_json(const entry& type, const text::json& fields) {
    return any_message::made_by(type, 1024, [&](void* object, wire::arena& memory) {
        return text::from_json(fields, type.fields(), object, memory);
    });
}

} // namespace jauscat::catalogue
