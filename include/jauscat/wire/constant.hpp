// A number that is always the same: the id of a message, the tag of a variant without alternatives.
#pragma once
#include <jauscat/wire/count.hpp>

namespace jauscat::wire {

/// The number `Value` in `Codec`. It is no member. Bytes that hold another number do not decode (`unknown_tag`).
template <label Name, class Codec, auto Value> struct constant {
    static_assert(detail::checked_codec<Codec>,
                  "constant: the second argument is not a codec (it needs value_type, size, store and load)");
    using keys = key_list<>;
    using value_type = typename Codec::value_type;
    static constexpr bool optional = false;
    static constexpr std::size_t min_size = Codec::size, max_size = Codec::size;
    static constexpr auto fixed_value = static_cast<value_type>(Value);
    static_assert(fixed_value == Value, "constant: the value does not fit its codec");
    static consteval std::string_view name() { return Name.view(); }

    JAUSCAT_INLINE static constexpr errc put(const auto&, std::byte* out) noexcept {
        return Codec::store(out, fixed_value);
    }
    JAUSCAT_INLINE static constexpr errc get(const auto&, const std::byte* in) noexcept {
        value_type value{};
        const errc error = Codec::load(in, value);
        return error == errc::ok && value != fixed_value ? errc::unknown_tag : error;
    }
    JAUSCAT_INLINE static constexpr void visit(const auto&, auto&&) {}
};

} // namespace jauscat::wire
