// Packets about the bus: its state, scans, handles, emergencies; and what SDO packets say of slaves that are not there.
#include "ethercat/packet_bench.hpp"

#include <array>
#include <memory>
#include <vector>

using namespace jauscat::ethercat;
using namespace jauscat::hilscher;
using jauscat::test::from_hex;
using jauscat::test::hex_of;
using jauscat::test::packet_bench;
using bytes = std::vector<std::byte>;

namespace {

constexpr std::array outputs{pdo_entry{0x7000, 1, 16, 6, "effort x"}, pdo_entry{0x7000, 2, 16, 6, "effort y"}};
constexpr std::array inputs{pdo_entry{0x6000, 1, 8, 5, "count"}};
constexpr std::array<bus_slave, 3> stations{bus_slave{0, 0x100}, bus_slave{1, 0x200}, bus_slave{2, 33}};

// Three slaves: with process data, without, and with inputs only.
struct bus : packet_bench {
    bus() {
        add({.vendor = 1, .product = 2, .revision = 3, .serial = 4, .outputs = outputs, .inputs = inputs});
        add({.vendor = 5, .product = 6, .revision = 7, .serial = 8});
        add({.vendor = 9, .product = 10, .inputs = inputs});
        options.slaves = stations;
    }
    std::uint32_t set(bus_state state) {
        const auto answer = ask(set_state_request{.us_new_ec_state = state});
        CHECK(answer.body.empty());
        return answer.status;
    }
    std::string state() {
        const auto answer = ask(get_state_request{});
        CHECK(answer.status == 0);
        return answer.body;
    }
    // Status of a read of the device type of a slave.
    std::uint32_t read(std::uint32_t station) {
        return ask(sdo_upload_request{.ul_node_id = station, .ul_index = 0x1000}).status;
    }
    void expect(al_state wanted) {
        for (const auto& each : devices) CHECK(each.slave.state() == wanted);
    }
};

constexpr const char* get_state = "20000000 00000000 00000000 00000000 00000000 07000000 00000000 46006500"
                                  " 00000000 00000000";
constexpr const char* set_pre_op = "20000000 00000000 00000000 00000000 02000000 08000000 00000000 48006500"
                                   " 00000000 00000000 0200";

} // namespace

TEST_CASE("set state and get state are confirmed byte for byte") {
    bus b;
    CHECK(b.answer(set_pre_op) == hex_of("20000000 00000000 00000000 00000000 00000000 08000000 00000000 49006500"
                                         " 00000000 00000000"));
    CHECK(b.answer(get_state) == hex_of("20000000 00000000 00000000 00000000 02000000 07000000 00000000 47006500"
                                        " 00000000 00000000 0200"));
}

TEST_CASE("set state changes the state of all configured slaves together") {
    bus b;
    CHECK(b.state() == "01 00");
    for (const auto& [state, reached] : {std::pair{bus_state::op, al_state::op},
                                         {bus_state::safe_op, al_state::safe_op},
                                         {bus_state::op, al_state::op},
                                         {bus_state::pre_op, al_state::pre_op},
                                         {bus_state::init, al_state::init},
                                         {bus_state::pre_op, al_state::pre_op},
                                         {bus_state::safe_op, al_state::safe_op},
                                         {bus_state::init, al_state::init},
                                         {bus_state::op, al_state::op},
                                         {bus_state::op, al_state::op}}) {
        CAPTURE(static_cast<unsigned>(state));
        CHECK(b.set(state) == 0);
        b.expect(reached);
        CHECK(b.state() == (state == bus_state::op        ? "08 00"
                            : state == bus_state::safe_op ? "04 00"
                            : state == bus_state::pre_op  ? "02 00"
                                                          : "01 00"));
        for (const auto& slave : stations) CHECK(b.read(slave.station) == (state == bus_state::init ? 0xC0650013 : 0));
    }
}

TEST_CASE("the state of the bus is that of its lowest slave, or 0 without slaves") {
    bus b;
    REQUIRE(b.set(bus_state::op) == 0);
    REQUIRE(b.link.run(b.master, change_state{0x200, al_state::pre_op}));
    CHECK(b.state() == "02 00");
    REQUIRE(b.link.run(b.master, change_state{33, al_state::init}));
    CHECK(b.state() == "01 00");
    CHECK(b.set(bus_state::op) == 0);
    b.expect(al_state::op);
    b.devices.clear();
    CHECK(b.state() == "00 00");
}

TEST_CASE("a slave that was reset is brought up again on a state change") {
    bus b;
    REQUIRE(b.set(bus_state::op) == 0);
    b.devices[1].slave.power_on();
    CHECK(b.read(0x200) == 0xC0650016); // no slave has its address
    CHECK(b.set(bus_state::op) == 0);
    b.expect(al_state::op);
    CHECK(b.read(0x200) == 0);
}

