// Frames and the schemas of what they carry, against literal bytes.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>
#include <jauscat/schema/ethercat/sii.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <random>
#include <vector>

using namespace jauscat::ethercat;
using jauscat::test::from_hex;
using jauscat::test::to_hex;
namespace wire = jauscat::wire;

namespace {

template <class T> std::string bytes_of(const T& message) {
    std::array<std::byte, wire::max_size<T>> out{};
    const auto encoded = wire::encode(message, out);
    return encoded ? to_hex(*encoded) : std::string{wire::describe(encoded.error())};
}

std::vector<std::byte> two_datagrams() {
    std::array<std::byte, max_frame_size> out{};
    frame_builder builder{out, 0x42};
    builder.add(command::bwr, 0, 0x0120, al_control{.state = al_state::init, .acknowledge = true});
    builder.add(command::fprd, 0x1001, 0x0130, 6);
    const auto finished = builder.finish();
    REQUIRE(finished);
    return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(finished->size())};
}

} // namespace

TEST_CASE("a frame of two datagrams has its more bit, length and padding") {
    CHECK(to_hex(two_datagrams()) == to_hex(from_hex("ffffffffffff 000000000000 88a4 2010"
                                                     "08 42 0000 2001 0280 0000 1100 0000"
                                                     "04 42 0110 3001 0600 0000 000000000000 0000"
                                                     "00000000000000000000 0000")));
}

TEST_CASE("a frame is built in a constant expression") {
    constexpr auto length = [] {
        std::array<std::byte, 64> out{};
        frame_builder builder{out};
        builder.add(command::brd, 0, 0, 1);
        const auto finished = builder.finish();
        return std::pair{finished->size(), out[14]};
    }();
    STATIC_REQUIRE(length.first == min_frame_size);
    STATIC_REQUIRE(length.second == std::byte{13});
}

TEST_CASE("parsing a frame restores its datagrams") {
    const auto frame = two_datagrams();
    frame_view view;
    const auto used = view.parse(frame);
    REQUIRE(used);
    CHECK(*used == 16 + 14 + 18);
    std::vector<datagram_view> seen;
    for (const auto datagram : view) seen.push_back(datagram);
    REQUIRE(seen.size() == 2);
    CHECK(seen[0].header.cmd == command::bwr);
    CHECK(seen[0].header.more);
    CHECK(seen[0].header.ado == 0x0120);
    CHECK(to_hex(seen[0].data) == "11 00");
    CHECK(seen[1].header.cmd == command::fprd);
    CHECK_FALSE(seen[1].header.more);
    CHECK(seen[1].header.adp == 0x1001);
    CHECK(seen[1].header.index == 0x42);
    CHECK(seen[1].data.size() == 6);
    CHECK(seen[1].working_counter == 0);
}

TEST_CASE("working counter and event bits are read from their positions") {
    const auto frame = from_hex("ffffffffffff 020000000000 88a4 0e10 07 05 0100 3001 0200 0810 0201 0300");
    frame_view view;
    REQUIRE(view.parse(frame));
    const datagram_view datagram = *view.begin();
    CHECK(datagram.working_counter == 3);
    CHECK(datagram.header.irq == 0x1008);
    CHECK(datagram.header.adp == 1);
    CHECK(to_hex(datagram.data) == "02 01");
}

TEST_CASE("a VLAN tag before the EtherType is skipped") {
    const auto frame = from_hex("ffffffffffff 020000000000 8100 2005 88a4 0d10 07 05 0100 0000 0100 0000 04 0100");
    frame_view view;
    REQUIRE(*view.parse(frame) == frame.size());
    CHECK((*view.begin()).working_counter == 1);
}

