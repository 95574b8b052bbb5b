// Random packets: each one is confirmed, or is no request packet; headers and lengths are checked first.
#include "ethercat/packet_bench.hpp"
#include "support/random_message.hpp"
#include <jauscat/schema/ethercat/hilscher_info.hpp>
#include <jauscat/schema/ethercat/hilscher_state.hpp>

#include <array>

using namespace jauscat::ethercat;
using namespace jauscat::hilscher;
using jauscat::test::packet_bench;
using bytes = std::vector<std::byte>;
namespace wire = jauscat::wire;

namespace {

constexpr std::array requests{packet_command::sdo_download_req,
                              packet_command::sdo_upload_req,
                              packet_command::get_od_list_req,
                              packet_command::get_object_description_req,
                              packet_command::get_entry_description_req,
                              packet_command::read_emergencies_req,
                              packet_command::start_bus_scan_req,
                              packet_command::get_bus_scan_info_req,
                              packet_command::get_state_req,
                              packet_command::set_state_req,
                              packet_command::get_slave_handles_req};

struct bench : packet_bench {
    bench() {
        add({.vendor = 1});
        add({.vendor = 2, .mailbox_out_size = 48, .mailbox_in_size = 48});
        devices[0].own.add(0x2000, 1, 4);
        REQUIRE(link.run(master, bring_up{0, 1}));
    }
    /// ulSta of the confirmation of a packet with this header and so many bytes of zeros behind it.
    std::uint32_t status(const packet_header& head, std::size_t body) {
        bytes request(40 + body);
        REQUIRE(wire::encode(head, request));
        const auto confirmation = execute(request);
        packet_header answer{};
        REQUIRE(wire::decode_prefix(answer, confirmation));
        return static_cast<std::uint32_t>(answer.ul_sta);
    }
};

/// Bytes that a request needs behind its header.
std::uint32_t least(packet_command command) {
    switch (command) {
    case packet_command::sdo_download_req:
    case packet_command::get_entry_description_req: return 16;
    case packet_command::sdo_upload_req: return 12;
    case packet_command::get_od_list_req:
    case packet_command::get_object_description_req:
    case packet_command::read_emergencies_req: return 8;
    case packet_command::get_slave_handles_req: return 4;
    case packet_command::get_bus_scan_info_req:
    case packet_command::set_state_req: return 2;
    default: return 0;
    }
}

} // namespace

TEST_CASE("random packets are confirmed or are not requests") {
    bench b;
    support::generator g{20261121};
    constexpr std::array<bus_slave, 2> stations{bus_slave{0, 1}, bus_slave{1, 2}};
    unsigned confirmed = 0, succeeded = 0;
    for (unsigned round = 0; round != 20000; ++round) {
        CAPTURE(round);
        bytes request(support::below(g, 120));
        support::fill(g, request);
        const bool aimed = request.size() >= 40 && support::chance(g, 0.95);
        if (aimed) {
            const auto command = requests.at(support::below(g, requests.size()));
            auto length = static_cast<std::uint32_t>(request.size() - 40);
            if (support::chance(g, 0.1)) length = static_cast<std::uint32_t>(support::below(g, 2000));
            REQUIRE(wire::encode(packet_header{.ul_dest = static_cast<std::uint32_t>(support::below(g, 40)),
                                               .ul_len = length,
                                               .ul_id = round,
                                               .ul_cmd = command,
                                               .ul_ext = support::chance(g, 0.1) ? 0x80u : 0u},
                                 request));
            // Fields that may be right: each of four bytes is small, or an object's index.
            for (std::size_t at = 40; at + 4 <= request.size(); at += 4)
                if (support::chance(g, 0.9)) {
                    const auto value = support::chance(g, 0.2) ? 0x2000u : support::below(g, 9);
                    request[at] = static_cast<std::byte>(value);
                    request[at + 1] = static_cast<std::byte>(value >> 8);
                    request[at + 2] = request[at + 3] = std::byte{};
                }
        }
        b.options = {.slaves = support::chance(g, 0.5) ? std::span{stations} : std::span<const bus_slave>{},
                     .check_header = support::chance(g, 0.3)};
        const std::size_t room = support::chance(g, 0.2) ? support::below(g, 100) : packet_job::confirmation_size;
        const auto confirmation = b.execute(request, room);
        packet_header asked{}, answer{};
        const bool is_request = static_cast<bool>(wire::decode_prefix(asked, request)) &&
                                (static_cast<std::uint32_t>(asked.ul_cmd) & 1u) == 0;
        if (confirmation.empty()) {
            CHECK((!is_request || room < 52));
            continue;
        }
        REQUIRE(wire::decode_prefix(answer, confirmation));
        REQUIRE(is_request);
        CHECK(answer.ul_len == confirmation.size() - 40);
        CHECK(static_cast<std::uint32_t>(answer.ul_cmd) == static_cast<std::uint32_t>(asked.ul_cmd) + 1);
        auto same = answer;
        same.ul_len = asked.ul_len;
        same.ul_sta = asked.ul_sta;
        same.ul_cmd = asked.ul_cmd;
        CHECK(same == asked);
        ++confirmed;
        if (answer.ul_sta == packet_status::ok) ++succeeded;
    }
    CHECK(confirmed > 10000);
    CHECK(succeeded > 1000);
}

