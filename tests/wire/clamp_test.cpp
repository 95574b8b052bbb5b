// Limiting scaled values.
#include "both_ways.hpp"
#include "samples.hpp"
#include "support/random_message.hpp"
#include <jauscat/schema/jaus/platform.hpp>

#include <cmath>
#include <limits>

using samples::envelope;
using samples::mixed;
using samples::point;
using wire::errc;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <wire::message T> constexpr T clamped(T value) {
    wire::clamp(value);
    return value;
}

} // namespace

TEST_CASE("clamp limits scaled values to their range") {
    both_ways([] { return clamped(point{.x = -101.0, .y = 1000.0}) == point{.x = -100.0, .y = 100.0}; });
    both_ways([] { return clamped(point{.x = infinity, .y = -infinity}) == point{.x = 100.0, .y = 0.0}; });
    both_ways([] { return clamped(point{.x = 12.5, .y = 50.0}) == point{.x = 12.5, .y = 50.0}; });
}

TEST_CASE("clamp reaches optional members and structures, and adds none") {
    both_ways([] {
        const envelope limited = clamped(
            envelope{.kind = 1,
                     .content = {.number = 2, .level = 200.0, .required = 3, .place = point{.x = -200.0, .y = 5.0}},
                     .tail = 4});
        return limited ==
               envelope{.kind = 1,
                        .content = {.number = 2, .level = 100.0, .required = 3, .place = point{.x = -100.0, .y = 5.0}},
                        .tail = 4};
    });
    both_ways([] {
        const mixed nothing{};
        return clamped(nothing) == nothing;
    });
}

TEST_CASE("clamp keeps NaN, which still does not encode") {
    both_ways([] {
        const point limited = clamped(point{.x = not_a_number});
        return limited.x != limited.x && encode_error(limited) == errc::out_of_range;
    });
}

TEMPLATE_TEST_CASE("a clamped value encodes unless it holds NaN", "", point, mixed, envelope,
                   jauscat::jaus::set_wrench_effort, jauscat::jaus::report_wrench_effort) {
    using T = TestType;
    support::generator random{9};
    int refused = 0, encoded = 0;
    for (int round = 0; round != 4000; ++round) {
        const T wild = support::random_message<T>(random, {.present = 0.7, .illegal = 0.2});
        bool has_nan = false;
        const auto look = [&has_nan](const auto& self, const auto& object) -> void {
            wire::visit(object, [&](auto, const auto& member) {
                const auto each = [&](const auto& value) {
                    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>)
                        has_nan = has_nan || std::isnan(value);
                    else if constexpr (wire::message<std::remove_cvref_t<decltype(value)>>)
                        self(self, value);
                };
                if constexpr (requires { *member; }) {
                    if (member) each(*member);
                } else {
                    each(member);
                }
            });
        };
        look(look, wild);
        refused += encode_error(wild) == errc::out_of_range;
        const auto error = encode_error(clamped(wild));
        REQUIRE(error == (has_nan ? errc::out_of_range : errc::ok));
        encoded += error == errc::ok;
    }
    REQUIRE(refused > 300);
    REQUIRE(encoded > 300);
}

namespace selected_samples {

struct level {
    double value{};
    friend constexpr bool operator==(const level&, const level&) = default;
};
struct inner {
    double chosen{}; // in the form that the outer structure selects
    std::array<level, 2> levels{};
    friend constexpr bool operator==(const inner&, const inner&) = default;
};
struct outer {
    std::uint8_t type{};
    double chosen{};
    std::variant<std::monostate, level> structure{};
    std::optional<level> present{};
    inner part{};
    wire::inline_list<level, 3> list{};
    friend constexpr bool operator==(const outer&, const outer&) = default;
};

} // namespace selected_samples

template <> struct jauscat::wire::schema<selected_samples::level> {
    using T = selected_samples::level;
    using type = layout<field<&T::value, scaled<i16le, samples::signed_percent>>>;
};
template <> struct jauscat::wire::schema<selected_samples::inner> {
    using T = selected_samples::inner;
    using type = layout<selected<&T::chosen, by<&selected_samples::outer::type>, when<1, scaled<u8, samples::percent>>,
                                 when<2, scaled<i16le, samples::signed_percent>>>,
                        array<&T::levels>>;
};
template <> struct jauscat::wire::schema<selected_samples::outer> {
    using T = selected_samples::outer;
    using type = layout<field<&T::type, u8>,
                        selected<&T::chosen, by<&T::type>, when<1, scaled<u8, samples::percent>>,
                                 when<2, scaled<i16le, samples::signed_percent>>>,
                        selected<&T::structure, by<&T::type>, when<1>, when<2, selected_samples::level>>,
                        presence<u8, nested<&T::present>>, nested<&T::part>, repeated<&T::list, count<"n", u8>>>;
};

TEST_CASE("clamp limits selected values to the range of their form, and what is in structures of every kind") {
    using selected_samples::outer;
    outer wild{.type = 2, .chosen = -300, .structure = selected_samples::level{300}, .present = {{300}}};
    wild.part = {.chosen = -300, .levels = {{{300}, {-300}}}};
    REQUIRE(wild.list.push_back({300}));
    outer expected{.type = 2, .chosen = -100, .structure = selected_samples::level{100}, .present = {{100}}};
    expected.part = {.chosen = -100, .levels = {{{100}, {-100}}}};
    REQUIRE(expected.list.push_back({100}));
    CHECK(encode_error(wild) == errc::out_of_range);
    CHECK(clamped(wild) == expected);
    CHECK(encode_error(clamped(wild)) == errc::ok);
    wild.type = 1;
    wild.structure = {};
    CHECK(clamped(wild).chosen == 0);
    CHECK(clamped(wild).part.chosen == 0);
    CHECK(encode_error(clamped(wild)) == errc::ok);
    wild.type = 9; // no case: it does not encode
    CHECK(clamped(wild).chosen == -300);
}