TEST_CASE("each fault of a frame has its own error") {
    frame_view view;
    const auto error_of = [&](std::string_view hex) { return view.parse(from_hex(hex)).error(); };
    const std::string start = "ffffffffffff 000000000000 ";
    CHECK(error_of("") == frame_errc::too_short);
    CHECK(error_of(start + "88a4 0d") == frame_errc::too_short);
    CHECK(error_of(start + "8100 2005 88") == frame_errc::too_short);
    CHECK(error_of(start + "0800 0d10 0000") == frame_errc::not_ethercat);
    CHECK(error_of(start + "8100 2005 0800 0d10") == frame_errc::not_ethercat);
    CHECK(error_of(start + "88a4 0d40 00000000000000000000000000") == frame_errc::not_datagrams);
    CHECK(error_of(start + "88a4 0d10 0705 0000 0000 0100 0000 00 00") == frame_errc::length_beyond_frame);
    CHECK(error_of(start + "88a4 0010") == frame_errc::truncated_datagram);
    CHECK(error_of(start + "88a4 0d10 0705 0000 0000 0200 0000 00 0000 00") == frame_errc::truncated_datagram);
    CHECK(error_of(start + "88a4 0d10 0705 0000 0000 0180 0000 00 0000") == frame_errc::truncated_datagram);
    CHECK(error_of(start + "88a4 0e10 0705 0000 0000 0100 0000 00 0000 00") == frame_errc::length_mismatch);
    CHECK(view.begin() == view.end());
    for (unsigned code = 1; code <= static_cast<unsigned>(frame_errc::field_out_of_range); ++code)
        CHECK(describe(static_cast<frame_errc>(code)) != "unknown error");
}

TEST_CASE("one datagram holds up to 1486 bytes of data") {
    std::array<std::byte, 2000> out{};
    frame_builder full{out};
    CHECK(full.add(command::fpwr, 1, 0x1000, max_datagram_data).size() == max_datagram_data);
    CHECK(full.finish()->size() == max_frame_size);
    frame_builder over{out};
    CHECK(over.add(command::fpwr, 1, 0x1000, max_datagram_data + 1).empty());
    CHECK(over.finish().error() == frame_errc::no_space);
    frame_builder second{out};
    second.add(command::fpwr, 1, 0x1000, max_datagram_data);
    second.add(command::fprd, 1, 0x0130, 2);
    CHECK(second.finish().error() == frame_errc::no_space);
    frame_builder huge{out};
    huge.add(command::fpwr, 1, 0x1000, std::size_t{65536 + 10});
    CHECK(huge.finish().error() == frame_errc::no_space);
}

TEST_CASE("a frame that cannot be built has an error") {
    std::array<std::byte, 59> small{};
    frame_builder unpadded{small};
    unpadded.add(command::brd, 0, 0, 1);
    CHECK(unpadded.finish().error() == frame_errc::no_space);
    CHECK(frame_builder{std::span{small}.first(15)}.finish().error() == frame_errc::no_space);
    std::array<std::byte, 64> out{};
    CHECK(frame_builder{out}.finish().error() == frame_errc::empty);
    frame_builder wide{out};
    wide.add(command::fpwr, 1, 0x0120, al_control{.state = static_cast<al_state>(16)});
    CHECK(wide.finish().error() == frame_errc::field_out_of_range);
}

TEST_CASE("mailbox and CoE headers have the standard's bits") {
    CHECK(bytes_of(mailbox_header{.length = 0x26, .type = mailbox_type::coe, .counter = 5}) == "26 00 00 00 00 53");
    CHECK(bytes_of(mailbox_header{.length = 4, .address = 0x1001, .channel = 2, .priority = 3}) == "04 00 01 10 c2 00");
    CHECK(bytes_of(mailbox_header{.counter = 8}) == wire::describe(wire::errc::out_of_range));
    CHECK(bytes_of(mailbox_error_reply{.type = 1, .code = mailbox_error_code::invalid_size}) == "01 00 08 00");
    CHECK(bytes_of(coe_header{.service = coe_service::sdo_request}) == "00 20");
    CHECK(bytes_of(coe_header{.number = 0x101, .service = coe_service::sdo_response}) == "01 31");
}

