// Recorded traffic of two SAE programs: every datagram is decoded, and encoded again to the same bytes.
#include "sae/machine.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/pcap.hpp"

#include <map>

namespace {

namespace sae = jauscat::sae;
using bytes = std::vector<std::byte>;

constexpr sae::jaus_id controller{20, 1, 126}, component{10, 1, 126};

/// The content of a frame with UDP over IPv4, by the length of UDP.
bytes datagram_of(const bytes& frame) {
    const auto number = [&](std::size_t at) { return std::to_integer<std::size_t>(frame.at(at)); };
    REQUIRE((number(12) << 8 | number(13)) == 0x0800);
    REQUIRE(number(23) == 17);
    const std::size_t udp = 14 + (number(14) & 0xF) * 4;
    REQUIRE((number(udp + 2) << 8 | number(udp + 3)) == sae::jaus_port);
    const std::size_t size = number(udp + 4) << 8 | number(udp + 5);
    const auto begin = frame.begin() + static_cast<std::ptrdiff_t>(udp + 8);
    return {begin, begin + static_cast<std::ptrdiff_t>(size - 8)};
}
std::vector<bytes> datagrams() {
    std::vector<bytes> all;
    for (const auto& frame : jauscat::test::read_pcap("sae_management.pcap")) all.push_back(datagram_of(frame));
    return all;
}

} // namespace

TEST_CASE("every datagram of the SAE capture is decoded and encoded again to its bytes") {
    std::map<unsigned, int> codes;
    int acknowledgements = 0;
    const auto all = datagrams();
    CHECK(all.size() == 22);
    for (const auto& datagram : all) {
        CHECK(jauscat::jaus::form_of(datagram) == jauscat::jaus::datagram_form::judp2);
        sae::datagram_reader messages{datagram};
        const auto m = messages.next();
        REQUIRE(m);
        CHECK_FALSE(messages.has_next());
        bytes out(datagram.size());
        const auto again = sae::put_datagram(m.header, m.payload, m.sequence_number, out);
        REQUIRE(again);
        CHECK(out == datagram);
        if (m.payload.empty())
            ++acknowledgements;
        else
            ++codes[std::to_integer<unsigned>(m.payload[0]) | std::to_integer<unsigned>(m.payload[1]) << 8];
    }
    CHECK(acknowledgements == 1);
    CHECK(codes == std::map<unsigned, int>{{0x000D, 2},
                                           {0x000F, 2},
                                           {0x2002, 5},
                                           {0x4002, 5},
                                           {0x0004, 2},
                                           {0x0006, 1},
                                           {0x0007, 1},
                                           {0x0003, 1},
                                           {0x000E, 1},
                                           {0x0010, 1}});
}

TEST_CASE("two transports that are given the capture's messages send its datagrams") {
    jauscat::test::machine there{{{component}}}, here{{{controller}}};
    for (const auto& datagram : datagrams()) {
        const auto m = sae::datagram_reader{datagram}.next();
        auto& sender = m.header.source == controller ? here : there;
        auto& receiver = m.header.source == controller ? there : here;
        if (!m.payload.empty())
            REQUIRE(
                sender.transport.send({.source = m.header.source,
                                       .destination = m.header.destination,
                                       .priority = m.header.priority,
                                       .is_acknowledged = m.header.acknowledgement == sae::acknowledgement::request},
                                      m.payload, {}));
        const auto sent = sender.transport.next_datagram({});
        REQUIRE(sent);
        CHECK(jauscat::test::to_hex(sent->bytes) == jauscat::test::to_hex(datagram));
        receiver.receive(sent->bytes, jauscat::time_point{});
    }
    CHECK(here.received.size() + there.received.size() == 21);
    CHECK_FALSE(here.transport.next_event());
    CHECK_FALSE(there.transport.next_event());
}
