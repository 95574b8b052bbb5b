// sii, pdos, watch and monitor of jauscat-ecat, with emulated slaves.
#include "ecat/tool.hpp"
#include "support/catch.hpp"
#include <jauscat/ethercat/slave/sii_image.hpp>

using namespace ecat_test;
using ethercat::al_state;

namespace {

const std::vector<ethercat::pdo_entry> outputs{
    {.index = 0x7000, .subindex = 1, .bits = 16, .data_type = 6, .name = "target"}};
const std::vector<ethercat::pdo_entry> inputs{
    {.index = 0x6000, .subindex = 1, .bits = 16, .data_type = 3, .name = "position"},
    {.index = 0x6000, .subindex = 2, .bits = 1, .data_type = 1, .name = "ready"},
    {.index = 0, .subindex = 0, .bits = 7},
    {.index = 0x6000, .subindex = 3, .bits = 32, .data_type = 8, .name = "effort"}};

std::vector<ethercat::slave_description> with_process_data() {
    auto slaves = three();
    slaves[1].outputs = outputs;
    slaves[1].inputs = inputs;
    return slaves;
}

} // namespace

TEST_CASE("sii shows the memory decoded") {
    const emulated_bus ring{with_process_data()};
    const auto ended = run("sii --slave 1 --format json" + on(ring));
    CHECK(ended.code == done);
    CHECK(ended.err.empty());
    const auto is = ended.parsed()[0];
    CHECK(is["identity"]["product"] == 2);
    CHECK(is["configuration"]["station_alias"] == 300);
    CHECK(is["configuration"]["checksum_is_right"] == true);
    CHECK(is["mailbox"]["coe"] == true);
    CHECK(is["general"]["name"] == "gripper");
    CHECK(is["sync_managers"].size() == 4);
    CHECK(is["sync_managers"][3]["use"] == "inputs");
    REQUIRE(is["pdos"].size() == 5);
    CHECK(is["pdos"][0]["name"] == "position");
    CHECK(run("sii --slave 1" + on(ring)).says("gripper"));
}

TEST_CASE("sii writes the memory to a file, and shows its bytes") {
    const auto slaves = with_process_data();
    const emulated_bus ring{slaves};
    const scratch files;
    const auto slave = GENERATE(1, 2); // reads of 4 and of 8 bytes
    const auto number = " --slave " + std::to_string(slave);
    const auto ended = run("sii --output " + (files / "image") + number + on(ring));
    CHECK(ended.code == done);
    CHECK(ended.out.empty());
    const auto image = ethercat::make_sii_image(slaves[static_cast<std::size_t>(slave)]);
    std::string expected;
    for (std::size_t i = 0; i != image.size(); ++i) expected += static_cast<char>(image[i]);
    CHECK(content(files / "image") == expected);
    CHECK(run("sii --hex" + number + on(ring)).says("0010  07 00 00 00"));
    const auto refused = run("sii --output /nowhere/image" + number + on(ring));
    CHECK(refused.code == failed);
    CHECK(refused.complains("/nowhere/image: cannot be written"));
}

TEST_CASE("pdos shows what is mapped, with names and types") {
    const bool are_described = GENERATE(false, true);
    emulated_bus ring{with_process_data(), are_described};
    const auto ended = run("pdos --slave 1 --format json" + on(ring));
    INFO(ended.err);
    CHECK(ended.code == done);
    const auto is = ended.parsed()[0];
    CHECK(is["source"] == "coe");
    REQUIRE(is["pdos"].size() == 2);
    CHECK(is["pdos"][0]["index"] == 0x1600);
    CHECK(is["pdos"][0]["direction"] == "output");
    CHECK(is["pdos"][1]["index"] == 0x1A00);
    CHECK(is["pdos"][1]["sync_manager"] == 3);
    REQUIRE(is["pdos"][1]["entries"].size() == 4);
    CHECK(is["pdos"][1]["entries"][3]["bit_offset"] == 24);
    CHECK(is["pdos"][1]["entries"][3]["index"] == 0x6000);
    CHECK(states(ring) == all_in(al_state::init));
    const auto all = run("pdos" + on(ring));
    CHECK(all.says("0x6000:03"));
    CHECK(all.says("gap"));
    CHECK(run("pdos --slave 0" + on(ring)).says("no process data"));
}

