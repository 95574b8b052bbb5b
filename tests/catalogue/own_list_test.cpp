// Catalogues of messages of one's own, and several together.
#include "support/catch.hpp"
#include <jauscat/catalogue/of.hpp>
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/schema/jaus/platform.hpp>

namespace own {

struct blink {
    std::uint8_t times{};
};
struct blinked {
    std::uint16_t times{};
};
struct other_effort {
    std::uint8_t effort{};
};

} // namespace own

template <> struct jauscat::wire::schema<own::blink> {
    using type = layout<field<&own::blink::times, u8>>;
    static constexpr std::uint16_t command_code = 0xD001;
};
template <> struct jauscat::wire::schema<own::blinked> {
    using type = layout<field<&own::blinked::times, u16le>>;
    static constexpr std::uint16_t command_code = 0xD002;
};
template <> struct jauscat::wire::schema<own::other_effort> {
    using type = layout<field<&own::other_effort::effort, u8>>;
    static constexpr std::uint16_t command_code = 0x0405;
};

namespace {

namespace catalogue = jauscat::catalogue;
namespace jaus = jauscat::jaus;

} // namespace

TEST_CASE("a list of message types is a catalogue, in the order of their codes") {
    const auto& mine = catalogue::of<jaus::message_list<own::blinked, own::blink>>();
    REQUIRE(mine.size() == 2);
    CHECK(mine.begin()->name() == "blink");
    CHECK(mine.find(std::uint16_t{0xD002})->name() == "blinked");
    CHECK(mine.find(std::uint16_t{0xD000}) == nullptr);
    CHECK(&catalogue::of<jaus::message_list<own::blinked, own::blink>>() == &mine);
    const auto message = mine.from_text("blink times=3");
    REQUIRE(message);
    CHECK(message->as<own::blink>()->times == 3);
    CHECK(catalogue::of<jaus::message_list<>>().size() == 0);
}

TEST_CASE("catalogues are put together, and of two messages with one code the earlier one counts") {
    const auto& mine = catalogue::of<jaus::message_list<own::blink, own::other_effort>>();
    const catalogue::list standard_first{catalogue::ra_3_3(), mine};
    CHECK(standard_first.size() == catalogue::ra_3_3().size() + 1);
    CHECK(standard_first.find(std::uint16_t{0x0405})->name() == "set_wrench_effort");
    CHECK((*standard_first.find("blink"))->command_code() == 0xD001);
    CHECK((*standard_first.find("set_wrench_effort"))->command_code() == 0x0405);

    const catalogue::list own_first{mine, catalogue::ra_3_3()};
    CHECK(own_first.find(std::uint16_t{0x0405})->name() == "other_effort");
    CHECK(!own_first.find("set_wrench_effort"));
}

TEST_CASE("messages of a list that has ended are still there") {
    const auto message = catalogue::list{catalogue::of<jaus::message_list<own::blink>>()}.from_text("blink times=3");
    REQUIRE(message);
    CHECK(message->type().name() == "blink");
    CHECK(message->to_text() == "  times = 3\n");
}
