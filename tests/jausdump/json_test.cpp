// Lines of hex in, JSON out.
#include "program.hpp"
#include "support/catch.hpp"

using dump_test::json;
using dump_test::object_of;
using dump_test::run;
using dump_test::wrench;

namespace {

std::vector<json> golden_vectors() {
    std::vector<json> all;
    std::ifstream file{support::test_data("ra_vectors.jsonl")};
    for (std::string line; std::getline(file, line);) all.push_back(json::parse(line));
    return all;
}
std::string hex_of(const std::vector<json>& vectors) {
    std::string text;
    for (const auto& vector : vectors) text += vector.at("hex").get<std::string>() + "\n";
    return text;
}
bool is_payload_element(const json& vector) { return vector.contains("interface_type_codes"); }

/// The names of an object and of those in it, as members are called.
json in_snake_case(const json& value) {
    if (value.is_array()) {
        json made = json::array();
        for (const auto& element : value) made.push_back(in_snake_case(element));
        return made;
    }
    if (!value.is_object()) return value;
    json made = json::object();
    for (const auto& [key, inner] : value.items()) {
        std::string name;
        for (const char c : key)
            name += c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        made[name] = in_snake_case(inner);
    }
    return made;
}

} // namespace

TEST_CASE("a message is one object with the documented keys in order") {
    REQUIRE(
        run("--format json --reencode --translate seed", wrench + "\n").out ==
        R"({"message":"Set Wrench Effort","code":"0x0405","header":{"priority":6,"ack_nak":0,"service_connection":0,)"
        R"("experimental":0,"version":2,"reserved":0,)"
        R"("destination":{"subsystem":2,"node":2,"component":33,"instance":1},)"
        R"("source":{"subsystem":1,"node":1,"component":32,"instance":1},)"
        R"("data_flag":0,"data_size":5,"sequence_number":34},"presence_vector":"0x0041",)"
        R"("fields":{"propulsive_linear_effort_x":{"value":49.9984740745262,"raw":16383},)"
        R"("resistive_linear_effort_x":{"value":12.549019607843137,"raw":32}},)"
        R"("hex":"0602050401210202012001010500220041)"
        R"(00ff3f20","packet":"02000000000000000100000000000000)"
        R"(1d000000000000000000000008006500000000000000000002000000151b0000)"
        R"(1a0000000d000000060201200101220041)"
        R"(00ff3f20","origin":{"line":1}})"
        "\n");
}

TEST_CASE("every golden message encodes again to its bytes") {
    const auto vectors = golden_vectors();
    REQUIRE(vectors.size() > 1000);
    const auto result = run("--format json --reencode", hex_of(vectors));
    REQUIRE(result.code == 0);
    const auto objects = result.objects();
    REQUIRE(objects.size() == vectors.size());
    for (std::size_t i = 0; i != vectors.size(); ++i) {
        INFO("line " << i + 1 << ": " << vectors[i].at("message"));
        for (const auto* key : {"message", "code", "presence_vector", "hex"})
            REQUIRE(objects[i].at(key) == vectors[i].at(key));
        REQUIRE(nlohmann::json(objects[i].at("header")) == nlohmann::json(vectors[i].at("header")));
        REQUIRE(objects[i].at("fields").size() == vectors[i].at("fields").size());
    }
}

