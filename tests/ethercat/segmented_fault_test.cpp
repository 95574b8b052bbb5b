// Disturbed segmented transfers: each ends as done with the right value, or in its own error, and the other side gets
// an abort.
#include "ethercat/segmented_bench.hpp"

#include <algorithm>

using namespace jauscat::ethercat;
using namespace std::chrono_literals;
using jauscat::test::counting;
using jauscat::test::from_hex;
using jauscat::test::segmented_bench;
using jauscat::test::simulated_link;

namespace {

using bytes = std::vector<std::byte>;
using datagram = segmented_bench::datagram;

void put(const datagram& d, std::string_view hex, std::size_t at = 8) {
    std::ranges::copy(from_hex(hex), d.data.subspan(at).begin());
}
// Changes the answer with the command byte `command`, once.
auto instead_of(std::byte command, std::string_view hex) {
    return [command, hex, done = false](const datagram& d) mutable {
        if (done || d.data[8] != command) return;
        put(d, hex);
        done = true;
    };
}

} // namespace

TEST_CASE("an answer with the wrong toggle bit ends a transfer, and the slave gets an abort") {
    segmented_bench b{24};
    b.set(bytes(28));
    b.before_read = instead_of(std::byte{0x30}, "20"); // the answer to the second segment
    const auto result = b.download(counting(28));
    CHECK(result == master_error{.code = master_errc::toggle_bit});
    CHECK(b.mail.back() == "0a 00 00 00 00 43 00 20 80 26 69 01 00 00 03 05");
    b.before_read = {};
    b.set(bytes(28));
    REQUIRE(b.download(counting(28)));
    CHECK(b.stored() == counting(28));

    b.before_read = instead_of(std::byte{0x00}, "10");
    bytes into(28);
    CHECK(b.upload(into).error() == master_error{.code = master_errc::toggle_bit});
    CHECK(b.mail.back().substr(18) == "00 20 80 26 69 01 00 00 03 05");
    b.before_read = {};
    CHECK(b.upload(into) == master_result<std::size_t>{28});
}

TEST_CASE("a slave's abort between segments is reported and not answered") {
    segmented_bench b{24};
    b.set(bytes(28));
    // As slaves send it: with the object, without it, with other bits of the command left over.
    for (const char* abort : {"80 2669 01 22000008", "80 0000 00 22000008", "9f 2669 01 22000008"}) {
        b.before_read = instead_of(std::byte{0x20}, abort);
        CHECK(b.download(counting(28)).error() ==
              master_error{.code = master_errc::sdo_abort, .abort = abort_code{0x08000022}});
        CHECK(b.mail.size() == 4);
        bytes into(28);
        b.before_read = instead_of(std::byte{0x00}, abort);
        CHECK(b.upload(into).error() == master_error{.code = master_errc::sdo_abort, .abort = abort_code{0x08000022}});
        CHECK(b.mail.size() == 4);
    }
    b.before_read = {};
    b.objects.entries.at({b.index, b.subindex}).write_abort = abort_code::read_only;
    CHECK(b.download(counting(28)).error() ==
          master_error{.code = master_errc::sdo_abort, .abort = abort_code{0x06010002}});
    CHECK(b.stored() == bytes(28));
}

TEST_CASE("an upload whose segments do not have the announced size is refused") {
    segmented_bench b{24};
    b.set(counting(28));
    const auto upload_with = [&](std::byte command, std::string_view hex) {
        b.before_read = instead_of(command, hex);
        bytes into(28);
        const auto result = b.upload(into);
        b.before_read = {};
        return result;
    };
    const auto mismatch = [](std::uint32_t found) {
        return master_result<std::size_t>{
            master_error{.code = master_errc::size_mismatch, .bytes = 28, .found_bytes = found}};
    };
    CHECK(upload_with(std::byte{0x00}, "01") == mismatch(23)); // the last one, five bytes early
    CHECK(b.mail.size() == 4);
    CHECK(upload_with(std::byte{0x15}, "17") == mismatch(27)); // one byte fewer
    CHECK(b.mail.size() == 6);
    CHECK(upload_with(std::byte{0x15}, "13") == mismatch(29)); // one byte more
    CHECK(upload_with(std::byte{0x15}, "12") == mismatch(29)); // one byte more, and another segment
    CHECK(b.mail.size() == 7);
    CHECK(b.mail.back().substr(18) == "00 20 80 26 69 01 10 00 07 06");
    CHECK(upload_with(std::byte{0x15}, "1e") == mismatch(23)); // none, and another segment: it would never end
    CHECK(upload_with(std::byte{0x41}, "41 2669 01 1b000000").error() ==
          master_error{.code = master_errc::size_mismatch, .bytes = 27, .found_bytes = 28});
}

