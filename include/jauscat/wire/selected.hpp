// A value with a layout that depends on another member: a type code, a tag, an index.
#pragma once
#include <jauscat/wire/nested.hpp>

#include <algorithm>
#include <tuple>
#include <variant>

namespace jauscat::wire {

/// The member that selects; further pointers lead into it.
template <auto First, auto... Rest> struct by {
    using refers = key_list<First>;
    /// The tag, out of the structures around.
    JAUSCAT_INLINE static constexpr auto value(const auto& here) noexcept { return look_up<First, Rest...>(here); }
};

template <class T> inline constexpr bool is_variant = false;
template <class... T> inline constexpr bool is_variant<std::variant<T...>> = true;

/// One case: for `Tag` the value has the form `Form`, a codec or a struct with a schema; without one it has no bytes.
template <auto Tag, class Form = std::monostate> struct when {
    static constexpr auto tag = Tag;
    using form = Form;
};

namespace detail {

// How one case is sized, written and read; `value` is of the case's own type.
template <class Form> struct case_form {
    static_assert(checked_codec<Form>, "selected: the form of a case is neither a codec nor a struct with a schema");
    using value_type = typename Form::value_type;
    static constexpr std::size_t min_size = Form::size, max_size = Form::size;
    static constexpr std::size_t size(const auto&, const auto&) noexcept { return Form::size; }
    static constexpr in_cursor measure(in_cursor c, const auto&) noexcept { return {c.at + Form::size, c.slack}; }
    static constexpr std::size_t extent(const std::byte*, const auto&) noexcept { return Form::size; }
    template <bool Raw>
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& value, out_cursor c, const auto&) noexcept {
        using used = wire::codec_in_mode<Form, Raw>;
        c.error = used::store(c.at, static_cast<typename used::value_type>(value));
        if (c.error == errc::ok) c.at += Form::size;
        return c;
    }
    template <bool Raw> JAUSCAT_INLINE static constexpr in_cursor get(auto& value, in_cursor c, const auto&) noexcept {
        using used = wire::codec_in_mode<Form, Raw>;
        typename used::value_type loaded{};
        const errc error = used::load(c.at, loaded);
        if (error != errc::ok) return in_cursor::failed(error);
        value = static_cast<std::remove_reference_t<decltype(value)>>(loaded);
        return {c.at + Form::size, c.slack};
    }
};
template <message Form> struct case_form<Form> {
    using value_type = Form;
    using inner = layout_of<Form>;
    static constexpr std::size_t min_size = inner::min_size, max_size = inner::max_size;
    static constexpr std::size_t size(const auto& value, const auto& here) noexcept {
        return inner::size(value, object_scope{value, here});
    }
    template <class Here> static constexpr in_cursor measure(in_cursor c, const Here& here) noexcept {
        return inner::measure(c, byte_scope<Form, Here>{c.at, here.end, here});
    }
    template <class Here> static constexpr std::size_t extent(const std::byte* in, const Here& here) noexcept {
        return inner::extent(in, byte_scope<Form, Here>{in, here.end, here});
    }
    template <bool>
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& value, out_cursor c, const auto& here) noexcept {
        return inner::put(value, c, object_scope{value, here});
    }
    template <bool> JAUSCAT_INLINE static constexpr in_cursor get(auto& value, in_cursor c, const auto& here) noexcept {
        return inner::get(value, c, object_scope{value, here});
    }
};
/// Whether a structure of a case has value sets; codecs of cases have none.
template <class Form> consteval bool form_checks_values() {
    if constexpr (message<Form>)
        return layout_of<Form>::checks_values;
    else
        return false;
}
template <> struct case_form<std::monostate> {
    using value_type = std::monostate;
    static constexpr std::size_t min_size = 0, max_size = 0;
    static constexpr std::size_t size(const auto&, const auto&) noexcept { return 0; }
    static constexpr in_cursor measure(in_cursor c, const auto&) noexcept { return c; }
    static constexpr std::size_t extent(const std::byte*, const auto&) noexcept { return 0; }
    template <bool> static constexpr out_cursor put(const auto&, out_cursor c, const auto&) noexcept { return c; }
    template <bool> static constexpr in_cursor get(auto&, in_cursor c, const auto&) noexcept { return c; }
};

