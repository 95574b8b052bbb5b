// Walks over a message part by part and tells a trace of each part: what `diagnose` and the fuzz targets build on. The
// walks know the order of an item's parts; each value is read and written by the item's own get and put, which know no
// trace.
#pragma once
#include <jauscat/wire/array.hpp>
#include <jauscat/wire/bit_fields.hpp>
#include <jauscat/wire/diagnosis.hpp>
#include <jauscat/wire/embedded.hpp>
#include <jauscat/wire/gated_by.hpp>
#include <jauscat/wire/nested.hpp>
#include <jauscat/wire/presence.hpp>
#include <jauscat/wire/repeated.hpp>
#include <jauscat/wire/selected.hpp>
#include <jauscat/wire/string.hpp>
#include <jauscat/wire/tree.hpp>
#include <jauscat/wire/value_set.hpp>
#include <jauscat/wire/variant.hpp>

#include <algorithm>
#include <span>

namespace jauscat::wire {

/// Keeps the path to a part. Structures nested deeper than it is long (no standard message has them) are left out.
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

    /// The list or array that the walk is in.
    [[nodiscard]] constexpr std::string_view innermost() const noexcept {
        return found_.path[std::min(found_.depth, found_.path.size()) - 1].name;
    }
    /// Ends the walk. Returns false.
    constexpr bool fail(errc error) noexcept {
        found_.error = error;
        return false;
    }
    /// Whether the walk searches for a value outside its value set; else it does not look at value sets.
    [[nodiscard]] constexpr bool checks_values() const noexcept { return checks_values_; }
    /// Ends the walk at a value outside its value set. Returns false.
    constexpr bool fail_value(std::string_view name) noexcept {
        found_.field = name;
        return fail(errc::outside_value_set);
    }
    /// Why the walk ended; ok after the whole message.
    [[nodiscard]] constexpr errc error() const noexcept { return found_.error; }
    /// The part that the walk reached last, and `error`.
    [[nodiscard]] constexpr diagnosis found(errc error) const noexcept {
        diagnosis why = found_;
        why.error = error;
        why.depth = std::min(why.depth, why.path.size());
        return why;
    }

  protected:
    constexpr explicit path_trace(bool checks_values = false) noexcept : checks_values_{checks_values} {}

    diagnosis found_{};

  private:
    bool checks_values_;
};

/// Traces decoding, and checks each part against the end of the bytes. If it searches for a given error, it skips
/// others while the following parts can still be located.
class decode_trace : public path_trace {
  public:
    constexpr explicit decode_trace(std::span<const std::byte> bytes, errc wanted = errc::ok) noexcept
        : path_trace{wanted == errc::outside_value_set}, bytes_{bytes}, wanted_{wanted} {}

    /// The next byte, and how many there are from it on.
    [[nodiscard]] constexpr const std::byte* at() const noexcept { return bytes_.data() + offset_; }
    [[nodiscard]] constexpr std::size_t remaining() const noexcept { return bytes_.size() - offset_; }

    /// Names the part at the next byte. Fails if it has fewer bytes than it needs.
    constexpr bool reach(std::string_view name, std::size_t needed) noexcept {
        found_.field = name;
        found_.offset = offset_;
        found_.needed = needed;
        found_.available = remaining();
        return needed <= remaining() || fail(errc::truncated);
    }
    /// Fails with an error, unless the trace searches for another one.
    constexpr bool passes(errc error) noexcept {
        return error == errc::ok || (wanted_ != errc::ok && error != wanted_) || fail(error);
    }
    constexpr void advance(std::size_t size) noexcept { offset_ += size; }

    /// Called behind an item without parts and behind a presence vector with its items; behind an element that is a
    /// single value; and behind a number of `Size` bytes that is no member: a presence vector, a count.
    template <class Item> constexpr void passed(const auto&) noexcept {}
    template <class Item> constexpr void passed_element(const auto&) noexcept {}
    template <std::size_t Size> constexpr void passed_number(std::string_view, std::uint64_t) noexcept {}

  protected:
    [[nodiscard]] constexpr std::size_t offset() const noexcept { return offset_; }