TEST_CASE("a packet with an unknown command, or that is an answer, is recognised") {
    bench b;
    for (const std::uint32_t command : {0u, 0x65001Eu, 0x650040u, 0x9A00u, 0x2F30u, 0xFFFFFFFEu})
        CHECK(b.status({.ul_dest = 0x20, .ul_cmd = static_cast<packet_command>(command)}, 0) == 0xC0000004);
    bytes answer(40);
    for (const auto command : requests) {
        REQUIRE(wire::encode(
            packet_header{.ul_cmd = static_cast<packet_command>(static_cast<std::uint32_t>(command) + 1)}, answer));
        CHECK(b.execute(answer).empty());
    }
}

TEST_CASE("the size of a packet is that of its fields, and its length field may not be larger") {
    bench b;
    const auto sent = b.master.statistics().sent;
    for (const auto command : requests) {
        CAPTURE(static_cast<std::uint32_t>(command));
        const auto needs = least(command);
        if (needs != 0) {
            CHECK(b.status({.ul_len = needs - 1, .ul_cmd = command}, needs - 1) == 0xC0000007);
            CHECK(b.status({.ul_len = needs - 1, .ul_cmd = command}, needs) == 0xC0000007);
            CHECK(b.status({.ul_len = needs, .ul_cmd = command}, needs - 1) == 0xC0000007);
        }
        CHECK(b.status({.ul_len = needs + 5, .ul_cmd = command}, needs + 4) == 0xC0000007);
    }
    CHECK(b.master.statistics().sent == sent);
    CHECK(b.status({.ul_len = 8, .ul_cmd = packet_command::get_state_req}, 8) == 0); // more is passed over
}

TEST_CASE("headers that a card refuses are refused on request") {
    bench b;
    const auto status = [&](packet_header head) {
        head.ul_cmd = packet_command::get_state_req;
        return b.status(head, 0);
    };
    for (const bool checked : {false, true}) {
        b.options.check_header = checked;
        for (const std::uint32_t dest : {0x20u, 1u, 2u, 3u, 4u}) CHECK(status({.ul_dest = dest}) == 0);
        for (const std::uint32_t dest : {0u, 5u, 0x21u, 0x10000020u})
            CHECK(status({.ul_dest = dest}) == (checked ? 0xC0000005 : 0));
        CHECK(status({.ul_dest = 0x20, .ul_dest_id = 1}) == (checked ? 0xC0000006 : 0));
        for (const std::uint32_t ext : {0x40u, 0x80u, 0xC1u})
            CHECK(status({.ul_dest = 0x20, .ul_ext = ext}) == (checked ? 0xC0000008 : 0));
        CHECK(status({.ul_dest = 0x20, .ul_ext = 0x200}) == 0); // will be retried: no place in a sequence
    }
}

TEST_CASE("a confirmation buffer without space for the fields is refused before anything is sent") {
    bench b;
    for (const auto command : requests) {
        CAPTURE(static_cast<std::uint32_t>(command));
        bytes request(60);
        REQUIRE(wire::encode(packet_header{.ul_len = 20, .ul_cmd = command}, request));
        CHECK(b.execute(request, 39).empty());
    }
    const auto sent = b.master.statistics().sent;
    bytes request(44);
    REQUIRE(wire::encode(packet_header{.ul_len = 4, .ul_cmd = packet_command::start_bus_scan_req}, request));
    const auto confirmation = b.execute(request, 43);
    packet_header answer{};
    REQUIRE(wire::decode_prefix(answer, confirmation));
    CHECK(answer.ul_sta == packet_status::out_of_memory);
    CHECK(b.master.statistics().sent == sent);
}

TEST_CASE("a service of several jobs that is not driven to its end fails") {
    bench b;
    bytes request(44), confirmation(packet_job::confirmation_size);
    REQUIRE(wire::encode(packet_header{.ul_len = 4, .ul_cmd = packet_command::start_bus_scan_req}, request));
    packet_job job{request, confirmation};
    REQUIRE(job.start(b.master));
    static_cast<void>(b.link.run(b.master));
    confirmation.resize(job.finish(b.master));
    packet_header answer{};
    REQUIRE(wire::decode_prefix(answer, confirmation));
    CHECK(answer.ul_sta == packet_status::fail);
    CHECK(confirmation.size() == 40);
}
