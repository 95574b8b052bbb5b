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
    annotator(std::span<const std::byte> bytes, std::size_t first_offset, std::string_view indent)
        : bytes_{bytes}, first_offset_{first_offset}, indent_{indent} {}

    void fields(const structure& type, const void* object, const std::string& path) {
        const scope here{type.id, object, inner_};
        inner_ = &here;
        std::string row; // the bit-fields of one integer
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
            case member::role::constant: line(name, number_text(one, one.number(object)), one.least); break;
            case member::role::value:
                const void* const at = one.find(object);
                if (at == nullptr) break;
                if (one.carrier_bits == 0) {
                    member_value(one, at, path, name);
                    break;
                }
                append_member(row, row.empty() ? "" : ", ", name, printer::one_line(one.name, *one.how, at));
                if (one.ends_carrier) line(std::exchange(row, {}), one.carrier_bits / 8);
                break;
            }
        }
        inner_ = here.outer;
    }
    [[nodiscard]] std::string text() && { return std::move(text_); }

  private:
    void line(const std::string& what, std::size_t size) {
        const auto here = bytes_.first(std::min(size, bytes_.size()));
        std::string row = indent_ + hex_offset(first_offset_) + "  " + hex(here);
        const std::size_t column = indent_.size() + 6 + 4 * 3 + 1; // four bytes, then the text
        if (row.size() < column) row.append(column - row.size(), ' ');
        text_ += row + " " + what + "\n";
        bytes_ = bytes_.subspan(here.size());
        first_offset_ += here.size();
    }
    void line(const std::string& name, const std::string& value, std::size_t size) {
        std::string row;
        append_member(row, "", name, value);
        line(row, size);
    }
    static std::string number_text(const member& one, std::uint64_t number) {
        const bool as_hex = one.what == member::role::presence_vector || one.name == "message_id";
        return as_hex ? hex_number(number, one.least * 2) : std::to_string(number);
    }

    void member_value(const member& one, const void* at, const std::string& path, const std::string& name) {
        const std::size_t size = one.least == one.most ? one.least : wire::unbounded;
        if (!std::holds_alternative<choice_form>(one.how->is)) return value(name, *one.how, at, size);
        const held_case held = case_of(one, at, inner_);
        if (held.how == nullptr) return line(name, "none", 0);
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
                    line(name, printer::one_line(name, how, at), size != wire::unbounded ? size : size_of(is, at));
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
        line(name + ".index", std::to_string(index), is.bits / 8);
        if (const form* const how = is.alternatives[index].how; how != nullptr) value(name, *how, is.get(at));
    }
    void lines(const std::string&, const choice_form&, const void*) {} // always a member, see member_value

    [[nodiscard]] std::size_t size_of(const octets_form& is, const void* at) const {
        if (is.to_the_end) return bytes_.size();
        if (is.zero_filled || is.least == is.most) return is.most;
        return is.get(at).size() + (is.zero_terminated ? 1 : 0);
    }
    static std::size_t size_of(const encoded_form& is, const void* at) { return is.encode(at).size(); }
    static std::size_t size_of(const auto& is, const void*) { return is.bits / 8; }

    std::span<const std::byte> bytes_; // that are left
    std::size_t first_offset_;         // of the next one
    std::string indent_;
    const scope* inner_{};
    std::string text_;
};

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL std::string annotate(const structure& type, const void* object, std::span<const std::byte> bytes,
                                  std::size_t first_offset, std::string_view indent) {
    detail::annotator out{bytes, first_offset, indent};
    out.fields(type, object, {});
    return std::move(out).text();
}
JAUSCAT_DECL std::string annotate(const wire::diagnosis& why, std::span<const std::byte> bytes,
                                  std::size_t first_offset, std::string_view indent) {
    const std::string before{indent};
    return hex_dump(bytes, before, first_offset) + before + text::to_text(why, first_offset) + "\n";
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::text