  private:
    std::span<const std::byte> bytes_;
    errc wanted_;
    std::size_t offset_{};
};

/// Traces encoding, and counts the bytes.
class encode_trace : public path_trace {
  public:
    constexpr explicit encode_trace(errc wanted = errc::ok) noexcept : path_trace{wanted == errc::outside_value_set} {}

    /// Names the part at the next byte.
    constexpr void reach(std::string_view name, std::size_t needed) noexcept {
        found_.field = name;
        found_.needed = needed;
    }
    constexpr bool passes(errc error) noexcept { return error == errc::ok || fail(error); }
    constexpr void advance(std::size_t size) noexcept { found_.offset += size; }
};

namespace detail {

inline constexpr std::string_view presence_vector = "presence_vector";

/// Passes an item whose values are in their value sets; else names the first one that is not.
template <class Item> constexpr bool pass_values([[maybe_unused]] const auto& object, [[maybe_unused]] auto& trace) {
    bool inside = true;
    if constexpr (item_checks_values<Item> && !raw_object<decltype(object)>) {
        if (trace.checks_values())
            Item::visit(object, [&]<class Leaf>(Leaf, const auto& member) {
                if (inside && !member_in_its_set<Leaf>(member)) inside = trace.fail_value(Leaf::name());
            });
    }
    return inside;
}
/// The same for an element of a list or an array, and for a count.
template <class Codec> constexpr bool pass_value([[maybe_unused]] const auto& value, [[maybe_unused]] auto& trace) {
    if constexpr (requires { typename Codec::value_set; })
        return !trace.checks_values() || Codec::value_set::contains(value) || trace.fail(errc::outside_value_set);
    else
        return true;
}

/// Walks over an item as a whole.
template <class Item> struct walk_over_whole {
    static constexpr bool get(auto& object, auto& trace, const auto& here) {
        if (!trace.reach(item_label<Item>(), Item::min_size)) return false;
        if constexpr (fixed_item<Item>) {
            if (!trace.passes(Item::get(object, trace.at()))) return false;
            trace.advance(Item::max_size);
        } else {
            const in_cursor start{trace.at(), trace.remaining() - Item::min_size};
            const in_cursor end = Item::get(object, start, here);
            if (end.error() == errc::truncated) return trace.reach(item_label<Item>(), trace.remaining() + 1);
            if (end.error() != errc::ok) return trace.fail(end.error());
            trace.advance(static_cast<std::size_t>(end.at - start.at));
        }
        trace.template passed<Item>(object);
        return pass_values<Item>(object, trace);
    }
    static constexpr bool put(const auto& object, auto& trace, [[maybe_unused]] const auto& here) {
        trace.reach(item_label<Item>(), fixed_item<Item> ? Item::max_size : 0);
        std::array<std::byte, Item::max_size == unbounded ? most_of_unbounded : Item::max_size> out{};
        const std::size_t size = sized<Item>::size(object, here);
        if (size <= out.size()) {
            out_cursor c{out.data(), errc::ok};
            put_item<Item>(object, c, here);
            if (!trace.passes(c.error)) return false;
        }
        trace.advance(size);
        return pass_values<Item>(object, trace);
    }

  private:
    // A longer value is not put: among the library's items only `rest` can be so long, and it cannot fail.
    static constexpr std::size_t most_of_unbounded = 1024;
};
/// How the walks go over an item: as a whole, but for the items below.
template <class Item> struct walk_over : walk_over_whole<Item> {};

/// Over one of several items.
template <class Item> constexpr bool walk_get(auto& object, auto& trace, const auto& here) {
    return trace.reach(item_label<Item>(), 0) && walk_over<Item>::get(object, trace, here);
}
template <class Item> constexpr bool walk_put(const auto& object, auto& trace, const auto& here) {
    trace.reach(item_label<Item>(), 0);
    return walk_over<Item>::put(object, trace, here);
}

template <class... Items> struct walk_over<layout<Items...>> {
    static constexpr bool get([[maybe_unused]] auto& object, [[maybe_unused]] auto& trace,
                              [[maybe_unused]] const auto& here) {
        return (walk_get<Items>(object, trace, here) && ... && true);
    }
    static constexpr bool put([[maybe_unused]] const auto& object, [[maybe_unused]] auto& trace,
                              [[maybe_unused]] const auto& here) {
        return (walk_put<Items>(object, trace, here) && ... && true);
    }
};

/// Over a structure with a schema.
template <class T> constexpr bool walk_get_message(auto& value, auto& trace, const auto& outer) {
    return walk_over<layout_of<T>>::get(value, trace, object_scope{value, outer});
}
template <class T> constexpr bool walk_put_message(const auto& value, auto& trace, const auto& outer) {
    return walk_over<layout_of<T>>::put(value, trace, object_scope{value, outer});
}

template <auto Member> struct walk_over<nested<Member>> {
    using item = nested<Member>;
    static constexpr bool get(auto& object, auto& trace, const auto& here) {
        trace.template enter<item>();
        if (!walk_get_message<typename item::value_type>(emplace_in<Member>(object), trace, here)) return false;
        trace.leave();
        return true;
    }
    static constexpr bool put(const auto& object, auto& trace, const auto& here) {
        trace.template enter<item>();
        if (!walk_put_message<typename item::value_type>(value_of<Member>(object), trace, here)) return false;
        trace.leave();
        return true;
    }
};

template <class Carrier, class... Fields>
struct walk_over<bit_fields<Carrier, Fields...>> : walk_over_whole<bit_fields<Carrier, Fields...>> {
    using item = bit_fields<Carrier, Fields...>;
    // Names the bit-field with a value that does not fit, not the whole integer.
    static constexpr bool put(const auto& object, auto& trace, const auto&) {
        std::string_view name = item_label<item>();
        static_cast<void>((... || (!Fields::fits(object) && (name = item_label<Fields>(), true))));
        trace.reach(name, item::max_size);
        std::array<std::byte, item::max_size> out{};
        if (!trace.passes(item::put(object, out.data()))) return false;
        trace.advance(out.size());
        return pass_values<item>(object, trace);
    }
};

/// Over the elements of a list or an array.
template <class Item, bool Raw>
constexpr bool walk_get_elements(std::size_t size, auto& scratch, auto& trace, const auto& here) {
    trace.template enter<Item>();
    for (std::size_t i = 0; i != size; ++i) {
        trace.element(i);
        scratch = {};
        if constexpr (Item::of_records) {
            if (!walk_get_message<typename Item::value_type>(scratch, trace, here)) return false;
        } else {
            using used = wire::codec_in_mode<typename Item::element_type::codec_type, Raw>;
            if (!trace.reach(trace.innermost(), used::size)) return false;
            if (!trace.passes(used::load(trace.at(), scratch))) return false;
            trace.advance(used::size);
            trace.template passed_element<Item>(scratch);
            if (!pass_value<typename Item::element_type::codec_type>(scratch, trace)) return false;
        }
    }
    trace.leave();
    return true;
}
template <class Item, bool Raw> constexpr bool walk_put_elements(const auto& elements, auto& trace, const auto& here) {
    trace.template enter<Item>();
    for (std::size_t i = 0; i != elements.size(); ++i) {
        trace.element(i);
        if constexpr (Item::of_records) {
            if (!walk_put_message<typename Item::value_type>(elements[i], trace, here)) return false;
        } else {
            using used = wire::codec_in_mode<typename Item::element_type::codec_type, Raw>;
            trace.reach(trace.innermost(), used::size);
            std::array<std::byte, used::size> out{};
            if (!trace.passes(used::store(out.data(), elements[i]))) return false;
            if (!pass_value<typename Item::element_type::codec_type>(elements[i], trace)) return false;
            trace.advance(used::size);
        }
    }
    trace.leave();
    return true;
}
/// One element of the list or the array, as `object` holds it.
template <auto Member, class Object>
using element_in =
    typename list_traits<std::remove_cvref_t<decltype(value_of<Member>(std::declval<Object&>()))>>::value_type;

template <auto Member, class Element> struct walk_over<array<Member, Element>> {
    using item = array<Member, Element>;
    template <class Object> static constexpr bool get(Object&, auto& trace, const auto& here) {
        element_in<Member, Object> scratch{};
        return walk_get_elements<item, raw_object<Object>>(item::length, scratch, trace, here);
    }
    template <class Object> static constexpr bool put(const Object& object, auto& trace, const auto& here) {
        return walk_put_elements<item, raw_object<Object>>(value_of<Member>(object), trace, here);
    }
};

/// Over a count. One of no bytes is a member elsewhere.
template <class Count> constexpr bool walk_get_count(std::size_t& elements, auto& trace, const auto& here) {
    if constexpr (Count::prefix_size != 0) {
        if (!trace.reach(item_label<Count>(), Count::prefix_size)) return false;
    }
    in_cursor c{trace.at(), trace.remaining() - Count::prefix_size};
    if (!Count::get(elements, c, here)) return trace.fail(c.error());
    if constexpr (Count::prefix_size != 0) {
        trace.advance(Count::prefix_size);
        trace.template passed_number<Count::prefix_size>(item_label<Count>(), elements);
    }
    return pass_value<Count>(elements, trace);
}
template <class Count> constexpr bool walk_put_count(std::size_t elements, auto& trace, const auto& here) {
    if constexpr (Count::prefix_size != 0) trace.reach(item_label<Count>(), Count::prefix_size);
    std::array<std::byte, Count::prefix_size> out{};
    if (!trace.passes(Count::put(elements, {out.data(), errc::ok}, here).error)) return false;
    trace.advance(Count::prefix_size);
    return pass_value<Count>(elements, trace);
}

template <auto Member, class Count, class Element> struct walk_over<repeated<Member, Count, Element>> {
    using item = repeated<Member, Count, Element>;
    template <class Object> static constexpr bool get(Object&, auto& trace, const auto& here) {
        std::size_t size{};
        if (!walk_get_count<Count>(size, trace, here)) return false;
        if constexpr (!item::traits::elsewhere) {
            if (size > item::traits::capacity && !trace.passes(errc::count_above_capacity)) return false;
        }
        element_in<Member, Object> scratch{};
        return walk_get_elements<item, raw_object<Object>>(size, scratch, trace, here);
    }
    template <class Object> static constexpr bool put(const Object& object, auto& trace, const auto& here) {
        const auto& elements = value_of<Member>(object);
        return walk_put_count<Count>(elements.size(), trace, here) &&
               walk_put_elements<item, raw_object<Object>>(elements, trace, here);
    }
};

template <auto Member, auto Children, std::size_t MaxDepth> struct walk_over<tree<Member, Children, MaxDepth>> {
    using item = tree<Member, Children, MaxDepth>;
    template <class Object> static constexpr bool get(Object&, auto& trace, const auto& here) {
        tree_walk<MaxDepth> levels;
        trace.template enter<item>();
        for (std::size_t i = 0; i == 0 || !levels.complete(); ++i) {
            trace.element(i);
            element_in<Member, Object> one{};
            if (!walk_get_message<typename item::node>(one, trace, here)) return false;
            if (!levels.pass(item::children(one))) return trace.fail(errc::too_deep);
        }
        trace.leave();
        return true;
    }
    static constexpr bool put(const auto& object, auto& trace, const auto& here) {
        const auto& nodes = member_of<Member>(object);
        trace.template enter<item>();
        const errc error = item::for_each_node(nodes, [&](std::size_t i, const auto& one) {
            trace.element(i);
            if (!walk_put_message<typename item::node>(one, trace, here)) return trace.error();
            if (i + 1 != nodes.size()) trace.element(i + 1); // refused before it is reached, if its number is wrong
            return errc::ok;
        });
        if (!trace.passes(error)) return false;
        trace.leave();
        return true;
    }
};

template <unknown_bits Unknown, class Carrier, class... Items>
struct walk_over<presence_group<Unknown, Carrier, Items...>> {
    using item = presence_group<Unknown, Carrier, Items...>;
    using mask_type = typename item::mask_type;

