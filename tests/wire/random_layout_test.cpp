// Layouts made at random, as the compiler accepts them: what is encoded comes back, and nothing less is accepted.
#include "support/catch.hpp"
#include <jauscat/wire/wire.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace wire = jauscat::wire;

/// Numbers at compile time.
struct dice {
    std::uint32_t state;
    constexpr explicit dice(std::uint32_t seed) : state{seed * 2'654'435'761U + 1} {}
    constexpr unsigned operator()(unsigned sides) {
        state = state * 1'664'525U + 1'013'904'223U;
        return (state >> 16U) % sides;
    }
};

constexpr std::size_t item_count = 9;
constexpr std::array<std::size_t, item_count> shuffled(unsigned seed) {
    std::array<std::size_t, item_count> order{};
    for (std::size_t i = 0; i != item_count; ++i) order[i] = i;
    dice roll{seed};
    for (std::size_t i = item_count - 1; i != 0; --i) std::swap(order[i], order[roll(static_cast<unsigned>(i + 1))]);
    return order;
}
constexpr unsigned variant_of(unsigned seed, unsigned item) { return dice{seed * 31 + item}(3); }

struct share {
    static constexpr double min = -1, max = 1;
};
struct pair_of_numbers {
    std::uint8_t first{};
    std::int16_t second{};
    friend constexpr bool operator==(const pair_of_numbers&, const pair_of_numbers&) = default;
    struct schema : wire::items {
        using T = pair_of_numbers;
        using type = layout<field<&T::first, u8>, field<&T::second, i16be>>;
    };
};

template <unsigned Seed> struct sample {
    std::uint8_t count{}, tag{};
    std::uint16_t number{};
    double level{};
    std::optional<std::uint16_t> extra{};
    std::optional<double> other{};
    wire::inline_list<std::uint8_t, 5> items{};
    std::uint32_t value{};
    std::string_view text{};
    pair_of_numbers inner{};

    struct schema;
};

struct parts : wire::items {
    template <unsigned Kind, class... Cases>
    using one_of = std::tuple_element_t<Kind % sizeof...(Cases), std::tuple<Cases...>>;

    template <unsigned Seed> struct of {
        using T = sample<Seed>;
        static constexpr unsigned kind(unsigned item) { return variant_of(Seed, item); }
        using all =
            std::tuple<field<&T::count, u8>, field<&T::tag, u8>,
                       one_of<kind(2), field<&T::number, u16le>, field<&T::number, u16be>>,
                       one_of<kind(3), field<&T::level, scaled<i16le, share>>, field<&T::level, scaled<u8, share>>,
                              field<&T::level, f64le>>,
                       one_of<kind(4), presence<u8, field<&T::extra, u16le>, field<&T::other, scaled<u8, share>>>,
                              presence<u16le, field<&T::other, scaled<u16le, share>>, field<&T::extra, u16be>>>,
                       one_of<kind(5), repeated<&T::items, counted_by<&T::count>, element<"item", u8>>,
                              repeated<&T::items, wire::count<"items", u8>, element<"item", u8>>>,
                       one_of<kind(6), selected<&T::value, by<&T::tag>, when<0, u8>, when<1, u32le>, when<2, u16be>>,
                              field<&T::value, u32be>>,
                       one_of<kind(7), string<&T::text, fixed<4>>, string<&T::text, wire::count<"length", u16le>>,
                              string<&T::text, zero_terminated>>,
                       nested<&T::inner>>;
        template <std::size_t Place> using item = std::tuple_element_t<shuffled(Seed)[Place], all>;
        template <class> struct made;
        template <std::size_t... Place> struct made<std::index_sequence<Place...>> {
            static constexpr bool is_accepted = wire::detail::all_refer_back<item<Place>...>();
            using type = layout<item<Place>...>;
        };
        using result = made<std::make_index_sequence<item_count>>;
        static constexpr bool counts_elsewhere = kind(5) % 2 == 0, is_tagged = kind(6) % 2 == 0;
    };
};
template <unsigned Seed> struct sample<Seed>::schema : wire::items {
    using type = typename parts::of<Seed>::result::type;
};

template <unsigned Seed> void comes_back(std::size_t& accepted) {
    if constexpr (parts::of<Seed>::result::is_accepted) {
        ++accepted;
        INFO("layout " << Seed);
        std::mt19937 random{Seed};
        constexpr std::array<std::string_view, 4> texts{"", "a", "abc", "abcd"};
        for (int round = 0; round != 200; ++round) {
            sample<Seed> sent{};
            REQUIRE(sent.items.resize(random() % 6));
            for (auto& one : sent.items) one = static_cast<std::uint8_t>(random());
            sent.count = static_cast<std::uint8_t>(parts::of<Seed>::counts_elsewhere ? sent.items.size() : random());
            sent.tag = static_cast<std::uint8_t>(parts::of<Seed>::is_tagged ? random() % 3 : random());
            sent.number = static_cast<std::uint16_t>(random());
            sent.level = random() % 2 == 0 ? -1 : 1; // exact in each of its forms
            if (random() % 2 == 0) sent.extra = static_cast<std::uint16_t>(random());
            if (random() % 2 == 0) sent.other = random() % 2 == 0 ? -1 : 1;
            constexpr std::array<std::uint32_t, 3> most{0xFF, 0xFFFFFFFF, 0xFFFF};
            sent.value = static_cast<std::uint32_t>(random()) & (parts::of<Seed>::is_tagged ? most[sent.tag] : most[1]);
            sent.text = texts[random() % texts.size()];
            sent.inner = {static_cast<std::uint8_t>(random()), static_cast<std::int16_t>(random())};

            std::vector<std::byte> bytes(wire::encoded_size(sent));
            const auto written = wire::encode(sent, bytes);
            REQUIRE(written);
            REQUIRE(written->size() == bytes.size());
            sample<Seed> received{};
            REQUIRE(wire::decode(received, bytes));
            const auto all = [](const sample<Seed>& m) {
                return std::tuple{m.count, m.tag, m.number, m.level, m.extra, m.other, m.value, m.text, m.inner};
            };
            REQUIRE(all(received) == all(sent));
            REQUIRE(std::ranges::equal(received.items, sent.items));
            // Encoded again they are the same bytes, and no shorter ones are a message.
            std::vector<std::byte> again(bytes.size());
            REQUIRE(wire::encode(received, again));
            REQUIRE(again == bytes);
            for (std::size_t size = 0; size != bytes.size(); ++size) {
                sample<Seed> part{};
                const auto shorter = std::span{bytes}.first(size);
                REQUIRE_FALSE(wire::decode(part, shorter));
            }
            const wire::view<sample<Seed>> seen{bytes};
            REQUIRE(seen);
            REQUIRE(seen.template get<&sample<Seed>::number>() == sent.number);
            REQUIRE(seen.template get<&sample<Seed>::inner>().template get<&pair_of_numbers::second>() ==
                    sent.inner.second);
        }
    }
}

} // namespace

TEST_CASE("messages of random layouts come back as they were encoded") {
    std::size_t accepted = 0;
    [&]<unsigned... Seed>(std::integer_sequence<unsigned, Seed...>) {
        (comes_back<Seed>(accepted), ...);
    }(std::make_integer_sequence<unsigned, 60>{});
    CHECK(accepted > 15);
    CHECK(accepted < 60); // in the others a count or a tag comes behind what it is for
}
