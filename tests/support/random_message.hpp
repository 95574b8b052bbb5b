// Random messages of any schema, for property tests and benchmarks.
#pragma once
#include <jauscat/wire/visit.hpp>
#include <jauscat/wire/wire.hpp>

#include <limits>
#include <memory>
#include <memory_resource>
#include <random>
#include <span>

namespace support {

namespace wire = jauscat::wire;

/// Seeded by each test with a number of its own, so that a failure repeats.
using generator = std::mt19937_64;

inline bool chance(generator& g, double probability) { return std::bernoulli_distribution{probability}(g); }

/// 0 to `limit` - 1.
inline std::size_t below(generator& g, std::size_t limit) { return static_cast<std::size_t>(g() % limit); }

inline void fill(generator& g, std::span<std::byte> out) {
    for (auto& byte : out) byte = static_cast<std::byte>(g());
}

/// What a random message is made of.
struct odds {
    double present = 0.5; ///< probability that an optional field is there
    double illegal = 0;   ///< probability that a value that can be illegal is
    bool exact = false;   ///< scaled values are ones that a raw value stands for, so that they survive a round trip
};

namespace detail {

/// Whether the member `First` belongs to the structure that the scope `Here` stands in.
template <auto First, class Here>
inline constexpr bool stands_here =
    std::is_same_v<wire::structure_of_scope<std::remove_cvref_t<Here>>, wire::owner_t<First>>;

template <auto First, auto... Rest> auto& follow(auto& object) {
    auto& member = wire::member_of<First>(object);
    if constexpr (sizeof...(Rest) == 0)
        return member;
    else
        return follow<Rest...>(member);
}

class randomiser {
  public:
    randomiser(generator& g, const odds& o, std::pmr::memory_resource& memory) : g_{g}, odds_{o}, memory_{memory} {}

    template <class T> void message(T& object, const auto& outer) {
        const wire::object_scope here{object, outer};
        wire::layout_of<T>::all_items([&]<class Item>() {
            item(Item{}, object, here);
            return true;
        });
    }

  private:
    // Flags first: they say what is in the other items.
    template <wire::unknown_bits Unknown, class Carrier, class... Items>
    void item(wire::presence_group<Unknown, Carrier, Items...>, auto& object, const auto& here) {
        (flag(Items{}, object), ...);
        (item(Items{}, object, here), ...);
    }
    template <auto Member> void item(wire::presence_flag<Member>, auto&, const auto&) {}
    template <class Item> void flag(Item, auto&) {}
    template <auto Member> void flag(wire::presence_flag<Member>, auto& object) {
        wire::member_of<Member>(object) = chance(g_, odds_.present);
    }
    template <class Carrier, class... Fields>
    void item(wire::bit_fields<Carrier, Fields...>, auto& object, const auto&) {
        (bit(Fields{}, object), ...);
    }
    template <std::size_t Width> void bit(wire::reserved<Width>, auto&) {}
    template <auto Member, std::size_t Width> void bit(wire::bit_field<Member, Width> field, auto& object) {
        field.assign(object,
                     chance(g_, odds_.illegal) ? ~std::uint64_t{} : integer() & (~std::uint64_t{} >> (64 - Width)));
    }
    template <auto Member, std::size_t Width, class... Parts>
    void bit(wire::bit_field_in_set<Member, Width, Parts...> field, auto& object) {
        do bit(wire::bit_field<Member, Width>{}, object);
        while (!wire::detail::in_its_set<decltype(field)>(wire::member_of<Member>(object)));
    }
    template <wire::label Name, class Codec, auto Value>
    void item(wire::constant<Name, Codec, Value>, auto&, const auto&) {}
    template <auto Flag, class Item> void item(wire::gated_by<Flag, Item>, auto& object, const auto& here) {
        auto& member = wire::member_of<Item::key>(object);
        if (wire::look_up<Flag>(here) != chance(g_, odds_.illegal))
            value(Item{}, member.emplace(), object, here);
        else
            member.reset();
    }
    template <class Item> void item(Item, auto& object, const auto& here) {
        auto& member = wire::member_of<Item::key>(object);
        if constexpr (!Item::optional)
            value(Item{}, member, object, here);
        else if (chance(g_, odds_.present))
            value(Item{}, member.emplace(), object, here);
        else
            member.reset();
    }

