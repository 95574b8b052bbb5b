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
