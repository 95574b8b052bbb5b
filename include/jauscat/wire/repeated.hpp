// Lists: of records with a schema of their own, or of single values.
#pragma once
#include <jauscat/wire/count.hpp>
#include <jauscat/wire/list.hpp>
#include <jauscat/wire/nested.hpp>

namespace jauscat::wire {

/// The elements of a list are single values, carried by `Codec`. `Name` is the standard's name of an element; the
/// member's is that of the field in it.
template <label Name, class Codec> struct element {
    static_assert(detail::checked_codec<Codec>,
                  "element: the second argument is not a codec (it needs value_type, size, store and load)");
    using codec_type = Codec;
    static consteval std::string_view name() { return Name.view(); }
};
/// The elements of a list are records, laid out by their schema.
struct record {};

namespace detail {

/// Elements that are single values.
template <class Codec, bool Raw> struct value_form {
    using used = wire::codec_in_mode<Codec, Raw>;
    static constexpr std::size_t min_size = Codec::size, max_size = Codec::size;
    static constexpr bool fixed = true;
    JAUSCAT_INLINE static constexpr std::size_t size(const auto&, const auto&) noexcept { return Codec::size; }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& value, out_cursor c, const auto&) noexcept {
        c.error = used::store(c.at, value);
        if (c.error == errc::ok) c.at += Codec::size;
        return c;
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& value, in_cursor c, const auto&) noexcept {
        const errc error = used::load(c.at, value);
        return error == errc::ok ? in_cursor{c.at + Codec::size, c.slack} : in_cursor::failed(error);
    }
};
/// Elements that are records.
template <class T> struct record_form {
    using inner = layout_of<T>;
    using refers = references_of<inner>;
    static constexpr std::size_t min_size = inner::min_size, max_size = inner::max_size;
    static constexpr bool fixed = fixed_item<inner>;
    JAUSCAT_INLINE static constexpr std::size_t size(const auto& value, const auto& here) noexcept {
        return inner::size(value, object_scope{value, here});
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& value, out_cursor c, const auto& here) noexcept {
        return inner::put(value, c, object_scope{value, here});
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& value, in_cursor c, const auto& here) noexcept {
        return inner::get(value, c, object_scope{value, here});
    }
    template <class Here> static constexpr auto inside(const std::byte* in, const Here& here) noexcept {
        return byte_scope<T, Here>{in, here.end, here};
    }
};

/// Form of an element in the bytes: that of a record, or of a single value.
template <class Element, bool Raw, class Value> struct element_form {
    using type = value_form<typename Element::codec_type, Raw>;
};
template <bool Raw, class Value> struct element_form<record, Raw, Value> {
    using type = record_form<Value>;
};
/// The elements of a list or an array, one after another, each in the form `Form`.
template <class Form>
JAUSCAT_INLINE constexpr std::size_t size_of_elements(const auto& elements,
                                                      [[maybe_unused]] const auto& here) noexcept {
    std::size_t total = 0;
    if constexpr (Form::min_size == Form::max_size)
        total = elements.size() * Form::max_size;
    else
        for (std::size_t i = 0; i != elements.size(); ++i) total += Form::size(elements[i], here);
    return total;
}
template <class Form>
JAUSCAT_INLINE constexpr out_cursor put_elements(const auto& elements, out_cursor c, const auto& here) noexcept {
    for (std::size_t i = 0; i != elements.size(); ++i) {
        c = Form::put(elements[i], c, here);
        if (c.error != errc::ok) return c;
    }
    return c;
}
template <class Form>
JAUSCAT_INLINE constexpr in_cursor get_elements(auto* first, std::size_t size, in_cursor c, const auto& here) noexcept {
    for (std::size_t i = 0; i != size && c.at != nullptr; ++i) c = Form::get(first[i], c, here);
    return c;
}
template <class Form>
JAUSCAT_INLINE constexpr in_cursor measure_elements(std::size_t size, in_cursor c,
                                                    [[maybe_unused]] const auto& here) noexcept {
    if constexpr (Form::fixed)
        c.at += size * Form::max_size;
    else
        for (std::size_t i = 0; i != size && c.at != nullptr; ++i)
            c = Form::inner::measure(c, Form::inside(c.at, here));
    return c;
}
template <class Form>
JAUSCAT_INLINE constexpr std::size_t extent_of_elements(std::size_t size, [[maybe_unused]] const std::byte* in,
                                                        [[maybe_unused]] const auto& here) noexcept {
    std::size_t total = 0;
    if constexpr (Form::fixed)
        total = size * Form::max_size;
    else
        for (std::size_t i = 0; i != size; ++i)
            total += Form::inner::extent(in + total, Form::inside(in + total, here));
    return total;
}

/// The type of an element in a `raw`.
template <class Element, class Value> struct raw_element {
    using type = typename wire::codec_in_mode<typename Element::codec_type, true>::value_type;
};
template <class Value> struct raw_element<record, Value> {
    using type = raw<Value>;
};

} // namespace detail

template <class Item, class Outer> class list_view;

namespace detail {
template <auto Member, class Is> inline constexpr bool is_list_member = requires { list_traits<Is>::counted; };
template <class Element, class Own> struct list_value {
    using type = typename Element::codec_type::value_type;
};
template <class Own> struct list_value<record, Own> {
    using type = Own;
};
} // namespace detail