    template <auto Member, class Codec> void value(wire::field<Member, Codec>, auto& member, auto&, const auto&) {
        number<Codec>(member);
    }
    template <auto Member> void value(wire::not_on_wire<Member>, auto& member, auto&, const auto&) {
        member = static_cast<std::remove_reference_t<decltype(member)>>(integer());
    }
    template <auto Member> void value(wire::nested<Member>, auto& member, auto&, const auto& here) {
        message(member, here);
    }
    template <auto Member, class Count, class Element>
    void value(wire::repeated<Member, Count, Element>, auto& member, auto& object, const auto& here) {
        using traits = typename wire::repeated<Member, Count, Element>::traits;
        const auto element = [&](auto& one) {
            if constexpr (std::is_same_v<Element, wire::record>)
                message(one, here);
            else
                number<typename Element::codec_type>(one);
        };
        if constexpr (traits::elsewhere) {
            const auto elements =
                make<typename std::remove_reference_t<decltype(member)>::value_type>(length<Count>(4, object, here));
            for (auto& one : elements) element(one);
            member = elements;
        } else {
            const bool full = chance(g_, 0.05);
            const std::size_t most = full ? traits::capacity : std::min<std::size_t>(traits::capacity, 4);
            static_cast<void>(member.resize(length<Count>(most, object, here))); // within the capacity
            for (auto& one : member) element(one);
        }
    }
    template <auto Member, class Element>
    void value(wire::array<Member, Element>, auto& member, auto&, const auto& here) {
        for (auto& one : member)
            if constexpr (std::is_same_v<Element, wire::record>)
                message(one, here);
            else
                number<Element>(one);
    }
    template <auto Member, auto Children, std::size_t MaxDepth>
    void value(wire::tree<Member, Children, MaxDepth>, auto& member, auto&, const auto& here) {
        const auto nodes = make<typename std::remove_reference_t<decltype(member)>::value_type>(20);
        wire::tree_walk<MaxDepth> walk;
        std::size_t size = 0, announced = 1;
        do {
            auto& node = nodes[size++];
            const auto& children = wire::member_of<Children>(node);
            const std::size_t room = walk.depth() + 1 == MaxDepth ? 0 : nodes.size() - announced;
            do message(node, here);
            while (children > room);
            announced += children;
            static_cast<void>(walk.pass(children));
        } while (!walk.complete());
        member = nodes.first(size);
    }
    template <auto Member, class Selector, class... Cases>
    void value(wire::selected<Member, Selector, Cases...>, auto& member, auto& object, const auto& here) {
        using item = wire::selected<Member, Selector, Cases...>;
        // Another value may have drawn it.
        if (!item::with_case(Selector::value(here), []<class>() {})) draw_tag<Cases...>(Selector{}, object, here);
        const auto draw = [&]<class Case>(auto& held) { // depends on its type, as clang requires of discarded branches
            using form = typename Case::form;
            if constexpr (std::is_same_v<form, std::monostate>)
                held = form{};
            else if constexpr (wire::message<form>)
                message(held.template emplace<form>(), here);
            else if constexpr (item::of_variant)
                number<form>(held.template emplace<typename form::value_type>());
            else
                number<form>(held);
        };
        item::with_case(Selector::value(here), [&]<class Case>() { draw.template operator()<Case>(member); });
        if (chance(g_, odds_.illegal)) draw_tag<Cases...>(Selector{}, object, here);
    }
    template <auto Member, class Tag> void value(wire::variant<Member, Tag>, auto& member, auto&, const auto& here) {
        using alternatives = typename wire::variant<Member, Tag>::alternatives;
        alternatives::with(below(g_, alternatives::count),
                           [&]<std::size_t I, class>() { message(member.template emplace<I>(), here); });
    }
    // A tag of a structure around this one stays what it is.
    template <class... Cases, auto First, auto... Rest>
    void draw_tag(wire::by<First, Rest...>, auto& object, const auto& here) {
        constexpr std::array tags{Cases::tag...};
        if constexpr (stands_here<First, decltype(here)>) follow<First, Rest...>(object) = tags[below(g_, tags.size())];
    }
    /// Text and bytes.
    template <class Item> void value(Item, auto& member, auto& object, const auto& here) {
        constexpr std::size_t most = std::min<std::size_t>(Item::max_size, 100);
        std::size_t size = chance(g_, 0.1) ? most : below(g_, std::min<std::size_t>(most, 20) + 1);
        if constexpr (requires { typename Item::count_type; })
            size = length<typename Item::count_type>(size, object, here);
        else if (Item::max_size != wire::unbounded && chance(g_, odds_.illegal))
            size = Item::max_size + 1;
        if constexpr (std::is_same_v<typename Item::value_type, std::string_view>) {
            const auto text = make<char>(size);
            for (char& c : text) c = static_cast<char>('!' + below(g_, 94)); // all that can be seen
            member = {text.data(), size};
        } else {
            const auto bytes = make<std::byte>(size);
            fill(g_, bytes);
            member = std::remove_reference_t<decltype(member)>{bytes};
        }
    }