TEST_CASE("a segmented upload beyond the buffer is read to its end, and an endless one is aborted") {
    segmented_bench b{24};
    b.set(counting(28));
    bytes small(27);
    const auto too_long = [](std::uint32_t found) {
        return master_result<std::size_t>{
            master_error{.code = master_errc::data_too_long, .bytes = 27, .found_bytes = found}};
    };
    CHECK(b.upload(small) == too_long(28));
    CHECK(b.mail.size() == 6);
    CHECK(b.mail.back().substr(18, 8) == "00 30 15"); // the last segment: the slave's transfer is complete
    bytes none{};
    CHECK(b.upload(none).error() == master_error{.code = master_errc::data_too_long, .found_bytes = 28});
    CHECK(b.mail.size() == 6);

    b.before_read = instead_of(std::byte{0x00}, "80 2669 01 22000008"); // the slave abandons it in between
    CHECK(b.upload(small) == too_long(28));
    CHECK(b.mail.size() == 4);

    // 65,536 bytes are still read, and end here after 28; one byte more is too long to be read.
    b.before_read = instead_of(std::byte{0x41}, "41 2669 01 00000100");
    CHECK(b.upload(small).error() ==
          master_error{.code = master_errc::size_mismatch, .bytes = 65536, .found_bytes = 28});
    b.before_read = instead_of(std::byte{0x41}, "41 2669 01 01000100");
    CHECK(b.upload(small) == too_long(65537));
    CHECK(b.mail.size() == 3);
    CHECK(b.mail.back().substr(18) == "00 20 80 26 69 01 05 00 04 05");
    bytes into(28);
    CHECK(b.upload(into) == master_result<std::size_t>{28});
}

TEST_CASE("an upload of another size than expected is refused") {
    for (const std::size_t size : {std::size_t{1}, std::size_t{8}, std::size_t{28}}) {
        segmented_bench b{24};
        b.set(counting(size));
        bytes into(40);
        const auto upload = [&](std::size_t expected) {
            return jauscat::test::size_of(
                b.link.run(b.master, jauscat::ethercat::upload{0x1001, b.index, b.subindex, into, {.size = expected}}));
        };
        CHECK(upload(size) == master_result<std::size_t>{size});
        const auto mismatch = [size](std::size_t expected) {
            return master_result<std::size_t>{master_error{.code = master_errc::size_mismatch,
                                                           .bytes = static_cast<std::uint32_t>(expected),
                                                           .found_bytes = static_cast<std::uint32_t>(size)}};
        };
        CHECK(upload(size + 1) == mismatch(size + 1));
        CHECK(upload(size - 1) == mismatch(size - 1));
        CHECK(upload(size) == master_result<std::size_t>{size});
    }
}

TEST_CASE("answers to segments may end after the command byte") {
    segmented_bench b{24};
    b.set(bytes(28));
    b.before_read = [](const datagram& d) {
        if (d.data[8] == std::byte{0x20} || d.data[8] == std::byte{0x30}) put(d, "0300", 0);
    };
    REQUIRE(b.download(counting(28)));
    CHECK(b.mail.back() == "03 00 00 00 00 33 00 30 30");
    CHECK(b.stored() == counting(28));
}

TEST_CASE("a slave that is silent between segments is abandoned, and gets an abort on its return") {
    segmented_bench b{24};
    b.set(bytes(40));
    b.before_read = [&](const datagram& d) { b.works = d.data[8] != std::byte{0x20}; };
    CHECK(b.download(counting(40)).error() == master_error{.code = master_errc::mailbox_timeout});
    CHECK(b.objects.writes == 0);
    // The abort is in the mailbox, or waits for it.
    b.before_read = {};
    b.works = true;
    REQUIRE(b.download(counting(40, 5)));
    CHECK(b.stored() == counting(40, 5));
    CHECK(b.objects.writes == 1);
    bytes into(40);
    REQUIRE(b.upload(into));
    CHECK(into == counting(40, 5));
}

