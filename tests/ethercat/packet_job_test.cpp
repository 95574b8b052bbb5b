// Request packets executed by the master: the confirmations to the byte.
#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/ethercat/hilscher/packet_job.hpp>
#include <jauscat/ethercat/slave/loopback_link.hpp>
#include <jauscat/net/link/run_master.hpp>

#include <array>
#include <vector>

using namespace jauscat::ethercat;
using jauscat::hilscher::packet_status;
using jauscat::test::from_hex;
using jauscat::test::hex_of;
using jauscat::test::to_hex;
namespace hilscher = jauscat::hilscher;
namespace net = jauscat::net;
namespace test = jauscat::test;

namespace {

using bytes = std::vector<std::byte>;

// One slave at station 0100h, with objects of 4 and of 600 bytes.
struct bench {
    test::objects objects{};
    std::array<slave, 1> devices{
        slave{{.vendor = 1, .product = 2, .mailbox_out_size = 1024, .mailbox_in_size = 1024}, objects}};
    loopback_link link{devices};
    master_for<16> m{};

    bench() {
        objects.add(0x2000, 1, 4);
        objects.add(0x3000, 0, 600);
        REQUIRE(net::run(link, m, bring_up{0, 0x0100}));
    }
    bytes execute(const bytes& request) {
        bytes confirmation(packet_job::confirmation_size);
        packet_job job{request, confirmation};
        if (job.start(m)) static_cast<void>(net::run(link, m));
        confirmation.resize(job.finish(m));
        return confirmation;
    }
    std::string answer(const char* request) { return to_hex(execute(from_hex(request))); }
};

/// A download of 4 bytes to object 2000h:1 of slave 0100h, packet number 1.
constexpr const char* download_request = "20000000 00000000 00000000 00000000 14000000 01000000 00000000 08006500"
                                         " 00000000 00000000 00010000 00200000 01000000 04000000 44332211";

bytes with(bytes packet, std::size_t offset, std::uint32_t value) {
    REQUIRE(jauscat::wire::encode(esc_word{static_cast<std::uint16_t>(value)}, std::span{packet}.subspan(offset)));
    REQUIRE(jauscat::wire::encode(esc_word{static_cast<std::uint16_t>(value >> 16)},
                                  std::span{packet}.subspan(offset + 2)));
    return packet;
}
/// ulSta of a confirmation.
std::uint32_t status_of(const bytes& confirmation) {
    hilscher::packet_header head{};
    REQUIRE(jauscat::wire::decode_prefix(head, confirmation));
    return static_cast<std::uint32_t>(head.ul_sta);
}

} // namespace

TEST_CASE("a download is confirmed by 40 bytes: the request's header with command 650009h and no length") {
    bench b;
    CHECK(b.answer(download_request) == hex_of("20000000 00000000 00000000 00000000 00000000 01000000 00000000 09006500"
                                               " 00000000 00000000"));
    CHECK(to_hex(b.objects.entries.at({0x2000, 1}).value) == "44 33 22 11");
}

TEST_CASE("a download to a missing object is confirmed with ulSta C0650031h") {
    bench b;
    b.objects.entries.clear();
    CHECK(b.answer(download_request) == hex_of("20000000 00000000 00000000 00000000 00000000 01000000 310065c0 09006500"
                                               " 00000000 00000000"));
}

TEST_CASE("an upload is confirmed with the data, and after an error by 52 bytes") {
    bench b;
    b.objects.entries.at({0x2000, 1}).value = from_hex("44332211");
    const auto upload = "20000000 07000000 00000000 08000000 0c000000 02000000 00000000 06006500 00000000 00000000"
                        " 00010000 00200000 01000000";
    CHECK(b.answer(upload) == hex_of("20000000 07000000 00000000 08000000 14000000 02000000 00000000 07006500"
                                     " 00000000 00000000 00010000 00200000 01000000 04000000 44332211"));
    b.objects.entries.at({0x2000, 1}).read_abort = abort_code::write_only;
    CHECK(b.answer(upload) == hex_of("20000000 07000000 00000000 08000000 0c000000 02000000 2f0065c0 07006500"
                                     " 00000000 00000000 00010000 00200000 01000000"));
}

TEST_CASE("every abort with a status of its own is confirmed with that status") {
    bench b;
    for (std::uint32_t status = 0xC0650027; status != 0xC0650044; ++status) {
        CAPTURE(status);
        const auto code = hilscher::abort_of(static_cast<packet_status>(status));
        REQUIRE(code != abort_code::none);
        b.objects.entries.at({0x2000, 1}).write_abort = code;
        CHECK(status_of(b.execute(from_hex(download_request))) == status);
    }
    b.objects.entries.at({0x2000, 1}).write_abort = abort_code::subindex_0_not_zero;
    CHECK(status_of(b.execute(from_hex(download_request))) == 0xC0650044);
}

