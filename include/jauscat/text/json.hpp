// Messages as JSON and back. The only header that needs nlohmann-json.
//
// The object has the fields by name, in wire order. Scaled fields are {"value": 49.998, "raw": 16383}; enumerations,
// flags and bit-fields of one integer (time stamps) are that integer; groups are arrays, in which a single value stands
// under its field's name: "joint": [{"joint_effort": {...}}]; a variant is an object of its alternative, by the name of
// its type: "velocity": {"velocity_vehicle": {...}}; counts have names of their own; absent fields are left
// out; bytes and messages inside messages are hex. Not every text and number is JSON: text that is not UTF-8 is
// {"hex": "ff00"}, the numbers that are none are "NaN", "Infinity" and "-Infinity".
#pragma once
#include <jauscat/text/describe.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/text/quoted.hpp>

#include <cmath>
#include <nlohmann/json.hpp>

namespace jauscat::text {

/// Keeps the order of the fields.
using json = nlohmann::ordered_json;

namespace detail {

/// Hex without spaces, lower case.
inline std::string plain_hex(std::span<const std::byte> bytes) {
    std::string text = hex(bytes);
    std::erase(text, ' ');
    return text;
}

inline json json_number(std::uint64_t number, bool is_signed) {
    return is_signed ? json(static_cast<std::int64_t>(number)) : json(number);
}
inline json json_real(double real) {
    if (std::isnan(real)) return "NaN";
    if (std::isinf(real)) return real > 0 ? "Infinity" : "-Infinity";
    return real;
}

/// Writes any structure; `scope` holds what is around it, for tags.
class json_writer {
  public:
    json fields(const structure& type, const void* object, bool outermost) {
        const scope here{type.id, object, inner_};
        inner_ = &here;
        json made = json::object();
        for (std::size_t i = 0; i != type.members.size(); ++i) {
            const member& one = type.members[i];
            switch (one.what) {
            case member::role::flag:
            case member::role::constant:
            case member::role::not_on_wire: break;
            case member::role::presence_vector: // the message's own is beside the fields
                if (!outermost) made[std::string{one.name}] = one.number(object);
                break;
            case member::role::count:
                if (type.members[i + 1].find(object) != nullptr) made[std::string{one.name}] = one.number(object);
                break;
            case member::role::value:
                if (const void* const found = one.find(object); found != nullptr)
                    made[std::string{one.name}] = value(one, found);
                break;
            }
        }
        inner_ = here.outer;
        return made;
    }

    json value(const form& how, const void* at) {
        return std::visit([&](const auto& is) { return told(is, at); }, how.is);
    }

  private:
    json value(const member& one, const void* at) {
        if (!std::holds_alternative<choice_form>(one.how->is)) return value(*one.how, at);
        const held_case held = case_of(one, at, inner_);
        if (!held.known) return nullptr;
        if (held.how == nullptr) return json::object();
        json made = value(*held.how, held.at);
        return std::holds_alternative<structure_form>(held.how->is) ? made : json{{"value", std::move(made)}};
    }

