// Text is the same in every locale, and what was printed is read again.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include "support/decimal_comma.hpp"
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/print.hpp>

#include <cstdio>
#include <iostream>

namespace {

namespace jaus = jauscat::jaus;
namespace text = jauscat::text;
namespace wire = jauscat::wire;

std::string wrong_with(const char* line) {
    std::array<std::byte, 64> lists{};
    wire::arena memory{lists};
    jaus::set_travel_speed message{};
    return text::from_text(line, message, memory).error().message;
}

} // namespace

TEST_CASE("text has decimal points where the locale uses commas") {
    const support::decimal_comma locale;
    if (!locale) {
        std::cout << "SKIPPED: no locale with a decimal comma, and no localedef (package locales)\n";
        return;
    }
    std::array<char, 8> printed{};
    std::snprintf(printed.data(), printed.size(), "%.1f", 2.5);
    REQUIRE(std::string{printed.data()} == "2,5");

    const jaus::set_wrench_effort message{.propulsive_linear_effort_x = 12.5, .resistive_linear_effort_x = 50};
    CHECK(text::to_text(message, 0) == "presence_vector = 0x0041\n"
                                       "propulsive_linear_effort_x = 12.5 % (raw 4096)\n"
                                       "resistive_linear_effort_x = 50 % (raw 128)\n");
    std::array<std::byte, 5> bytes{};
    REQUIRE(wire::encode(message, bytes)->size() == bytes.size());
    CHECK(text::annotate<jaus::set_wrench_effort>(bytes).find("= 12.500381 %") != std::string::npos);
    CHECK(wrong_with("desired_speed=2.5") == "");
    CHECK(wrong_with("desired_speed=\"2.5 m/s\"") == "");
    CHECK(wrong_with("desired_speed=2,5") == "desired_speed is '2,5', which is no number");
}