TEST_CASE("states that cannot be set are confirmed with an error") {
    bus b;
    CHECK(b.set(bus_state::unknown) == 0xC0650076);
    CHECK(b.set(bus_state::boot) == 0xC0650076);
    CHECK(b.set(static_cast<bus_state>(0x10)) == 0xC0650076);
    b.options.slaves = {};
    CHECK(b.set(bus_state::pre_op) == 0xC065000D); // no slave is known
    const std::array<bus_slave, 257> too_many{};
    b.options.slaves = too_many;
    CHECK(b.set(bus_state::pre_op) == 0xC0650010);

    constexpr std::array absent{bus_slave{0, 0x100}, bus_slave{3, 0x400}};
    b.options.slaves = absent;
    CHECK(b.set(bus_state::pre_op) == 0xC0650016);
    constexpr std::array other{bus_slave{0, 0x100, {.product = 3}}};
    b.options.slaves = other;
    CHECK(b.set(bus_state::pre_op) == 0xC0000001);
    b.options.slaves = stations;
    b.link.faults.lose = 100;
    CHECK(b.set(bus_state::pre_op) == 0xC0650014);
    b.link.faults.lose = 0;
    CHECK(b.set(bus_state::pre_op) == 0);

    bytes data(4);
    REQUIRE(b.master.start(upload{0x100, 0x1000, 0, data}));
    CHECK(b.set(bus_state::op) == 0xC0650075);
    CHECK(b.ask(get_state_request{}).status == 0xC065001B);
}

TEST_CASE("a slave that refuses a state fails the service") {
    bus b;
    constexpr std::array first{bus_slave{0, 0x100}};
    b.options.slaves = first;
    REQUIRE(b.set(bus_state::pre_op) == 0);
    // The master requests OP while the slave is still in PRE-OP: the answer is AL status code 0011h.
    b.link.on_way_back = [](bytes& frame) {
        if (frame.at(20) == std::byte{0x30} && frame.at(21) == std::byte{0x01} && frame.at(26) == std::byte{4})
            frame.at(26) = std::byte{0x12}, frame.at(30) = std::byte{0x11};
    };
    CHECK(b.set(bus_state::safe_op) == 0xC0000001);
}

TEST_CASE("a bus scan counts the slaves, brings them up at stations 1, 2, 3 and reports their identities") {
    bus b;
    b.options.slaves = {};
    CHECK(b.answer("20000000 00000000 00000000 00000000 04000000 00000000 00000000 20006500 00000000 00000000"
                   " e8030000") == hex_of("20000000 00000000 00000000 00000000 04000000 00000000 00000000 21006500"
                                          " 00000000 00000000 03000000"));
    b.expect(al_state::pre_op);
    for (std::uint16_t station = 1; station != 4; ++station) CHECK(b.read(station) == 0);
    CHECK(b.answer("20000000 00000000 00000000 00000000 02000000 00000000 00000000 22006500 00000000 00000000 ffff") ==
          hex_of("20000000 00000000 00000000 00000000 14000000 00000000 00000000 23006500 00000000 00000000"
                 " 05000000 06000000 07000000 08000000 10560000"));
    CHECK(b.ask(get_bus_scan_info_request{.us_auto_inc_addr = 0}).body ==
          hex_of("01000000 02000000 03000000 04000000 10560000"));
    CHECK(b.ask(get_bus_scan_info_request{.us_auto_inc_addr = 0xFFFD}).status == 0xC0650012);
    CHECK(b.set(bus_state::op) == 0); // of what the scan has found
    b.expect(al_state::op);
}

TEST_CASE("a scan assigns the configured stations, continues after a refusal, and works without a timeout") {
    bus b;
    b.add({.vendor = 11, .mailbox_out_size = 0, .mailbox_in_size = 256}); // no usable mailbox
    b.add({.vendor = 12});
    const auto scan = b.answer("20000000 00000000 00000000 00000000 00000000 00000000 00000000 20006500"
                               " 00000000 00000000");
    CHECK(scan == hex_of("20000000 00000000 00000000 00000000 04000000 00000000 00000000 21006500 00000000 00000000"
                         " 05000000"));
    CHECK(b.read(0x100) == 0);
    CHECK(b.read(33) == 0);
    CHECK(b.read(5) == 0);
    CHECK(b.ask(get_bus_scan_info_request{.us_auto_inc_addr = 0xFFFD}).status == 0xC0650023);
    b.link.faults.lose = 100;
    CHECK(b.ask(start_bus_scan_request{}).status == 0xC0650014);
    CHECK(b.ask(get_bus_scan_info_request{}).status == 0xC0650014);
}

