// A view of any bytes reads what decode reads.
#include "support/messages.hpp"
#include <jauscat/wire/wire.hpp>

#include <bit>
#include <variant>

using namespace fuzz;
namespace wire = jauscat::wire;

namespace {

template <class T> inline constexpr bool is_view = false;
template <class T, class Outer> inline constexpr bool is_view<wire::view<T, Outer>> = true;
template <class T> inline constexpr bool is_list_view = false;
template <class Item, class Outer> inline constexpr bool is_list_view<wire::list_view<Item, Outer>> = true;
template <class T> inline constexpr bool is_variant = false;
template <class... T> inline constexpr bool is_variant<std::variant<T...>> = true;

template <class T> struct viewed;
template <class T, class Outer> struct viewed<wire::view<T, Outer>> {
    using type = T;
};

void for_members(const auto& view, auto&& call) {
    [&]<auto... Members>(wire::key_list<Members...>) {
        (call.template operator()<Members>(), ...);
    }(typename wire::layout_of<typename viewed<std::remove_cvref_t<decltype(view)>>::type>::keys{});
}

template <bool Raw> void compare_all(const auto& view, const auto& object);

/// `read` came from a view; `member` is the same of a message or of a raw.
template <bool Raw, class Read, class Member> void compare(const Read& read, const Member& member) {
    if constexpr (requires { member.has_value(); }) {
        check(read.has_value() == member.has_value(), "a view and decode see the same fields");
        if (member) compare<Raw>(*read, *member);
    } else if constexpr (requires { read.has_value(); }) {
        // Allowed: a view has no integers for scaled elements of a list and scaled cases.
        if constexpr (!(Raw && std::floating_point<typename Read::value_type> && std::integral<Member>)) {
            check(read.has_value(), "a view reads every value that decodes");
            compare<Raw>(*read, member);
        }
    } else if constexpr (is_view<Read>) {
        compare_all<Raw>(read, member);
    } else if constexpr (is_list_view<Read>) {
        check(read.size() == member.size(), "a view and decode count the same elements");
        auto element = member.begin();
        for (const auto& one : read) compare<Raw>(one, *element++);
    } else if constexpr (is_variant<Read>) {
        check(read.index() == member.index(), "a view and decode see the same type");
        std::visit(
            [&]<class Value>(const Value& value) {
                if (const auto* other = std::get_if<Value>(&member)) compare<Raw>(value, *other);
            },
            read);
    } else if constexpr (std::floating_point<Read>) { // NaN is equal here
        const auto same = static_cast<Member>(read);
        check(std::bit_cast<std::array<std::byte, sizeof(Member)>>(same) ==
                  std::bit_cast<std::array<std::byte, sizeof(Member)>>(member),
              "a view reads the value that decode reads");
    } else {
        check(read == member, "a view reads the value that decode reads");
    }
}
template <bool Raw> void compare_all(const auto& view, const auto& object) {
    for_members(view, [&]<auto Member>() {
        if constexpr (Raw)
            compare<Raw>(view.template get_raw<Member>(), wire::member_of<Member>(object));
        else
            compare<Raw>(view.template get<Member>(), wire::member_of<Member>(object));
    });
}

/// Fields that are there, but whose raw value stands for nothing. `read` came from a view.
template <class Read> std::size_t illegal_values(const Read& read, bool there = true) {
    std::size_t count = 0;
    if constexpr (is_view<Read>) {
        for_members(read, [&]<auto Member>() {
            bool has_raw = true;
            if constexpr (wire::is_optional_member<Member>) has_raw = read.template get_raw<Member>().has_value();
            count += illegal_values(read.template get<Member>(), has_raw);
        });
    } else if constexpr (is_list_view<Read>) {
        for (const auto& element : read) count += illegal_values(element);
    } else if constexpr (requires { read.has_value(); }) {
        count = read ? illegal_values(*read) : std::size_t{there};
    }
    return count;
}

template <class T> void check_view(std::span<const std::byte> body) {
    wire::arena& memory = fresh_arena();
    T message{};
    wire::raw<T> raw{};
    const wire::errc decoded = wire::decode(message, body, memory).error();
    const wire::errc raw_decoded = wire::decode(raw, body, memory).error();
    const auto is_of_memory = [](wire::errc error) {
        return error == wire::errc::arena_full || error == wire::errc::count_above_capacity;
    };
    if (is_of_memory(decoded) || is_of_memory(raw_decoded)) return; // a view needs none
    const wire::view<T> view{body};
    check(view.error() == raw_decoded, "a view checks the structure as the raw's decode does");
    if (!view) return;
    compare_all<true>(view, raw);
    if (decoded == wire::errc::ok) compare_all<false>(view, message);
    check((decoded == wire::errc::ok) == (illegal_values(view) == 0),
          "decode refuses a complete body only for a value that is illegal");
}

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    with_body(input, one_of_each_kind{}, []<class T>(std::span<const std::byte> body) { check_view<T>(body); });
}
