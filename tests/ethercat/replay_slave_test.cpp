// The master's side of recorded traffic, replayed against our slave: foreign masters get the expected answers.
#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/pcap.hpp"
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/slave/slave.hpp>

#include <string>
#include <vector>

using namespace jauscat::ethercat;
using jauscat::test::from_hex;
using jauscat::test::read_pcap;
using jauscat::test::to_hex;
namespace test = jauscat::test;
namespace wire = jauscat::wire;

namespace {

// What an SDO answer says, without the filling that other slaves leave behind it: specifier, index, subindex and, where
// there are any, data or abort code.
std::string said(std::span<const std::byte> data) {
    mailbox_header mailbox{};
    const auto body = data.subspan(*wire::decode_prefix(mailbox, data)).first(mailbox.length);
    sdo_normal sdo{};
    const auto message = body.subspan(2);
    REQUIRE(wire::decode_prefix(sdo, message));
    const bool bare = sdo.header.specifier == sdo_specifier::download_response;
    const std::size_t used = sdo.header.expedited ? 8u - sdo.header.unused : bare ? 4 : message.size();
    return to_hex(body.first(2)) + " | " + to_hex(message.first(used));
}

struct replayed {
    std::size_t identical_reads{};
    std::size_t identical_sii_reads{};
    std::vector<std::string> answers{};
};

// Sends every recorded frame on its way out through the slave and compares with what came back then.
replayed replay(const char* capture, slave& device) {
    replayed result;
    std::uint32_t sii_word = 0; // that the master reads
    const auto frames = read_pcap(capture);
    for (std::size_t i = 0; i != frames.size(); i += 2) {
        auto ours = frames[i];
        device.process(ours);
        frame_view our_view, recorded_view;
        REQUIRE(our_view.parse(ours));
        REQUIRE(recorded_view.parse(frames[i + 1]));
        auto recorded = recorded_view.begin();
        for (const auto datagram : our_view) {
            const auto expected = *recorded++;
            INFO("frame " << i + 1 << " at " << datagram.header.ado);
            REQUIRE(datagram.working_counter == expected.working_counter);
            REQUIRE(datagram.header.adp == expected.header.adp);
            REQUIRE(datagram.header.index == expected.header.index);
            const auto ado = datagram.header.ado;
            if (ado == 0x0502 && datagram.data.size() == 6) {
                sii_request request{};
                REQUIRE(wire::decode_prefix(request, datagram.data));
                sii_word = request.address;
            }
            const bool reads = datagram.header.cmd == command::fprd || datagram.header.cmd == command::brd ||
                               datagram.header.cmd == command::aprd;
            if (!reads) continue;
            if (ado == 0x1400) {
                result.answers.push_back(said(datagram.data));
                REQUIRE(result.answers.back() == said(expected.data));
            } else if (ado == 0x0805 || ado == 0x080D) {
                REQUIRE((datagram.data[0] & std::byte{8}) == (expected.data[0] & std::byte{8}));
            } else if (ado == 0x0130 || ado == 0x0010 || ado == 0x0012 || ado == 0x0110 || ado == 0x0502) {
                REQUIRE(to_hex(datagram.data) == to_hex(expected.data));
                ++result.identical_reads;
            } else if (ado == 0x0508 && sii_word >= 0x0004 && sii_word < 0x003E && sii_word != 0x0006) {
                // The fixed part but for the controller's own configuration and its checksum: who, and which mailbox.
                INFO("SII word " << sii_word);
                REQUIRE(to_hex(datagram.data) == to_hex(expected.data));
                ++result.identical_sii_reads;
            } else if (ado == 0x0000 && datagram.data.size() >= 8) {
                REQUIRE(datagram.data[5] == expected.data[5]); // SyncManagers
                REQUIRE(datagram.data[7] == expected.data[7]); // ports
                ++result.identical_reads;
            } else if (ado == 0x0007) {
                REQUIRE(datagram.data[0] == expected.data[0]); // ports
                ++result.identical_reads;
            }
        }
        REQUIRE(recorded == recorded_view.end());
    }
    return result;
}

constexpr std::string_view payload = "05048ba2e81c7e8c98c80abef712b37565f567f3fea96c7f496cac27";

} // namespace