TEST_CASE("a slave that was not scanned is brought up when it is queried") {
    bus b;
    CHECK(b.ask(get_bus_scan_info_request{.us_auto_inc_addr = 0xFFFE}).body.substr(0, 11) == "09 00 00 00");
    CHECK(b.read(33) == 0);
    CHECK(b.read(0x100) == 0xC065000F);
}

TEST_CASE("handles are station addresses of configured, active and faulted slaves") {
    bus b;
    const auto handles = [&](handle_list list) { return b.ask(get_slave_handles_request{.ul_param = list}); };
    CHECK(handles(handle_list::configured).body == hex_of("01000000 00010000 00020000 21000000"));
    CHECK(handles(handle_list::active).body == hex_of("02000000"));
    CHECK(handles(handle_list::faulted).body == hex_of("03000000 00010000 00020000 21000000"));
    REQUIRE(b.set(bus_state::pre_op) == 0);
    CHECK(b.answer("20000000 00000000 00000000 00000000 04000000 00000000 00000000 082f0000 00000000 00000000"
                   " 02000000") == hex_of("20000000 00000000 00000000 00000000 10000000 00000000 00000000 092f0000"
                                          " 00000000 00000000 02000000 00010000 00020000 21000000"));
    CHECK(handles(handle_list::faulted).body == hex_of("03000000"));
    CHECK(handles(static_cast<handle_list>(0)).status == 0xC0000009);
    CHECK(handles(static_cast<handle_list>(4)).status == 0xC0000009);
    b.options.slaves = {};
    CHECK(handles(handle_list::configured).body == hex_of("01000000 00010000 00020000 21000000"));
}

TEST_CASE("emergencies are cleared when read, and those waiting in the mailbox count") {
    bus b;
    REQUIRE(b.set(bus_state::pre_op) == 0);
    constexpr std::uint16_t mailbox = 0x1600;
    unsigned waiting = 2;
    // Emergencies 0042h of this many kinds stand in the mailbox of the first slave.
    b.link.on_way_back = [&](bytes& frame) {
        const auto word = [&](std::size_t at) {
            return std::to_integer<unsigned>(frame.at(at)) | std::to_integer<unsigned>(frame.at(at + 1)) << 8;
        };
        if (frame.at(16) != std::byte{4} || word(18) != 0x100 || word(20) != mailbox || waiting == 0) return;
        const auto mail = from_hex("0a00 0000 00 03 0010 0042 08 0102030405");
        std::ranges::copy(mail, frame.begin() + 26);
        frame.at(26 + 11) = static_cast<std::byte>(waiting--);
        frame.at(26 + 256) = std::byte{1}; // working counter
    };
    const auto emergencies = [&](std::uint32_t slave, std::uint32_t forget) {
        return b.ask(read_emergencies_request{.ul_slave_handle = slave, .f_delete_emergency = forget});
    };
    const auto kept = emergencies(0x100, 0);
    CHECK(kept.status == 0);
    CHECK(kept.length == 52);
    CHECK(kept.body == hex_of("00010000 00000000 00000000 00420802 02030405 00420801 02030405"
                              " 0000000000000000 0000000000000000 0000000000000000"));
    CHECK(emergencies(0x200, 0).body == hex_of("00020000 00000000 00000000 0000000000000000 0000000000000000"
                                               " 0000000000000000 0000000000000000 0000000000000000"));
    waiting = 5; // seven in all: the oldest two are dropped
    CHECK(emergencies(0x100, 1).body == hex_of("00010000 01000000 01000000 00420805 02030405 00420804 02030405"
                                               " 00420803 02030405 00420802 02030405 00420801 02030405"));
    CHECK(emergencies(0x100, 0).body.substr(0, 59) == hex_of("00010000 00000000 00000000 0000000000000000"));
    CHECK(emergencies(0x101, 0).status == 0xC000000E);
    CHECK(emergencies(0x10100, 0).status == 0xC000000E);
    b.link.faults.lose = 100;
    CHECK(emergencies(0x100, 0).status == 0xC0650014);
}

TEST_CASE("a slave in INIT, an absent one and one without CoE are distinguished") {
    bus b;
    REQUIRE(b.set(bus_state::pre_op) == 0);
    REQUIRE(b.link.run(b.master, change_state{0x200, al_state::init}));
    CHECK(b.read(0x200) == 0xC0650013);
    b.devices.pop_back();
    CHECK(b.read(33) == 0xC0650016);
    CHECK(b.read(34) == 0xC065000F);
    CHECK(b.read(0x100) == 0);
}