/// A list: `Count` is the number of elements (count, counted_by, one_less_than), `Element` their form (record,
/// element). Decoding a `list` stores its elements in the arena (`arena_full`); an `inline_list` holds up to its
/// capacity (`count_above_capacity`).
template <auto Member, class Count, class Element = record> struct repeated {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using member_type = member_value_t<Member>;
    static_assert(detail::is_list_member<Member, member_type>, "repeated: the member must be a list or an inline_list");
    using traits = list_traits<member_type>;
    static_assert(traits::counted, "repeated: a std::array has no count (use array)");
    using value_type = typename traits::value_type;
    using count_type = Count;
    using element_type = Element;
    static constexpr bool optional = is_optional_member<Member>;
    static constexpr bool of_records = std::is_same_v<Element, record>;

    static_assert(
        of_records || requires {
            typename Element::codec_type;
            Element::name();
        }, "repeated: the third argument is neither record nor an element (it needs codec_type and name)");
    static_assert(detail::is_carried<Member, value_type, typename detail::list_value<Element, value_type>::type>,
                  "repeated: the elements are not of the type that their codec carries");
    static_assert(detail::checked_count<Count, owner_t<Member>>,
                  "repeated: the second argument is not a count (it needs prefix_size, contextual, put, get and peek)");
    using plain_form = typename detail::element_form<Element, false, value_type>::type;
    // Elements that may take no bytes are bounded by their count alone.
    static_assert(plain_form::min_size != 0 || Count::prefix_size == 1,
                  "repeated: an element may take no bytes at all, so it needs a count of one byte");

    using refers = joined_keys<references_of<Count>, references_of<plain_form>>;
    static constexpr bool contextual = true; // elements look at what is around them
    static constexpr bool checks_values = requires { typename Count::value_set; } || [] {
        if constexpr (of_records)
            return layout_of<value_type>::checks_values;
        else
            return requires { typename element_type::codec_type::value_set; };
    }();
    static constexpr bool needs_memory = traits::elsewhere || [] {
        if constexpr (of_records)
            return layout_of<value_type>::needs_memory;
        else
            return false;
    }();
    static constexpr std::size_t min_size = Count::prefix_size;
    static constexpr std::size_t max_size = [] {
        if constexpr (traits::elsewhere)
            return unbounded;
        else
            return plain_form::max_size == unbounded ? unbounded
                                                     : Count::prefix_size + traits::capacity * plain_form::max_size;
    }();
    static_assert(
        [] {
            if constexpr (!traits::elsewhere && requires { Count::limit; })
                return traits::capacity <= Count::limit;
            else
                return true;
        }(),
        "repeated: the list's capacity exceeds what its count can say");

    static consteval std::string_view name() { return name_of<Member>(); }

    using raw_list = typename traits::template of<typename detail::raw_element<Element, value_type>::type>;
    using raw_type = std::conditional_t<optional, std::optional<raw_list>, raw_list>;

    JAUSCAT_INLINE static constexpr std::size_t size(const auto& object, const auto& here) noexcept {
        const auto& elements = value_of<Member>(object);
        return Count::prefix_size + detail::size_of_elements<form_in<decltype(object)>>(elements, here);
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto& here) noexcept {
        const auto& elements = value_of<Member>(object);
        c = Count::put(elements.size(), c, here);
        if (c.error != errc::ok) return c;
        return detail::put_elements<form_in<decltype(object)>>(elements, c, here);
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto& here) noexcept {
        using form = form_in<decltype(object)>;
        auto& elements = emplace_in<Member>(object);
        using stored = typename list_traits<std::remove_reference_t<decltype(elements)>>::value_type;
        std::size_t size{};
        if (!Count::get(size, c, here)) return c;
        if (!spend_elements(c, size)) return c;
        if constexpr (traits::elsewhere && discarding<decltype(here)>) {
            for (std::size_t i = 0; i != size && c.at != nullptr; ++i) {
                stored scratch{};
                c = form::get(scratch, c, here);
            }
            return c;
        } else if constexpr (traits::elsewhere) {
            stored* const first = root_of(here).memory.template allocate<stored>(size);
            if (first == nullptr && size != 0) return in_cursor::failed(errc::arena_full);
            elements = std::span<const stored>{first, size};
            return detail::get_elements<form>(first, size, c, here);
        } else {
            if (!elements.resize(size)) return in_cursor::failed(errc::count_above_capacity);
            return detail::get_elements<form>(elements.begin(), size, c, here);
        }
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto& here) noexcept {
        const std::size_t size = Count::peek(c.at, here);
        if (!spend_elements(c, size)) return c;
        c.at += Count::prefix_size;
        return detail::measure_elements<plain_form>(size, c, here);
    }
    JAUSCAT_INLINE static constexpr std::size_t extent(const std::byte* in, const auto& here) noexcept {
        return Count::prefix_size +
               detail::extent_of_elements<plain_form>(Count::peek(in, here), in + Count::prefix_size, here);
    }
    template <auto, reading Mode>
    JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        return list_view<repeated, std::remove_cvref_t<decltype(here)>>{in + Count::prefix_size, Count::peek(in, here),
                                                                        here};
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(repeated{}, member_of<Member>(object));
    }

  private:
    template <class Object>
    using form_in = typename detail::element_form<
        Element, raw_object<Object>, std::remove_cvref_t<decltype(value_of<Member>(std::declval<Object&>())[0])>>::type;

    // Takes the fewest bytes of `size` elements from the slack.
    JAUSCAT_INLINE static constexpr bool spend_elements(in_cursor& c, std::size_t size) noexcept {
        if constexpr (plain_form::min_size != 0) {
            if (size > c.slack / plain_form::min_size) {
                c = in_cursor::failed(errc::truncated);
                return false;
            }
            c.slack -= size * plain_form::min_size;
        }
        return true;
    }
};

} // namespace jauscat::wire
