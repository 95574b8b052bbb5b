// Explains a failed encode or decode: field, element, byte and cause. It repeats the walk with a trace, so that the hot
// path returns only an error code.
#pragma once
#include <jauscat/wire/bit_fields.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

namespace jauscat::wire {

/// A structure or list that a walk is inside of.
struct diagnosis_step {
    /// Not a list.
    static constexpr std::size_t no_element = unbounded;
    std::string_view name{};
    std::size_t element = no_element; ///< place in a list, from 0

    friend constexpr bool operator==(const diagnosis_step&, const diagnosis_step&) = default;
};

/// Position and cause of a failure.
struct diagnosis {
    errc error{};
    std::string_view
        field{}; ///< the member's name, "presence_vector", a count's name, or empty where no field is at fault
    std::array<diagnosis_step, 6> path{}; ///< the structures and lists around it, outermost first
    std::size_t depth{};                  ///< how many of them
    std::size_t offset{}; ///< byte of the message at which the field starts (trailing_bytes: the first byte too many)
    std::size_t needed{}; ///< bytes the field needs there (no_space: bytes the message needs)
    std::size_t available{}; ///< bytes that are left there (no_space: bytes of the buffer)

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return error == errc::ok; }
    /// The structure or list that holds the field; empty for the message itself.
    [[nodiscard]] constexpr diagnosis_step parent() const noexcept {
        return depth == 0 ? diagnosis_step{} : path[depth - 1];
    }
};

/// Keeps the path. Structures nested deeper than it is long (no standard message has them) are left out.
class path_trace {
  public:
    template <class Item> constexpr void enter() noexcept {
        if (found_.depth < found_.path.size())
            found_.path[found_.depth] = {item_label<Item>(), diagnosis_step::no_element};
        ++found_.depth;
    }
    constexpr void element(std::size_t index) noexcept {
        if (found_.depth <= found_.path.size()) found_.path[found_.depth - 1].element = index;
    }
    constexpr void leave() noexcept { --found_.depth; }

    [[nodiscard]] constexpr diagnosis found(errc error) const noexcept {
        diagnosis why = found_;
        why.error = error;
        why.depth = std::min(why.depth, why.path.size());
        return why;
    }

  protected:
    diagnosis found_{};
};

/// Traces decoding, and checks each field against the end of the bytes. If it searches for a given error, it skips
/// others while the following fields can still be located.
class decode_trace : public path_trace {
  public:
    constexpr explicit decode_trace(std::span<const std::byte> bytes, errc wanted = errc::ok) noexcept
        : bytes_{bytes}, wanted_{wanted} {}

    [[nodiscard]] constexpr bool passes(errc error) const noexcept { return wanted_ != errc::ok && error != wanted_; }

    template <class Item> constexpr bool reach(const auto&, const std::byte* at) noexcept {
        // Items with parts are checked part by part.
        constexpr bool whole = fixed_item<Item> && !item_of_parts<Item>;
        return reach_bytes(item_label<Item>(), at, whole ? Item::min_size : 0);
    }
    template <class Codec> constexpr bool reach_number(std::string_view name, const std::byte* at) noexcept {
        return reach_bytes(name, at, Codec::size);
    }
    template <class Item> constexpr bool reach_octets(const std::byte* at, std::size_t size) noexcept {
        return reach_bytes(item_label<Item>(), at, size);
    }
    constexpr bool reach_element(const std::byte* at, std::size_t size) noexcept {
        return reach_bytes(found_.path[std::min(found_.depth, found_.path.size()) - 1].name, at, size);
    }
    [[nodiscard]] constexpr std::size_t remaining(const std::byte* at) const noexcept {
        return bytes_.size() - offset_of(at);
    }
    template <class> constexpr void passed(const auto&, const std::byte*) noexcept {}
    template <class> constexpr void passed_element(const auto&, const std::byte*) noexcept {}
    template <class> constexpr void passed_number(std::string_view, std::uint64_t, const std::byte*) noexcept {}