TEST_CASE("errors of link and mailbox have packet statuses") {
    bus b;
    REQUIRE(b.set(bus_state::pre_op) == 0);
    b.link.on_way_back = [](bytes& frame) {
        const bool reply = frame.at(16) == std::byte{4} && frame.at(21) == std::byte{0x16};
        if (!reply || frame.at(26) == std::byte{}) return;
        const auto mail = from_hex("0400 0000 00 00 0100 0200"); // the protocol is not supported
        std::ranges::copy(mail, frame.begin() + 26);
    };
    CHECK(b.read(0x100) == 0xC0650022);
    b.link.on_way_back = {};
    CHECK(b.read(0x100) == 0);

    bytes request(52), confirmation(packet_job::confirmation_size);
    REQUIRE(jauscat::wire::encode(sdo_upload_request{.ul_node_id = 0x100, .ul_index = 0x1000}, request));
    const auto given_up = [&](master_errc error) {
        packet_job job{request, confirmation};
        REQUIRE(job.start(b.master));
        b.master.cancel(error);
        CHECK_FALSE(job.next(b.master));
        CHECK(job.error().code == error);
        REQUIRE(job.finish(b.master) == 52);
        packet_header head{};
        REQUIRE(jauscat::wire::decode_prefix(head, confirmation));
        return static_cast<std::uint32_t>(head.ul_sta);
    };
    CHECK(given_up(master_errc::not_sent) == 0xC0650002);
    CHECK(given_up(master_errc::timeout) == 0xC0650015);
}

TEST_CASE("a service that could not be started for another reason is confirmed with that reason") {
    bytes request(40), confirmation(packet_job::confirmation_size);
    REQUIRE(jauscat::wire::encode(get_state_request{}, request));
    packet_job job{request, confirmation};
    REQUIRE(job.finish(master_for<1>{}, {.code = master_errc::no_reply}) == 40);
    packet_header head{};
    REQUIRE(jauscat::wire::decode_prefix(head, confirmation));
    CHECK(static_cast<std::uint32_t>(head.ul_sta) == 0xC0650014);
}

TEST_CASE("over a link that loses, duplicates and delays frames a state is reached or refused with a reason") {
    bus b;
    b.link.faults = {.lose = 10, .duplicate = 5, .delay = 20};
    constexpr std::array states{std::pair{bus_state::op, al_state::op}, std::pair{bus_state::init, al_state::init},
                                std::pair{bus_state::safe_op, al_state::safe_op},
                                std::pair{bus_state::pre_op, al_state::pre_op}};
    unsigned reached = 0;
    for (unsigned round = 0; round != 100; ++round) {
        const auto& [wanted, state] = states.at(round * 7 % 11 % states.size());
        CAPTURE(round, static_cast<unsigned>(wanted));
        if (b.set(wanted) != 0) continue;
        b.expect(state);
        ++reached;
    }
    CHECK(reached > 95);
}

TEST_CASE("set state of more slaves than it has room for is refused, and of as many is not") {
    const auto count = packet_set_state::capacity + GENERATE(std::size_t{0}, std::size_t{1});
    const slave_description description{};
    jauscat::test::objects own{};
    standard_objects dictionary{description, own};
    std::vector<slave> slaves;
    slaves.reserve(count);
    for (std::size_t i = 0; i != count; ++i) slaves.emplace_back(description, dictionary);
    jauscat::test::simulated_link link{[&](std::span<std::byte> frame) {
        for (auto& each : slaves) each.process(frame);
    }};
    const auto master = std::make_unique<master_for<packet_set_state::capacity + 44>>();
    const auto execute = [&](auto packet) {
        packet.head.ul_dest = 0x20;
        packet.head.ul_len = static_cast<std::uint32_t>(jauscat::wire::max_size<decltype(packet)> - 40);
        bytes request(jauscat::wire::max_size<decltype(packet)>), confirmation(packet_job::confirmation_size);
        REQUIRE(jauscat::wire::encode(packet, request));
        const auto made = execute_packet(*master, request, confirmation, [&] { return link.run(*master); });
        packet_header head{};
        REQUIRE(jauscat::wire::decode_prefix(head, made));
        return head.ul_sta;
    };
    CHECK(execute(start_bus_scan_request{}) == packet_status::ok);
    CHECK(master->slaves().size() == count);
    const bool has_room = count <= packet_set_state::capacity;
    CHECK(execute(set_state_request{.us_new_ec_state = bus_state::pre_op}) ==
          (has_room ? packet_status::ok : packet_status::coe_no_resource));
    CHECK(execute(get_slave_handles_request{.ul_param = handle_list::active}) == packet_status::ok);
}