    static json told(const integer_form& is, const void* at) { return json_number(is.get(at), is.is_signed); }
    static json told(const real_form& is, const void* at) { return json_real(is.get(at)); }
    static json told(const scaled_form& is, const void* at) {
        const double real = is.get(at);
        json made{{"value", json_real(real)}};
        if (real >= is.lowest && real <= is.highest) made["raw"] = json_number(is.to_raw(real), is.is_signed);
        return made;
    }
    static json told(const octets_form& is, const void* at) {
        const auto bytes = is.get(at);
        if (!is.characters) return plain_hex(bytes);
        std::string text{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
        return is_utf8(text) ? json(std::move(text)) : json{{"hex", plain_hex(bytes)}};
    }
    json told(const structure_form& is, const void* at) { return fields(*is.of, at, false); }
    static json told(const packed_form& is, const void* at) { return is.get(at); }
    static json told(const encoded_form& is, const void* at) { return plain_hex(is.encode(at)); }
    json told(const variant_form& is, const void* at) {
        const alternative& held = is.alternatives[is.index(at)];
        return {{std::string{held.name}, held.how == nullptr ? json::object() : value(*held.how, is.get(at))}};
    }
    json told(const list_form& is, const void* at) {
        json made = json::array();
        const auto* element = static_cast<const std::byte*>(is.first(at));
        for (std::size_t left = is.size(at); left != 0; --left, element += is.stride) {
            json one = value(*is.element, element);
            made.push_back(is.field.empty() ? std::move(one) : json{{std::string{is.field}, std::move(one)}});
        }
        return made;
    }
    json told(const tree_form& is, const void* at) {
        const auto* next = static_cast<const std::byte*>(is.nodes.first(at));
        std::size_t left = is.nodes.size(at);
        return left == 0 ? json(nullptr) : node(is, next, left);
    }
    json told(const choice_form&, const void*) { return nullptr; } // always a member, see value

    json node(const tree_form& is, const std::byte*& next, std::size_t& left) {
        const std::byte* const here = next;
        json made = value(*is.nodes.element, here);
        next += is.nodes.stride;
        --left;
        json children = json::array();
        for (std::uint64_t more = is.children.get(here); more != 0 && left != 0; --more)
            children.push_back(node(is, next, left));
        made["child"] = std::move(children);
        return made;
    }

    const scope* inner_{};
};

// Values deeper than a message can be are ignored: a sender cannot exhaust the stack.
inline input input_of(const json& value, std::size_t level = 0) {
    input made{.what = input::kind::leaf};
    if (value.is_null() || level == max_levels) {
        made.what = input::kind::nothing;
    } else if (value.is_object()) {
        made.what = input::kind::object;
        for (const auto& [name, part] : value.items()) made.parts.emplace_back(input_of(part, level + 1)).name = name;
    } else if (value.is_array()) {
        made.what = input::kind::array;
        for (const auto& part : value) made.parts.push_back(input_of(part, level + 1));
    } else if (value.is_string()) {
        made.text = value.get<std::string>();
    } else if (value.is_number_float() && !std::isfinite(value.get<double>())) {
        made.text = json_real(value.get<double>()).get<std::string>();
    } else {
        made.text = value.dump();
    }
    return made;
}

} // namespace detail

/// The fields of a message as JSON. For its presence vector see presence_vector_of.
[[nodiscard]] inline json to_json(const structure& type, const void* object) {
    return detail::json_writer{}.fields(type, object, true);
}
/// The same for a typed message.
template <wire::message T> [[nodiscard]] json to_json(const T& message) { return to_json(describe<T>(), &message); }

/// `"0x7A"`, as wide as the vector; null where the message has none.
[[nodiscard]] inline json presence_vector_of(const structure& type, const void* object) {
    for (const member& one : type.members)
        if (one.what == member::role::presence_vector)
            return hex_number(one.number(object), std::get<integer_form>(one.how->is).bits / 4);
    return nullptr;
}
/// The same for a typed message.
template <wire::message T> [[nodiscard]] json presence_vector_of(const T& message) {
    return presence_vector_of(describe<T>(), &message);
}

/// A message from the JSON of its fields. `presence_vector`, as a number or text in hex, may be among them: it
/// determines the members of list elements if the lists are empty. Counts may be omitted, scaled fields may be numbers,
/// and all values of from_text are accepted as text. Lists, texts and bytes are stored in `memory`. After an error
/// the message is valid but unspecified.
template <wire::message T>
[[nodiscard]] result<void, error> from_json(const json& fields, T& message, wire::arena& memory) {
    return from_input(detail::input_of(fields), message, memory);
}
/// The same for a value-initialised object of which only the structure is known.
[[nodiscard]] inline result<void, error> from_json(const json& fields, const structure& type, void* object,
                                                   wire::arena& memory) {
    return from_input(detail::input_of(fields), type, object, memory);
}

} // namespace jauscat::text
