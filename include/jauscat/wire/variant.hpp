// One of several structures, with its number before it (the variant of SAE AS5684).
#pragma once
#include <jauscat/wire/selected.hpp>

#include <algorithm>
#include <variant>

namespace jauscat::wire {

namespace detail {

template <class Alternative> struct raw_alternative {
    using type = raw<Alternative>;
};
template <> struct raw_alternative<std::monostate> {
    using type = std::monostate;
};
template <class Alternative>
concept variant_alternative = message<Alternative> || std::is_same_v<Alternative, std::monostate>;
template <class Alternative> consteval bool alternative_needs_memory() {
    if constexpr (message<Alternative>)
        return layout_of<Alternative>::needs_memory;
    else
        return false;
}
template <class Alternative> consteval bool alternative_takes_rest() {
    if constexpr (message<Alternative>)
        return layout_of<Alternative>::to_the_end;
    else
        return false;
}
template <class Alternative, class... All>
inline constexpr std::size_t times_among = (std::size_t{std::is_same_v<Alternative, All>} + ... + 0);

template <class Variant> struct alternatives_of {
    static constexpr bool of_variant = false;
    static constexpr std::size_t count = 0, min_size = 0, max_size = 0;
    static constexpr bool are_structures = true, are_distinct = true, needs_memory = false, takes_rest = false,
                          checks_values = false;
    using raw_type = Variant;
};
/// Alternatives by their numbers. Where they are many, all members of one type share the functions, out of line.
template <class... Alternatives> struct alternatives_of<std::variant<Alternatives...>> {
    static constexpr bool of_variant = true;
    static constexpr std::size_t count = sizeof...(Alternatives);
    static constexpr bool are_structures = (variant_alternative<Alternatives> && ...);
    static constexpr bool are_distinct = ((times_among<Alternatives, Alternatives...> == 1) && ...);
    static constexpr std::size_t min_size = std::min({case_form<Alternatives>::min_size...});
    static constexpr std::size_t max_size = std::max({case_form<Alternatives>::max_size...});
    static constexpr bool needs_memory = (alternative_needs_memory<Alternatives>() || ...);
    static constexpr bool takes_rest = (alternative_takes_rest<Alternatives>() || ...);
    static constexpr bool checks_values = (form_checks_values<Alternatives>() || ...);
    using raw_type = std::variant<typename raw_alternative<Alternatives>::type...>;

    /// Calls f.template operator()<I, Alternative>() for alternative `index`; false where there is none.
    template <std::size_t I = 0> JAUSCAT_INLINE static constexpr bool with(std::size_t index, auto&& f) {
        if constexpr (I == count) {
            return false;
        } else {
            if (index != I) return with<I + 1>(index, f);
            f.template operator()<I, std::variant_alternative_t<I, std::variant<Alternatives...>>>();
            return true;
        }
    }
    [[gnu::noinline]] static constexpr std::size_t size(const auto& value) noexcept {
        std::size_t total = 0;
        with(value.index(), [&]<std::size_t I, class Form>() {
            total = case_form<Form>::size(*std::get_if<I>(&value), plain_root{});
        });
        return total;
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& value, out_cursor c, const auto& root) noexcept {
        if constexpr (count > most_inlined)
            return put_called(value, c, root);
        else
            return put_here(value, c, root);
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& value, std::size_t index, in_cursor c,
                                                  const auto& root) noexcept {
        if constexpr (count > most_inlined)
            return get_called(value, index, c, root);
        else
            return get_here(value, index, c, root);
    }
    [[gnu::noinline]] static constexpr in_cursor measure(std::size_t index, in_cursor c,
                                                         const std::byte* stop) noexcept {
        in_cursor end = in_cursor::failed(errc::unknown_tag);
        with(index, [&]<std::size_t, class Form>() {
            end = c;
            if (spend(end, case_form<Form>::min_size - min_size))
                end = case_form<Form>::measure(end, alone(c.at, stop));
        });
        return end;
    }
    [[gnu::noinline]] static constexpr std::size_t extent(std::size_t index, const std::byte* in,
                                                          const std::byte* stop) noexcept {
        std::size_t total = 0;
        with(index, [&]<std::size_t, class Form>() { total = case_form<Form>::extent(in, alone(in, stop)); });
        return total;
    }

  private:
    template <class Root>
    JAUSCAT_INLINE static constexpr out_cursor put_here(const auto& value, out_cursor c, const Root&) noexcept {
        out_cursor end{c.at, errc::unknown_tag};
        with(value.index(), [&]<std::size_t I, class Form>() {
            const auto& form = *std::get_if<I>(&value);
            if constexpr (std::is_same_v<Root, checking_root> && form_checks_values<Form>()) {
                if (check_values_in(form) != errc::ok) {
                    end.error = errc::outside_value_set;
                    return;
                }
            }
            end = case_form<Form>::template put<false>(form, c, plain_root{});
        });
        return end;
    }
    [[gnu::noinline]] static constexpr out_cursor put_called(const auto& value, out_cursor c,
                                                             const auto& root) noexcept {
        return put_here(value, c, root);
    }
    JAUSCAT_INLINE static constexpr in_cursor get_here(auto& value, std::size_t index, in_cursor c,
                                                       const auto& root) noexcept {
        in_cursor end = in_cursor::failed(errc::unknown_tag);
        with(index, [&]<std::size_t I, class Form>() {
            end = c;
            if (spend(end, case_form<Form>::min_size - min_size))
                end = case_form<Form>::template get<false>(value.template emplace<I>(), end, root);
        });
        return end;
    }
    [[gnu::noinline]] static constexpr in_cursor get_called(auto& value, std::size_t index, in_cursor c,
                                                            const auto& root) noexcept {
        return get_here(value, index, c, root);
    }
    static constexpr auto alone(const std::byte* bytes, const std::byte* stop) noexcept {
        return byte_scope<plain_root, plain_root>{bytes, stop, {}};
    }
};

template <auto Member, class Is> inline constexpr bool is_variant_member = alternatives_of<Is>::of_variant;
template <auto Member, class Is> inline constexpr bool has_structures = alternatives_of<Is>::are_structures;
template <auto Member, class Is> inline constexpr bool has_distinct_alternatives = alternatives_of<Is>::are_distinct;

} // namespace detail

/// The alternative of a variant in received bytes.
template <class Variant> class variant_view {
  public:
    /// Made by a view.
    constexpr variant_view(std::size_t index, std::span<const std::byte> bytes) noexcept
        : index_{index}, bytes_{bytes} {}

    /// The number of the alternative, from 0.
    [[nodiscard]] constexpr std::size_t index() const noexcept { return index_; }
    /// The bytes of the alternative, without its number.
    [[nodiscard]] constexpr std::span<const std::byte> bytes() const noexcept { return bytes_; }
    /// A view of the alternative `Alternative`, or empty where another one was sent.
    template <class Alternative> [[nodiscard]] constexpr auto get() const noexcept {
        static_assert(
            requires(Variant& value) { std::get_if<Alternative>(&value); },
            "variant: the variant has no such alternative");
        std::optional<view<Alternative, plain_root>> found;
        detail::alternatives_of<Variant>::with(index_, [&]<std::size_t, class Held>() {
            if constexpr (std::is_same_v<Held, Alternative>)
                found = view<Alternative, plain_root>::of_measured(bytes_, plain_root{});
        });
        return found;
    }

  private:
    std::size_t index_;
    std::span<const std::byte> bytes_;
};

/// The member, a std::variant of structures with a schema, after the number of its alternative in `Tag`. A number
/// without an alternative says `unknown_tag`. std::monostate is an alternative without bytes. A structure in a variant
/// reads no members of enclosing structures.
template <auto Member, class Tag> struct variant {
    static_assert(detail::checked_codec<Tag>,
                  "variant: the second argument is not a codec (it needs value_type, size, store and load)");
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using value_type = member_value_t<Member>;
    static_assert(detail::is_variant_member<Member, value_type>, "variant: the member must be a std::variant");
    static_assert(detail::has_structures<Member, value_type>,
                  "variant: an alternative is neither a structure with a schema nor std::monostate");
    static_assert(detail::has_distinct_alternatives<Member, value_type>, "variant: two alternatives are of one type");
    using alternatives = detail::alternatives_of<value_type>;
    using tag_codec = Tag;
    using tag_type = typename Tag::value_type;
    static_assert(std::unsigned_integral<tag_type>, "variant: the tag must be an unsigned integer");
    static_assert(alternatives::count - 1 <= std::numeric_limits<tag_type>::max(),
                  "variant: more alternatives than the tag can number");
    static constexpr bool optional = is_optional_member<Member>;
    static constexpr bool contextual = true; // never at constant offsets
    static constexpr bool needs_memory = alternatives::needs_memory;
    static constexpr bool to_the_end = alternatives::takes_rest;
    static constexpr bool checks_values = alternatives::checks_values;
    static constexpr std::size_t min_size = Tag::size + alternatives::min_size;
    static constexpr std::size_t max_size = add_sizes(Tag::size, alternatives::max_size);
    using raw_type =
        std::conditional_t<optional, std::optional<typename alternatives::raw_type>, typename alternatives::raw_type>;

    static consteval std::string_view name() { return name_of<Member>(); }

    JAUSCAT_INLINE static constexpr std::size_t size(const auto& object, const auto&) noexcept {
        return Tag::size + alternatives::size(value_of<Member>(object));
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto& here) noexcept {
        const auto& value = value_of<Member>(object);
        Tag::store(c.at, static_cast<tag_type>(value.index()));
        return alternatives::put(value, {c.at + Tag::size, errc::ok}, root_of(here));
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto& here) noexcept {
        return alternatives::get(emplace_in<Member>(object), index_at(c.at), {c.at + Tag::size, c.slack},
                                 root_of(here));
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto& here) noexcept {
        return alternatives::measure(index_at(c.at), {c.at + Tag::size, c.slack}, here.end);
    }
    JAUSCAT_INLINE static constexpr std::size_t extent(const std::byte* in, const auto& here) noexcept {
        return Tag::size + alternatives::extent(index_at(in), in + Tag::size, here.end);
    }
    template <auto, reading> JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        const std::size_t size = extent(in, here);
        return variant_view<value_type>{index_at(in), std::span{in + Tag::size, size - Tag::size}};
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(variant{}, member_of<Member>(object));
    }

    /// The number of the alternative in the bytes.
    JAUSCAT_INLINE static constexpr std::size_t index_at(const std::byte* in) noexcept {
        tag_type tag{};
        Tag::load(in, tag);
        return static_cast<std::size_t>(tag);
    }
};

} // namespace jauscat::wire
