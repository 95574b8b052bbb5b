// Writes any structure with the bytes that it was decoded from.
#pragma once
#include <jauscat/text/annotate.hpp>
#include <jauscat/text/impl/print.ipp>

#include <algorithm>
#include <variant>

namespace jauscat::text {

namespace detail {

/// Walks over a decoded message; the sizes of its values say where each begins.
class annotator {
  public:
    explicit annotator(std::size_t size) : size_{size} {}

    void fields(const structure& type, const void* object, const std::string& path) {
        const scope here{type.id, object, inner_};
        inner_ = &here;
        std::vector<annotated_field> bit_fields; // of one integer
        for (std::size_t i = 0; i != type.members.size(); ++i) {
            const member& one = type.members[i];
            std::string name = path + std::string{one.name};
            switch (one.what) {
            case member::role::flag:
            case member::role::not_on_wire: break;
            case member::role::count:
                if (type.members[i + 1].find(object) == nullptr) break;
                [[fallthrough]];
            case member::role::presence_vector:
            case member::role::constant: part(name, number_text(one, one.number(object)), one.least); break;
            case member::role::value:
                const void* const at = one.find(object);
                if (at == nullptr) break;
                if (one.carrier_bits == 0) {
                    member_value(one, at, path, name);
                    break;
                }
                bit_fields.push_back({name, printer::one_line(one.name, *one.how, at)});
                if (one.ends_carrier) part(std::exchange(bit_fields, {}), one.carrier_bits / 8);
                break;
            }
        }
        inner_ = here.outer;
    }
    [[nodiscard]] std::vector<annotated_part> parts() && { return std::move(parts_); }

  private:
    // A user's own item may take other bytes than its value tells: never more than there are.
    void part(std::vector<annotated_field> fields, std::size_t size) {
        size = std::min(size, size_ - offset_);
        parts_.push_back({offset_, size, std::move(fields)});
        offset_ += size;
    }
    void part(const std::string& path, std::string value, std::size_t size) { part({{path, std::move(value)}}, size); }
    static std::string number_text(const member& one, std::uint64_t number) {
        const bool as_hex = one.what == member::role::presence_vector || one.name == "message_id";
        return as_hex ? hex_number(number, one.least * 2) : std::to_string(number);
    }

    void member_value(const member& one, const void* at, const std::string& path, const std::string& name) {
        const std::size_t size = one.least == one.most ? one.least : wire::unbounded;
        if (!std::holds_alternative<choice_form>(one.how->is)) return value(name, *one.how, at, size);
        const held_case held = case_of(one, at, inner_);
        if (held.how == nullptr) return part(name, "none", 0);
        if (const auto* const inner = std::get_if<structure_form>(&held.how->is))
            fields(*inner->of, held.at, path);
        else
            value(name, *held.how, held.at);
    }
    /// `size`: bytes, where the member says it.
    void value(const std::string& name, const form& how, const void* at, std::size_t size = wire::unbounded) {
        if (const structure* const inner = structure_of(how); inner != nullptr) return fields(*inner, at, name + ".");
        std::visit(
            [&](const auto& is) {
                if constexpr (requires { lines(name, is, at); })
                    lines(name, is, at);
                else
                    part(name, printer::one_line(name, how, at), size != wire::unbounded ? size : size_of(is, at));
            },
            how.is);
    }

    /// What has fields of its own, and no notation in one line.
    static const structure* structure_of(const form& how) {
        if (const auto* const is = std::get_if<structure_form>(&how.is)) return is->of;
        if (const auto* const is = std::get_if<encoded_form>(&how.is)) return is->of;
        const auto* const packed = std::get_if<packed_form>(&how.is);
        return packed != nullptr && packed->show == nullptr ? packed->of : nullptr;
    }
    void lines(const std::string&, const structure_form&, const void*) {} // see structure_of
    void lines(const std::string& name, const list_form& is, const void* at) {
        const auto* element = static_cast<const std::byte*>(is.first(at));
        for (std::size_t i = 0; i != is.size(at); ++i, element += is.stride)
            value(name + "[" + std::to_string(i) + "]", *is.element, element);
    }
    void lines(const std::string& name, const tree_form& is, const void* at) { lines(name, is.nodes, at); }
    void lines(const std::string& name, const variant_form& is, const void* at) {
        const std::size_t index = is.index(at);
        part(name + ".index", std::to_string(index), is.bits / 8);
        if (const form* const how = is.alternatives[index].how; how != nullptr) value(name, *how, is.get(at));
    }
    void lines(const std::string&, const choice_form&, const void*) {} // always a member, see member_value

    [[nodiscard]] std::size_t size_of(const octets_form& is, const void* at) const {
        if (is.to_the_end) return size_ - offset_;
        if (is.zero_filled || is.least == is.most) return is.most;
        return is.get(at).size() + (is.zero_terminated ? 1 : 0);
    }
    static std::size_t size_of(const encoded_form& is, const void* at) { return is.encode(at).size(); }
    static std::size_t size_of(const auto& is, const void*) { return is.bits / 8; }

    std::size_t size_;     // of the whole message
    std::size_t offset_{}; // of the next part
    const scope* inner_{};
    std::vector<annotated_part> parts_{};
};

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL annotation annotated(const structure& type, const void* object, std::span<const std::byte> bytes) {
    detail::annotator walk{bytes.size()};
    walk.fields(type, object, {});
    return {.parts = std::move(walk).parts()};
}

JAUSCAT_DECL std::string to_text(const annotation& told, std::span<const std::byte> bytes, std::size_t first_offset,
                                 std::string_view indent) {
    const std::string before{indent};
    if (told.fault.error != wire::errc::ok)
        return hex_dump(bytes, before, first_offset) + before + text::to_text(told.fault, first_offset) + "\n";
    const std::size_t column = before.size() + 6 + 4 * 3 + 1; // four bytes, then the text
    std::string text;
    for (const annotated_part& part : told.parts) {
        std::string row = before + hex_offset(first_offset + part.offset);
        row += "  " + hex(bytes.subspan(part.offset, part.size));
        if (row.size() < column) row.append(column - row.size(), ' ');
        std::string_view separator = " ";
        for (const annotated_field& field : part.fields)
            detail::append_member(row, std::exchange(separator, ", "), field.path, field.value);
        text += row + "\n";
    }
    return text;
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::text
