// Slaves that take an entry only while subindex 0 of its object is 0, and the master's way with them.
#include "ethercat/segmented_bench.hpp"

using namespace jauscat::ethercat;
using jauscat::test::counting;
using jauscat::test::segmented_bench;

namespace {

using bytes = std::vector<std::byte>;

// Objects in the TxPDO mapping area, behind the rule.
struct strict_bench : segmented_bench {
    explicit strict_bench(std::uint16_t mailbox_size = 256) : segmented_bench{mailbox_size, {.subindex_0_rule = true}} {
        objects.add(0x1AF5, 26, 28);
        objects.add(0x2000, 26, 28);
    }
};
constexpr master_error not_zero{.code = master_errc::sdo_abort, .abort = abort_code{0x06010003}};

} // namespace

TEST_CASE("a slave that requires subindex 0 to be cleared accepts a download that does so") {
    strict_bench b;
    const auto refused = b.download(0x1AF5, 26, counting(28));
    CHECK(refused == not_zero);
    CHECK(describe_reason(refused.error()) == describe(abort_code::subindex_0_not_zero));
    CHECK(b.objects.writes == 0);

    REQUIRE(b.download(0x1AF5, 26, counting(28), {.clear_subindex_0 = true}));
    CHECK(b.mail == std::vector<std::string>{
                        "0a 00 00 00 00 23 00 20 2f f5 1a 00 00 00 00 00",
                        "0a 00 00 00 00 23 00 30 60 f5 1a 00 00 00 00 00",
                        "26 00 00 00 00 33 00 20 21 f5 1a 1a 1c 00 00 00 01 02 03 04 05 06 07 08 09 0a 0b 0c 0d 0e "
                        "0f 10 11 12 13 14 15 16 17 18 19 1a 1b 1c",
                        "0a 00 00 00 00 33 00 30 60 f5 1a 1a 00 00 00 00",
                    });
    CHECK(b.objects.entries.at({0x1AF5, 26}).value == counting(28));
    // Subindex 0 stays 0, so that the next download needs no clearing; another object has its own.
    CHECK(b.download(0x1AF5, 26, counting(28, 2)));
    bytes count(1, std::byte{0xFF});
    REQUIRE(b.upload(count, 0x1AF5, 0));
    CHECK(count == bytes{std::byte{0}});
    b.objects.add(0x1AF6, 1, 28);
    CHECK(b.download(0x1AF6, 1, counting(28)) == not_zero);
}

TEST_CASE("clearing and segments can be combined") {
    strict_bench b{24};
    CHECK(b.download(0x1AF5, 26, counting(28)) == not_zero);
    CHECK(b.mail.size() == 2); // at the start, not after the last segment
    REQUIRE(b.download(0x1AF5, 26, counting(28), {.clear_subindex_0 = true}));
    CHECK(b.mail.size() == 2 + 6);
    CHECK(b.objects.entries.at({0x1AF5, 26}).value == counting(28));
}

TEST_CASE("a number in subindex 0, or power-on, makes a slave's entries fixed again") {
    strict_bench b;
    REQUIRE(b.download(0x1AF5, 0, bytes(1)));
    REQUIRE(b.download(0x1AF5, 26, counting(28)));
    REQUIRE(b.download(0x1AF5, 0, counting(1)));
    CHECK(b.download(0x1AF5, 26, counting(28)) == not_zero);
    CHECK(b.download(0x1AF5, 0, bytes(2)).error() ==
          master_error{.code = master_errc::sdo_abort, .abort = abort_code{0x06070010}});
    REQUIRE(b.download(0x1AF5, 0, bytes(1)));
    b.device.power_on();
    REQUIRE(b.link.run(b.master, bring_up{0, 0x1001}));
    CHECK(b.download(0x1AF5, 26, counting(28)) == not_zero);
}

TEST_CASE("the rule applies to mapping and assignment objects only") {
    strict_bench b;
    CHECK(b.download(0x2000, 26, counting(28)));
    for (const unsigned covered : {0x1600u, 0x17FFu, 0x1A00u, 0x1BFFu, 0x1C10u, 0x1C2Fu})
        CHECK(subindex_0_rule::covers(static_cast<std::uint16_t>(covered)));
    for (const unsigned free : {0u, 0x15FFu, 0x1800u, 0x19FFu, 0x1C00u, 0x1C0Fu, 0x1C30u, 0x6926u, 0xFFFFu})
        CHECK_FALSE(subindex_0_rule::covers(static_cast<std::uint16_t>(free)));
    subindex_0_rule rule;
    rule.set_entries(0x1BFF, 0);
    CHECK(rule.refusal(0x1BFF, 1) == abort_code::none);
    CHECK(rule.refusal(0x1C10, 1) == abort_code::subindex_0_not_zero);
    CHECK(rule.refusal(0x1A00, 1) == abort_code::subindex_0_not_zero);
    CHECK(rule.refusal(0x1A00, 0) == abort_code::none);
    CHECK(rule.refusal(0x2000, 1) == abort_code::none);
}

TEST_CASE("a slave without a subindex 0 to clear is distinguished from one that refuses the data") {
    segmented_bench b{256};
    b.objects.add(0x1AF5, 26, 28);
    const auto result = b.download(0x1AF5, 26, counting(28), {.clear_subindex_0 = true});
    CHECK(result == master_error{.code = master_errc::clear_refused, .abort = abort_code{0x06020000}});
    CHECK(describe_reason(result.error()) == "no such object in the dictionary");
    CHECK(b.mail.size() == 2);
    CHECK(b.objects.writes == 0);
    CHECK(b.download(0x1AF5, 26, counting(28)));
}

TEST_CASE("a download to subindex 0 itself clears nothing") {
    strict_bench b;
    REQUIRE(b.download(0x1AF5, 0, counting(1), {.clear_subindex_0 = true}));
    CHECK(b.mail.size() == 2);
    CHECK(b.mail.front() == "0a 00 00 00 00 13 00 20 2f f5 1a 00 01 00 00 00");
}