TEST_CASE("watch shows the inputs of slaves in SAFE-OP") {
    emulated_bus ring{with_process_data()};
    const auto refused = run("watch" + on(ring));
    CHECK(refused.code == failed);
    CHECK(refused.complains("no chosen slave is in SAFE-OP or OP"));
    REQUIRE(run("state safe-op --slave 1 --yes" + on(ring)).code == done);
    ring.with(1, [](auto& each) {
        const auto to = each.slave.inputs();
        REQUIRE(to.size() == 7);
        for (const auto& [at, octet] : {std::pair{0, 0xFE}, {1, 0xFF}, {2, 0x81}, {5, 0xC0}, {6, 0x3F}})
            to[static_cast<std::size_t>(at)] = static_cast<std::byte>(octet);
    });
    const auto ended = run("watch --period 10000 --seconds 0.1 --format json" + on(ring));
    INFO(ended.err);
    CHECK(ended.code == done);
    std::istringstream lines{ended.out};
    std::string line;
    std::size_t looks = 0;
    for (; std::getline(lines, line); ++looks) {
        const auto rows = json::parse(line);
        REQUIRE(rows.size() == 3);
        CHECK(rows[0]["name"] == "position");
        CHECK(rows[0]["value"] == -2);
        CHECK(rows[1]["value"] == true);
        CHECK(rows[2]["value"] == 1.5);
    }
    CHECK(looks > 1);
    const auto table = run_until_interrupted("watch --slave 1" + on(ring), "3");
    CHECK(table.code == done);
    CHECK(table.says("0x6000:03"));
    CHECK(states(ring)[1] == al_state::safe_op);
}

TEST_CASE("watch reads inputs by their logical address where a slave has them at no other one") {
    auto slaves = with_process_data();
    slaves[2].inputs = inputs;
    emulated_bus ring{slaves};
    REQUIRE(run("state safe-op --yes" + on(ring)).code == done);
    ring.on_way_back([](std::span<std::byte> frame) {
        ethercat::mutable_frame_view view;
        if (!view.parse(frame)) return;
        for (const auto each : view)
            if (each.header.cmd == ethercat::command::aprd && each.header.length == 7) {
                std::ranges::fill(each.data, std::byte{});
                static_cast<void>(jauscat::wire::encode(ethercat::datagram_trailer{0}, each.bytes.last(2)));
            }
    });
    ring.with(1, [](auto& each) { each.slave.inputs()[0] = std::byte{7}; });
    ring.with(2, [](auto& each) { each.slave.inputs()[0] = std::byte{9}; });
    const auto ended = run("watch --seconds 0.01 --format json" + on(ring));
    INFO(ended.err);
    CHECK(ended.code == done);
    const auto rows = ended.parsed();
    REQUIRE(rows.size() == 6);
    CHECK(rows[0]["value"] == 7);
    CHECK(rows[3]["position"] == 2);
    CHECK(rows[3]["value"] == 9);
    ring.on_way_back([](std::span<std::byte> frame) { // and now nowhere
        ethercat::mutable_frame_view view;
        if (!view.parse(frame)) return;
        for (const auto each : view)
            if (each.header.length == 7)
                static_cast<void>(jauscat::wire::encode(ethercat::datagram_trailer{0}, each.bytes.last(2)));
    });
    const auto failing = run("watch --seconds 0.01" + on(ring));
    CHECK(failing.code == failed);
    CHECK(failing.complains("slave 1 on " + ring.where() + ": its inputs at 0x"));
}

TEST_CASE("monitor counts frames, working counters and errors of ports") {
    emulated_bus ring{three()};
    const auto ended = run("monitor --seconds 0.3 --format json" + on(ring));
    INFO(ended.err);
    const auto is = ended.parsed()[0];
    CHECK(is["frames"] > 10);
    CHECK(is["slaves"] == 3);
    CHECK(is["working_counter_least"] == 3);
    CHECK(is["working_counter_wrong"] == 0);
    CHECK(is["ports"].size() == 6);
    CHECK(is["ports"][0]["lost_links"] == 0);
    CHECK(is["round_trip_us"]["max"] > 0);
    CHECK(ended.code == (is["lost"] == 0 ? done : failed)); // a busy machine may lose some

    const auto interrupted = run_until_interrupted("monitor" + on(ring), "3");
    CHECK(interrupted.says("round trip"));
    CHECK(interrupted.says("working counter   3 expected"));
}

TEST_CASE("monitor reports slaves that go and frames that are lost") {
    emulated_bus ring{three()};
    std::thread fault{[&] {
        std::this_thread::sleep_for(std::chrono::milliseconds{500});
        ring.cut_behind(2);
    }};
    const auto cut = run("monitor --seconds 1.5 --format json" + on(ring));
    fault.join();
    CHECK(cut.code == failed);
    CHECK(cut.complains("slave 2 on " + ring.where() + ": its error counters cannot be read"));
    CHECK(cut.parsed()[0]["working_counter_least"] == 2);
    CHECK(cut.parsed()[0]["working_counter_wrong"] > 0);

    ring.cut_behind(3);
    std::thread silence{[&] {
        std::this_thread::sleep_for(std::chrono::milliseconds{500});
        ring.is_silent = true;
    }};
    const auto lost = run("monitor --seconds 1.5 --format json" + on(ring));
    silence.join();
    CHECK(lost.code == failed);
    CHECK(lost.parsed()[0]["lost"] > 0);
}

