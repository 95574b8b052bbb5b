// A view of any bytes reads what decode reads.
#include "support/messages.hpp"
#include <jauscat/wire/wire.hpp>

#include <bit>

using namespace fuzz;
namespace wire = jauscat::wire;

namespace {

template <class T> inline constexpr bool is_view = false;
template <class T> inline constexpr bool is_view<wire::view<T>> = true;

template <class T> void for_keys(auto&& call) {
    [&]<auto... Members>(wire::key_list<Members...>) { (call.template operator()<Members>(), ...); }
    (typename wire::layout_of<T>::keys{});
}

template <bool Raw, class T> void compare_all(const wire::view<T>& view, const auto& object);

/// `read` came from a view; `member` is the same field of a message or of a raw.
template <bool Raw, class Read, class Member> void compare(const Read& read, const Member& member) {
    if constexpr (requires { member.has_value(); }) {
        check(read.has_value() == member.has_value(), "a view and decode see the same fields");
        if (member) compare<Raw>(*read, *member);
    } else if constexpr (requires { read.has_value(); }) {
        check(read.has_value(), "a view reads every value that decodes");
        compare<Raw>(*read, member);
    } else if constexpr (is_view<Read>) {
        compare_all<Raw>(read, member);
    } else if constexpr (std::floating_point<Read>) { // NaN is equal here
        const auto same = static_cast<Member>(read);
        check(std::bit_cast<std::array<std::byte, sizeof(Member)>>(same) ==
                  std::bit_cast<std::array<std::byte, sizeof(Member)>>(member),
              "a view reads the value that decode reads");
    } else {
        check(read == member, "a view reads the value that decode reads");
    }
}
template <bool Raw, class T> void compare_all(const wire::view<T>& view, const auto& object) {
    for_keys<T>([&]<auto Member>() {
        if constexpr (Raw)
            compare<Raw>(view.template get_raw<Member>(), wire::member_of<Member>(object));
        else
            compare<Raw>(view.template get<Member>(), wire::member_of<Member>(object));
    });
}

/// Fields that are there, but whose raw value stands for nothing.
template <class T> std::size_t illegal_values(const wire::view<T>& view) {
    std::size_t count = 0;
    const auto add = [&]<class Real>(const Real& real, bool there) {
        if constexpr (is_view<Real>)
            count += illegal_values(real);
        else if constexpr (requires { real.has_value(); }) {
            if constexpr (is_view<typename Real::value_type>)
                count += real ? illegal_values(*real) : 0;
            else
                count += there && !real;
        }
    };
    for_keys<T>([&]<auto Member>() {
        const auto raw = view.template get_raw<Member>();
        bool there = true;
        if constexpr (requires { raw.has_value(); }) there = raw.has_value();
        add(view.template get<Member>(), there);
    });
    return count;
}

template <class T> void check_view(std::span<const std::byte> body) {
    T message{};
    wire::raw<T> raw{};
    const bool decoded = static_cast<bool>(wire::decode(message, body));
    const wire::view<T> view{body};
    check(view.error() == wire::decode(raw, body).error(), "a view checks the structure as the raw's decode does");
    if (!view) return;
    compare_all<true>(view, raw);
    if (decoded) compare_all<false>(view, message);
    check(decoded == (illegal_values(view) == 0), "decode refuses a complete body only for a value that is illegal");
}

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    with_body(input, []<class T>(std::span<const std::byte> body) { check_view<T>(body); });
}
