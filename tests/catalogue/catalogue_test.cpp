// What a catalogue says of a message, and what can be done with one.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/jaus/message/ignored_bits.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/jaus/catalog.hpp>
#include <jauscat/schema/jaus/messages.hpp>

namespace {

namespace catalogue = jauscat::catalogue;
namespace jaus = jauscat::jaus;
namespace text = jauscat::text;
namespace wire = jauscat::wire;
using jauscat::test::from_hex;
using jauscat::test::to_hex;

const catalogue::entry& of(std::string_view name) {
    const auto found = catalogue::ra_3_3().find(name);
    REQUIRE(found);
    return **found;
}

} // namespace

TEST_CASE("the catalogue has every message of the standard, by ascending command code") {
    const auto& all = catalogue::ra_3_3();
    CHECK(all.size() == jaus::catalog.size());
    CHECK(std::ranges::is_sorted(all, {}, &catalogue::entry::command_code));
    for (const auto& [code, name] : jaus::catalog) {
        INFO(name);
        const auto* const by_code = all.find(code);
        REQUIRE(by_code != nullptr);
        CHECK(by_code->command_code() == code);
        const auto by_name = all.find(name);
        REQUIRE(by_name);
        CHECK(*by_name == by_code);
        CHECK(by_code->name() == text::snake_case(name));
        CHECK(by_code->fields().name == by_code->name());
        CHECK(by_code->min_size() <= by_code->max_size());
    }
}

TEST_CASE("a message is found by the name of its type, by that of the standard, and by its code in hex") {
    for (const auto* name : {"set_wrench_effort", "Set Wrench Effort", "0405", "0405h", "0x0405", "405"})
        CHECK(of(name).command_code() == 0x0405);
    const auto unknown = catalogue::ra_3_3().find("set_wrench_efort");
    REQUIRE(!unknown);
    CHECK(unknown.error().code == text::errc::unknown_message);
    CHECK(unknown.error().value == "set_wrench_efort");
    CHECK(unknown.error().message == "there is no message 'set_wrench_efort'; did you mean set_wrench_effort?");
    CHECK(catalogue::ra_3_3().find("9999h").error().message == "there is no message with the code 0x9999");
    CHECK(catalogue::ra_3_3().find(std::uint16_t{0x9999}) == nullptr);
    CHECK(catalogue::ra_3_3().find("").error().code == text::errc::unknown_message);
}

TEST_CASE("a query and its report name each other") {
    for (const auto& message : catalogue::ra_3_3()) {
        INFO(message.name());
        const auto code = message.command_code();
        if (const auto report = message.report(); report != 0) {
            CHECK(report == code + 0x2000);
            CHECK(catalogue::ra_3_3().find(report)->query() == code);
        } else {
            const auto expected = jaus::report_code_of(code);
            CHECK((expected == 0 || catalogue::ra_3_3().find(expected) == nullptr));
        }
        if (const auto query = message.query(); query != 0) CHECK(catalogue::ra_3_3().find(query)->report() == code);
    }
    CHECK(of("set_wrench_effort").query() == 0);
    CHECK(of("set_wrench_effort").report() == 0);
}

TEST_CASE("the places of presence vectors are those of the schemas") {
    CHECK(std::ranges::is_sorted(jaus::presence_vectors, {}, &jaus::presence_vector_place::command_code));
    using text::member;
    std::size_t count = 0;
    for (const auto& message : catalogue::ra_3_3()) {
        INFO(message.name());
        std::size_t offset = 0;
        std::vector<jaus::presence_vector_place> places;
        std::ranges::copy_if(jaus::presence_vectors, std::back_inserter(places),
                             [&](const auto& one) { return one.command_code == message.command_code(); });
        auto place = places.begin();
        const auto expect = [&](std::size_t size, std::uint32_t fields) {
            REQUIRE(place != places.end());
            CHECK(place->offset == offset);
            CHECK(place->size == size);
            CHECK(place->fields == fields);
            ++place;
            ++count;
        };
        for (const member& one : message.fields().members) {
            if (one.what == member::role::presence_vector) expect(one.least, message.presence_bits());
            const bool of_report = one.name == "report_presence_vector" ||
                                   (one.name == "presence_vector" && one.what == member::role::value);
            // The bits of these reports are not all known.
            const bool is_open =
                message.name() == "query_mission_status" || message.name() == "query_vector_knowledge_store_objects";
            if (of_report && !is_open) expect(one.least, catalogue::ra_3_3().find(message.report())->presence_bits());
            if (one.optional || one.least != one.most) break;
            offset += one.least;
        }
        CHECK(place == places.end());
    }
    CHECK(count == jaus::presence_vectors.size());
}

