// Recorded traffic of other masters and slaves: it parses completely, and rebuilding it gives the same bytes.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/pcap.hpp"
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>
#include <jauscat/wire/wire.hpp>

#include <algorithm>
#include <vector>

using namespace jauscat::ethercat;
using jauscat::test::read_pcap;
using jauscat::test::to_hex;
namespace wire = jauscat::wire;

namespace {

using bytes = std::vector<std::byte>;

// Decodes a T from the front and writes its encoding there. Returns the bytes after it.
template <class T> std::span<std::byte> rebuild(T& message, std::span<std::byte> at) {
    const auto used = wire::decode_prefix(message, at);
    REQUIRE(used);
    std::ranges::fill(at.first(*used), std::byte{0xEE});
    REQUIRE(wire::encode(message, at)->size() == *used);
    return at.subspan(*used);
}
template <class T> std::span<std::byte> rebuild(std::span<std::byte> at) {
    T message{};
    return rebuild(message, at);
}

// Mailbox, CoE and SDO layers of a mailbox datagram.
void rebuild_mailbox(std::span<std::byte> data) {
    mailbox_header mailbox{};
    auto rest = rebuild(mailbox, data);
    REQUIRE(mailbox.type == mailbox_type::coe);
    REQUIRE(mailbox.counter >= 1);
    REQUIRE(mailbox.length <= rest.size());
    coe_header coe{};
    rest = rebuild(coe, rest.first(mailbox.length));
    REQUIRE((coe.service == coe_service::sdo_request || coe.service == coe_service::sdo_response));
    sdo_header sdo{};
    REQUIRE(wire::decode_prefix(sdo, rest));
    if (sdo.specifier == sdo_specifier::abort) {
        rest = rebuild<sdo_abort>(rest);
    } else if (sdo.expedited) {
        rest = rebuild<sdo_expedited>(rest);
    } else {
        rest = rebuild<sdo_normal>(rest);
    }
}

// The layers inside a datagram, by where it reads or writes.
void rebuild_data(const datagram_view& datagram, std::span<std::byte> data) {
    const auto& header = datagram.header;
    const bool written = header.cmd == command::bwr || header.cmd == command::fpwr || header.cmd == command::apwr;
    if (!written && datagram.working_counter == 0) return; // a read before the slaves carries nothing
    if (header.ado >= esc_registers::process_ram.address) return rebuild_mailbox(data);
    if (header.ado == esc_registers::al_control.address) rebuild<al_control>(data);
    if (header.ado == esc_registers::al_status.address && header.length >= 6) rebuild<al_status>(data);
    if (header.ado == esc_registers::sii_control.address && header.length == 6) rebuild<sii_request>(data);
    if (header.ado == esc_registers::sync_manager.address)
        for (; !data.empty(); data = data.subspan(8)) rebuild<sync_manager>(data);
    if (header.ado == esc_registers::station_address.address) rebuild<esc_word>(data);
}

// KickCAT leaves leftovers in the reserved bits 11 to 13 of a length; we send zeros there.
void clear_reserved_bits(std::span<std::byte> frame) {
    mutable_frame_view view;
    REQUIRE(view.parse(frame));
    for (const auto datagram : view) datagram.bytes[7] &= std::byte{0xC7};
}

void rebuilds_to_the_same_bytes(const char* capture, std::size_t expected_frames) {
    const auto frames = read_pcap(capture);
    REQUIRE(frames.size() == expected_frames);
    for (const bytes& frame : frames) {
        frame_view view;
        const auto used = view.parse(frame);
        INFO(to_hex(frame));
        REQUIRE(used);
        REQUIRE(std::all_of(frame.begin() + static_cast<std::ptrdiff_t>(*used), frame.end(),
                            [](std::byte padding) { return padding == std::byte{}; }));

        ethernet_header ethernet{};
        REQUIRE(wire::decode_prefix(ethernet, frame));
        bytes again(max_frame_size);
        frame_builder builder{again, 0, ethernet};
        for (const auto datagram : view) {
            const auto room = builder.add(datagram.header);
            REQUIRE(room.size() == datagram.data.size());
            std::ranges::copy(datagram.data, room.begin());
            rebuild_data(datagram, room);
            const datagram_trailer trailer{.working_counter = datagram.working_counter};
            REQUIRE(wire::encode(trailer, std::span{room.data() + room.size(), 2}));
        }
        REQUIRE(builder.finish()->size() == std::max(*used, min_frame_size));
        again.resize(*used);
        bytes expected = frame;
        expected.resize(*used);
        clear_reserved_bits(expected);
        REQUIRE(to_hex(again) == to_hex(expected));
    }
}

} // namespace

TEST_CASE("the capture of SOEM and SOES parses and rebuilds") {
    rebuilds_to_the_same_bytes("ethercat_soem_soes.pcap", 386);
}

TEST_CASE("the capture of KickCAT parses and rebuilds") { rebuilds_to_the_same_bytes("ethercat_kickcat.pcap", 494); }
