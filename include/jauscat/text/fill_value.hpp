// Fills one value of a message from parsed input. Each function returns an error text, or nothing.
#pragma once
#include <jauscat/text/scan.hpp>

namespace jauscat::text::detail {

inline constexpr std::string_view single = "is a single value";
inline constexpr std::string_view no_capacity = "does not fit into the memory for lists";

inline std::string fill_value(const integer_form& is, void* at, const input& in, wire::arena&) {
    if (in.what != input::kind::leaf) return std::string{single};
    std::uint64_t number{};
    std::string wrong = scan(in.text, is, number);
    if (wrong.empty()) is.set(at, number);
    return wrong;
}
inline std::string fill_value(const real_form& is, void* at, const input& in, wire::arena&) {
    if (in.what != input::kind::leaf) return std::string{single};
    double real{};
    std::string wrong = scan(in.text, is, real);
    if (wrong.empty()) is.set(at, real);
    return wrong;
}
/// A number, or an object of a value and its raw integer, which must agree.
inline std::string fill_value(const scaled_form& is, void* at, const input& in, wire::arena&) {
    const input* const raw = in.find("raw");
    const input* const value = in.what == input::kind::leaf ? &in : in.find("value");
    if (in.what != input::kind::leaf && ((raw == nullptr && value == nullptr) ||
                                         in.parts.size() != (raw != nullptr ? 1u : 0u) + (value != nullptr ? 1u : 0u)))
        return "is a single value, or a value and its raw integer";
    double real{}, by_raw{};
    std::string wrong;
    if (raw != nullptr) wrong = scan_raw(raw->text, is, by_raw);
    if (wrong.empty() && value != nullptr) wrong = scan(value->text, is, real);
    if (!wrong.empty()) return wrong;
    if (value == nullptr) real = by_raw;
    if (raw != nullptr && is.to_raw(real) != is.to_raw(by_raw))
        return "has the value " + value->text + " and the raw integer " + raw->text + ", which stands for " +
               real_text(by_raw);
    is.set(at, real);
    return {};
}

/// Copies octets to where a message may point at them, and calls use(copy).
inline std::string keep(std::span<const std::byte> bytes, wire::arena& memory, auto&& use) {
    if (bytes.empty()) return use(bytes);
    auto* const copy = memory.allocate<std::byte>(bytes.size());
    if (copy == nullptr) return std::string{no_capacity};
    std::ranges::copy(bytes, copy);
    return use(std::span<const std::byte>{copy, bytes.size()});
}
/// Text as it is or as {"hex": ...}; bytes in hex.
inline std::string fill_value(const octets_form& is, void* at, const input& in, wire::arena& memory) {
    const input* const hex = in.find("hex");
    if (in.what != input::kind::leaf && (hex == nullptr || in.parts.size() != 1)) return std::string{single};
    std::vector<std::byte> scanned;
    std::span<const std::byte> bytes = std::as_bytes(std::span{in.text});
    if (!is.characters || hex != nullptr) {
        auto found = scan_hex(hex != nullptr ? hex->text : in.text);
        if (!found) return "is not in hex: pairs of digits";
        scanned = *std::move(found);
        bytes = scanned;
    }
    if (is.zero_filled)
        while (!bytes.empty() && bytes.back() == std::byte{}) bytes = bytes.first(bytes.size() - 1);
    const std::string has =
        "has " + std::to_string(bytes.size()) + (is.characters ? " characters" : " bytes") + ", must have ";
    if (bytes.size() > is.most) return has + "at most " + std::to_string(is.most);
    if (bytes.size() < is.least) return has + std::to_string(is.least);
    if (is.zero_terminated && std::ranges::find(bytes, std::byte{}) != bytes.end())
        return "contains a zero, which ends it";
    return keep(bytes, memory, [&](std::span<const std::byte> copy) { return is.set(at, copy), std::string{}; });
}
inline std::string fill_value(const encoded_form& is, void* at, const input& in, wire::arena& memory) {
    const auto bytes = in.what == input::kind::leaf ? scan_hex(in.text) : std::nullopt;
    if (!bytes) return "is a whole message in hex: pairs of digits";
    return keep(*bytes, memory, [&](std::span<const std::byte> copy) -> std::string {
        return is.decode(at, copy) ? "" : "is no whole message";
    });
}
/// In its own notation, or as its integer.
inline std::string fill_value(const packed_form& is, void* at, const input& in) {
    if (in.what != input::kind::leaf) return std::string{single};
    if (is.read != nullptr && is.read(at, in.text)) return {};
    std::string_view text = in.text;
    is_raw(text);
    if (!scan_whole(text) && is.show != nullptr)
        return says(text, "which is neither of the form '" + is.show(at) + "' nor a raw integer");
    std::uint64_t number{};
    std::string wrong = scan_bits(text, false, is.bits, {}, number);
    if (wrong.empty()) is.set(at, number);
    return wrong;
}

} // namespace jauscat::text::detail