TEST_CASE("bits of a presence vector without a field are told, also of what an event or a connection asks for") {
    const auto ignored = [](std::uint16_t code, std::string_view body) {
        return jaus::ignored_presence_bits(code, from_hex(body));
    };
    CHECK(ignored(0x0405, "ffff 0000") == 0xF000); // what the fields say is not its matter
    CHECK(ignored(0x0405, "ff0f 0000") == 0);
    CHECK(ignored(0x0405, "ff") == 0);
    CHECK(ignored(0x2405, "ffff") == 0xF000);
    CHECK(ignored(0x240F, "0000 ff") == 0xFC);
    CHECK(ignored(0x4400, "ffffffff") == 0xFFE00000);
    CHECK(ignored(0x0008, "0544 0010 ffffffff") == 0xFFFFF000);
    CHECK(ignored(0x0008, "0544 0010 ff0f0000") == 0);
    CHECK(ignored(0x0008, "0242 0010 ffffffff") == 0); // Report Heartbeat Pulse has no vector
    CHECK(ignored(0x01F0, "80 01 0544 05 02000000 ffff") == 0xF000);
    CHECK(ignored(0x01F0, "00 01 0544 05") == 0);
    CHECK(ignored(0x01F3, "ff 01 0544 01") == 0xFE);
    CHECK(ignored(0x41F1, "01 0544 00 04000000 00f0 0000") == 0xF000);
    CHECK(ignored(0x41F1, "01 f141 00 00000000") == 0);
    CHECK(ignored(0x2A23, "00 ff 01") == 0); // the vector of the report has bits that are not known
    CHECK(ignored(0x2A23, "80 ff 01") == 0x80);
    CHECK(ignored(0xD123, "ffff") == 0);
}

TEST_CASE("a message is made of a line, and printed") {
    const auto message = of("set_wrench_effort").from_text("propulsive_linear_effort_x=50");
    REQUIRE(message);
    const auto body = message->encode();
    REQUIRE(body);
    CHECK(to_hex(*body) == "01 00 00 40");
    CHECK(message->to_text() == "  presence_vector = 0x0001\n  propulsive_linear_effort_x = 50 % (raw 16384)\n");
    CHECK(of("set_wrench_effort").to_text(*body, 0) ==
          "presence_vector = 0x0001\npropulsive_linear_effort_x = 50.001526 % (raw 16384)\n");
    CHECK(of("set_wrench_effort").annotate(*body, 16) ==
          "  0010  01 00         presence_vector = 0x0001\n"
          "  0012  00 40         propulsive_linear_effort_x = 50.001526 % (raw 16384)\n");

    const auto wrong = of("set_wrench_effort").from_text("propulsive_linear_effort_x=150");
    REQUIRE(!wrong);
    CHECK(wrong.error().code == text::errc::out_of_range);
    CHECK(of("set_wrench_effort").from_text("\"x").error().code == text::errc::unfinished_quote);
}

TEST_CASE("a line names its message in its first word") {
    const auto message = catalogue::ra_3_3().from_text("set_emergency emergency_code=transition_to_emergency");
    REQUIRE(message);
    CHECK(message->command_code() == 0x0006);
    REQUIRE(message->as<jaus::set_emergency>() != nullptr);
    CHECK(message->as<jaus::set_emergency>()->emergency_code.bits() == 1);
    CHECK(message->as<jaus::clear_emergency>() == nullptr);
    CHECK(catalogue::ra_3_3().from_text("").error().code == text::errc::missing_name);
    CHECK(catalogue::ra_3_3().from_text("set_emergenci").error().code == text::errc::unknown_message);
    CHECK(catalogue::ra_3_3().from_text("set_emergency x=1").error().code == text::errc::unknown_field);
}

