// Packets that ask for a slave's dictionary, with emulated slaves that describe theirs: small mailboxes, bad wires.
#include "ethercat/described_objects.hpp"
#include "ethercat/packet_bench.hpp"
#include <jauscat/schema/ethercat/hilscher_info.hpp>

using namespace jauscat::ethercat;
using namespace jauscat::hilscher;
using jauscat::test::hex_of;
using bytes = std::vector<std::byte>;

namespace {

struct bench : jauscat::test::basic_packet_bench<jauscat::test::described_objects> {
    explicit bench(std::uint16_t mailbox) {
        add({.vendor = 1, .mailbox_out_size = mailbox, .mailbox_in_size = mailbox});
        REQUIRE(link.run(master, bring_up{0, 0x100}));
    }
    jauscat::test::confirmed list(packet_list_type type) {
        return ask(get_od_list_request{.ul_node_id = 0x100, .ul_list_type = type});
    }
    jauscat::test::confirmed object(std::uint32_t index) {
        return ask(get_object_description_request{.ul_node_id = 0x100, .ul_index = index});
    }
    jauscat::test::confirmed entry(std::uint32_t index, std::uint32_t subindex, std::uint32_t mask = 7) {
        return ask(get_entry_description_request{
            .ul_node_id = 0x100, .ul_index = index, .ul_sub_index = subindex, .ul_access_bit_mask = mask});
    }
};

constexpr const char* all_objects = "00010000 01000000 09000000 0010 0810 1810 001c 0020 0120 0220 0320 0030";
constexpr const char* mixture = "00010000 00300000 00000000 09000000 00000000 04000000 07000000 6d697874757265";
constexpr const char* part_1 = "00010000 00300000 01000000 07000000 05000000 03000000 3f000000 00000000 00000000"
                               " 00000000 04000000 70617274";

} // namespace

TEST_CASE("a slave's dictionary is read in packets at every mailbox size") {
    for (const auto mailbox : std::initializer_list<std::uint16_t>{24, 48, 256, 1486}) {
        CAPTURE(mailbox);
        bench b{mailbox};
        CHECK(b.list(packet_list_type::all).body == hex_of(all_objects));
        CHECK(b.list(packet_list_type::rx_pdo).body == hex_of("00010000 02000000 01000000 0020"));
        CHECK(b.list(packet_list_type::tx_pdo).body == hex_of("00010000 03000000 01000000 0120"));
        CHECK(b.list(packet_list_type::backup).body == hex_of("00010000 04000000 01000000 0220"));
        CHECK(b.list(packet_list_type::start_up).body == hex_of("00010000 05000000 01000000 0320"));
        CHECK(b.object(0x3000).body == hex_of(mixture));
        CHECK(b.entry(0x3000, 1).body == hex_of(part_1));
        CHECK(b.object(0x2FFF).status == 0xC0650031);
        CHECK(b.entry(0x3000, 5).status == 0xC065003A);
        CHECK(b.entry(0x2000, 0).body.substr(3 * 24, 3 * 12 - 1) == hex_of("7f000000 01000000 00000000"));
    }
}

TEST_CASE("over a link that loses, duplicates and delays frames a description is correct or an error") {
    bench b{48};
    b.link.faults = {.lose = 10, .duplicate = 5, .delay = 20};
    unsigned right = 0;
    const auto check = [&](const jauscat::test::confirmed& answer, const char* expected) {
        if (answer.status != 0) return;
        CHECK(answer.body == hex_of(expected));
        ++right;
    };
    for (unsigned round = 0; round != 200; ++round) {
        CAPTURE(round);
        check(b.list(packet_list_type::all), all_objects);
        check(b.object(0x3000), mixture);
        check(b.entry(0x3000, 1), part_1);
    }
    CHECK(right > 590);
}