    static constexpr bool get(auto& object, auto& trace, const auto& here) {
        if (!trace.reach(presence_vector, Carrier::size)) return false;
        const mask_type mask = item::loaded(trace.at());
        trace.advance(Carrier::size);
        trace.template passed_number<Carrier::size>(presence_vector, mask);
        const bool unknown = (mask & ~item::known_bits) != 0;
        if (Unknown == unknown_bits::refused && unknown && !trace.passes(errc::unknown_presence_bit)) return false;
        item::set_flags(object, mask);
        std::size_t at = 0;
        if (!(get_if_present<Items>(object, mask, at, trace, here) && ...)) return false;
        if (Unknown == unknown_bits::tolerated && unknown) trace.advance(trace.remaining());
        trace.template passed<item>(object);
        return true;
    }
    static constexpr bool put(const auto& object, auto& trace, const auto& here) {
        trace.reach(presence_vector, Carrier::size);
        trace.advance(Carrier::size);
        return ((!item::template is_present<Items>(object) || walk_put<Items>(object, trace, here)) && ...);
    }

  private:
    template <class Item>
    static constexpr bool get_if_present(auto& object, mask_type mask, std::size_t& at, auto& trace, const auto& here) {
        if constexpr (takes_bit<Item>) {
            if ((mask >> at++ & 1u) == 0) return true;
        }
        return walk_get<Item>(object, trace, here);
    }
};

template <auto Flag, class Item> struct walk_over<gated_by<Flag, Item>> {
    static constexpr bool get(auto& object, auto& trace, const auto& here) {
        return !look_up<Flag>(here) || walk_get<Item>(object, trace, here);
    }
    static constexpr bool put(const auto& object, auto& trace, const auto& here) {
        const bool there = look_up<Flag>(here);
        if (there != member_of<Item::key>(object).has_value()) return trace.fail(errc::presence_mismatch);
        return !there || walk_put<Item>(object, trace, here);
    }
};

template <auto Member, class Selector, class... Cases> struct walk_over<selected<Member, Selector, Cases...>> {
    using item = selected<Member, Selector, Cases...>;

    static constexpr bool get(auto& object, auto& trace, const auto& here) {
        bool done = false;
        const bool known = item::with_case(Selector::value(here), [&]<class Case>() {
            using form = typename Case::form;
            if (!trace.reach(item::name(), case_form<form>::min_size)) return;
            if constexpr (message<form>) {
                auto& value = emplace_in<Member>(object);
                if constexpr (item::of_variant)
                    done = walk_get_message<form>(value.template emplace<form>(), trace, root_of(here));
                else
                    done = walk_get_message<form>(value, trace, root_of(here));
            } else {
                const in_cursor start{trace.at(), trace.remaining() - item::min_size};
                if (!trace.passes(item::get(object, start, here).error())) return;
                trace.advance(case_form<form>::max_size);
                trace.template passed<item>(object);
                done = true;
            }
        });
        if (known) return done;
        if (!trace.passes(errc::unknown_tag) || !trace.reach(item::name(), item::min_size)) return false;
        trace.advance(item::min_size);
        return true;
    }
    static constexpr bool put(const auto& object, auto& trace, const auto& here) {
        const auto& value = value_of<Member>(object);
        bool done = false;
        const bool known = item::with_case(Selector::value(here), [&]<class Case>() {
            using form = typename Case::form;
            if constexpr (message<form>) {
                if constexpr (item::of_variant) {
                    const auto* const one = std::get_if<form>(&value);
                    done = one ? walk_put_message<form>(*one, trace, root_of(here)) : trace.fail(errc::unknown_tag);
                } else {
                    done = walk_put_message<form>(value, trace, root_of(here));
                }
            } else {
                std::array<std::byte, case_form<form>::max_size> out{};
                if (!trace.passes(item::put(object, {out.data(), errc::ok}, here).error)) return;
                trace.advance(out.size());
                done = true;
            }
        });
        return known ? done : trace.fail(errc::unknown_tag);
    }
};

template <auto Member, class Count> struct walk_over<counted_run<Member, Count>> {
    using item = counted_run<Member, Count>;
    static constexpr bool get(auto& object, auto& trace, const auto& here) {
        const std::byte* const first = trace.at();
        const std::size_t remaining = trace.remaining();
        std::size_t size{};
        if (!walk_get_count<Count>(size, trace, here) || !trace.reach(item::name(), size)) return false;
        item::get(object, in_cursor{first, remaining - item::min_size}, here);
        trace.advance(size);
        trace.template passed<item>(object);
        return true;
    }
    static constexpr bool put(const auto& object, auto& trace, const auto& here) {
        const std::size_t size = value_of<Member>(object).size();
        if (!walk_put_count<Count>(size, trace, here)) return false;
        trace.advance(size);
        return true;
    }
};

template <auto Member, class Tag> struct walk_over<variant<Member, Tag>> {
    using item = variant<Member, Tag>;
    using alternatives = typename item::alternatives;
    static constexpr std::string_view index_name = "index";

    static constexpr bool get(auto& object, auto& trace, const auto& here) {
        trace.template enter<item>();
        if (!trace.reach(index_name, Tag::size)) return false;
        const std::size_t index = item::index_at(trace.at());
        bool done = false;
        const bool known = alternatives::with(index, [&]<std::size_t I, class Alternative>() {
            trace.advance(Tag::size);
            trace.template passed_number<Tag::size>(index_name, index);
            [[maybe_unused]] auto& value = emplace_in<Member>(object).template emplace<I>();
            if constexpr (message<Alternative>)
                done = walk_get_message<Alternative>(value, trace, root_of(here));
            else
                done = true;
        });
        if (!known) return trace.fail(errc::unknown_tag);
        if (!done) return false;
        trace.leave();
        return true;
    }
    static constexpr bool put(const auto& object, auto& trace, const auto& here) {
        const auto& value = value_of<Member>(object);
        trace.template enter<item>();
        trace.reach(index_name, Tag::size);
        trace.advance(Tag::size);
        bool done = false;
        alternatives::with(value.index(), [&]<std::size_t I, class Alternative>() {
            if constexpr (message<Alternative>)
                done = walk_put_message<Alternative>(*std::get_if<I>(&value), trace, root_of(here));
            else
                done = true;
        });
        if (!done) return false;
        trace.leave();
        return true;
    }
};

template <auto Member, class Count> struct walk_over<embedded<Member, Count>> {
    using item = embedded<Member, Count>;
    static constexpr bool get(auto& object, auto& trace, const auto& here) {
        std::size_t size{};
        if (!walk_get_count<Count>(size, trace, here) || !trace.reach(item::name(), size)) return false;
        emplace_in<Member>(object) = embedded_message{std::span{trace.at(), size}};
        trace.advance(size);
        trace.template passed<item>(object);
        return true;
    }
    // A longer embedded message, which no packet carries, is not put: its own diagnose explains why it does not encode.
    static constexpr std::size_t most_of_embedded = 4096;
    static constexpr bool put(const auto& object, auto& trace, const auto& here) {
        const embedded_message& inner = value_of<Member>(object);
        if (!walk_put_count<Count>(inner.size(), trace, here)) return false;
        trace.reach(item::name(), inner.size());
        if (inner.size() <= most_of_embedded) {
            std::array<std::byte, most_of_embedded> out{};
            if (!trace.passes(inner.put(out.data()).error)) return false;
        }
        trace.advance(inner.size());
        return pass_values<item>(object, trace);
    }
};

template <auto Member> struct walk_over<terminated_run<Member>> : walk_over_whole<terminated_run<Member>> {
    using item = terminated_run<Member>;
    static constexpr bool put(const auto& object, auto& trace, const auto&) {
        const auto& value = value_of<Member>(object);
        if (!item::legal(value)) return trace.fail(errc::out_of_range);
        trace.advance(value.size() + 1);
        return true;
    }
};

} // namespace detail

/// Decodes the bytes of `trace` into `value`, part by part. Elements of lists are not kept. False where it fails.
template <message T> constexpr bool decode_traced(T& value, auto& trace) {
    return detail::walk_get_message<T>(value, trace, discarding_root{});
}
/// Encodes `value` part by part, into no buffer. False where it fails.
template <message T> constexpr bool encode_traced(const T& value, auto& trace) {
    return detail::walk_put_message<T>(value, trace, plain_root{});
}

} // namespace jauscat::wire