TEST_CASE("payload data elements are decoded with the given types, and stay hex without") {
    std::vector<json> vectors;
    for (auto& vector : golden_vectors())
        if (is_payload_element(vector)) vectors.push_back(std::move(vector));
    REQUIRE(vectors.size() > 10);
    const auto types = vectors[0].at("interface_type_codes").dump();

    const dump_test::scratch files;
    std::ofstream{files / "types"} << types << "\n";
    for (const auto& given : {"'" + types + "'", files / "types"}) {
        const auto result = run("--format json --reencode --payload-types " + given, hex_of(vectors));
        REQUIRE(result.code == 0);
        const auto objects = result.objects();
        REQUIRE(objects.size() == vectors.size());
        for (std::size_t i = 0; i != vectors.size(); ++i) {
            REQUIRE(objects[i].at("fields") == in_snake_case(vectors[i].at("fields")));
            REQUIRE(objects[i].at("hex") == vectors[i].at("hex"));
        }
    }
    const std::string element = "2002010d f11337a7 3b017949 0380 0000 01 03 49";
    REQUIRE(object_of(element).at("fields").at("element") == "0349");
    REQUIRE(object_of(element, "--payload-types 1,2,10").at("fields").at("element").at(0).at("value") ==
            json{{"raw", 73}});
    // Interface 3 has no type; the element does not fit its type.
    REQUIRE(object_of(element, "--payload-types 1,2").at("error").at("error") == "unknown_tag");
    const auto error = object_of(element, "--payload-types 1,2,3").at("error");
    REQUIRE(error.at("error") == "truncated");
    REQUIRE(error.at("field") == "element[0]");
    REQUIRE(error.at("byte") == 17);
}

TEST_CASE("a line may have spaces, 0x, colons and the prefix of a datagram") {
    const std::string plain = "060205040121020201200101050022004100ff3f20";
    const auto expected = object_of(plain, "--reencode");
    REQUIRE(expected.at("hex") == plain);
    for (const std::string line :
         {"  06 02 05 04 01 21 02 02 01 20 01 01 05 00 22 00 41 00 ff 3f 20\t\r",
          "06:02:05:04:01:21:02:02:01:20:01:01:05:00:22:00:41:00:FF:3F:20",
          "0x06 0x02 0x05 0x04 0X01 0x21 0x02 0x02 0x01 0x20 0x01 0x01 0x05 0x00 0x22 0x00 0x41 0x00 0xff 0x3f 0x20",
          "0x060205040121020201200101050022004100ff3f20",
          "06,02,05,04,01,21,02,02,01,20,01,01,05,00,22,00,41,00,ff,3f,20",
          "4a41555330312e30 06020504012102020120010105002200 4100ff3f20"}) {
        INFO(line);
        REQUIRE(object_of(line, "--reencode") == expected);
    }
}

TEST_CASE("lines that are not bytes are reported by number, and the run continues") {
    const auto result = run("--format json", "\n06020\n060z\n" + wrench + "\n0x 0x06\n");
    REQUIRE(result.code == 1);
    const auto objects = result.objects();
    REQUIRE(objects.size() == 4);
    REQUIRE(objects[0].at("error").at("error") == "odd_digits");
    REQUIRE(objects[0].at("error").at("text") ==
            "line 2: an odd number of hex digits: the last, at column 5, is half a byte");
    REQUIRE(objects[1].at("error").at("error") == "not_hex");
    REQUIRE(objects[1].at("error").at("text") == "line 3: not a hex digit at column 4");
    REQUIRE(objects[2].at("message") == "Set Wrench Effort");
    REQUIRE(objects[3].at("error").at("error") == "truncated");
    for (const auto& key : {"message", "code", "header", "presence_vector", "fields"})
        REQUIRE(objects[0].at(key).is_null());
}

TEST_CASE("presence bits that stand for no field are ignored and told") {
    const auto object = object_of("0602 0504 01210202 01200101 0400 2200 01f0 0040");
    CHECK(object.at("presence_vector") == "0x0001");
    CHECK(object.at("ignored_presence_bits") == "0xF000");
    CHECK_FALSE(object.contains("error"));
    // Query Vector Knowledge Store Objects: the vector of the report behind its own is not the message's.
    CHECK_FALSE(object_of("0602 232a 01210202 01200101 0300 2200 00 95 01").contains("ignored_presence_bits"));
    CHECK(object_of("0602 232a 01210202 01200101 0300 2200 80 95 01").at("ignored_presence_bits") == "0x80");
    CHECK_FALSE(object_of("0602 0504 01210202 01200101 0400 2200 0100 0040").contains("ignored_presence_bits"));
}

