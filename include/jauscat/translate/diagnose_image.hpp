// Explains a refused translation to or from a process image: row, field and value, or the field that does not decode.
#pragma once
#include <jauscat/translate/diagnose.hpp>
#include <jauscat/translate/image_translator.hpp>
#include <jauscat/wire/diagnose.hpp>

namespace jauscat::translate {

namespace detail {

constexpr void blame(diagnosis& found, const wire::diagnosis& why) noexcept {
    found.codec = why.error;
    found.parent = why.parent().name;
    found.field = why.field;
}

// The first signed scaled field with its lowest integer.
template <class T> constexpr void blame_illegal(diagnosis& found, const image_message<T>& message) noexcept {
    wire::visit(message, [&]<class Item>(Item, const auto& member) {
        if constexpr (is_signed_scaled<Item>) {
            const auto value = [&] {
                if constexpr (Item::optional)
                    return member.last();
                else
                    return member;
            }();
            if (!found.field.empty() || value != std::numeric_limits<decltype(value)>::min()) return;
            found.field = wire::item_label<Item>();
            found.value = static_cast<std::uint64_t>(value);
            found.codec = wire::errc::out_of_range;
        }
    });
}

} // namespace detail

/// Explains `error` that `image_translator<Table>::to_image` or `merge` returned for `body` and `image`: the field of
/// the message that does not decode (`codec`), or the first row that refuses it. `field` is empty if bytes are missing
/// in the image or too many in the body.
template <class Table>
[[nodiscard]] constexpr diagnosis diagnose_to_image(errc error, std::span<const std::byte> body,
                                                    std::span<const std::byte> image) noexcept {
    diagnosis found{.error = error};
    typename Table::image_type values{};
    if (error == errc::ok || !wire::decode_prefix(values, image)) return found;
    using message_type = image_message<typename Table::message_type>;
    message_type message{};
    Table::keep(values, message);
    if (!wire::decode(message, body)) {
        detail::blame(found, wire::diagnose<message_type>(body));
        return found;
    }
    detail::blame_illegal(found, message);
    if (found.field.empty()) detail::find_row<true>(typename Table::rows{}, found, message, values, sizes{});
    return found;
}

/// Explains `error` that `image_translator<Table>::from_image` returned for `image`: the first row that refuses it, or
/// the field of the message that does not encode (`codec`). `field` is empty for errors of sizes.
template <class Table>
[[nodiscard]] constexpr diagnosis diagnose_from_image(errc error, std::span<const std::byte> image) noexcept {
    diagnosis found{.error = error};
    typename Table::image_type values{};
    if (error == errc::ok || !wire::decode_prefix(values, image)) return found;
    image_message<typename Table::message_type> message{};
    detail::find_row<false>(typename Table::rows{}, found, values, message, sizes{});
    if (found.row == diagnosis::no_row) detail::blame(found, wire::diagnose(message));
    return found;
}

} // namespace jauscat::translate
