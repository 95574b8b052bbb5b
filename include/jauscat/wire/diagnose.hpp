// The long answer to a failed encode or decode: which field, at which byte, and what was wrong. Walks the layout again,
// so that the hot path carries nothing but an error code.
#pragma once
#include <jauscat/wire/bits.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>
#include <jauscat/wire/nested.hpp>
#include <jauscat/wire/presence.hpp>

namespace jauscat::wire {

/// Where and why an operation failed.
struct diagnosis {
    errc error{};
    std::string_view field{};  ///< the member's name, "presence_vector", or empty when no single field is at fault
    std::string_view parent{}; ///< the nested message that holds it, or empty
    std::size_t offset{}; ///< byte of the message at which the field starts (trailing_bytes: the first byte too many)
    std::size_t needed{}; ///< bytes the field needs there (no_space: bytes the message needs)
    std::size_t available{}; ///< bytes that are left there (no_space: bytes of the buffer)

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return error == errc::ok; }
};

namespace detail {

/// Walks items in wire order until one of them fails with the error that is looked for.
template <class Object> class fault_finder {
  public:
    constexpr fault_finder(errc wanted, std::span<const std::byte> bytes) noexcept : bytes_{bytes} {
        found_.error = wanted;
    }

    /// Decodes `Layout` into `object`; false when the fault was found.
    template <class Layout> constexpr bool decode(auto& object) noexcept {
        return Layout::all_items([&]<class Item>() { return decode_item<Item>(object); });
    }
    /// Tries to encode each item of `Layout`; false when the fault was found.
    template <class Layout> constexpr bool encode(const auto& object) noexcept {
        return Layout::all_items([&]<class Item>() { return encode_item<Item>(object); });
    }
    [[nodiscard]] constexpr const diagnosis& found() const noexcept { return found_; }

  private:
    template <class Item> constexpr bool decode_item(auto& object) noexcept {
        if constexpr (requires { Item::known_bits; }) {
            return decode_presence<Item>(object);
        } else if constexpr (requires { typename Item::inner; }) {
            const auto outer = std::exchange(found_.parent, Item::name());
            if (!decode<typename Item::inner>(inner_of<Item>(object))) return false;
            found_.parent = outer;
            return true;
        } else {
            if (!enough(label<Item>(), Item::max_size)) return false;
            const errc error = Item::get(object, bytes_.data() + found_.offset);
            return step(label<Item>(), error, Item::max_size);
        }
    }

    template <class Item> constexpr bool decode_presence(auto& object) noexcept {
        using carrier = typename Item::carrier_codec;
        if (!enough("presence_vector", carrier::size)) return false;
        const auto mask = Item::loaded(bytes_.data() + found_.offset);
        if (!step("presence_vector", (mask & ~Item::known_bits) != 0 ? errc::unknown_presence_bit : errc::ok,
                  carrier::size))
            return false;
        std::size_t at = 0;
        return Item::all_items([&]<class Sub>() {
            if constexpr (Sub::optional) {
                if ((mask >> at++ & 1u) == 0) return true;
            }
            return decode_item<Sub>(object);
        });
    }

    template <class Item> constexpr bool encode_item(const auto& object) noexcept {
        if constexpr (requires { Item::known_bits; }) {
            found_.offset += Item::carrier_codec::size;
            return Item::all_items([&]<class Sub>() {
                if constexpr (Sub::optional) {
                    if (!member_of<Sub::key>(object)) return true;
                }
                return encode_item<Sub>(object);
            });
        } else if constexpr (requires { typename Item::inner; }) {
            const auto outer = std::exchange(found_.parent, Item::name());
            const auto& member = member_of<Item::key>(object);
            if constexpr (Item::optional) {
                if (!encode<typename Item::inner>(*member)) return false;
            } else {
                if (!encode<typename Item::inner>(member)) return false;
            }
            found_.parent = outer;
            return true;
        } else {
            std::array<std::byte, Item::max_size> scratch{};
            const errc error = Item::put(object, scratch.data());
            return step(label_of_value<Item>(object), error, Item::max_size);
        }
    }

    constexpr bool enough(std::string_view name, std::size_t size) noexcept {
        if (bytes_.size() - found_.offset >= size) return true;
        return step(name, errc::truncated, size);
    }
    // Past an item, or at the fault.
    constexpr bool step(std::string_view name, errc error, std::size_t size) noexcept {
        if (error == found_.error && error != errc::ok) {
            found_.field = name;
            found_.needed = size;
            found_.available = bytes_.size() - std::min(found_.offset, bytes_.size());
            return false;
        }
        found_.offset += size;
        return error != errc::truncated;
    }

    template <class Item> static constexpr auto& inner_of(auto& object) noexcept {
        auto& member = member_of<Item::key>(object);
        if constexpr (Item::optional)
            return member.emplace();
        else
            return member;
    }
    // A group of bit-fields is named by its first member; when a value does not fit, by the member that is too wide.
    template <class Item> static constexpr std::string_view label() noexcept {
        if constexpr (requires { Item::name(); })
            return Item::name();
        else
            return first_name(typename Item::keys{});
    }
    template <class Item> static constexpr std::string_view label_of_value(const auto& object) noexcept {
        if constexpr (requires { Item::name(); })
            return Item::name();
        else
            return too_wide(static_cast<typename Item::fields*>(nullptr), object);
    }
    template <auto... Members> static constexpr std::string_view first_name(key_list<Members...>) noexcept {
        const std::array<std::string_view, sizeof...(Members) + 1> names{member_name<Members>..., "reserved"};
        return names[0];
    }
    template <class... Fields>
    static constexpr std::string_view too_wide(std::tuple<Fields...>*, const auto& object) noexcept {
        std::string_view name;
        static_cast<void>((... || (!Fields::fits(object) && (name = label<Fields>(), true))));
        return name;
    }

    std::span<const std::byte> bytes_;
    diagnosis found_{};
};

} // namespace detail

/// Why `decode` refuses `in`; `error` is ok when it does not.
template <message T> [[nodiscard]] constexpr diagnosis diagnose(std::span<const std::byte> in) noexcept {
    T scratch{};
    const result used = decode_prefix(scratch, in);
    if (used) {
        if (used.size() == in.size()) return {};
        return {.error = errc::trailing_bytes, .offset = used.size(), .available = in.size() - used.size()};
    }
    detail::fault_finder<T> finder{used.error(), in};
    finder.template decode<layout_of<T>>(scratch);
    return finder.found();
}

/// Why `encode` refuses to write `value` into `space` bytes; `error` is ok when it does not.
template <message T>
[[nodiscard]] constexpr diagnosis diagnose(const T& value, std::size_t space = max_size<T>) noexcept {
    const std::size_t needed = encoded_size(value);
    if (space < needed) return {.error = errc::no_space, .needed = needed, .available = space};
    detail::fault_finder<T> finder{errc::out_of_range, {}};
    if (finder.template encode<layout_of<T>>(value)) return {};
    return finder.found();
}

} // namespace jauscat::wire
