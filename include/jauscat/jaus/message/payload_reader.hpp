// The typed values of Set and Report Payload Data Element. Their types do not travel with them: they are those that the
// payload gave for its interfaces in an earlier Report Payload Interface. Without them the elements stay the bytes that
// the message holds.
#pragma once
#include <jauscat/schema/jaus/payload.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

namespace jauscat::jaus {

/// One element: the number of its interface, from 1, and its value.
struct payload_element {
    std::uint8_t interface_number{}; ///< from 1, as reported
    payload_value value{};           ///< of the type that was reported for the interface
    friend constexpr bool operator==(const payload_element&, const payload_element&) = default;
};

/// Reads `count` elements out of `bytes` (the members of the message) one by one. `types` holds the type codes of
/// interface 1, 2, ... in order. Text points into `bytes`.
///
///     jaus::payload_reader elements{message.number_of_payload_command_elements, message.element, types};
///     jaus::payload_element one{};
///     while (elements.next(one)) use(one);
///     if (elements.error() != wire::errc::ok) ...
class payload_reader {
  public:
    /// Refers to `bytes` and `types`, which must outlive it.
    constexpr payload_reader(std::size_t count, std::span<const std::byte> bytes,
                             std::span<const payload_type> types) noexcept
        : left_{count}, bytes_{bytes}, types_{types} {}

    /// False at the end and after an error.
    [[nodiscard]] constexpr bool next(payload_element& element) noexcept {
        if (error_ != wire::errc::ok) return false;
        if (left_ == 0) {
            if (at_ != bytes_.size()) error_ = wire::errc::trailing_bytes;
            return false;
        }
        error_ = read(element);
        if (error_ == wire::errc::ok) --left_;
        return error_ == wire::errc::ok;
    }
    /// ok, or why the last call of next() failed: truncated, unknown_tag (an interface without a type, or a type that
    /// the standard does not have), trailing_bytes.
    [[nodiscard]] constexpr wire::errc error() const noexcept { return error_; }
    /// Bytes that were read.
    [[nodiscard]] constexpr std::size_t offset() const noexcept { return at_; }

  private:
    [[nodiscard]] constexpr wire::errc read(payload_element& element) noexcept {
        if (at_ == bytes_.size()) return wire::errc::truncated;
        const auto number = std::to_integer<std::uint8_t>(bytes_[at_]);
        if (number == 0 || number > types_.size()) return wire::errc::unknown_tag;
        element.interface_number = number;
        element.value.type_code = types_[number - 1u];
        const auto used = wire::decode_prefix(element.value, bytes_.subspan(at_ + 1));
        if (used) at_ += 1 + *used;
        return used.error();
    }

    std::size_t left_;
    std::span<const std::byte> bytes_;
    std::span<const payload_type> types_;
    std::size_t at_{};
    wire::errc error_{};
};

/// Writes elements as the message's bytes and returns those. Errors: those of wire::encode.
[[nodiscard]] constexpr result<std::span<std::byte>, wire::errc>
encode_payload_elements(std::span<const payload_element> elements, std::span<std::byte> out) noexcept {
    std::size_t at = 0;
    for (const payload_element& element : elements) {
        if (at == out.size()) return wire::errc::no_space;
        out[at] = std::byte{element.interface_number};
        const auto value = wire::encode(element.value, out.subspan(at + 1));
        if (!value) return value;
        at += 1 + value->size();
    }
    return out.first(at);
}

/// Whether an interface's values are scaled integers, between its minimum and its maximum.
[[nodiscard]] constexpr bool is_scaled(payload_type type) noexcept {
    return type >= payload_type::scaled_byte && type <= payload_type::scaled_unsigned_long_integer;
}

/// The real value of a scaled element, by the formula of wire::scaled. `min` and `max` are the interface's limits.
/// Empty if the type is not scaled, or the raw value is not a valid one.
[[nodiscard]] constexpr std::optional<double> real_value(const payload_value& element, double min,
                                                         double max) noexcept {
    if (!is_scaled(element.type_code)) return std::nullopt;
    std::optional<double> real;
    const auto convert = [&]<class Raw>(const Raw* raw) {
        if (raw == nullptr) return;
        constexpr auto top = std::numeric_limits<Raw>::max();
        constexpr auto bottom = std::is_signed_v<Raw> ? -static_cast<double>(top) : 0.0;
        if (std::is_signed_v<Raw> && *raw == std::numeric_limits<Raw>::min()) return;
        const double scale = (max - min) / (static_cast<double>(top) - bottom);
        real = static_cast<double>(*raw) * scale + (std::is_signed_v<Raw> ? (min + max) / 2 : min);
    };
    convert(std::get_if<std::uint8_t>(&element.value));
    convert(std::get_if<std::int16_t>(&element.value));
    convert(std::get_if<std::uint16_t>(&element.value));
    convert(std::get_if<std::int32_t>(&element.value));
    convert(std::get_if<std::uint32_t>(&element.value));
    convert(std::get_if<std::int64_t>(&element.value));
    convert(std::get_if<std::uint64_t>(&element.value));
    return real;
}

} // namespace jauscat::jaus
