// JAUS on the cyclic path: the outputs and inputs of one slave, and what the asker gets to hear.
#include "image_samples.hpp"
#include "support/instant.hpp"
#include <jauscat/bridge/image_exchange.hpp>
#include <jauscat/ethercat/slave/image_entries.hpp>

using namespace jauscat;
using namespace jauscat::test;
using namespace std::chrono_literals;
using support::instant;

namespace {

using exchange =
    bridging::image_exchange<translation::set_wrench_effort_table, translation::report_wrench_effort_table>;

struct robot {
    exchange mine{{.subsystem = 2, .station = 7}, 33, 10ms};
    image outputs{}, inputs{};

    /// The slave looks at its outputs: it takes the elements that the command has.
    void slave_works() {
        auto in = values_of(inputs);
        const auto out = values_of(outputs);
        if (in.command_count == out.command_count) return;
        in.command_count = out.command_count;
        in.presence_vector = 0x0FFF;
        if ((out.presence_vector & 1) != 0) in.propulsive_linear_effort_x = out.propulsive_linear_effort_x;
        if ((out.presence_vector & 2) != 0) in.propulsive_linear_effort_y = out.propulsive_linear_effort_y;
        REQUIRE(wire::encode(in, inputs));
    }
    translate::errc commands(std::string_view body, jaus::ack_nak ack = jaus::ack_nak::none, std::uint16_t sequence = 1,
                             instant now = 0s) {
        return mine.on_command(head(exchange::command_code, ack, sequence), from_hex(body), outputs, inputs, now)
            .error();
    }
    /// The next acknowledgement in short: "ack 5", or nothing.
    std::string acknowledgement(instant now = 0s) {
        std::array<std::byte, 16> out{};
        const auto size = mine.acknowledgement(inputs, now, out);
        if (size == 0) return {};
        const auto message = jaus::split(std::span{out}.first(size));
        REQUIRE(message);
        CHECK(message.header.destination == jaus::address{.instance = 1, .component = 32, .node = 1, .subsystem = 1});
        CHECK(message.header.source == jaus::address{.instance = 1, .component = 33, .node = 7, .subsystem = 2});
        const bool good = message.header.ack_nak == jaus::ack_nak::ack;
        return (good ? "ack " : "nak ") + std::to_string(message.header.sequence_number);
    }
    static jaus::header head(std::uint16_t code, jaus::ack_nak ack = jaus::ack_nak::none, std::uint16_t sequence = 1) {
        return {.ack_nak = ack,
                .command_code = code,
                .destination = {.instance = 1, .component = 33, .node = 7, .subsystem = 2},
                .source = {.instance = 1, .component = 32, .node = 1, .subsystem = 1},
                .sequence_number = sequence};
    }
};

} // namespace

TEST_CASE("a command is acknowledged when the slave has accepted it") {
    robot r;
    REQUIRE(r.commands("0100 3412", jaus::ack_nak::request, 5) == translate::errc::ok);
    CHECK(values_of(r.outputs).propulsive_linear_effort_x == 0x1234);
    CHECK(r.acknowledgement() == "");
    r.slave_works();
    CHECK(r.acknowledgement() == "ack 5");
    CHECK(r.acknowledgement() == "");
}

TEST_CASE("a command that the slave does not accept in time is refused, without an answer if none was requested") {
    robot r;
    REQUIRE(r.commands("0100 3412", jaus::ack_nak::none, 4) == translate::errc::ok);
    REQUIRE(r.commands("0100 3412", jaus::ack_nak::request, 5) == translate::errc::ok);
    CHECK(r.acknowledgement(9ms) == "");
    CHECK(r.acknowledgement(10ms) == "nak 5");
    CHECK(r.acknowledgement(10ms) == "");
}

TEST_CASE("commands in one cycle are merged without loss of elements") {
    robot r;
    REQUIRE(r.commands("0100 1111", jaus::ack_nak::request, 1) == translate::errc::ok);
    REQUIRE(r.commands("0200 2222", jaus::ack_nak::request, 2) == translate::errc::ok);
    CHECK(values_of(r.outputs).presence_vector == 3);
    r.slave_works();
    CHECK(values_of(r.inputs).propulsive_linear_effort_x == 0x1111);
    CHECK(values_of(r.inputs).propulsive_linear_effort_y == 0x2222);
    CHECK(r.acknowledgement() == "ack 1");
    CHECK(r.acknowledgement() == "ack 2");
    REQUIRE(r.commands("0200 3333") == translate::errc::ok); // alone again
    CHECK(values_of(r.outputs).presence_vector == 2);
}

TEST_CASE("a refused command changes no output and is not waited for") {
    robot r;
    CHECK(r.commands("0100 0080", jaus::ack_nak::request) == translate::errc::out_of_range);
    CHECK(r.outputs == image{});
    CHECK(r.acknowledgement(1s) == "");
}

TEST_CASE("a command beyond the capacity for acknowledgements is refused before the outputs change") {
    robot r;
    for (std::size_t i = 0; i != exchange::capacity; ++i)
        REQUIRE(r.commands("0100 3412", jaus::ack_nak::request) == translate::errc::ok);
    const auto before = r.outputs;
    CHECK(r.commands("0100 7856", jaus::ack_nak::request) == translate::errc::no_capacity);
    CHECK(r.outputs == before);
    CHECK(r.commands("0100 7856") == translate::errc::ok);
}

