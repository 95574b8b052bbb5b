// A message's bytes with the fields they carry, a line each: what an operator reads when something is wrong.
//
//     0012  ff 3f        propulsive_linear_effort_x = 49.998474 % (raw 16383)
#pragma once
#include <jauscat/text/value.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/diagnose.hpp>

namespace jauscat::text {

namespace detail {

class annotator {
  public:
    annotator(std::span<const std::byte> bytes, std::size_t first_offset, std::string indent)
        : bytes_{bytes}, first_offset_{first_offset}, indent_{std::move(indent)} {}

    template <class Layout> void layout(const auto& object, const std::string& prefix) {
        Layout::all_items([&]<class Item>() {
            item<Item>(object, prefix);
            return true;
        });
    }
    [[nodiscard]] std::size_t offset() const noexcept { return at_; }
    [[nodiscard]] std::string text() && { return std::move(text_); }

    void line(std::size_t size, const std::string& what) {
        const auto here = bytes_.subspan(at_, size);
        std::string row = indent_ + formatted("%04zx  ", first_offset_ + at_) + hex(here);
        const std::size_t column = indent_.size() + 6 + 4 * 3 + 1; // four bytes, then the text
        if (row.size() < column) row.append(column - row.size(), ' ');
        text_ += row + " " + what + "\n";
        at_ += size;
    }

  private:
    template <class Item> void item(const auto& object, const std::string& prefix) {
        if constexpr (requires { Item::known_bits; }) {
            const auto mask = Item::mask(object);
            line(Item::carrier_codec::size, "presence_vector = " + hex_number(mask, Item::carrier_codec::size * 2));
            Item::all_items([&]<class Sub>() {
                if constexpr (Sub::optional) {
                    if (!wire::member_of<Sub::key>(object)) return true;
                }
                item<Sub>(object, prefix);
                return true;
            });
        } else if constexpr (requires { typename Item::inner; }) {
            const auto& member = wire::member_of<Item::key>(object);
            const std::string inside = prefix + std::string{Item::name()} + ".";
            if constexpr (Item::optional)
                layout<typename Item::inner>(*member, inside);
            else
                layout<typename Item::inner>(member, inside);
        } else if constexpr (requires { typename Item::fields; }) {
            std::string row;
            Item::visit(object, [&](auto field, const auto& value) {
                row += (row.empty() ? "" : ", ") + prefix + std::string{field.name()} + " = " + to_text(field, value);
            });
            line(Item::max_size, row);
        } else {
            const auto& member = wire::member_of<Item::key>(object);
            std::string value;
            if constexpr (Item::optional)
                value = to_text(Item{}, *member);
            else
                value = to_text(Item{}, member);
            line(Item::max_size, prefix + std::string{Item::name()} + " = " + value);
        }
    }

    std::span<const std::byte> bytes_;
    std::size_t first_offset_;
    std::string indent_;
    std::size_t at_{};
    std::string text_;
};

} // namespace detail

/// Decodes a `T` from the front of `bytes` and prints a line for each field: offset (counted from `first_offset`),
/// bytes, name, value. Bytes that do not decode are dumped with the reason.
template <wire::message T>
[[nodiscard]] std::string annotate(std::span<const std::byte> bytes, std::size_t first_offset = 0,
                                   const std::string& indent = "  ") {
    T message{};
    if (const wire::result used = wire::decode_prefix(message, bytes); !used) {
        const wire::diagnosis why = wire::diagnose<T>(bytes);
        return hex_dump(bytes, indent) + indent + std::string{wire::describe(why.error)} + ": " +
               std::string{why.field} + " at byte " + std::to_string(first_offset + why.offset) + " needs " +
               std::to_string(why.needed) + " bytes, " + std::to_string(why.available) + " left\n";
    }
    detail::annotator rows{bytes, first_offset, indent};
    rows.layout<wire::layout_of<T>>(message, "");
    return std::move(rows).text();
}

} // namespace jauscat::text
