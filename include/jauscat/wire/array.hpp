// A fixed number of elements without a count: records with a schema of their own, or single values.
#pragma once
#include <jauscat/wire/repeated.hpp>

#include <array>
#include <optional>

namespace jauscat::wire {

namespace detail {

template <class T> inline constexpr bool is_std_array = false;
template <class T, std::size_t Size> inline constexpr bool is_std_array<std::array<T, Size>> = true;
template <auto Member, class Is> inline constexpr bool is_array_member = is_std_array<Is>;
template <class Element, class Own> struct array_value {
    using type = typename Element::value_type;
};
template <class Own> struct array_value<record, Own> {
    using type = Own;
};

/// The elements of an array are single values; they are named after the member.
template <auto Member, class Codec> struct array_element {
    using codec_type = Codec;
    static consteval std::string_view name() { return name_of<Member>(); }
};
template <auto Member, class Element> struct array_element_of {
    using type = array_element<Member, Element>;
};
template <auto Member> struct array_element_of<Member, record> {
    using type = record;
};

} // namespace detail

/// The elements of a std::array one after another, each carried by the codec `Element`, or laid out by its schema
/// (`record`). A view gives single values as a std::array (a std::optional of it where they are scaled), records as a
/// list_view.
template <auto Member, class Element = record> struct array {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using member_type = member_value_t<Member>;
    static_assert(detail::is_array_member<Member, member_type>, "array: the member must be a std::array");
    using traits = list_traits<member_type>;
    using value_type = typename traits::value_type;
    using element_type = typename detail::array_element_of<Member, Element>::type;
    static constexpr std::size_t length = traits::capacity;
    static constexpr bool optional = is_optional_member<Member>;
    static constexpr bool of_records = std::is_same_v<Element, record>;
    static_assert(length != 0, "array: the member has no elements");
    static_assert(
        [] {
            if constexpr (of_records)
                return true;
            else
                return detail::checked_codec<Element>;
        }(),
        "array: the second argument is not a codec (it needs value_type, size, store and load)");
    static_assert(detail::has_type<Member, value_type, typename detail::array_value<Element, value_type>::type>,
                  "array: the elements are not of the type that their codec carries");
    using plain_form = typename detail::element_form<element_type, false, value_type>::type;
    using refers = references_of<plain_form>;

    static constexpr bool contextual = [] {
        if constexpr (of_records)
            return is_contextual<layout_of<value_type>>;
        else
            return false;
    }();
    static constexpr bool checks_values = [] {
        if constexpr (of_records)
            return layout_of<value_type>::checks_values;
        else
            return requires { typename element_type::codec_type::value_set; };
    }();
    static constexpr bool needs_memory = [] {
        if constexpr (of_records)
            return layout_of<value_type>::needs_memory;
        else
            return false;
    }();
    static constexpr std::size_t min_size = length * plain_form::min_size;
    static constexpr std::size_t max_size =
        plain_form::max_size == unbounded ? unbounded : length * plain_form::max_size;
    static_assert(
        [] {
            if constexpr (of_records)
                return !takes_rest<layout_of<value_type>>;
            else
                return true;
        }(),
        "array: an element takes the rest of the body, so that none can follow it");

    static consteval std::string_view name() { return name_of<Member>(); }

    using raw_array = typename traits::template of<typename detail::raw_element<element_type, value_type>::type>;
    using raw_type = std::conditional_t<optional, std::optional<raw_array>, raw_array>;

    JAUSCAT_INLINE static constexpr errc put(const auto& object, std::byte* out) noexcept
    requires plain_form::fixed
    {
        return put(object, out_cursor{out, errc::ok}, plain_root{}).error;
    }
    JAUSCAT_INLINE static constexpr errc get(auto& object, const std::byte* in) noexcept
    requires plain_form::fixed
    {
        return get(object, in_cursor{in, 0}, plain_root{}).error();
    }
    JAUSCAT_INLINE static constexpr std::size_t size(const auto& object, const auto& here) noexcept {
        return detail::size_of_elements<form_in<decltype(object)>>(value_of<Member>(object), here);
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto& here) noexcept {
        return detail::put_elements<form_in<decltype(object)>>(value_of<Member>(object), c, here);
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto& here) noexcept {
        auto& elements = emplace_in<Member>(object);
        return detail::get_elements<form_in<decltype(object)>>(elements.data(), length, c, here);
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto& here) noexcept {
        return detail::measure_elements<plain_form>(length, c, here);
    }
    JAUSCAT_INLINE static constexpr std::size_t extent(const std::byte* in, const auto& here) noexcept {
        return detail::extent_of_elements<plain_form>(length, in, here);
    }
    template <auto, reading Mode>
    JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        if constexpr (of_records) {
            return list_view<array, std::remove_cvref_t<decltype(here)>>{in, length, here};
        } else {
            using used = codec_in_mode<Element, Mode == reading::raw>;
            std::array<typename used::value_type, length> values{};
            errc error = errc::ok;
            for (auto& one : values) {
                if (const errc illegal = used::load(in, one); illegal != errc::ok) error = illegal;
                in += used::size;
            }
            if constexpr (Mode == reading::real && requires { typename Element::raw_codec; })
                return error == errc::ok ? std::optional{values} : std::nullopt;
            else
                return values;
        }
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(array{}, member_of<Member>(object));
    }

  private:
    template <class Object>
    using form_in = typename detail::element_form<
        element_type, raw_object<Object>,
        std::remove_cvref_t<decltype(value_of<Member>(std::declval<Object&>())[0])>>::type;
};

} // namespace jauscat::wire
