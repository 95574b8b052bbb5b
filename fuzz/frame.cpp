// Bytes that claim to be an EtherCAT frame: what parses is whole, and can be built again.
#include "support/target.hpp"
#include <jauscat/ethercat/frame_view.hpp>

using namespace fuzz;
using namespace jauscat;
using namespace jauscat::ethercat;

namespace {

void check_rebuilt(std::span<const std::byte> frame, const frame_view& view, std::size_t used) {
    ethernet_header ethernet{};
    const auto header_size = *wire::decode_prefix(ethernet, frame);
    byte_vector again(max_frame_size);
    frame_builder builder{again, 0, ethernet};
    for (const auto datagram : view) {
        const auto room = builder.add(datagram.header);
        if (room.size() != datagram.data.size()) return; // longer than a frame that this project builds
        std::ranges::copy(datagram.data, room.begin());
    }
    const auto finished = builder.finish();
    if (!finished) return; // the same
    frame_view rebuilt;
    const auto parsed = rebuilt.parse(*finished);
    if (ethernet.ether_type == ether_type_vlan) { // the builder puts no tag
        check(parsed.error() == frame_errc::too_short || parsed.error() == frame_errc::not_ethercat,
              "a frame without its tag is another one");
        return;
    }
    check(parsed && *parsed == used, "a frame built again has the same size");
    check(std::ranges::equal(std::span{again}.first(header_size), frame.first(header_size)),
          "a frame built again has the same Ethernet header");
    auto theirs = view.begin();
    for (const auto ours : rebuilt) {
        const auto expected = *theirs++;
        // Allowed: reserved bits are sent as zero, and a counter starts at zero.
        check(ours.header.cmd == expected.header.cmd && ours.header.index == expected.header.index &&
                  ours.header.adp == expected.header.adp && ours.header.ado == expected.header.ado &&
                  ours.header.length == expected.header.length &&
                  ours.header.circulating == expected.header.circulating && ours.header.more == expected.header.more &&
                  ours.header.irq == expected.header.irq && ours.working_counter == 0,
              "a datagram built again has the same header");
        check(std::ranges::equal(ours.data, expected.data), "a datagram built again has the same data");
    }
    check(theirs == view.end(), "a frame built again has all datagrams");
}

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    const byte_vector frame = copy_of(input);
    frame_view view;
    const auto used = view.parse(frame);
    byte_vector changeable = frame;
    mutable_frame_view mutable_view;
    check(mutable_view.parse(changeable).error() == used.error(), "both kinds of view agree");
    if (!used) {
        check(view.begin() == view.end(), "a frame that does not parse has no datagrams");
        return;
    }
    check(*used <= frame.size(), "a frame ends within its bytes");
    std::size_t bytes_of_datagrams = 0;
    bool more = true;
    for (const auto datagram : view) {
        check(more, "no datagram follows one that announces none");
        more = datagram.header.more;
        check(datagram.data.size() == datagram.header.length, "a datagram has the data it announces");
        check(datagram.bytes.size() == datagram.data.size() + datagram_overhead, "a datagram has all its bytes");
        bytes_of_datagrams += datagram.bytes.size();
    }
    check(!more, "the last datagram announces no other");
    check(bytes_of_datagrams <= *used - frame_header_size, "the datagrams lie within the frame");
    check_rebuilt(frame, view, *used);
}