TEST_CASE("SOEM brings our slave up and gets the same answers as from SOES") {
    test::objects objects;
    objects.sub_0_rule = true;
    objects.add(0x1B1A, 0, 1);
    objects.entries[{0x1B1A, 0}].value[0] = std::byte{1};
    objects.add(0x1B1A, 1, 28);
    objects.add(0x6926, 1, 28);
    objects.add(0x2001, 0, 4);
    objects.add(0x2002, 0, 1);
    objects.entries[{0x2010, 0}].write_abort = abort_code::read_only;
    slave device{{.vendor = 0x6A5,
                  .product = 0x0BADB001,
                  .mailbox_out_size = 128,
                  .mailbox_in_offset = 0x1400,
                  .mailbox_in_size = 128,
                  .name = "usPruobe128"},
                 objects};
    const auto result = replay("ethercat_soem_soes.pcap", device);
    CHECK(result.identical_reads > 60);
    CHECK(result.identical_sii_reads == 7);
    REQUIRE(result.answers.size() == 13);
    CHECK(result.answers.front() == "00 20 | 80 1a 1b 01 03 00 01 06");
    CHECK(result.answers.back() == "00 30 | 41 1a 1b 01 1c 00 00 00 " + to_hex(from_hex(payload)));
    CHECK(objects.entries.at({0x1B1A, 1}).value == from_hex(payload));
    CHECK(objects.entries.at({0x6926, 1}).value == from_hex(payload));
    CHECK(objects.writes == 5);
    CHECK(device.station_address() == 0x1001);
    CHECK(device.state() == al_state::init); // the capture ends with a request for INIT
}

TEST_CASE("KickCAT brings our slave up and reads back what it wrote") {
    test::objects objects;
    objects.add(0x6926, 1, 28);
    slave device{{.vendor = 0x6A5,
                  .product = 0x0BADB001,
                  .mailbox_out_size = 512,
                  .mailbox_in_offset = 0x1400,
                  .mailbox_in_size = 512},
                 objects};
    const auto result = replay("ethercat_kickcat.pcap", device);
    CHECK(result.identical_reads > 75);
    CHECK(result.identical_sii_reads == 28);
    REQUIRE(result.answers.size() == 2);
    CHECK(result.answers.front() == "00 30 | 60 26 69 01");
    CHECK(objects.writes == 1);
    CHECK(to_hex(objects.entries.at({0x6926, 1}).value).substr(0, 23) == "00 00 00 00 1d 24 2b 32");
    CHECK(device.station_address() == 1001);
    CHECK(device.state() == al_state::init);
}

// How SOEM finds a category: the words of each header from 0x40 on, 4 bytes at a time.
TEST_CASE("a walk over the SII categories finds those of the recorded slaves and the end") {
    constexpr std::array outputs{pdo_entry{0x7000, 0, 8, 5, "Out"}};
    constexpr std::array inputs{pdo_entry{0x6000, 0, 16, 3, "In"}};
    const auto image = make_sii_image({.mailbox_out_size = 128,
                                       .mailbox_in_offset = 0x1400,
                                       .mailbox_in_size = 128,
                                       .name = "usPruobe128",
                                       .outputs = outputs,
                                       .inputs = inputs},
                                      {.sdo_information = true, .complete_access = true});
    std::vector<std::string> categories;
    std::size_t at = 0x40 * 2;
    for (;;) {
        sii_category_header header{};
        REQUIRE(wire::decode_prefix(header, std::span{image}.subspan(at)));
        at += 4;
        if (header.category == sii_category::end) break;
        REQUIRE(at + header.words * 2u <= image.size());
        categories.push_back(std::to_string(static_cast<unsigned>(header.category)) + ": " +
                             to_hex(std::span{image}.subspan(at, header.words * 2u)));
        at += header.words * 2u;
    }
    REQUIRE(categories.size() == 6);
    CHECK(categories[0] == "10: 05 0b 75 73 50 72 75 6f 62 65 31 32 38 07 4f 75 74 70 75 74 73 06 49 6e 70 75 74 73 "
                           "03 4f 75 74 02 49 6e 00");
    CHECK(categories[1] == "30: 00 00 01 01 00 23 00 00 00 00 00 00 00 00 00 00 11 00 00 00 00 00 00 00 00 00 00 00 00 "
                           "00 00 00");
    CHECK(categories[2] == "40: 01 02");
    // As recorded, but for the addresses of process data: 1800h and 1900h there.
    CHECK(categories[3] == "41: 00 10 80 00 26 00 01 01 00 14 80 00 22 00 01 02 00 1c 01 00 64 00 01 03 "
                           "00 24 02 00 20 00 01 04");
    CHECK(categories[4] == "50: 00 1a 01 03 00 03 11 00 00 60 00 05 03 10 00 00");
    CHECK(categories[5] == "51: 00 16 01 02 00 02 11 00 00 70 00 04 05 08 00 00");
}
