// The packets of the EtherCAT master's API byte by byte, against the manual's tables.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/schema/ethercat/hilscher_info.hpp>
#include <jauscat/schema/ethercat/hilscher_state.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <string>

using namespace jauscat::hilscher;
using jauscat::test::from_hex;
using jauscat::test::hex_of;
using jauscat::test::to_hex;
namespace ethercat = jauscat::ethercat;
namespace wire = jauscat::wire;

namespace {

/// The packet's bytes after the header; the header is checked to carry the command and this length, and to be 40 bytes.
template <class Packet> std::string body(Packet packet, std::uint32_t command, std::uint32_t length) {
    std::array<std::byte, 128> bytes{};
    const auto encoded = wire::encode(packet, bytes);
    REQUIRE(encoded);
    packet_header head{};
    REQUIRE(*wire::decode_prefix(head, bytes) == 40);
    CHECK(static_cast<std::uint32_t>(head.ul_cmd) == command);
    CHECK(head.ul_len == length);
    const auto rest = encoded->subspan(40);
    return rest.empty() ? std::string{} : to_hex(rest);
}

/// The packet that these bytes of body make, after a header of zeros.
template <class Packet> Packet read(const char* text) {
    auto bytes = from_hex(text);
    bytes.insert(bytes.begin(), 40, std::byte{});
    Packet packet{};
    REQUIRE(wire::decode(packet, bytes));
    return packet;
}

} // namespace

TEST_CASE("the packet header has ten words in the manual's order") {
    std::array<std::byte, 40> bytes{};
    const packet_header head{.ul_dest = 0x01020304,
                             .ul_src = 0x11121314,
                             .ul_dest_id = 0x21222324,
                             .ul_src_id = 0x31323334,
                             .ul_len = 0x41424344,
                             .ul_id = 0x51525354,
                             .ul_sta = packet_status::coe_timeout,
                             .ul_cmd = packet_command::sdo_upload_cnf,
                             .ul_ext = 0x81828384,
                             .ul_rout = 0x91929394};
    REQUIRE(wire::encode(head, bytes)->size() == 40);
    CHECK(to_hex(bytes) == hex_of("04030201 14131211 24232221 34333231 44434241 54535251 150065c0 07006500"
                                  " 84838281 94939291"));
}

TEST_CASE("packets about a slave's dictionary have the manual's layout") {
    CHECK(body(get_od_list_request{.ul_node_id = 0x100, .ul_list_type = packet_list_type::start_up}, 0x65000A, 8) ==
          hex_of("00010000 05000000"));
    CHECK(body(get_od_list_confirmation{.ul_node_id = 0x100, .ul_list_type = packet_list_type::all, .ul_data_cnt = 3},
               0x65000B, 0) == hex_of("00010000 01000000 03000000"));
    CHECK(body(get_object_description_request{.ul_node_id = 0x100, .ul_index = 0x1018}, 0x650018, 8) ==
          hex_of("00010000 18100000"));
    CHECK(body(get_object_description_confirmation{.ul_node_id = 0x100,
                                                   .ul_index = 0x1018,
                                                   .ul_data_type = 0x23,
                                                   .ul_obj_code = 9,
                                                   .ul_obj_category = 1,
                                                   .ul_max_num_sub_index = 4,
                                                   .ul_ob_name_len = 8},
               0x650019, 0) == hex_of("00010000 18100000 23000000 09000000 01000000 04000000 08000000"));
    CHECK(body(
              get_entry_description_request{
                  .ul_node_id = 0x100, .ul_index = 0x1018, .ul_sub_index = 2, .ul_access_bit_mask = 0x7F},
              0x65001A, 16) == hex_of("00010000 18100000 02000000 7f000000"));
    CHECK(
        body(get_entry_description_confirmation{.ul_node_id = 0x100,
                                                .ul_index = 0x1018,
                                                .ul_sub_index = 2,
                                                .ul_value_info = 0x0F,
                                                .ul_data_type = 7,
                                                .ul_bit_len = 32,
                                                .ul_ob_access = {.read_pre_op = true, .tx_pdo = true, .setting = true},
                                                .f_rx_pdo_mapping = 0,
                                                .f_tx_pdo_mapping = 1,
                                                .ul_unit_type = 0x01020304,
                                                .ul_data_len = 5},
             0x65001B, 0) == hex_of("00010000 18100000 02000000 0f000000 07000000 20000000 81020000 00000000"
                                    " 01000000 04030201 05000000"));
}

TEST_CASE("packets about the bus have the manual's layout") {
    CHECK(body(set_state_request{.us_new_ec_state = bus_state::op}, 0x650048, 2) == hex_of("0800"));
    CHECK(body(set_state_confirmation{}, 0x650049, 0).empty());
    CHECK(body(get_state_request{}, 0x650046, 0).empty());
    CHECK(body(get_state_confirmation{.us_current_ec_state = bus_state::safe_op}, 0x650047, 2) == hex_of("0400"));
    CHECK(body(start_bus_scan_request{.ul_timeout = 1000}, 0x650020, 4) == hex_of("e8030000"));
    CHECK(body(start_bus_scan_confirmation{.ul_found_slaves = 3}, 0x650021, 4) == hex_of("03000000"));
    CHECK(body(get_bus_scan_info_request{.us_auto_inc_addr = 0xFFFE}, 0x650022, 2) == hex_of("feff"));
    CHECK(body(get_bus_scan_info_confirmation{.ul_vendor_id = 1,
                                              .ul_product_code = 2,
                                              .ul_revision_number = 3,
                                              .ul_serial_number = 4,
                                              .ul_port_state = 0x5611},
               0x650023, 20) == hex_of("01000000 02000000 03000000 04000000 11560000"));
    CHECK(body(get_slave_handles_request{.ul_param = handle_list::active}, 0x2F08, 4) == hex_of("02000000"));
    CHECK(body(get_slave_handles_confirmation{.ul_param = handle_list::faulted}, 0x2F09, 0) == hex_of("03000000"));
    CHECK(body(read_emergencies_request{.ul_slave_handle = 7, .f_delete_emergency = 1}, 0x65001C, 8) ==
          hex_of("07000000 01000000"));
    CHECK(body(read_emergencies_confirmation{.ul_slave_handle = 7, .f_delete_emergency = 1, .f_overflow_occured = 1},
               0x65001D, 52) == hex_of("07000000 01000000 01000000"));
}

TEST_CASE("packets decode to the encoded values") {
    CHECK(read<get_od_list_request>("00010000 02000000").ul_list_type == packet_list_type::rx_pdo);
    const auto object =
        read<get_object_description_confirmation>("00010000 18100000 23000000 09000000 01000000 04000000 08000000");
    CHECK(object.ul_obj_code == static_cast<std::uint32_t>(ethercat::object_code::record));
    CHECK(object.ul_ob_name_len == 8);
    const auto entry = read<get_entry_description_confirmation>(
        "00010000 18100000 02000000 0f000000 07000000 20000000 81020000 00000000 01000000 04030201 05000000");
    CHECK(entry.ul_ob_access.read_pre_op);
    CHECK_FALSE(entry.ul_ob_access.write_op);
    CHECK(entry.f_tx_pdo_mapping == 1);
    CHECK(entry.ul_unit_type == 0x01020304);
    CHECK(read<get_state_confirmation>("0400").us_current_ec_state == bus_state::safe_op);
    CHECK(read<get_bus_scan_info_request>("ffff").us_auto_inc_addr == 0xFFFF);
}