  protected:
    [[nodiscard]] constexpr std::size_t offset_of(const std::byte* at) const noexcept {
        return static_cast<std::size_t>(at - bytes_.data());
    }

  private:
    constexpr bool reach_bytes(std::string_view name, const std::byte* at, std::size_t size) noexcept {
        found_.field = name;
        found_.offset = offset_of(at);
        found_.needed = size;
        found_.available = remaining(at);
        return found_.available >= size;
    }

    std::span<const std::byte> bytes_;
    errc wanted_;
};

/// Watches encoding, and counts the bytes.
class encode_trace : public path_trace {
  public:
    template <class Item> constexpr bool reach(const auto& object, const std::byte*) noexcept {
        if constexpr (requires { typename Item::fields; })
            found_.field = too_wide(static_cast<typename Item::fields*>(nullptr), object);
        else
            found_.field = item_label<Item>();
        found_.needed = fixed_item<Item> && !item_of_parts<Item> ? Item::max_size : 0;
        return true;
    }
    template <class Codec> constexpr bool reach_number(std::string_view name, const std::byte*) noexcept {
        found_.field = name;
        found_.needed = Codec::size;
        return true;
    }
    constexpr void advance(std::size_t size) noexcept { found_.offset += size; }

  private:
    // The bit-field with a value that does not fit, so that the diagnosis does not name the whole integer.
    template <class... Fields>
    static constexpr std::string_view too_wide(std::tuple<Fields...>*, const auto& object) noexcept {
        std::string_view name;
        static_cast<void>((... || (!Fields::fits(object) && (name = item_label<Fields>(), true))));
        return name;
    }
};

/// Decodes `in` into `value`, watched by `trace`.
template <message T> constexpr in_cursor decode_traced(T& value, std::span<const std::byte> in, auto& trace) noexcept {
    const traced_root root{trace};
    return layout_of<T>::get(value, {in.data(), 0}, object_scope{value, root});
}

namespace detail {
/// The error of `decode` with enough memory.
template <message T> constexpr errc decode_error(std::span<const std::byte> in) noexcept {
    using root = std::conditional_t<needs_memory<T>, discarding_root, plain_root>;
    T scratch{};
    return decode<true>(scratch, in, root{}).error();
}
} // namespace detail

/// Explains the error of `decode` for `in`: the first field in wire order with that error. `error` is ok when the bytes
/// are valid (arena_full depends on the memory).
template <message T> [[nodiscard]] constexpr diagnosis diagnose(std::span<const std::byte> in) noexcept {
    const errc error = detail::decode_error<T>(in);
    if (error == errc::ok) return {};
    if (error == errc::too_long) return {.error = error, .needed = in.size(), .available = packed_size<errc>::max_size};
    T scratch{};
    decode_trace trace{in, error};
    const in_cursor end = decode_traced(scratch, in, trace);
    if (error != errc::trailing_bytes) return trace.found(error);
    const std::size_t left = trace.remaining(end.at);
    return {.error = error, .offset = in.size() - left, .available = left};
}

/// Explains the error of `encode` for `value` and `space` bytes; `error` is ok without one.
template <message T>
[[nodiscard]] constexpr diagnosis diagnose(const T& value, std::size_t space = unbounded) noexcept {
    const std::size_t needed = encoded_size(value);
    if (!never_too_long<T> && needed > packed_size<errc>::max_size)
        return {.error = errc::too_long, .needed = needed, .available = packed_size<errc>::max_size};
    if (space < needed) return {.error = errc::no_space, .needed = needed, .available = space};
    encode_trace trace;
    const traced_root root{trace};
    const out_cursor end = layout_of<T>::put(value, {nullptr, errc::ok}, object_scope{value, root});
    return end.error == errc::ok ? diagnosis{} : trace.found(end.error);
}

} // namespace jauscat::wire
