// Registers of the distributed clock, of the ports and of error counters, byte for byte.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/schema/ethercat/dc_registers.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <vector>

using namespace jauscat::ethercat;
namespace wire = jauscat::wire;
using jauscat::test::from_hex;
using jauscat::test::to_hex;

namespace {

template <class Register> std::string bytes_of(const Register&, const typename Register::value_type& value) {
    std::vector<std::byte> bytes(wire::max_size<typename Register::value_type>);
    REQUIRE(wire::encode(value, bytes));
    return to_hex(bytes);
}
template <class Register> typename Register::value_type value_of(const Register& at, std::string_view hex) {
    typename Register::value_type value{};
    const auto bytes = from_hex(hex);
    REQUIRE(bytes.size() == at.size);
    REQUIRE(wire::decode(value, bytes));
    return value;
}

} // namespace

TEST_CASE("a clock's difference is sign and magnitude") {
    const auto at = esc_registers::dc_difference;
    CHECK(value_of(at, "05000000").value() == 5);
    CHECK(value_of(at, "05000080").value() == -5);
    CHECK(value_of(at, "ffffffff").value() == -INT32_MAX);
    CHECK(bytes_of(at, dc_difference::of(-1)) == "01 00 00 80");
    CHECK(bytes_of(at, dc_difference::of(INT32_MIN)) == "ff ff ff ff");
}

TEST_CASE("a clock's times and offsets are little-endian numbers of nanoseconds") {
    CHECK(value_of(esc_registers::dc_receive_times, "01000000 02000000 03000000 ffffffff").ports ==
          std::array<std::uint32_t, 4>{1, 2, 3, 0xFFFFFFFF});
    CHECK(bytes_of(esc_registers::dc_offset, {-2}) == "fe ff ff ff ff ff ff ff");
    CHECK(bytes_of(esc_registers::dc_system_time, {0x0102030405060708}) == "08 07 06 05 04 03 02 01");
    CHECK(value_of(low_half(esc_registers::dc_system_time), "08070605").value == 0x05060708);
}

TEST_CASE("bits of the SYNC unit") {
    CHECK(bytes_of(esc_registers::dc_activation, {.on = true, .sync0 = true}) == "03");
    CHECK(bytes_of(esc_registers::dc_activation, {.on = true, .sync0 = true, .sync1 = true}) == "07");
    CHECK(bytes_of(esc_registers::dc_cyclic_control, {.latch0_by_pdi = true, .latch1_by_pdi = true}) == "30");
    CHECK(value_of(esc_registers::dc_activation_status, "04").start_not_near);
}

TEST_CASE("error counters stand in the order of the data sheet") {
    const auto counted = value_of(esc_registers::error_counters, "0102030405060708 090a0b0c 0d 0e ffff 1112ff14");
    CHECK(counted.ports == std::array<port_error_counters, 4>{{{1, 2}, {3, 4}, {5, 6}, {7, 8}}});
    CHECK(counted.forwarded_errors == std::array<std::uint8_t, 4>{9, 10, 11, 12});
    CHECK(counted.processing_errors == 13);
    CHECK(counted.pdi_errors == 14);
    CHECK(counted.lost_links == std::array<std::uint8_t, 4>{0x11, 0x12, 0xFF, 0x14});
}

TEST_CASE("a port is open if its loop is open and it communicates") {
    const auto line = value_of(esc_registers::dl_status, "305a").ports();
    CHECK(line[0].is_open());
    CHECK(line[1].is_open());
    CHECK(line[2] == dl_port{.link = false, .closed = true, .communication = false});
    const auto end = value_of(esc_registers::dl_status, "1056").ports();
    CHECK(end[0].is_open());
    CHECK_FALSE(end[1].is_open());
    const auto features = value_of(esc_registers::description, "11 00 0000 08 08 08 0f fc01");
    CHECK(features.dc);
    CHECK(features.dc_64);
    CHECK(features.dc_sync_activation);
    CHECK_FALSE(features.no_lrw);
}
