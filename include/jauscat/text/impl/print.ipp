// Writes any structure as lines of text.
#pragma once
#include <jauscat/text/hex.hpp>
#include <jauscat/text/message_name.hpp>
#include <jauscat/text/outside_values.hpp>
#include <jauscat/text/print.hpp>
#include <jauscat/text/quoted.hpp>
#include <jauscat/text/value.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <variant>

namespace jauscat::text {

namespace detail {

inline std::string with_unit(std::string text, std::string_view unit) {
    if (!unit.empty()) (text += ' ') += unit;
    return text;
}
inline std::string digits(std::uint64_t number, bool is_signed) {
    return is_signed ? std::to_string(static_cast<std::int64_t>(number)) : std::to_string(number);
}
inline std::string_view name_in(std::span<const std::string_view> names, std::uint64_t number) {
    return number < names.size() ? names[static_cast<std::size_t>(number)] : std::string_view{};
}

/// Writes any structure; a value of one line follows its name, one of more lines is indented below it.
class printer {
  public:
    explicit printer(std::size_t indent) : indent_{indent} {}

    void fields(const structure& type, const void* object) {
        const scope here{type.id, object, inner_};
        inner_ = &here;
        for (std::size_t i = 0; i != type.members.size(); ++i) {
            const member& one = type.members[i];
            switch (one.what) {
            case member::role::constant:
            case member::role::not_on_wire: break;
            case member::role::presence_vector:
                line(one.name, hex_number(one.number(object), std::get<integer_form>(one.how->is).bits / 4));
                break;
            case member::role::count:
                if (type.members[i + 1].find(object) != nullptr)
                    line(one.name, marked(std::to_string(one.number(object)), std::get<integer_form>(one.how->is),
                                          one.number(object)));
                break;
            case member::role::flag:
            case member::role::value:
                if (const void* const found = one.find(object); found != nullptr) member_value(one, found);
                break;
            }
        }
        inner_ = here.outer;
    }
    [[nodiscard]] std::string text() && { return std::move(text_); }

    /// A value that fits a line; empty for others.
    static std::string one_line(std::string_view name, const form& how, const void* at) {
        return std::visit(
            [&](const auto& is) {
                if constexpr (requires { one_line(name, is, at); })
                    return one_line(name, is, at);
                else
                    return std::string{};
            },
            how.is);
    }

  private:
    void line(std::string_view name, std::string_view value) {
        text_.append(indent_, ' ');
        text_ += name;
        if (!value.empty()) (text_ += " = ") += value;
        text_ += '\n';
    }
    void member_value(const member& one, const void* at) {
        if (std::holds_alternative<choice_form>(one.how->is)) {
            const held_case held = case_of(one, at, inner_);
            if (!held.known)
                line(one.name, "of another type");
            else if (held.how == nullptr)
                line(one.name, "none");
            else
                value(one.name, *held.how, held.at);
        } else {
            value(one.name, *one.how, at);
        }
    }
    void value(std::string_view name, const form& how, const void* at) {
        std::visit(
            [&](const auto& is) {
                if constexpr (requires { one_line(name, is, at); })
                    line(name, one_line(name, is, at));
                else
                    lines(name, is, at);
            },
            how.is);
    }