TEST_CASE("pdos of more entries than a slave can have are refused") {
    auto slaves = with_process_data();
    emulated_bus ring{slaves};
    ring.on_way_back([](std::span<std::byte> frame) {
        ethercat::mutable_frame_view view;
        if (!view.parse(frame)) return;
        for (const auto d : view) { // each number of PDOs and entries is 255, and each PDO the first one
            if (d.data.size() < 16 || d.working_counter == 0) continue;
            const auto is = [&](std::size_t at, unsigned value) { return d.data[at] == static_cast<std::byte>(value); };
            const bool is_answer = is(5, 0x03) || is(5, 0x13) || is(5, 0x23) || is(5, 0x33) || is(5, 0x43) ||
                                   is(5, 0x53) || is(5, 0x63) || is(5, 0x73);
            if (!is_answer || !(is(7, 0x30) || is(8, 0x80))) continue; // or aborted
            const bool is_assignment = is(10, 0x1C) && (is(9, 0x12) || is(9, 0x13));
            const bool is_mapping = is(10, 0x16) || is(10, 0x1A);
            if (!is_assignment && !is_mapping) continue;
            const auto subindex = d.data[11];
            d.data[7] = std::byte{0x30};
            if (subindex == std::byte{}) {
                d.data[8] = std::byte{0x4F};
                d.data[12] = std::byte{0xFF};
            } else if (is_mapping) {
                d.data[8] = std::byte{0x43};
            } else {
                d.data[8] = std::byte{0x4B};
                d.data[12] = std::byte{0x00};
                d.data[13] = is(9, 0x12) ? std::byte{0x16} : std::byte{0x1A};
            }
        }
    });
    const auto ended = run("pdos --slave 1" + on(ring));
    INFO(ended.err);
    CHECK(ended.code == failed);
    CHECK(ended.complains("more than 4096 PDOs and entries"));
}

TEST_CASE("pdos names an assigned PDO that the slave does not have") {
    auto slaves = with_process_data();
    emulated_bus ring{slaves};
    ring.on_way_back([](std::span<std::byte> frame) {
        ethercat::mutable_frame_view view;
        if (!view.parse(frame)) return;
        for (const auto d : view) { // the mapping object of the inputs is missing: an abort of 1A00h
            if (d.data.size() < 16 || d.working_counter == 0 || d.data[7] != std::byte{0x30}) continue;
            if (d.data[9] != std::byte{0x00} || d.data[10] != std::byte{0x1A}) continue;
            d.data[8] = std::byte{0x80};
            constexpr std::array abort{std::byte{}, std::byte{}, std::byte{0x02}, std::byte{0x06}};
            std::ranges::copy(abort, d.data.subspan(12).begin());
        }
    });
    const auto table = run("pdos --slave 1" + on(ring));
    CHECK(table.code == failed);
    CHECK(table.says("error"));
    CHECK(table.says("the slave does not have 0x1A00:0"));
    const auto json = run("pdos --slave 1 --format json" + on(ring));
    CHECK(json.code == failed);
    REQUIRE(json.parsed()[0]["pdos"].size() == 2);
    CHECK(json.parsed()[0]["pdos"][1]["error"] == "the slave does not have 0x1A00:00");
}

TEST_CASE("watch says when a slave leaves its state and when it is back, and shows no inputs in between") {
    const bool comes_back = GENERATE(true, false);
    auto slaves = with_process_data();
    emulated_bus ring{slaves};
    REQUIRE(run("state safe-op --yes" + on(ring)).code == done);
    unsigned looks = 0; // at inputs
    unsigned states = 0;
    ring.on_way_back([&, comes_back](std::span<std::byte> frame) {
        ethercat::mutable_frame_view view;
        if (!view.parse(frame)) return;
        for (const auto each : view) {
            if (each.header.cmd != ethercat::command::aprd) continue;
            if (each.header.length == 7) ++looks;
            const bool is_second = each.header.adp == 2; // counted by three slaves from -1
            if (looks == 0 || !is_second || each.header.ado != ethercat::esc_registers::al_status.address) continue;
            if (++states <= 3 || !comes_back) each.data[0] = std::byte{0x02};
        }
    });
    const auto ended = run("watch --slave 1 --period 10000 --seconds 2 --format json" + on(ring));
    INFO(ended.err);
    CHECK(ended.code == (comes_back ? done : failed));
    CHECK(ended.complains("slave 1"));
    CHECK(ended.complains("it is in PRE-OP, it was in SAFE-OP: its inputs are not valid"));
    CHECK(ended.complains("it is in SAFE-OP, it was in PRE-OP\n") == comes_back);
    CHECK(ended.says(R"("state":"PRE-OP")"));
    CHECK(ended.says(R"("value":null)"));
}