TEST_CASE("a transfer cancelled between segments is aborted before the next one") {
    segmented_bench b{24};
    b.set(bytes(40));
    const auto data = counting(40);
    int frames = 0;
    b.link.on_way_back = [&](bytes& frame) {
        if (++frames > 5) frame.clear(); // drain, start and its answer, segment and its answer
    };
    CHECK(b.link.run(b.master, download{0x1001, b.index, b.subindex, data}, 100ms).error() ==
          master_error{.code = master_errc::timeout});
    CHECK(b.objects.writes == 0);

    const auto other = counting(28);
    segmented_bench c{24};
    c.set(bytes(28));
    c.before_read = [&](const datagram& d) {
        if (d.data[8] == std::byte{0x20}) c.link.now += 1s; // the caller's timeout
    };
    CHECK(c.link.run(c.master, download{0x1001, c.index, c.subindex, other}, 500ms).error() ==
          master_error{.code = master_errc::timeout});
    c.before_read = {};
    REQUIRE(c.download(counting(28, 5)));
    REQUIRE(c.mail.size() >= 7);
    const auto abort = std::ranges::find(c.mail, "00 20 80 26 69 01 00 00 04 05",
                                         [](const std::string& m) { return m.size() > 18 ? m.substr(18) : m; });
    REQUIRE(abort != c.mail.end());
    CHECK(c.mail.end() - abort == 9); // then the question whether a late answer comes, and the whole of the next one
    CHECK(c.stored() == counting(28, 5));
    REQUIRE(c.download(counting(28)));
    CHECK(c.mail.size() == 6); // once is enough
}

TEST_CASE("a slave reset between segments is detected, and the next transfer works after bring-up") {
    segmented_bench b{24};
    b.set(bytes(28));
    b.before_read = [&](const datagram& d) {
        if (d.data[8] == std::byte{0x20}) b.device.power_on();
    };
    CHECK(b.download(counting(28)).error() == master_error{.code = master_errc::working_counter});
    b.before_read = {};
    REQUIRE(b.link.run(b.master, bring_up{0, 0x1001}));
    REQUIRE(b.download(counting(28)));
    CHECK(b.stored() == counting(28));
    // A change of state does not end a transfer in every slave, so an abort goes first.
    CHECK(b.mail.front().substr(18) == "00 20 80 26 69 01 00 00 04 05");
    CHECK(b.mail.size() == 1 + 6);
}

TEST_CASE("any lost frame of a segmented transfer is repeated, and the value is correct") {
    // 40 bytes through a mailbox of 24 are 4 messages: 8 frames, and one more for the drain before the first.
    for (int lost = 1; lost <= 9 + 8; ++lost) {
        for (const bool on_way_out : {true, false}) {
            segmented_bench b{24};
            b.set(bytes(40));
            int frames = 0;
            simulated_link link{[&](std::span<std::byte> frame) {
                if (++frames == lost && on_way_out) return;
                b.device.process(frame);
            }};
            link.on_way_back = [&](bytes& frame) {
                if (frames == lost) frame.clear();
            };
            INFO("frame " << lost << (on_way_out ? " out" : " back"));
            const auto data = counting(40);
            CHECK(link.run(b.master, download{0x1001, b.index, b.subindex, data}));
            CHECK(b.stored() == data);
            CHECK(b.objects.writes == 1);
            bytes into(40);
            CHECK(jauscat::test::size_of(link.run(b.master, upload{0x1001, b.index, b.subindex, into})) ==
                  master_result<std::size_t>{40});
            CHECK(into == data);
            CHECK(b.master.statistics().lost == 1);
        }
    }
}

TEST_CASE("each segmented transfer over a bad link succeeds or ends in an error") {
    segmented_bench b{24};
    b.set(bytes(60));
    b.link.faults = {.lose = 10, .duplicate = 10, .delay = 20};
    std::size_t done = 0;
    bool up = true;
    for (unsigned i = 0; i != 500; ++i) {
        if (!up) {
            up = static_cast<bool>(b.link.run(b.master, bring_up{0, 0x1001}));
            if (!up) continue;
        }
        const auto before = b.stored();
        const auto writes = b.objects.writes;
        const auto data = counting(60, i);
        const auto result = b.download(data);
        INFO("download " << i << ": " << describe(result.error()));
        REQUIRE((result || result.error().code == master_errc::no_reply));
        REQUIRE(b.objects.writes <= writes + 1);
        REQUIRE((b.stored() == data || (!result && b.stored() == before)));
        if (!result) {
            up = false;
            continue;
        }
        REQUIRE(b.objects.writes == writes + 1);
        bytes into(60);
        const auto read = b.upload(into);
        REQUIRE((read || read.error().code == master_errc::no_reply));
        if (read) REQUIRE(into == data);
        done += read ? 1 : 0;
    }
    CHECK(done > 490);
    CHECK(b.master.statistics().lost > 1'000);
}
