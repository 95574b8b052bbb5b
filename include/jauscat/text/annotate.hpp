// A message's bytes with the fields they carry, a line each: what an operator reads when something is wrong.
//
//     0012  ff 3f        propulsive_linear_effort_x = 49.998474 % (raw 16383)
#pragma once
#include <jauscat/text/diagnosis_text.hpp>
#include <jauscat/text/message_name.hpp>
#include <jauscat/text/value.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/diagnose.hpp>

namespace jauscat::text {

namespace detail {

/// Traces decoding and writes a line for each field.
class annotating_trace : public wire::decode_trace {
  public:
    annotating_trace(std::span<const std::byte> bytes, std::size_t first_offset, std::string indent)
        : decode_trace{bytes}, bytes_{bytes}, first_offset_{first_offset}, indent_{std::move(indent)} {}

    template <class Item> void passed(const auto& object) {
        if constexpr (requires { typename Item::fields; }) {
            std::string row;
            Item::visit(object, [&](auto field, const auto& value) {
                append_member(row, row.empty() ? "" : ", ", prefix() + std::string{field.name()},
                              to_text(field, value));
            });
            line(row);
        } else if constexpr (requires { Item::fixed_value; }) {
            constant_line(Item::name(), static_cast<std::uint64_t>(Item::fixed_value), Item::max_size);
        } else if constexpr (requires { Item::key; } && Item::max_size != 0) {
            const auto& value = wire::value_of(wire::member_of<Item::key>(object));
            if constexpr (Item::name() == "command_code")
                member_line(Item::name(), code_text(value));
            else
                member_line(Item::name(), to_text(Item{}, value));
        }
    }
    template <class Item> void passed_element(const auto& value) {
        element_line(to_text(typename Item::element_type{}, value));
    }
    template <std::size_t Size> void passed_number(std::string_view name, std::uint64_t value) {
        number_line(name, value, Size);
    }
    [[nodiscard]] std::string text() && { return std::move(text_); }

  private:
    // What is no template is compiled once for all messages.
    void member_line(std::string_view name, const std::string& value) {
        std::string row = prefix();
        append_member(row, "", name, value);
        line(row);
    }
    void element_line(const std::string& value) {
        std::string name = prefix();
        name.pop_back(); // the dot
        line(name + " = " + value);
    }
    void constant_line(std::string_view name, std::uint64_t value, std::size_t size) {
        member_line(name, name == "message_id" ? hex_number(value, size * 2) : std::to_string(value));
    }
    void number_line(std::string_view name, std::uint64_t value, std::size_t size) {
        member_line(name, name == "presence_vector" ? hex_number(value, size * 2) : std::to_string(value));
    }
    [[nodiscard]] std::string prefix() const { return path_text(found(wire::errc::ok)); }
    void line(const std::string& what) {
        const std::size_t next = offset();
        const auto here = bytes_.subspan(at_, next - at_);
        std::string row = indent_ + hex_offset(first_offset_ + at_) + "  " + hex(here);
        const std::size_t column = indent_.size() + 6 + 4 * 3 + 1; // four bytes, then the text
        if (row.size() < column) row.append(column - row.size(), ' ');
        text_ += row + " " + what + "\n";
        at_ = next;
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
    detail::annotating_trace rows{bytes, first_offset, indent};
    if (!wire::decode_traced(message, rows))
        return hex_dump(bytes, indent, first_offset) + indent + to_text(wire::diagnose<T>(bytes), first_offset) + "\n";
    return std::move(rows).text();
}

} // namespace jauscat::text
