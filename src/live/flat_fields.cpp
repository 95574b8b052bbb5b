#include "flat_fields.hpp"

#include <jauscat/text/json.hpp>
#include <jauscat/text/value.hpp>

#include <string>
#include <utility>
#include <variant>

namespace jauscat::net::live {

namespace {

using namespace text;

std::string plain_hex(std::span<const std::byte> bytes) { return text::detail::plain_hex(bytes); }

/// Writes any structure; `path_` is that of the value that is written.
class flattener {
  public:
    void fields(const structure& type, const void* object) {
        const scope here{type.id, object, inner_};
        inner_ = &here;
        for (std::size_t i = 0; i != type.members.size(); ++i) {
            const member& one = type.members[i];
            switch (one.what) {
            case member::role::flag:
            case member::role::constant:
            case member::role::presence_vector:
            case member::role::not_on_wire: break;
            case member::role::count:
                if (type.members[i + 1].find(object) != nullptr) at(one.name, [&] { put(one.number(object)); });
                break;
            case member::role::value:
                if (const void* const found = one.find(object); found != nullptr)
                    at(one.name, [&] { member_value(one, found); });
                break;
            }
        }
        inner_ = here.outer;
    }
    flat_fields made{};

  private:
    void at(std::string_view name, auto&& write) {
        const auto before = path_.size();
        if (before != 0) path_ += '.';
        path_ += name;
        write();
        path_.resize(before);
    }
    void put(json value, std::string_view unit = {}) {
        made.values[path_] = std::move(value);
        if (!unit.empty()) made.units[path_] = unit;
    }
    void member_value(const member& one, const void* found) {
        if (!std::holds_alternative<choice_form>(one.how->is)) return value(*one.how, found);
        const held_case held = case_of(one, found, inner_);
        if (held.known && held.how != nullptr) value(*held.how, held.at);
    }
    void value(const form& how, const void* found) {
        std::visit([&](const auto& is) { write(is, found); }, how.is);
    }

    void write(const integer_form& is, const void* found) {
        const auto number = is.get(found);
        const auto name = number < is.names.size() ? is.names[static_cast<std::size_t>(number)] : std::string_view{};
        switch (is.what) {
        case integer_form::meaning::boolean: return put(number != 0);
        case integer_form::meaning::flags: return put(text::detail::set_bits(is.names, is.bits, number));
        case integer_form::meaning::enumeration: return name.empty() ? put(number) : put(name);
        case integer_form::meaning::number: break;
        }
        put(text::detail::json_number(number, is.is_signed), is.unit);
    }
    void write(const real_form& is, const void* found) { put(text::detail::json_real(is.get(found)), is.unit); }
    void write(const scaled_form& is, const void* found) { put(text::detail::json_real(is.get(found)), is.unit); }
    void write(const octets_form& is, const void* found) {
        const auto bytes = is.get(found);
        std::string characters{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
        put(is.characters && is_utf8(characters) ? std::move(characters) : plain_hex(bytes));
    }
    void write(const structure_form& is, const void* found) { fields(*is.of, found); }
    void write(const packed_form& is, const void* found) {
        is.show != nullptr ? put(is.show(found)) : put(is.get(found));
    }
    void write(const encoded_form& is, const void* found) { put(plain_hex(is.encode(found))); }
    void write(const variant_form& is, const void* found) {
        const alternative& held = is.alternatives[is.index(found)];
        at(held.name, [&] { held.how == nullptr ? put(true) : value(*held.how, is.get(found)); });
    }
    void write(const list_form& is, const void* found) {
        const auto* element = static_cast<const std::byte*>(is.first(found));
        for (std::size_t i = 0, size = is.size(found); i != size; ++i, element += is.stride)
            at(std::to_string(i), [&] {
                is.field.empty() ? value(*is.element, element) : at(is.field, [&] { value(*is.element, element); });
            });
    }
    void write(const tree_form& is, const void* found) { // its nodes one after the other, as on the wire
        write(is.nodes, found);
    }
    void write(const choice_form&, const void*) {} // always a member, see member_value

    std::string path_{};
    const scope* inner_{};
};

} // namespace

flat_fields flatten(const catalogue::any_message& message) {
    flattener all;
    all.fields(message.type().fields(), message.object());
    return std::move(all.made);
}

} // namespace jauscat::net::live
