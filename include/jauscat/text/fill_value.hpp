// Fills one value of a message from parsed input. The errors name no field.
#pragma once
#include <jauscat/text/scan.hpp>

namespace jauscat::text::detail {

inline error not_a(std::string_view kind) { return {.code = errc::wrong_kind, .message = std::string{kind}}; }
inline error not_single() { return not_a("is a single value"); }
inline error no_capacity() { return {.code = errc::arena_full, .message = "does not fit into the memory for lists"}; }

inline result<void, error> fill_value(const integer_form& is, void* at, const input& in, wire::arena&) {
    if (in.what != input::kind::leaf) return not_single();
    const auto number = scan(in.text, is);
    if (number) is.set(at, *number);
    return number.error();
}
inline result<void, error> fill_value(const real_form& is, void* at, const input& in, wire::arena&) {
    if (in.what != input::kind::leaf) return not_single();
    const auto real = scan(in.text, is);
    if (real) is.set(at, *real);
    return real.error();
}
/// A number, or an object of a value and its raw integer, which must agree.
inline result<void, error> fill_value(const scaled_form& is, void* at, const input& in, wire::arena&) {
    const input* const raw = in.find("raw");
    const input* const value = in.what == input::kind::leaf ? &in : in.find("value");
    if (in.what != input::kind::leaf && ((raw == nullptr && value == nullptr) ||
                                         in.parts.size() != (raw != nullptr ? 1u : 0u) + (value != nullptr ? 1u : 0u)))
        return not_a("is a single value, or a value and its raw integer");
    const auto by_raw = raw != nullptr ? scan_raw(raw->text, is) : 0.0;
    if (!by_raw) return by_raw.error();
    const auto real = value != nullptr ? scan(value->text, is) : by_raw;
    if (!real) return real.error();
    if (raw != nullptr && is.to_raw(*real) != is.to_raw(*by_raw))
        return error{.code = errc::inconsistent,
                     .message = "has the value " + value->text + " and the raw integer " + raw->text +
                                ", which stands for " + real_text(*by_raw)};
    is.set(at, *real);
    return {};
}

/// Copies octets to where a message may point at them, and calls use(copy).
inline result<void, error> keep(std::span<const std::byte> bytes, wire::arena& memory, auto&& use) {
    if (bytes.empty()) return use(bytes);
    auto* const copy = memory.allocate<std::byte>(bytes.size());
    if (copy == nullptr) return no_capacity();
    std::ranges::copy(bytes, copy);
    return use(std::span<const std::byte>{copy, bytes.size()});
}
/// Text as it is or as {"hex": ...}; bytes in hex.
inline result<void, error> fill_value(const octets_form& is, void* at, const input& in, wire::arena& memory) {
    const input* const hex = in.find("hex");
    if (in.what != input::kind::leaf && (hex == nullptr || in.parts.size() != 1)) return not_single();
    std::vector<std::byte> scanned;
    std::span<const std::byte> bytes = std::as_bytes(std::span{in.text});
    if (!is.characters || hex != nullptr) {
        auto found = scan_hex(hex != nullptr ? hex->text : in.text);
        if (!found) return error{.code = errc::invalid_value, .message = "is not in hex: pairs of digits"};
        scanned = *std::move(found);
        bytes = scanned;
    }
    if (is.zero_filled)
        while (!bytes.empty() && bytes.back() == std::byte{}) bytes = bytes.first(bytes.size() - 1);
    const auto must_have = [&](const std::string& size) {
        return error{.code = errc::wrong_size,
                     .message = "has " + std::to_string(bytes.size()) + (is.characters ? " characters" : " bytes") +
                                ", must have " + size};
    };
    if (bytes.size() > is.most) return must_have("at most " + std::to_string(is.most));
    if (bytes.size() < is.least) return must_have(std::to_string(is.least));
    if (is.zero_terminated && std::ranges::find(bytes, std::byte{}) != bytes.end())
        return error{.code = errc::invalid_value, .message = "contains a zero, which ends it"};
    return keep(bytes, memory,
                [&](std::span<const std::byte> copy) { return is.set(at, copy), result<void, error>{}; });
}
inline result<void, error> fill_value(const encoded_form& is, void* at, const input& in, wire::arena& memory) {
    const auto bytes = in.what == input::kind::leaf ? scan_hex(in.text) : std::nullopt;
    if (!bytes) return error{.code = errc::invalid_value, .message = "is a whole message in hex: pairs of digits"};
    return keep(*bytes, memory, [&](std::span<const std::byte> copy) -> result<void, error> {
        if (is.decode(at, copy)) return {};
        return error{.code = errc::invalid_value, .message = "is no whole message"};
    });
}
/// In its own notation, or as its integer.
inline result<void, error> fill_value(const packed_form& is, void* at, const input& in) {
    if (in.what != input::kind::leaf) return not_single();
    if (is.read != nullptr && is.read(at, in.text)) return {};
    std::string_view text = in.text;
    is_raw(text);
    if (!scan_whole(text) && is.show != nullptr)
        return says(errc::invalid_value, text, "which is neither of the form '" + is.show(at) + "' nor a raw integer");
    const auto number = scan_bits(text, false, is.bits, {});
    if (number) is.set(at, *number);
    return number.error();
}

} // namespace jauscat::text::detail
