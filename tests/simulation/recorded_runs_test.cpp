// What is sent and told in recorded runs has not changed unnoticed.
#include "simulation/recorded_runs.hpp"
#include "simulation/story.hpp"
#include "support/catch.hpp"
#include "support/paths.hpp"

#include <array>
#include <chrono>
#include <span>
#include <thread>

using namespace simulation;
using namespace std::chrono_literals;

// Motors compute in floating point: where a compiler fuses multiplications and additions, digests are others.
#if defined(__x86_64__) && !defined(__FMA__)
TEST_CASE("in recorded runs all programs send and tell what they did when they were recorded") {
    const auto recorded = read_recorded_runs(support::source_file("tests/simulation/recorded_runs.txt"));
    const auto are = renewed(recorded, std::thread::hardware_concurrency());
    REQUIRE(are.size() > 100);
    for (std::size_t i = 0; i != are.size(); ++i) {
        INFO("if this is meant, renew: simulate --renew tests/simulation/recorded_runs.txt. To see where they differ, "
             "compare the output of simulate --trace --system SYSTEM --seed SEED --seconds SECONDS with that of the "
             "commit before");
        CHECK(line_of(are[i]) == line_of(recorded[i]));
        CHECK_FALSE(are[i].breaks);
    }
}
#endif

TEST_CASE("a run with another byte, word or cause has another digest") {
    const auto digest_of = [](auto&& tell) {
        story one;
        tell(one);
        return one.digest();
    };
    const std::array<std::byte, 9> frame{std::byte{1}};
    auto other = frame;
    other.back() = std::byte{1};
    const auto sent = [](const char* what, std::chrono::nanoseconds at, std::span<const std::byte> content) {
        return [=](story& one) { one.mix(at, what, content); };
    };
    const auto expected = digest_of(sent("a frame", 1ns, frame));
    CHECK(digest_of(sent("a frame", 1ns, frame)) == expected);
    CHECK(digest_of(sent("a frame", 1ns, other)) != expected);
    CHECK(digest_of(sent("a frame", 2ns, frame)) != expected);
    CHECK(digest_of(sent("no frame", 1ns, frame)) != expected);
    CHECK(digest_of(sent("a frame", 1ns, std::span{frame}.first(8))) != expected);
    const auto told = [](const char* why) { return [=](story& one) { one.tell({.why = why}); }; };
    CHECK(digest_of(told("its slave is lost")) != digest_of(told("its slave is there")));
}