/// With more cases or alternatives than these, they are written and read in a function for all members that have them:
/// a payload's interface has three values of 22 cases each. A call for fewer took more instructions than they do.
inline constexpr std::size_t most_inlined = 4;

/// Operations on a value of the type `Value`, by its tag. A structure in a case reads no enclosing members.
template <class Value, bool Raw, class... Cases> struct case_table {
    static constexpr std::size_t min_size = std::min({case_form<typename Cases::form>::min_size...});
    static constexpr std::size_t max_size = std::max({case_form<typename Cases::form>::max_size...});

    /// Calls f.template operator()<form>() for the form of a tag; false where there is none.
    JAUSCAT_INLINE static constexpr bool with_form(auto tag, auto&& f) {
        return (... || (tag == Cases::tag && (f.template operator()<case_form<typename Cases::form>>(), true)));
    }
    [[gnu::noinline]] static constexpr std::size_t size(const Value& value, auto tag) noexcept {
        std::size_t total = 0;
        with_form(tag, [&]<class Form>() {
            if (const auto* const one = in<Form>(value)) total = Form::size(*one, plain_root{});
        });
        return total;
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const Value& value, auto tag, out_cursor c,
                                                   const auto& root) noexcept {
        if constexpr (sizeof...(Cases) > most_inlined)
            return put_called(value, tag, c, root);
        else
            return put_here(value, tag, c, root);
    }
    JAUSCAT_INLINE static constexpr in_cursor get(Value& value, auto tag, in_cursor c, const auto& root) noexcept {
        if constexpr (sizeof...(Cases) > most_inlined)
            return get_called(value, tag, c, root);
        else
            return get_here(value, tag, c, root);
    }
    [[gnu::noinline]] static constexpr in_cursor measure(auto tag, in_cursor c, const std::byte* stop) noexcept {
        in_cursor end = in_cursor::failed(errc::unknown_tag);
        with_form(tag, [&]<class Form>() {
            end = c;
            if (spend(end, Form::min_size - min_size)) end = Form::measure(end, alone(c.at, stop));
        });
        return end;
    }
    [[gnu::noinline]] static constexpr std::size_t extent(auto tag, const std::byte* bytes,
                                                          const std::byte* stop) noexcept {
        std::size_t total = 0;
        with_form(tag, [&]<class Form>() { total = Form::extent(bytes, alone(bytes, stop)); });
        return total;
    }

  private:
    JAUSCAT_INLINE static constexpr out_cursor put_here(const Value& value, auto tag, out_cursor c,
                                                        const auto& root) noexcept {
        out_cursor end{c.at, errc::unknown_tag};
        with_form(tag, [&]<class Form>() {
            if (const auto* const one = in<Form>(value)) end = Form::template put<Raw>(*one, c, root);
        });
        return end;
    }
    JAUSCAT_INLINE static constexpr in_cursor get_here(Value& value, auto tag, in_cursor c, const auto& root) noexcept {
        in_cursor end = in_cursor::failed(errc::unknown_tag);
        with_form(tag, [&]<class Form>() {
            end = c;
            if (!spend(end, Form::min_size - min_size)) return;
            if constexpr (is_variant<Value>)
                end = Form::template get<Raw>(value.template emplace<typename Form::value_type>(), end, root);
            else
                end = Form::template get<Raw>(value, end, root);
        });
        return end;
    }
    [[gnu::noinline]] static constexpr out_cursor put_called(const Value& value, auto tag, out_cursor c,
                                                             const auto& root) noexcept {
        return put_here(value, tag, c, root);
    }
    [[gnu::noinline]] static constexpr in_cursor get_called(Value& value, auto tag, in_cursor c,
                                                            const auto& root) noexcept {
        return get_here(value, tag, c, root);
    }
    // The value, if it is of the form's type.
    template <class Form> static constexpr auto in(const Value& value) noexcept {
        if constexpr (is_variant<Value>)
            return std::get_if<typename Form::value_type>(&value);
        else
            return &value;
    }
    static constexpr auto alone(const std::byte* bytes, const std::byte* stop) noexcept {
        return byte_scope<plain_root, plain_root>{bytes, stop, {}};
    }
};

} // namespace detail

