// One member carried by one codec.
#pragma once
#include <jauscat/wire/item.hpp>
#include <jauscat/wire/scalar.hpp>

#include <optional>

namespace jauscat::wire {

/// The member `Member`, carried by the codec `Codec`. A std::optional member belongs into a `presence`.
template <auto Member, class Codec> struct field {
    static_assert(detail::checked_codec<Codec>,
                  "field: the second argument is not a codec (it needs value_type, size, store and load)");

    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using codec_type = Codec;
    using value_type = member_value_t<Member>;
    static constexpr bool optional = is_optional_member<Member>;
    static constexpr bool checks_values = requires { typename Codec::value_set; };
    static constexpr std::size_t min_size = Codec::size, max_size = Codec::size;
    static_assert(detail::is_carried<Member, value_type, typename Codec::value_type>,
                  "field: the member's type is not the type its codec carries");

    /// The member's name, for text.
    static consteval std::string_view name() { return name_of<Member>(); }

    /// The type of this field in a `raw`.
    using raw_value = std::conditional_t<std::is_same_v<codec_in_mode<Codec, true>, Codec>, value_type,
                                         typename codec_in_mode<Codec, true>::value_type>;
    using raw_type = std::conditional_t<optional, std::optional<raw_value>, raw_value>;

    JAUSCAT_INLINE static constexpr errc put(const auto& object, std::byte* out) noexcept {
        using used = codec_in_mode<Codec, raw_object<decltype(object)>>;
        using carried = typename used::value_type;
        if constexpr (raw_object<decltype(object)>)
            return used::store(out, static_cast<carried>(value_of<Member>(object)));
        else if constexpr (optional) // not value_of(): a function for each field took a tenth of the compile time
            return used::store(out, static_cast<carried>(*(object.*Member)));
        else
            return used::store(out, static_cast<carried>(object.*Member));
    }
    JAUSCAT_INLINE static constexpr errc get(auto& object, const std::byte* in) noexcept {
        using used = codec_in_mode<Codec, raw_object<decltype(object)>>;
        typename used::value_type value{};
        if (const errc error = used::load(in, value); error != errc::ok) return error;
        if constexpr (raw_object<decltype(object)>)
            member_of<Member>(object) = static_cast<raw_value>(value);
        else
            object.*Member = static_cast<value_type>(value);
        return errc::ok;
    }

    template <auto, reading Mode> JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto&) noexcept {
        using used = codec_in_mode<Codec, Mode == reading::raw>;
        using value = typename used::value_type;
        value loaded{};
        [[maybe_unused]] const errc error = used::load(in, loaded);
        // Decoding a scaled value as a real one can meet the one raw value without a meaning.
        if constexpr (Mode == reading::real && requires { typename Codec::raw_codec; })
            return error == errc::ok ? std::optional<value>{loaded} : std::optional<value>{};
        else
            return loaded;
    }

    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(field{}, member_of<Member>(object));
    }
};

/// A member that is not on the wire: the caller sets it before decoding, where the type of the following bytes was
/// agreed before.
template <auto Member> struct not_on_wire {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using value_type = member_t<Member>;
    using raw_type = value_type;
    static constexpr bool optional = false;
    static constexpr std::size_t min_size = 0, max_size = 0;

    static consteval std::string_view name() { return name_of<Member>(); }
    JAUSCAT_INLINE static constexpr errc put(const auto&, std::byte*) noexcept { return errc::ok; }
    JAUSCAT_INLINE static constexpr errc get(auto&, const std::byte*) noexcept { return errc::ok; }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(not_on_wire{}, member_of<Member>(object));
    }
};

} // namespace jauscat::wire
