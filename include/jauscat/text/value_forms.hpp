// Text forms of single values: numbers, enumerations, flags, text and bytes, by member type and codec.
#pragma once
#include <jauscat/text/structure.hpp>
#include <jauscat/text/value.hpp>
#include <jauscat/wire/schema.hpp>
#include <jauscat/wire/value_set.hpp>

namespace jauscat::text::detail {

template <class T> inline constexpr char type_id{};

/// A member that is found in the structure alone.
template <auto Member> struct access {
    using owner = wire::owner_t<Member>;
    using value_type = wire::member_value_t<Member>;

    static const void* find(const void* object) {
        const auto& value = static_cast<const owner*>(object)->*Member;
        if constexpr (wire::is_optional_member<Member>)
            return value ? &*value : nullptr;
        else
            return &value;
    }
    static void* make(void* object) {
        auto& value = static_cast<owner*>(object)->*Member;
        if constexpr (wire::is_optional_member<Member>)
            return value ? &*value : &value.emplace();
        else
            return &value;
    }
    static std::uint64_t get(const void* object) {
        return static_cast<std::uint64_t>(static_cast<const owner*>(object)->*Member);
    }
    static void set(void* object, std::uint64_t number) {
        static_cast<owner*>(object)->*Member = static_cast<value_type>(number);
    }
    static constexpr other_member other() { return {&type_id<owner>, wire::member_name<Member>, &get, &set}; }
    static std::uint64_t size(const void* object) {
        const auto* const value = static_cast<const value_type*>(find(object));
        return value == nullptr ? 0 : value->size();
    }
};
/// The same for an item. By its list of keys: g++ 12 takes `Item::key` for a pointer of another type here and there.
template <class Keys> struct access_by_keys;
template <auto Member> struct access_by_keys<wire::key_list<Member>> {
    using type = access<Member>;
};
template <class Item> using access_of = typename access_by_keys<typename Item::keys>::type;

/// A value by its type alone, so that members of the same type share the code.
template <class Value> struct simple {
    static std::uint64_t get(const void* value) {
        if constexpr (requires { typename Value::bit_type; })
            return static_cast<const Value*>(value)->bits();
        else
            return static_cast<std::uint64_t>(*static_cast<const Value*>(value));
    }
    static void set(void* value, std::uint64_t number) {
        if constexpr (requires { typename Value::bit_type; })
            *static_cast<Value*>(value) = Value::from_bits(static_cast<typename Value::bits_type>(number));
        else
            *static_cast<Value*>(value) = static_cast<Value>(number);
    }
    static double get_real(const void* value) { return static_cast<double>(*static_cast<const Value*>(value)); }
    static void set_real(void* value, double real) { *static_cast<Value*>(value) = static_cast<Value>(real); }
};

template <class Codec> constexpr std::string_view unit_of() {
    if constexpr (requires { typename Codec::unit_type; })
        return Codec::unit_type::unit;
    else
        return {};
}

constexpr std::uint64_t two_s_complement(auto value) {
    return static_cast<std::uint64_t>(wire::detail::integer_in(value));
}
/// The numbers of a value set; none where it has a part of the user's own.
template <class Set> inline constexpr std::array<number_range, 0> numbers_in{};
template <auto Least, auto Most>
inline constexpr std::array<number_range, 1> numbers_in<wire::between<Least, Most>>{
    number_range{two_s_complement(Least), two_s_complement(Most)}};
template <auto... Values>
inline constexpr std::array<number_range, sizeof...(Values)> numbers_in<wire::one_of<Values...>>{
    number_range{two_s_complement(Values), two_s_complement(Values)}...};
template <class... Parts> consteval auto joined_numbers() {
    constexpr bool is_known = ((numbers_in<Parts>.size() != 0) && ...);
    std::array<number_range, is_known ? (numbers_in<Parts>.size() + ...) : 0> all{};
    auto at = all.begin();
    if constexpr (is_known) ((at = std::ranges::copy(numbers_in<Parts>, at).out), ...);
    return all;
}
template <class... Parts>
inline constexpr auto numbers_in<wire::detail::joined_values<Parts...>> = joined_numbers<Parts...>();
/// Of a codec, a bit-field or a count.
template <class Coded> constexpr std::span<const number_range> values_of() {
    if constexpr (requires { typename Coded::value_set; })
        return numbers_in<typename Coded::value_set>;
    else
        return {};
}

/// How many values from 0 on may have a name.
template <class Coded, unsigned Bits> constexpr std::size_t named_values() {
    std::uint64_t most = 0;
    for (const number_range& one : values_of<Coded>()) most = std::max(most, one.most);
    const std::uint64_t all = std::uint64_t{1} << std::min(Bits, 8U);
    return static_cast<std::size_t>(values_of<Coded>().empty() ? all : std::min(most + 1, all));
}

/// `Coded`: a codec, or a bit-field.
template <class Value, unsigned Bits, class Coded> constexpr integer_form integer_of(std::string_view unit = {}) {
    integer_form made{.bits = Bits,
                      .unit = unit,
                      .values = values_of<Coded>(),
                      .get = &simple<Value>::get,
                      .set = &simple<Value>::set};
    if constexpr (requires { typename Value::bit_type; }) {
        made.what = integer_form::meaning::flags;
        made.names = enumerator_names<typename Value::bit_type, Bits>;
        made.type = wire::type_name<typename Value::bit_type>();
    } else if constexpr (std::is_enum_v<Value>) {
        made.what = integer_form::meaning::enumeration;
        made.names = enumerator_names<Value, named_values<Coded, Bits>()>;
        made.type = wire::type_name<Value>();
    } else if constexpr (std::is_same_v<Value, bool>) {
        made.what = integer_form::meaning::boolean;
    } else {
        made.is_signed = std::is_signed_v<Value>;
    }
    return made;
}

template <class Value, class Codec> constexpr form form_by_codec() {
    if constexpr (requires { typename Codec::range_type; }) {
        using range = typename Codec::range_type;
        using raw = typename Codec::raw_type;
        return {scaled_form{.unit = unit_of_range<range>(),
                            .min = range::min,
                            .max = range::max,
                            .lowest = Codec::lowest,
                            .highest = Codec::highest,
                            .is_signed = std::is_signed_v<raw>,
                            .bits = static_cast<unsigned>(Codec::size * 8),
                            .get = &simple<Value>::get_real,
                            .set = &simple<Value>::set_real,
                            .to_raw = [](double real) { return static_cast<std::uint64_t>(Codec::to_raw(real)); },
                            .to_real = [](std::uint64_t n) { return Codec::to_real(static_cast<raw>(n)); }}};
    } else if constexpr (std::floating_point<Value>) {
        return {real_form{.unit = unit_of<Codec>(),
                          .most = static_cast<double>(std::numeric_limits<typename Codec::value_type>::max()),
                          .bits = static_cast<unsigned>(Codec::size * 8),
                          .get = &simple<Value>::get_real,
                          .set = &simple<Value>::set_real}};
    } else if constexpr (requires { std::tuple_size<Value>::value; }) {
        return {octets_form{
            .least = Codec::size,
            .most = Codec::size,
            .get = [](const void* value) { return std::span<const std::byte>{*static_cast<const Value*>(value)}; },
            .set =
                [](void* value, std::span<const std::byte> bytes) {
                    std::ranges::copy(bytes, static_cast<Value*>(value)->begin());
                }}};
    } else {
        return {integer_of<Value, static_cast<unsigned>(Codec::size * 8), Codec>(unit_of<Codec>())};
    }
}
template <class Value, class Codec> inline constexpr form codec_form = form_by_codec<Value, Codec>();
template <class Value, std::size_t Width, class Field = void>
inline constexpr form bit_form{integer_of<Value, static_cast<unsigned>(Width), Field>()};
/// A presence vector or a constant.
template <class Codec> inline constexpr form number_form{integer_form{.bits = static_cast<unsigned>(Codec::size * 8)}};
template <class Count>
inline constexpr form count_form{
    integer_form{.bits = static_cast<unsigned>(Count::codec_type::size * 8), .values = values_of<Count>()}};

template <class Value> std::span<const std::byte> octets_of(const void* value) {
    const auto& held = *static_cast<const Value*>(value);
    return std::as_bytes(std::span{held.data(), held.size()});
}
template <class Value> void point_at(void* value, std::span<const std::byte> bytes) {
    if constexpr (std::is_same_v<Value, std::string_view>)
        *static_cast<Value*>(value) = {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    else
        *static_cast<Value*>(value) = Value{bytes};
}
template <class Item> inline constexpr bool zero_filled = false;
template <auto M, std::size_t N> inline constexpr bool zero_filled<wire::fixed_run<M, N>> = true;
template <auto M, std::size_t N> inline constexpr bool zero_filled<wire::lenient_run<M, N>> = true;
template <class Item> inline constexpr bool zero_terminated = false;
template <auto M> inline constexpr bool zero_terminated<wire::terminated_run<M>> = true;

template <class Item> inline constexpr bool to_the_end = false;
template <auto M> inline constexpr bool to_the_end<wire::run_to_end<M>> = true;
template <auto M, std::size_t N> inline constexpr bool to_the_end<wire::lenient_run<M, N>> = true;

template <class Item> constexpr std::size_t most_of() {
    if constexpr (requires { Item::count_type::limit; })
        return Item::count_type::limit;
    else
        return Item::max_size;
}
template <class Item>
inline constexpr form octets_run_form{
    octets_form{.characters = std::is_same_v<typename Item::value_type, std::string_view>,
                .most = most_of<Item>(),
                .zero_filled = zero_filled<Item>,
                .zero_terminated = zero_terminated<Item>,
                .to_the_end = to_the_end<Item>,
                .get = &octets_of<typename Item::value_type>,
                .set = &point_at<typename Item::value_type>}};

} // namespace jauscat::text::detail