/// The type and the sizes of a case: `value_type`, `min_size`, `max_size`.
template <class Form> using case_form = detail::case_form<Form>;

namespace detail {
template <auto Member, class Is, class Case> inline constexpr bool fits_member = std::is_convertible_v<Case, Is>;
} // namespace detail

/// A member in the form that `Selector` selects among `Cases`. The member is a std::variant of the cases' types, or of
/// their one type. A tag without a case, and a value that is not of its tag's type, say unknown_tag.
/// In a `raw` a plain member with scaled cases is the integer on the wire, as std::uint64_t.
template <auto Member, class Selector, class... Cases> struct selected {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using value_type = member_value_t<Member>;
    using cases = std::tuple<Cases...>;
    using selector = Selector;
    using refers = references_of<Selector>;
    static constexpr bool optional = is_optional_member<Member>;
    static constexpr bool contextual = true;
    template <class Value, bool Raw> using table = detail::case_table<Value, Raw, Cases...>;
    static constexpr std::size_t min_size = table<value_type, false>::min_size;
    static constexpr std::size_t max_size = table<value_type, false>::max_size;
    static constexpr bool of_variant = is_variant<value_type>;
    static constexpr bool checks_values = (detail::form_checks_values<typename Cases::form>() || ...);
    static constexpr bool has_scaled = (requires { typename Cases::form::raw_codec; } || ...);
    static_assert(!(of_variant && has_scaled), "selected: scaled cases need a plain member");
    static_assert(
        of_variant ||
            (detail::fits_member<Member, value_type, typename detail::case_form<typename Cases::form>::value_type> &&
             ...),
        "selected: a case does not fit the member's type");
    using raw_value = std::conditional_t<has_scaled, std::uint64_t, value_type>;
    using raw_type = std::conditional_t<optional, std::optional<raw_value>, raw_value>;

    static consteval std::string_view name() { return name_of<Member>(); }

    /// Calls f.template operator()<Case>() for the case of a tag; false where there is none.
    static constexpr bool with_case(auto tag, auto&& f) {
        return (... || (tag == Cases::tag && (f.template operator()<Cases>(), true)));
    }

    JAUSCAT_INLINE static constexpr std::size_t size(const auto& object, const auto& here) noexcept {
        return table_in<decltype(object)>::size(value_of<Member>(object), Selector::value(here));
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto& here) noexcept {
        return table_in<decltype(object)>::put(value_of<Member>(object), Selector::value(here), c, root_of(here));
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto& here) noexcept {
        return table_in<decltype(object)>::get(emplace_in<Member>(object), Selector::value(here), c, root_of(here));
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto& here) noexcept {
        return table<value_type, false>::measure(Selector::value(here), c, here.end);
    }
    JAUSCAT_INLINE static constexpr std::size_t extent(const std::byte* in, const auto& here) noexcept {
        return table<value_type, false>::extent(Selector::value(here), in, here.end);
    }
    /// Decoded; empty where a scaled raw value is not legal. A view reads the raw value of a scaled case as a real one
    /// too: only a `raw` holds it.
    template <auto, reading> JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        value_type value{};
        const in_cursor c{in, static_cast<std::size_t>(here.end - in) - min_size};
        const bool legal = table<value_type, false>::get(value, Selector::value(here), c, plain_root{}).at != nullptr;
        return legal ? std::optional{value} : std::nullopt;
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(selected{}, member_of<Member>(object));
    }

  private:
    template <class Object>
    using table_in =
        table<std::remove_cvref_t<decltype(value_of<Member>(std::declval<Object&>()))>, raw_object<Object>>;
};

} // namespace jauscat::wire