TEST_CASE("SDO commands have the standard's bytes") {
    const auto command = [](sdo_header header) {
        header.index = 0x1B1A;
        header.subindex = 1;
        return bytes_of(sdo_normal{.header = header, .size = 28});
    };
    CHECK(command({.size_indicated = true, .specifier = sdo_specifier::download_request}) == "21 1a 1b 01 1c 00 00 00");
    CHECK(command({.specifier = sdo_specifier::upload_request}) == "40 1a 1b 01 1c 00 00 00");
    CHECK(command({.specifier = sdo_specifier::download_response}) == "60 1a 1b 01 1c 00 00 00");
    CHECK(command({.complete_access = true, .specifier = sdo_specifier::upload_request}) == "50 1a 1b 01 1c 00 00 00");
    const sdo_header one_byte{.size_indicated = true,
                              .expedited = true,
                              .unused = 3,
                              .specifier = sdo_specifier::download_request,
                              .index = 0x2002};
    CHECK(bytes_of(sdo_expedited{.header = one_byte, .data = {std::byte{0x5A}}}) == "2f 02 20 00 5a 00 00 00");
    const sdo_header abort{.specifier = sdo_specifier::abort, .index = 0x5555, .subindex = 1};
    CHECK(bytes_of(sdo_abort{.header = abort, .code = abort_code::no_object}) == "80 55 55 01 00 00 02 06");
    CHECK(bytes_of(sdo_segment_header{
              .last = true, .unused = 5, .toggle = true, .specifier = sdo_specifier::download_segment_request}) ==
          "1b");
    CHECK(bytes_of(coe_emergency{.error_code = 0xA001, .error_register = 0x10, .data = {std::byte{7}}}) ==
          "01 a0 10 07 00 00 00 00");
}

TEST_CASE("registers have the standard's bits") {
    CHECK(bytes_of(al_control{.state = al_state::pre_op, .acknowledge = true}) == "12 00");
    CHECK(bytes_of(al_status{.state = al_state::init, .error = true, .code = al_status_code::mailbox_pre_op}) ==
          "11 00 00 00 16 00");
    CHECK(bytes_of(sync_manager{.start = 0x1000,
                                .length = 128,
                                .mode = sync_manager_mode::mailbox,
                                .direction = sync_manager_direction::master_writes,
                                .pdi_interrupt = true,
                                .enable = true}) == "00 10 80 00 26 00 01 00");
    CHECK(bytes_of(sync_manager{.full = true, .repeat_request = true, .repeat_acknowledge = true}) ==
          "00 00 00 00 00 08 02 02");
    CHECK(bytes_of(sync_manager_handshake{.full = true, .enable = true}) == "08 01 00");
    CHECK(bytes_of(sii_request{.cmd = sii_command::read, .address = 0x18}) == "00 01 18 00 00 00");
    CHECK(bytes_of(sii_request{.eight_byte_reads = true, .busy = true}) == "40 80 00 00 00 00");
    CHECK(bytes_of(sii_owner{.force = true}) == "02");
    CHECK(bytes_of(sii_mailbox{
              .receive_offset = 0x1000, .receive_size = 128, .send_offset = 0x1400, .send_size = 128, .coe = true}) ==
          "00 10 80 00 00 14 80 00 04 00");
}

TEST_CASE("the parser survives 100000 random mutations of a frame") {
    std::mt19937 random{2024};
    const auto original = two_datagrams();
    std::size_t accepted = 0;
    for (int round = 0; round != 100'000; ++round) {
        auto frame = original;
        for (unsigned changes = random() % 4; changes != 0; --changes)
            frame[random() % frame.size()] = static_cast<std::byte>(random());
        frame.resize(random() % 8 == 0 ? random() % (frame.size() + 1) : frame.size());
        frame_view view;
        if (!view.parse(frame)) {
            REQUIRE(view.begin() == view.end());
            continue;
        }
        ++accepted;
        for (const auto datagram : view) {
            REQUIRE(datagram.bytes.data() >= frame.data());
            REQUIRE(datagram.bytes.data() + datagram.bytes.size() <= frame.data() + frame.size());
        }
    }
    CHECK(accepted > 10'000);
    CHECK(accepted < 100'000);
}