TEST_CASE("all messages of a line of AS5669-2007 are read") {
    const auto lines = run("--format json", "01 0000 0010 0602 0220 01210164 01280101 0000 0000"
                                            "0000 0010 0602 0242 0101ffff 01010101 0000 0000\n")
                           .objects();
    REQUIRE(lines.size() == 2);
    CHECK(lines[0].at("message") == "Query Component Status");
    CHECK(lines[1].at("message") == "Report Heartbeat Pulse");
}

TEST_CASE("a broken message is shown with the field and byte at fault") {
    const auto error_of = [](const std::string& hex) {
        const auto error = object_of(hex).at("error");
        return error.at("error").get<std::string>() + " " + error.at("field").get<std::string>() + " " +
               error.at("byte").dump();
    };
    REQUIRE(error_of("0602 05") == "truncated command_code 2");
    REQUIRE(error_of("0602 0504 01210202 01200101 0100 2200 41") == "truncated presence_vector 16");
    REQUIRE(error_of("0602 0504 01210202 01200101 0300 2200 4100 ff") == "truncated propulsive_linear_effort_x 18");
    REQUIRE(error_of("0602 0504 01210202 01200101 0400 2200 0100 0080") ==
            "out_of_range propulsive_linear_effort_x 18");
    // The header's size is wrong: bytes are missing, or the size alone is.
    REQUIRE(error_of("0602 0504 01210202 01200101 1400 2200 0100 00") == "truncated propulsive_linear_effort_x 18");
    REQUIRE(error_of("0602 0504 01210202 01200101 1400 2200 0100 0000") == "wrong_size data_size 12");
    const auto more = object_of("0602 0504 01210202 01200101 0600 2200 0100 0000 9999").at("error");
    REQUIRE(more.at("error") == "trailing_bytes");
    REQUIRE(more.at("field").is_null());
    REQUIRE(more.at("byte") == 20);
    // In a list: the second joint of two.
    REQUIRE(error_of("0602 0106 01310202 01200101 0400 2200 02 0080 00") == "truncated joint_effort[1] 19");
    REQUIRE(run("", "0602 0504 01210202 01200101 0300 2200 4100 ff\n").code == 1);
}

TEST_CASE("a message with an unknown code is shown as unknown, with its bytes") {
    const auto object = object_of("8602 15e0 01260598 01040182 0300 0000 010203", "--reencode --translate seed");
    REQUIRE(object.at("message") == "unknown");
    REQUIRE(object.at("code") == "0xE015");
    REQUIRE(object.at("fields").is_null());
    REQUIRE(object.at("error").at("error") == "unknown_command_code");
    REQUIRE(object.at("error").at("field") == "command_code");
    REQUIRE(object.at("error").at("byte") == 2);
    REQUIRE(object.at("packet") == "unknown_command_code");
    REQUIRE(object.at("bytes") == "860215e0012605980104018203000000010203");
    REQUIRE_FALSE(object.contains("hex"));
}

TEST_CASE("an acknowledgement without a body is shown as one; a body is decoded whatever the header states") {
    const auto acknowledgement = object_of("3602 0504 01200101 01210202 0000 2200", "--reencode");
    REQUIRE(acknowledgement.at("header").at("ack_nak") == 3);
    REQUIRE(acknowledgement.at("fields").is_null());
    REQUIRE(acknowledgement.at("hex") == "36020504012001010121020200002200");
    REQUIRE_FALSE(acknowledgement.contains("error"));
    REQUIRE(run("", "3602 0504 01200101 01210202 0000 2200\n").code == 0);
    // The same as a command lacks its presence vector.
    REQUIRE(object_of("0602 0504 01200101 01210202 0000 2200").at("error").at("error") == "truncated");

    // NAK, middle packet of a large data set.
    const auto body = object_of("2602 0504 01210202 01200101 0520 2200 4100 ff3f 20");
    REQUIRE(body.at("header").at("data_flag") == 2);
    REQUIRE(body.at("fields").at("propulsive_linear_effort_x").at("raw") == 16383);
}