TEST_CASE("an impossible request is confirmed with the reason, and nothing is sent") {
    bench b;
    const auto sent = b.m.statistics().sent;
    const auto request = from_hex(download_request);
    CHECK(status_of(b.execute(with(request, 28, 0x0065001E))) == 0xC0000004); // no such command here
    CHECK(status_of(b.execute(with(request, 16, 19))) == 0xC0000007);         // ulLen shorter than the data
    CHECK(status_of(b.execute(with(request, 52, 5))) == 0xC0000007);          // ulDataCnt beyond the packet
    CHECK(status_of(b.execute(with(request, 52, 0xFFFFFFF8))) == 0xC0000007);
    CHECK(status_of(b.execute(with(request, 44, 0x10000))) == 0xC0000009);
    CHECK(status_of(b.execute(with(request, 48, 0x100))) == 0xC0000009);
    CHECK(status_of(b.execute(with(request, 40, 0x10100))) == 0xC065000F);
    CHECK(status_of(b.execute(with(request, 40, 0x0101))) == 0xC065000F); // no slave has this station address
    CHECK(status_of(b.execute(bytes(request.begin(), request.begin() + 55))) == 0xC0000007);
    CHECK(b.execute(bytes(request.begin(), request.begin() + 39)).empty());
    CHECK(b.m.statistics().sent == sent);
    CHECK(b.objects.writes == 0);

    REQUIRE(b.m.start(upload{0x0100, 0x2000, 1, {}}));
    CHECK(status_of(b.execute(request)) == 0xC065001B); // the master is at work
}

TEST_CASE("a packet may be longer than its data count, which decides") {
    bench b;
    auto request = with(from_hex(download_request), 16, 1556);
    request.resize(1596);
    CHECK(status_of(b.execute(request)) == 0);
    CHECK(b.objects.entries.at({0x2000, 1}).value.size() == 4);
}

TEST_CASE("a download clears subindex 0 first on request") {
    bench b;
    b.objects.add(0x2000, 0, 1);
    b.objects.entries.at({0x2000, 0}).value = {std::byte{5}};
    const auto request = from_hex(download_request);
    const auto status = [&](const download_options& options) {
        bytes confirmation(packet_job::confirmation_size);
        packet_job job{request, confirmation, {.download = options}};
        REQUIRE(job.start(b.m));
        static_cast<void>(net::run(b.link, b.m));
        confirmation.resize(job.finish(b.m));
        return status_of(confirmation);
    };
    CHECK(status({}) == 0);
    CHECK(b.objects.entries.at({0x2000, 0}).value.front() == std::byte{5});
    CHECK(status({.clear_subindex_0 = true}) == 0);
    CHECK(b.objects.entries.at({0x2000, 0}).value.front() == std::byte{0});
    b.objects.entries.at({0x2000, 0}).write_abort = abort_code::read_only;
    CHECK(status({.clear_subindex_0 = true}) == 0xC0650030);
}

TEST_CASE("data that exceed the confirmation are not read, and a confirmation needs at least 40 bytes") {
    bench b;
    const auto upload = from_hex("20000000 00000000 00000000 00000000 0c000000 00000000 00000000 06006500"
                                 " 00000000 00000000 00010000 00300000 00000000");
    const auto size_in = [&](std::size_t room) {
        bytes confirmation(room);
        packet_job job{upload, confirmation};
        if (job.start(b.m)) static_cast<void>(net::run(b.link, b.m));
        confirmation.resize(job.finish(b.m));
        return std::pair{confirmation.size(), confirmation.size() < 40 ? 0 : status_of(confirmation)};
    };
    CHECK(size_in(656) == std::pair{std::size_t{656}, 0u});
    CHECK(size_in(655) == std::pair{std::size_t{52}, 0xC0650018u});
    CHECK(size_in(55) == std::pair{std::size_t{52}, 0xC0000003u});
    CHECK(size_in(51) == std::pair{std::size_t{0}, 0u});
}

TEST_CASE("the master's own errors have packet statuses") {
    const auto status = [](master_errc error) {
        return static_cast<std::uint32_t>(hilscher::status_of(master_error{.code = error}));
    };
    CHECK(status(master_errc::ok) == 0);
    CHECK(status(master_errc::not_sent) == 0xC0650002);
    CHECK(status(master_errc::no_reply) == 0xC0650014);
    CHECK(status(master_errc::timeout) == 0xC0650015);
    CHECK(status(master_errc::no_slave) == 0xC0650016);
    CHECK(status(master_errc::wrong_station) == 0xC065000F);
    CHECK(status(master_errc::working_counter) == 0xC065001A);
    CHECK(status(master_errc::no_mailbox) == 0xC0650023);
    CHECK(status(master_errc::no_coe) == 0xC0650024);
    CHECK(status(master_errc::al_error) == 0xC0650013);
    CHECK(status(master_errc::mailbox_timeout) == 0xC0650015);
    CHECK(status(master_errc::mailbox_error) == 0xC0650022);
    CHECK(status(master_errc::data_too_long) == 0xC0650018);
    CHECK(status(master_errc::toggle_bit) == 0xC0650027);
    CHECK(static_cast<std::uint32_t>(hilscher::status_of(
              {.code = master_errc::clear_refused, .abort = abort_code{0x06010002}})) == 0xC0650030);
    CHECK(status(master_errc::sii_busy) == 0xC0000001); // no status for it: failed
}
