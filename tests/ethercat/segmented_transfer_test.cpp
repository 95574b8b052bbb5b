// SDO transfers in segments: every size through every mailbox, byte for byte, and both ways of starting.
#include "ethercat/segmented_bench.hpp"

using namespace jauscat::ethercat;
using jauscat::test::counting;
using jauscat::test::segmented_bench;

namespace {

using bytes = std::vector<std::byte>;

// Messages of a transfer of `size` bytes: the first holds 16 bytes besides data, a segment 9.
std::size_t messages(std::size_t size, std::size_t mailbox, bool empty_start) {
    if (size <= mailbox - 16) return 1;
    const std::size_t first = empty_start ? 0 : mailbox - 16, segment = mailbox - 9;
    return 1 + (size - first + segment - 1) / segment;
}

// Every size, or some of them and those where one more message begins.
std::vector<std::size_t> sizes(bool every) {
    std::vector<std::size_t> all;
    for (std::size_t size = 1; size <= 2000; size += every || size < 130 ? 1 : 11) all.push_back(size);
    if (every) return all;
    for (const std::size_t mailbox : {128u, 1024u})
        for (const std::size_t filled : {mailbox - 16, 2 * mailbox - 25, mailbox - 9, 2 * mailbox - 18})
            for (const std::size_t size : {filled, filled + 1}) all.push_back(size);
    all.push_back(2000);
    return all;
}

void transfers_whole(std::uint16_t out, std::uint16_t in, bool empty_start, bool every = false) {
    segmented_bench b{out, in, {.empty_start = empty_start}};
    b.keeps_mail = false;
    b.set({std::byte{}});
    REQUIRE(b.download(bytes(1))); // drains the mailbox
    for (const auto size : sizes(every)) {
        INFO("mailboxes " << out << " and " << in << ", " << size << " bytes");
        const auto data = counting(size, static_cast<unsigned>(size));
        b.set(bytes(size));
        const auto writes = b.objects.writes;
        const auto sent = b.master.statistics().sent;
        REQUIRE(b.download(data, {.empty_start = empty_start}));
        CHECK(b.stored() == data);
        CHECK(b.objects.writes == writes + 1);
        const auto sent_by_download = b.master.statistics().sent - sent;
        CHECK(sent_by_download == 2 * messages(size, out, empty_start)); // frames: a write and a read each

        bytes into(size);
        CHECK(b.upload(into) == master_result<std::size_t>{size});
        CHECK(into == data);
        CHECK(b.master.statistics().sent - sent - sent_by_download == 2 * messages(size, in, empty_start));
    }
}

} // namespace

TEST_CASE("data of 1 to 2000 bytes pass mailboxes of every size unchanged") {
    for (const auto mailbox : std::initializer_list<std::uint16_t>{24, 25, 32, 48, 128, 1024}) {
        transfers_whole(mailbox, mailbox, false, mailbox >= 48); // a small one takes many frames
        transfers_whole(mailbox, mailbox, true);
    }
    transfers_whole(24, 128, false);
    transfers_whole(128, 25, false);
}

TEST_CASE("a segmented download and upload equal the standard's message for message") {
    segmented_bench b{24};
    b.set(bytes(28));
    REQUIRE(b.download(counting(28)));
    CHECK(b.mail == std::vector<std::string>{
                        "12 00 00 00 00 13 00 20 21 26 69 01 1c 00 00 00 01 02 03 04 05 06 07 08",
                        "0a 00 00 00 00 13 00 30 60 26 69 01 00 00 00 00",
                        "12 00 00 00 00 23 00 20 00 09 0a 0b 0c 0d 0e 0f 10 11 12 13 14 15 16 17",
                        "0a 00 00 00 00 23 00 30 20 00 00 00 00 00 00 00",
                        "0a 00 00 00 00 33 00 20 15 18 19 1a 1b 1c 00 00", // toggle, two bytes unused, last
                        "0a 00 00 00 00 33 00 30 30 00 00 00 00 00 00 00",
                    });
    CHECK(b.stored() == counting(28));

    bytes into(100);
    CHECK(b.upload(into) == master_result<std::size_t>{28});
    CHECK(b.mail == std::vector<std::string>{
                        "0a 00 00 00 00 43 00 20 40 26 69 01 00 00 00 00",
                        "12 00 00 00 00 43 00 30 41 26 69 01 1c 00 00 00 01 02 03 04 05 06 07 08",
                        "0a 00 00 00 00 53 00 20 60 00 00 00 00 00 00 00",
                        "12 00 00 00 00 53 00 30 00 09 0a 0b 0c 0d 0e 0f 10 11 12 13 14 15 16 17",
                        "0a 00 00 00 00 63 00 20 70 00 00 00 00 00 00 00",
                        "0a 00 00 00 00 63 00 30 15 18 19 1a 1b 1c 00 00",
                    });
    into.resize(28);
    CHECK(into == counting(28));
}

TEST_CASE("the first message of a segmented transfer may have no data") {
    segmented_bench b{24, {.empty_start = true}};
    b.set(bytes(17));
    REQUIRE(b.download(counting(17), {.empty_start = true}));
    CHECK(b.mail == std::vector<std::string>{
                        "0a 00 00 00 00 13 00 20 21 26 69 01 11 00 00 00",
                        "0a 00 00 00 00 13 00 30 60 26 69 01 00 00 00 00",
                        "12 00 00 00 00 23 00 20 00 01 02 03 04 05 06 07 08 09 0a 0b 0c 0d 0e 0f",
                        "0a 00 00 00 00 23 00 30 20 00 00 00 00 00 00 00",
                        "0a 00 00 00 00 33 00 20 1b 10 11 00 00 00 00 00",
                        "0a 00 00 00 00 33 00 30 30 00 00 00 00 00 00 00",
                    });
    bytes into(17);
    CHECK(b.upload(into) == master_result<std::size_t>{17});
    CHECK(into == counting(17));
    CHECK(b.mail.at(1) == "0a 00 00 00 00 43 00 30 41 26 69 01 11 00 00 00");
    CHECK(b.mail.at(3) == "12 00 00 00 00 53 00 30 00 01 02 03 04 05 06 07 08 09 0a 0b 0c 0d 0e 0f");
    CHECK(b.mail.at(5) == "0a 00 00 00 00 63 00 30 1b 10 11 00 00 00 00 00");
}

TEST_CASE("an object is written after its last segment, and uploaded as it was at the start") {
    segmented_bench b{24};
    b.set(counting(40));
    int reads = 0;
    b.before_read = [&](const auto&) {
        if (++reads == 2) b.set(bytes(40)); // the object changes while it is under way
    };
    bytes into(40);
    REQUIRE(b.upload(into));
    CHECK(reads > 2);
    CHECK(into == counting(40));

    b.before_read = [&](const auto&) {
        if (b.mail.size() < 7) CHECK(b.stored() == bytes(40)); // until the last segment
    };
    REQUIRE(b.download(counting(40)));
    CHECK(b.mail.size() == 8);
    CHECK(b.stored() == counting(40));
}