TEST_CASE("a message of a body owns what it consists of") {
    const auto& type = of("report_identification");
    catalogue::any_message kept;
    {
        auto body = from_hex("01 01 11 27 6c 65 66 74 20 61 72 6d");
        body.resize(84);
        auto message = type.decode(body);
        REQUIRE(message);
        kept = *std::move(message);
        std::ranges::fill(body, std::byte{0xFF});
    }
    CHECK(kept.type() == type);
    CHECK(kept.to_text().find("\"left arm\"") != std::string::npos);
    const auto moved = std::move(kept);
    CHECK(moved.as<jaus::report_identification>()->authority_code == 1);
    CHECK(moved.encode()->size() == 84);
}

TEST_CASE("lists have the memory that they need") {
    std::vector<std::string> words;
    for (unsigned i = 0; i != 255; ++i) words.push_back("joint[" + std::to_string(i) + "].joint_effort=12.5");
    const auto message = of("set_joint_efforts").from_words(words);
    REQUIRE(message);
    const auto body = message->encode();
    REQUIRE(body);
    CHECK(body->size() == 1 + 255 * 2);
    const auto again = of("set_joint_efforts").decode(*body);
    REQUIRE(again);
    CHECK(*again->encode() == *body);
    CHECK(again->to_text().find("joint[254].joint_effort = 12.498665 %") != std::string::npos);
}

TEST_CASE("a body that does not decode is explained, and printed as its error") {
    const auto& type = of("set_wrench_effort");
    const auto body = from_hex("01 00 00");
    const auto message = type.decode(body);
    REQUIRE(!message);
    CHECK(message.error().error == wire::errc::truncated);
    CHECK(message.error().field == "propulsive_linear_effort_x");
    CHECK(message.error() == type.diagnose(body));
    const auto why = catalogue::ra_3_3().why_malformed(type.command_code(), body);
    CHECK(why.find("propulsive_linear_effort_x at byte 2 needs 2 bytes, 1 left") != std::string::npos);
    CHECK(type.to_text(body) == "  " + why + "\n");
    CHECK(catalogue::ra_3_3().explainer()(type.command_code(), body) == why);
    CHECK(catalogue::ra_3_3().why_malformed(type.command_code(), from_hex("00 00")).empty());
    CHECK(catalogue::ra_3_3().why_malformed(0x9999, body).empty());
}

TEST_CASE("a whole message is annotated with its header; what is not known is shown in hex") {
    std::vector<std::byte> bytes(64);
    const jaus::set_wrench_effort effort{.propulsive_linear_effort_x = 50};
    const auto made = jaus::make_message(jaus::header{.source = {1, 1, 1, 1}}, effort, bytes);
    REQUIRE(made);
    const auto lines = catalogue::ra_3_3().annotate(*made);
    CHECK(lines.find("command_code = ") != std::string::npos);
    CHECK(lines.ends_with("  0012  00 40         propulsive_linear_effort_x = 50.001526 % (raw 16384)\n"));

    (*made)[2] = (*made)[3] = std::byte{0x99};
    const auto dump = catalogue::ra_3_3().annotate(*made);
    CHECK(dump.find("propulsive") == std::string::npos);
    CHECK(dump.find("01 00 00 40") != std::string::npos);
    CHECK(catalogue::ra_3_3().annotate(std::span{*made}.first(5)).find("truncated") != std::string::npos);
    CHECK(!catalogue::ra_3_3().annotate({}).empty());
}

TEST_CASE("an entry says which bytes each field of a body has") {
    const auto& effort = of("set_wrench_effort");
    const auto parts = effort.annotated(from_hex("41 00 00 40 20")).parts;
    REQUIRE(parts.size() == 3);
    CHECK(parts[1].offset == 2);
    CHECK(parts[1].size == 2);
    REQUIRE(parts[1].fields.size() == 1);
    CHECK(parts[1].fields[0].path == "propulsive_linear_effort_x");
    CHECK(parts[1].fields[0].value == "50.001526 % (raw 16384)");
    CHECK(parts[2].offset == 4);
    const auto cut = effort.annotated(from_hex("41 00 00"));
    CHECK(cut.parts.empty());
    CHECK(cut.fault.error == wire::errc::truncated);
}
