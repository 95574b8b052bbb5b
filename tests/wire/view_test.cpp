// Single fields read out of bytes.
#include "both_ways.hpp"
#include "samples.hpp"
#include "support/random_message.hpp"
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/schema/jaus/platform.hpp>

using samples::envelope;
using samples::flags;
using samples::mixed;
using samples::point;
using wire::errc;

namespace {

template <wire::message T> void require_agreement(const wire::view<T>& view, const T& real, const wire::raw<T>& raw);

/// What a view read of one member (`seen`, and `seen_raw` as an integer) equals what was decoded.
// A function of its own: clang 19 crashes when a generic lambda asks these questions.
template <class Member>
void require_same(const auto& seen, const auto& seen_raw, const Member& member, const auto& integer) {
    if constexpr (wire::message<Member>) {
        require_agreement(seen, member, integer);
    } else if constexpr (requires { requires wire::message<typename Member::value_type>; }) {
        REQUIRE(seen.has_value() == member.has_value());
        if (seen) require_agreement(*seen, *member, *integer);
    } else {
        REQUIRE(seen == member); // a required scaled member is compared with a std::optional that must hold it
        REQUIRE(seen_raw == integer);
    }
}

/// What `view` reads of each member equals what `real` and `raw`, decoded from the same bytes, hold.
template <wire::message T> void require_agreement(const wire::view<T>& view, const T& real, const wire::raw<T>& raw) {
    wire::visit(real, [&]<class Item>(Item, const auto& member) {
        require_same(view.template get<Item::key>(), view.template get_raw<Item::key>(), member,
                     raw.template get<Item::key>());
    });
}

} // namespace

TEST_CASE("a view reads fields at their offsets") {
    both_ways([] {
        const auto in = bytes(0x01, 0x02, 0x05, 7, 0xFF, 0x34, 0x12, 5, 0, 0, 0, 0xEE);
        const wire::view<envelope> view{in};
        const auto content = view.get<&envelope::content>();
        return view && view.bytes().size() == 12 && view.get<&envelope::kind>() == 0x0102 &&
               content.get<&mixed::number>() == 7 && content.get<&mixed::level>() == 100.0 &&
               content.get_raw<&mixed::level>() == std::uint8_t{255} && content.get<&mixed::required>() == 0x1234 &&
               !content.get<&mixed::place>() && content.get<&mixed::id>() == 5u && view.get<&envelope::tail>() == 0xEE;
    });
}

TEST_CASE("a view reads bit-fields") {
    both_ways([] {
        const auto in = bytes(0x23, 0xF9); // reserved bits set
        const wire::view<flags> view{in};
        return view && view.get<&flags::length>() == 0x123 &&
               view.get<&flags::shade>() == static_cast<samples::colour>(3) && view.get<&flags::circulating>() &&
               view.get_raw<&flags::length>() == 0x123;
    });
}

TEST_CASE("an illegal raw value is empty as a real value and readable as a raw one") {
    both_ways([] {
        const auto in = bytes(0x00, 0x80, 0xFF);
        const wire::view<point> view{in};
        return view && !view.get<&point::x>() && view.get_raw<&point::x>() == -32768 && view.get<&point::y>() == 100.0;
    });
}

TEST_CASE("a view refuses bytes of another structure") {
    both_ways([] {
        const auto in = bytes(0x04, 7, 0, 0, 1, 2, 3);
        return !wire::view<mixed>{in} && wire::view<mixed>{in}.error() == errc::truncated;
    });
    both_ways([] {
        const auto in = bytes(0x00, 7, 0, 0, 1);
        return wire::view<mixed>{in}.error() == errc::trailing_bytes;
    });
    both_ways([] {
        const auto in = bytes(0x08, 7, 0, 0);
        return wire::view<mixed>{in}.error() == errc::unknown_presence_bit;
    });
    both_ways([] { return wire::view<mixed>{std::span<const std::byte>{}}.error() == errc::truncated; });
    both_ways([] { return static_cast<bool>(wire::view<samples::empty>{std::span<const std::byte>{}}); });
}

TEMPLATE_TEST_CASE("a view and decode agree on random bytes", "", samples::scalars, flags, point, mixed, envelope,
                   samples::open, samples::fine, jauscat::jaus::header, jauscat::jaus::set_wrench_effort,
                   jauscat::jaus::report_global_pose) {
    using T = TestType;
    support::generator random{8};
    std::array<std::byte, wire::max_size<T> + 2> buffer{};
    int agreed = 0;
    for (int round = 0; round != 4000; ++round) {
        // Half of them well formed, half noise.
        std::size_t size = support::below(random, buffer.size() + 1);
        if (support::chance(random, 0.5))
            size = wire::encode(support::random_message<T>(random), buffer)->size();
        else
            support::fill(random, buffer);
        const auto in = std::span<const std::byte>{buffer}.first(size);
        T real{};
        wire::raw<T> raw{};
        const auto used = wire::decode(real, in);
        const auto used_raw = wire::decode(raw, in);
        const wire::view<T> view{in};
        REQUIRE(view.error() == used_raw.error());
        if (used) {
            require_agreement(view, real, raw);
            ++agreed;
        } else {
            REQUIRE((used.error() == view.error() || used.error() == errc::out_of_range));
        }
    }
    REQUIRE(agreed > 1000);
}
