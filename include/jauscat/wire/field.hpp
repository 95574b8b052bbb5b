// One member carried by one codec.
#pragma once
#include <jauscat/wire/item.hpp>
#include <jauscat/wire/scalar.hpp>

#include <optional>

namespace jauscat::wire {

/// The member `Member`, carried by the codec `Codec`. A std::optional member belongs into a `presence`.
template <auto Member, class Codec> struct field {
    static_assert(codec<Codec>,
                  "field: the second argument is not a codec (it needs value_type, size, store and load)");

    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using codec_type = Codec;
    using value_type = member_value_t<Member>;
    static constexpr bool optional = is_optional_member<Member>;
    static constexpr std::size_t min_size = Codec::size, max_size = Codec::size;
    static_assert(std::is_same_v<value_type, typename Codec::value_type> ||
                      (std::floating_point<value_type> && std::floating_point<typename Codec::value_type>),
                  "field: the member's type is not the type its codec carries");

    /// The member's name, for text.
    static consteval std::string_view name() { return name_of<Member>(); }

    /// The type that stands for this field in a `raw`.
    using raw_value = std::conditional_t<std::is_same_v<codec_in_mode<Codec, true>, Codec>, value_type,
                                         typename codec_in_mode<Codec, true>::value_type>;
    using raw_type = std::conditional_t<optional, std::optional<raw_value>, raw_value>;

    [[gnu::always_inline]] static constexpr errc put(const auto& object, std::byte* out) noexcept {
        using used = codec_in_mode<Codec, raw_object<decltype(object)>>;
        if constexpr (raw_object<decltype(object)>)
            return used::store(out, static_cast<typename used::value_type>(held(member_of<Member>(object))));
        else if constexpr (optional) // no call for the member: see put_item
            return used::store(out, static_cast<typename used::value_type>(*(object.*Member)));
        else
            return used::store(out, static_cast<typename used::value_type>(object.*Member));
    }
    [[gnu::always_inline]] static constexpr errc get(auto& object, const std::byte* in) noexcept {
        using used = codec_in_mode<Codec, raw_object<decltype(object)>>;
        typename used::value_type value{};
        if (const errc error = used::load(in, value); error != errc::ok) return error;
        if constexpr (raw_object<decltype(object)>)
            member_of<Member>(object) = static_cast<raw_value>(value);
        else
            object.*Member = static_cast<value_type>(value);
        return errc::ok;
    }

    template <auto, reading Mode>
    [[gnu::always_inline]] static constexpr auto read(const std::byte* in, const auto&) noexcept {
        using used = codec_in_mode<Codec, Mode == reading::raw>;
        using value = typename used::value_type;
        value loaded{};
        [[maybe_unused]] const errc error = used::load(in, loaded);
        // A real reading of a scaled value can meet the one raw value that stands for nothing.
        if constexpr (Mode == reading::real && requires { typename Codec::raw_codec; })
            return error == errc::ok ? std::optional<value>{loaded} : std::optional<value>{};
        else
            return loaded;
    }

    [[gnu::always_inline]] static constexpr void visit(auto& object, auto&& visitor) {
        visitor(field{}, member_of<Member>(object));
    }
};

/// A member that does not travel: the caller sets it before decoding, where the type of what follows was agreed before.
template <auto Member> struct unsent {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using value_type = member_t<Member>;
    using raw_type = value_type;
    static constexpr bool optional = false;
    static constexpr std::size_t min_size = 0, max_size = 0;

    static consteval std::string_view name() { return name_of<Member>(); }
    [[gnu::always_inline]] static constexpr errc put(const auto&, std::byte*) noexcept { return errc::ok; }
    [[gnu::always_inline]] static constexpr errc get(auto&, const std::byte*) noexcept { return errc::ok; }
    [[gnu::always_inline]] static constexpr void visit(auto& object, auto&& visitor) {
        visitor(unsent{}, member_of<Member>(object));
    }
};

} // namespace jauscat::wire
