// The translator of an image table: translates a message's body to the bytes of a process image, and the reverse by the
// same rows. All values are integers; no byte of the image changes unless the whole message is valid.
#pragma once
#include <jauscat/translate/image_table.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>

namespace jauscat::translate {

namespace detail {

// The lowest integer of a signed scaled field is not legal. A raw decode accepts it; an actuator must not get it.
template <class Item> inline constexpr bool is_signed_scaled = false;
template <class Item>
requires requires { typename Item::codec_type::raw_codec; }
inline constexpr bool is_signed_scaled<Item> = std::is_signed_v<typename Item::codec_type::raw_type>;

template <class T>
[[gnu::always_inline]] constexpr bool all_values_are_legal(const image_message<T>& message) noexcept {
    bool legal = true;
    wire::visit(message, [&]<class Item>(Item, const auto& member) {
        if constexpr (is_signed_scaled<Item>) {
            constexpr auto lowest = std::numeric_limits<typename Item::codec_type::raw_type>::min();
            if constexpr (Item::optional)
                legal &= member.last() != lowest;
            else
                legal &= member != lowest;
        }
    });
    return legal;
}

} // namespace detail

/// The error of a translation whose message or image does not decode or encode.
[[nodiscard]] constexpr errc errc_of(wire::errc error) noexcept {
    switch (error) {
    case wire::errc::ok: return errc::ok;
    case wire::errc::truncated: return errc::truncated;
    case wire::errc::trailing_bytes: return errc::wrong_size;
    case wire::errc::unknown_presence_bit: return errc::reserved_value;
    case wire::errc::no_space: return errc::no_space;
    default: return errc::out_of_range;
    }
}

/// Translates by the rows of `Table`, an image_table.
template <class Table> struct image_translator {
    using message_type = typename Table::message_type;
    using image_type = typename Table::image_type;
    static constexpr std::size_t image_size = wire::max_size<image_type>;

    /// Puts the message with this body into `image`, the first `image_size` bytes of which hold what was there before:
    /// elements that the message does not have keep it. Errors: truncated, wrong_size (more bytes than the message
    /// has), no_space, out_of_range, reserved_value (also a presence bit without an element); the image is then
    /// unchanged.
    [[nodiscard, gnu::always_inline]] static constexpr result<void, errc>
    to_image(std::span<const std::byte> body, std::span<std::byte> image) noexcept {
        return fill_image(body, image);
    }

    /// The same if the slave may not have read the previous message: its presence bits remain set beside the new ones,
    /// so that the image contains both commands.
    [[nodiscard, gnu::always_inline]] static constexpr result<void, errc> merge(std::span<const std::byte> body,
                                                                                std::span<std::byte> image) noexcept {
        static_assert(!std::is_void_v<typename Table::presence_row>, "merge: the table has no row presence_bits");
        return merge_image(body, image);
    }

    /// Writes the body of the message in `image` to the front of `body`, and returns it. Errors: truncated, no_space,
    /// out_of_range, reserved_value, wrong_packet (a constant has another value).
    [[nodiscard, gnu::always_inline]] static constexpr result<std::span<std::byte>, errc>
    from_image(std::span<const std::byte> image, std::span<std::byte> body) noexcept {
        return fill_body(image, body).of(body);
    }

    /// The same, as a message instead of its bytes.
    [[nodiscard]] static constexpr result<void, errc> read(std::span<const std::byte> image,
                                                           image_message<message_type>& message) noexcept {
        image_type values{};
        if (!wire::decode_prefix(values, image)) return errc::truncated;
        return Table::from_image(values, message);
    }

  private:
    // Whole translations, out of line or not as those of translator.
    JAUSCAT_FLATTEN JAUSCAT_INLINE static constexpr errc fill_image(std::span<const std::byte> body,
                                                                    std::span<std::byte> image) noexcept {
        return fill<false>(body, image);
    }
    JAUSCAT_FLATTEN JAUSCAT_INLINE static constexpr errc merge_image(std::span<const std::byte> body,
                                                                     std::span<std::byte> image) noexcept {
        return fill<true>(body, image);
    }
    JAUSCAT_FLATTEN JAUSCAT_INLINE static constexpr wire::packed_size<errc>
    fill_body(std::span<const std::byte> image, std::span<std::byte> body) noexcept {
        if constexpr (fits_on_stack)
            if (body.size() < largest) return fill_short_body(image, body);
        image_message<message_type> message{};
        if (const auto values = read(image, message); !values) return values.error();
        const auto encoded = wire::encode(message, body);
        if (!encoded) return errc_of(encoded.error());
        return encoded->size();
    }
    // Apart, so that a message in a body that any has room in is never stored, but goes from image to body in
    // registers.
    static constexpr std::size_t largest = wire::max_size<image_message<message_type>>;
    static constexpr bool fits_on_stack = !wire::fixed_message<image_message<message_type>> && largest <= 1024;
    [[gnu::noinline]] static constexpr wire::packed_size<errc> fill_short_body(std::span<const std::byte> image,
                                                                               std::span<std::byte> body) noexcept {
        std::array<std::byte, largest> whole{};
        const auto filled = fill_body(image, whole).of(std::span{whole});
        if (!filled) return filled.error();
        if (filled->size() > body.size()) return errc::no_space;
        std::ranges::copy(*filled, body.begin());
        return filled->size();
    }
    template <bool Merge>
    [[gnu::always_inline]] static constexpr errc fill(std::span<const std::byte> body,
                                                      std::span<std::byte> image) noexcept {
        image_type values{};
        if (!wire::decode_prefix(values, image)) return errc::no_space;
        image_message<message_type> message{};
        Table::keep(values, message);
        if (const auto used = wire::decode(message, body); !used) return errc_of(used.error());
        message.presence = detail::presence_in<wire::layout_of<message_type>>::of(message, body);
        if (!detail::all_values_are_legal(message)) return errc::out_of_range;
        [[maybe_unused]] const image_type before = values;
        if (const errc error = Table::to_image(message, values); error != errc::ok) return error;
        if constexpr (Merge) {
            using presence = typename Table::presence_row::says_presence;
            presence::of(values) |= presence::of(before);
        }
        return errc_of(wire::encode(values, image).error());
    }
};

} // namespace jauscat::translate