TEST_CASE("a restarted controller continues the count from the command that the slave accepted last") {
    robot first;
    for (int i = 0; i != 3; ++i) REQUIRE(first.commands("0300 0100 0200") == translate::errc::ok);
    first.slave_works();

    robot second;
    second.inputs = first.inputs;
    REQUIRE(second.mine.start(second.outputs, second.inputs));
    CHECK(values_of(second.outputs).command_count == 3);
    CHECK(values_of(second.outputs).presence_vector == 0);
    second.slave_works();
    CHECK(second.inputs == first.inputs); // nothing new
    REQUIRE(second.commands("0200 4444") == translate::errc::ok);
    second.slave_works();
    CHECK(values_of(second.inputs).propulsive_linear_effort_y == 0x4444);
    CHECK(second.mine.start(std::span{second.outputs}.first(20), second.inputs).error() == translate::errc::wrong_size);
}

TEST_CASE("acknowledgements wrap around with the counter") {
    robot r;
    REQUIRE(wire::encode(wrench_effort_image{.command_count = 0xFFFE}, r.inputs));
    REQUIRE(r.mine.start(r.outputs, r.inputs));
    for (std::uint16_t sequence = 1; sequence != 5; ++sequence) { // FFFFh, 1, 2, 3
        REQUIRE(r.commands("0100 3412", jaus::ack_nak::request, sequence) == translate::errc::ok);
        CHECK(r.acknowledgement() == "");
        r.slave_works();
        CHECK(r.acknowledgement() == "ack " + std::to_string(sequence));
    }
}

TEST_CASE("a query is answered from the inputs, with the requested elements that the slave has") {
    robot r;
    REQUIRE(wire::encode(wrench_effort_image{.presence_vector = 0x0803,
                                             .propulsive_linear_effort_x = 0x1111,
                                             .propulsive_linear_effort_y = 0x2222,
                                             .propulsive_linear_effort_z = 0x3333,
                                             .resistive_rotational_effort_z = 0xAA},
                         r.inputs));
    std::array<std::byte, 64> out{};
    const auto ask = [&](std::string_view body) {
        return r.mine.on_query<jaus::query_wrench_effort>(robot::head(exchange::query_code, jaus::ack_nak::none, 9),
                                                          from_hex(body), r.inputs, out);
    };
    const auto answer = jaus::split(*ask("0608"));
    REQUIRE(answer);
    CHECK(answer.header.command_code == 0x4405);
    CHECK(answer.header.sequence_number == 9);
    CHECK(answer.header.source.component == 33);
    CHECK(answer.header.destination.component == 32);
    CHECK(to_hex(answer.body) == "02 08 22 22 aa");
    CHECK(ask("06").error() == translate::errc::truncated);
    CHECK(ask("060800").error() == translate::errc::wrong_size);
    const auto into = [&](std::size_t size) {
        return r.mine
            .on_query<jaus::query_wrench_effort>(robot::head(exchange::query_code), from_hex("0608"), r.inputs,
                                                 std::span{out}.first(size))
            .error();
    };
    CHECK(into(15) == translate::errc::no_space);
    CHECK(into(20) == translate::errc::no_space);
    CHECK(into(21) == translate::errc::ok);
}

TEST_CASE("only complete commands and queries for the slave's component use the process image") {
    const robot r;
    auto head = robot::head(0x0405);
    CHECK(r.mine.takes(head));
    head.destination.component = 255;
    CHECK(r.mine.takes(head));
    head.destination.component = 34;
    CHECK_FALSE(r.mine.takes(head));
    CHECK(r.mine.takes(robot::head(0x2405)));
    CHECK_FALSE(r.mine.takes(robot::head(0x040A)));
    CHECK_FALSE(r.mine.takes(robot::head(0x0405, jaus::ack_nak::ack)));
    head = robot::head(0x0405);
    head.data_flag = jaus::data_flag::first;
    CHECK_FALSE(r.mine.takes(head));
    head = robot::head(0x0405);
    head.destination.node = 8;
    CHECK_FALSE(r.mine.takes(head));
}

TEST_CASE("the PDO entries of an image equal its fields") {
    constexpr auto& entries = ethercat::image_entries<wrench_effort_image, ethercat::image_objects::outputs>;
    STATIC_REQUIRE(entries.size() == 14);
    STATIC_REQUIRE(ethercat::process_data_size(entries) == exchange::command::image_size);
    CHECK(entries[0].index == 0x7000);
    CHECK(entries[0].subindex == 1);
    CHECK(entries[0].name == "command_count");
    CHECK(entries[2].bits == 16);
    CHECK(entries[2].data_type == 3); // INTEGER16
    CHECK(entries[13].subindex == 14);
    CHECK(entries[13].bits == 8);
    CHECK(entries[13].data_type == 5); // UNSIGNED8
    CHECK(entries[13].name == "resistive_rotational_effort_z");
}

// Bits and gaps.
namespace {
struct lamps {
    bool left{};
    std::uint8_t level{};
    float voltage{};
};
} // namespace
template <> struct jauscat::wire::schema<lamps> {
    using T = lamps;
    using type =
        layout<bit_fields<u8, bit_field<&T::left, 1>, reserved<4>, bit_field<&T::level, 3>>, field<&T::voltage, f32le>>;
};

TEST_CASE("the PDO entries of bit-fields have gaps for reserved bits") {
    constexpr auto& entries = ethercat::image_entries<lamps, 0x6010>;
    STATIC_REQUIRE(entries.size() == 4);
    STATIC_REQUIRE(ethercat::process_data_size(entries) == 5);
    CHECK(entries[0].data_type == 1); // BOOLEAN
    CHECK(entries[1].index == 0);
    CHECK(entries[1].bits == 4);
    CHECK(entries[2].index == 0x6010);
    CHECK(entries[2].subindex == 2);
    CHECK(entries[2].data_type == 0x32); // BIT3
    CHECK(entries[3].data_type == 8);    // REAL32
}
