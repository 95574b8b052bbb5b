// SAE JAUS: lines of payloads.
#include "program.hpp"
#include "support/catch.hpp"

using dump_test::json;
using dump_test::run;

namespace {

std::vector<json> golden_messages() {
    std::vector<json> all;
    std::ifstream file{support::test_data("sae_vectors.jsonl")};
    for (std::string line; std::getline(file, line);) all.push_back(json::parse(line));
    return all;
}

json payload_object(const std::string& hex, const std::string& arguments = {}) {
    return dump_test::object_of(hex, "--sae " + arguments);
}

} // namespace

TEST_CASE("every golden message of SAE is named, decoded, and encoded again to its bytes") {
    const auto messages = golden_messages();
    REQUIRE(messages.size() == 1444);
    std::string lines;
    for (const auto& one : messages) lines += one.at("hex").get<std::string>() + "\n";
    const auto result = run("--sae --format json --reencode", lines);
    CHECK(result.code == 0);
    const auto objects = result.objects();
    REQUIRE(objects.size() == messages.size());
    for (std::size_t i = 0; i != messages.size(); ++i) {
        INFO("line " << i + 1 << ": " << messages[i].dump());
        REQUIRE(objects[i].at("message") == messages[i].at("message"));
        REQUIRE(objects[i].at("code") == "0x" + messages[i].at("code").get<std::string>());
        REQUIRE(objects[i].at("hex") == messages[i].at("hex"));
        REQUIRE(objects[i].at("payload_size") == messages[i].at("hex").get<std::string>().size() / 2);
        REQUIRE(objects[i].at("fields").is_object());
        REQUIRE(objects[i].at("origin").at("line") == i + 1);
        REQUIRE_FALSE(objects[i].contains("error"));
    }
}

TEST_CASE("a payload is one object with the documented keys in order") {
    CHECK(run("--sae --format json --reencode", "0d0023\n").out ==
          R"({"message":"RequestControl","code":"0x000D","header":null,"presence_vector":null,)"
          R"("fields":{"authority_code":35},"hex":"0d0023","generation":"SAE","payload_size":3,"origin":{"line":1}})"
          "\n");
    const auto pose = payload_object("0244 0300 00000080 ffffff7f");
    CHECK(pose.at("message") == "ReportGlobalPose");
    CHECK(pose.at("presence_vector") == "0x0003");
    CHECK(pose.at("fields").size() == 2);
    CHECK(pose.at("fields").at("latitude").at("raw") == 0x80000000);
}

TEST_CASE("a payload is shown as a line of columns, then its fields") {
    const auto result = run("--sae", "0d 00 23\n");
    CHECK(result.code == 0);
    CHECK(result.says("      1                   0x000D  RequestControl                             3                  "
                      "->                  \n"
                      "         authority_code = 35\n"));
    CHECK(result.says("\n1 message: 1 decoded\n"));
}

TEST_CASE("a broken payload is shown with the field and byte at fault, an unknown one with code, size and bytes") {
    const auto error_of = [](const std::string& hex) {
        const auto object = payload_object(hex);
        CHECK(object.at("fields").is_null());
        CHECK_FALSE(object.at("bytes").get<std::string>().empty());
        const auto& error = object.at("error");
        return error.at("error").get<std::string>() + " " + error.at("field").dump() + " " + error.at("byte").dump();
    };
    CHECK(error_of("0d00") == R"(truncated "authority_code" 2)");
    CHECK(error_of("0d002300") == "trailing_bytes null 3");
    CHECK(error_of("0d") == "no_message_id null 0");
    CHECK(error_of("0244 0300 00000080 ffff") == R"(truncated "longitude" 8)");

    const auto unknown = payload_object("fed0 010203", "--reencode");
    CHECK(unknown.at("message") == "unknown");
    CHECK(unknown.at("code") == "0xD0FE");
    CHECK(unknown.at("payload_size") == 5);
    CHECK(unknown.at("bytes") == "fed0010203");
    CHECK(unknown.at("error").at("error") == "unknown_message_id");
    CHECK_FALSE(unknown.contains("hex"));
    const auto text = run("--sae", "fed0 010203\n");
    CHECK(text.code == 1);
    CHECK(text.says("unknown: message ID 0xD0FE is in no known service\n"));
    CHECK(text.says("         0000  fe d0 01 02 03\n"));
}

TEST_CASE("a value outside its value set is marked, and encoded again to the same bytes") {
    const auto object = payload_object("06000000", "--reencode");
    CHECK(object.at("fields") == json{{"emergency_code", 0}});
    CHECK(object.at("outside_values") == json::array({"emergency_code"}));
    CHECK(object.at("hex") == "06000000");
    CHECK_FALSE(object.contains("error"));
    CHECK_FALSE(payload_object("06000100").contains("outside_values"));
    const auto text = run("--sae --summary", "06000000\n060000\n");
    CHECK(text.code == 1);
    CHECK(text.says("2 messages: 1 decoded, 1 broken\n"));
    CHECK(run("--sae", "06000000\n").says("         emergency_code = 0x0000 (outside its values)\n"));
}

TEST_CASE("payloads are selected by message ID and name") {
    const auto selected = [](const std::string& arguments) {
        std::string codes;
        for (const auto& object : run("--sae --format json " + arguments, "0d0023\n0e00\n0d20\n0822\n").objects())
            codes += object.at("code").get<std::string>() + " ";
        return codes;
    };
    CHECK(selected("") == "0x000D 0x000E 0x200D 0x2208 ");
    CHECK(selected("--code 000D,2208") == "0x000D 0x2208 ");
    CHECK(selected("--name control") == "0x000D 0x000E 0x200D ");
    CHECK(selected("--name request_control") == "0x000D ");
    CHECK(selected("--name RequestControl") == "0x000D ");
}

TEST_CASE("Local Vector is decoded by the version of mobility that is given") {
    CHECK(payload_object("0804 01 ffff").at("error").at("field") != nullptr);
    const auto old = payload_object("0804 01 ffff", "--sae-mobility 1.0 --reencode");
    CHECK(old.at("message") == "SetLocalVector");
    CHECK(old.at("fields").contains("speed"));
    CHECK(old.at("hex") == "080401ffff");
    CHECK(payload_object("0d0023", "--sae-mobility 1.0").at("fields") == json{{"authority_code", 35}});
    CHECK(run("--sae --sae-mobility 2", "0e00\n").code == 2);
}

TEST_CASE("only lines of hex take --sae") {
    CHECK(run("--sae --listen 0").code == 2);
    const auto capture = run("--sae " + support::test_data("sae_management.pcap"));
    CHECK(capture.code == 2);
    CHECK(capture.err.find("--sae is for lines of hex") != std::string::npos);
    CHECK(run("--sae --translate seed", "0e00\n").err.find("--translate does not go with --sae") != std::string::npos);
}