    static std::string marked(std::string text, const integer_form& is, std::uint64_t number) {
        return is_outside(is, number) ? std::move(text) += outside_mark : text;
    }
    static std::string one_line(std::string_view name, const integer_form& is, const void* at) {
        return marked(integer_text(name, is, is.get(at)), is, is.get(at));
    }
    static std::string integer_text(std::string_view name, const integer_form& is, std::uint64_t number) {
        switch (is.what) {
        case integer_form::meaning::boolean: return number != 0 ? "true" : "false";
        case integer_form::meaning::flags:
            return set_bits(is.names, is.bits, number) + " (" + hex_number(number, is.bits / 4) + ")";
        case integer_form::meaning::enumeration:
            if (const std::string_view known = name_in(is.names, number); !known.empty())
                return std::string{known} + " (" + std::to_string(number) + ")";
            return hex_number(number, (is.bits + 3) / 4);
        case integer_form::meaning::number: break;
        }
        if (name.ends_with("command_code") || name.ends_with("message_code"))
            return code_text(static_cast<std::uint16_t>(number));
        if (name.ends_with("presence_vector")) return hex_number(number, is.bits / 4); // more readable in hex
        return with_unit(digits(number, is.is_signed), is.unit);
    }
    static std::string one_line(std::string_view, const real_form& is, const void* at) {
        return with_unit(real_text(is.get(at)), is.unit);
    }
    static std::string one_line(std::string_view, const scaled_form& is, const void* at) {
        const double real = is.get(at);
        std::string text = with_unit(real_text(real), is.unit);
        if (real >= is.lowest && real <= is.highest) text += " (raw " + digits(is.to_raw(real), is.is_signed) + ")";
        return text;
    }
    static std::string one_line(std::string_view, const octets_form& is, const void* at) {
        const auto bytes = is.get(at);
        if (is.characters) return quoted({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        return sized_hex(bytes);
    }
    static std::string one_line(std::string_view, const encoded_form& is, const void* at) {
        return sized_hex(is.encode(at));
    }
    static std::string one_line(std::string_view, const packed_form& is, const void* at) {
        std::string text = is.show != nullptr ? is.show(at) + " (raw " + std::to_string(is.get(at)) + ")"
                                              : hex_number(is.get(at), is.bits / 4);
        return outside_values(*is.of, at).empty() ? text : std::move(text) += outside_mark;
    }

    void lines(std::string_view name, const structure_form& is, const void* at) {
        line(name, {});
        below([&] { fields(*is.of, at); });
    }
    void lines(std::string_view name, const list_form& is, const void* at) {
        const std::size_t size = is.size(at);
        if (size == 0) line(name, "none");
        const auto* element = static_cast<const std::byte*>(is.first(at));
        for (std::size_t i = 0; i != size; ++i, element += is.stride) {
            std::string numbered = std::string{name} + "[" + std::to_string(i) + "]";
            if (!is.field.empty()) (numbered += '.') += is.field;
            value(numbered, *is.element, element);
        }
    }
    void lines(std::string_view name, const tree_form& is, const void* at) {
        const auto* next = static_cast<const std::byte*>(is.nodes.first(at));
        std::size_t left = is.nodes.size(at);
        if (left != 0) node(std::string{name}, is, next, left);
    }
    void lines(std::string_view name, const variant_form& is, const void* at) {
        const alternative& held = is.alternatives[is.index(at)];
        line(name, held.name);
        if (held.how == nullptr) return;
        if (const auto* const inner = std::get_if<structure_form>(&held.how->is))
            below([&] { fields(*inner->of, is.get(at)); });
        else
            below([&] { value(held.name, *held.how, is.get(at)); });
    }
    void lines(std::string_view, const choice_form&, const void*) {} // always a member, see member_value

    void node(const std::string& name, const tree_form& is, const std::byte*& next, std::size_t& left) {
        const std::byte* const here = next;
        value(name, *is.nodes.element, here);
        next += is.nodes.stride;
        --left;
        below([&] {
            const std::uint64_t children = is.children.get(here);
            for (std::uint64_t i = 0; i != children && left != 0; ++i)
                node("child[" + std::to_string(i) + "]", is, next, left);
        });
    }

    void below(auto&& write) {
        indent_ += 2;
        write();
        indent_ -= 2;
    }
    /// The first bytes; the rest is for annotate and JSON.
    static std::string sized_hex(std::span<const std::byte> bytes) {
        constexpr std::size_t shown = 32;
        std::string text = std::to_string(bytes.size()) + (bytes.size() == 1 ? " byte" : " bytes");
        if (!bytes.empty()) text += ": " + hex(bytes.first(std::min(bytes.size(), shown)));
        return bytes.size() > shown ? text + " ..." : text;
    }

    std::size_t indent_;
    const scope* inner_{};
    std::string text_;
};

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL std::string to_text(const structure& type, const void* object, std::size_t indent) {
    detail::printer out{indent};
    out.fields(type, object);
    return std::move(out).text();
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::text