    /// Up to `most` elements. A count in this structure is told; one further out was drawn before and decides.
    template <class Count> std::size_t length(std::size_t most, auto& object, const auto& here) {
        if constexpr (requires { typename Count::value_set; })
            return within(typename Count::value_set{}, most);
        else if constexpr (requires { Count::limit; })
            return below(g_, std::min(most, Count::limit) + 1);
        else
            return counted_elsewhere(Count{}, most, object, here);
    }
    template <auto Least, auto Most> std::size_t within(wire::between<Least, Most>, std::size_t most) {
        return std::min<std::size_t>(Least + below(g_, most + 1), Most);
    }
    template <std::size_t Less, auto First, auto... Rest>
    std::size_t counted_elsewhere(const wire::count_elsewhere<Less, First, Rest...>& count, std::size_t most,
                                  auto& object, const auto& here) {
        if constexpr (stands_here<First, decltype(here)>) {
            auto& told = follow<First, Rest...>(object);
            told = static_cast<std::remove_reference_t<decltype(told)>>(below(g_, most + 1) + Less);
        }
        return count.peek(nullptr, here) + chance(g_, odds_.illegal);
    }

    template <class Codec, class Value> void number(Value& value) {
        if constexpr (requires { typename Codec::range_type; } && std::floating_point<Value>) {
            value = real<Codec>();
        } else if constexpr (std::floating_point<Value>) {
            value = static_cast<Value>(std::normal_distribution<double>{0, 1e6}(g_));
        } else if constexpr (std::integral<Value> || std::is_enum_v<Value>) {
            do value = static_cast<Value>(integer());
            while (!wire::detail::holds_value<Codec>(value));
        } else if constexpr (requires { typename Value::bits_type; }) {
            value = Value::from_bits(static_cast<typename Value::bits_type>(integer()));
        } else {
            fill(g_, value);
        }
    }
    template <class Codec> double real() {
        using range = typename Codec::range_type;
        using limits = std::numeric_limits<double>;
        if (chance(g_, odds_.illegal)) {
            const std::array wrong{limits::quiet_NaN(), limits::infinity(), -limits::infinity(), range::min - 1.0,
                                   range::max + 1.0};
            return wrong[below(g_, wrong.size())];
        }
        if (odds_.exact)
            return Codec::to_real(std::max(Codec::bottom, static_cast<typename Codec::raw_type>(integer())));
        const auto which = g_() % 16;
        if (which == 0) return range::min;
        if (which == 1) return range::max;
        return std::uniform_real_distribution<double>{range::min, range::max}(g_);
    }
    /// Small ones are as frequent as all others.
    std::uint64_t integer() { return chance(g_, 0.5) ? g_() : g_() % 8; }

    template <class T> std::span<T> make(std::size_t size) {
        T* const first = std::pmr::polymorphic_allocator<T>{&memory_}.allocate(size);
        std::uninitialized_value_construct_n(first, size);
        return {first, size};
    }

    generator& g_;
    const odds& odds_;
    std::pmr::memory_resource& memory_;
};

} // namespace detail

/// A random `T`; unless `o` allows illegal values, one that encodes. Its lists, text and bytes are in `memory`.
template <wire::message T> T random_message(generator& g, std::pmr::memory_resource& memory, const odds& o = {}) {
    T message{};
    detail::randomiser{g, o, memory}.message(message, wire::plain_root{});
    return message;
}
/// The same for a message that holds everything itself.
template <wire::message T> T random_message(generator& g, const odds& o = {}) {
    return random_message<T>(g, *std::pmr::null_memory_resource(), o);
}

} // namespace support