TEST_CASE("bytes after an unknown presence bit of a tolerant message are counted") {
    // Report Global Pose with bit 9, as seen in recorded traffic: two bytes follow the time stamp.
    const auto object = object_of("0602 0244 01200101 01260202 0800 0100 0003 04030201 0605", "--reencode");
    REQUIRE(object.at("presence_vector") == "0x0100");
    REQUIRE(object.at("fields") == json{{"time_stamp", 0x01020304}});
    REQUIRE(object.at("dropped") == 2);
    REQUIRE(object.at("hex") == "06020244012001010126020206000100"
                                "000104030201");
    REQUIRE_FALSE(object.contains("error"));
}

TEST_CASE("the packet is that of the selected table, or the name of the error") {
    const auto packet = [](const std::string& hex, const std::string& table) {
        return object_of(hex, "--translate " + table).at("packet").get<std::string>();
    };
    // ulDest, ulDestId, ulNodeId, ulIndex 6933, ulSubIndex 26, ulDataCnt.
    REQUIRE(packet(wrench, "self-contained") == "20000000"
                                                "00000000"
                                                "00000000"
                                                "00000000"
                                                "21000000"
                                                "00000000"
                                                "00000000"
                                                "08006500"
                                                "00000000"
                                                "00000000"
                                                "02000000"
                                                "151b0000"
                                                "1a000000"
                                                "11000000"
                                                "0602"
                                                "01"
                                                "02"
                                                "01200101"
                                                "0500"
                                                "2200"
                                                "4100ff3f20");
    REQUIRE(packet("0602 0504 01210202 01200101 0530 2200 4100 ff3f 20", "seed") == "reserved_value");
    REQUIRE(packet("0602 0504 01210202 01200101 0600 2200 4100 ff3f 20", "seed") == "wrong_size");
}

TEST_CASE("filters select messages by code, name and address") {
    const std::string query = "0602 0220 01210202 01200101 0000 0100",
                      report = "0602 0240 01200101 01210202 0500 0100 0100000000";
    const auto input = wrench + "\n" + query + "\n" + report + "\n06\n";
    const auto codes = [&](const std::string& arguments) {
        std::string found;
        for (const auto& object : run("--format json " + arguments, input).objects())
            found +=
                (found.empty() ? "" : " ") + (object.at("code").is_null() ? "-" : object.at("code").get<std::string>());
        return found;
    };
    REQUIRE(codes("") == "0x0405 0x2002 0x4002 -");
    REQUIRE(codes("--code 2002") == "0x2002");
    REQUIRE(codes("--code 0x0405,4002h") == "0x0405 0x4002");
    REQUIRE(codes("--name component_status") == "0x2002 0x4002");
    REQUIRE(codes("--name 'Report Component' --name wrench") == "0x0405 0x4002");
    REQUIRE(codes("--from 2.2.33.1") == "0x4002");
    REQUIRE(codes("--from 1.1") == "0x0405 0x2002");
    REQUIRE(codes("--to '*.*.33'") == "0x0405 0x2002");
    REQUIRE(codes("--to 2 --name status") == "0x2002");
    REQUIRE(run("--format json --code 2002", input).code == 0); // the broken line was not asked for
}

TEST_CASE("the summary alone is one object") {
    const auto result = run("--format json --summary", wrench + "\n" + wrench + "\n06\n");
    REQUIRE(result.code == 1);
    REQUIRE(result.objects().size() == 1);
    const auto summary = result.objects()[0];
    REQUIRE(summary.at("decoded") == 2);
    REQUIRE(summary.at("broken") == 1);
    REQUIRE(
        summary.at("messages").at(1) ==
        json{{"code", "0x0405"}, {"message", "Set Wrench Effort"}, {"count", 2}, {"bytes", 42}, {"not_decoded", 0}});
}
