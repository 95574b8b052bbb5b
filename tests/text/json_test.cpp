// Messages as JSON: the shape that others rely on, and what is not JSON by itself.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/text/json.hpp>

#include <array>

namespace {

namespace jaus = jauscat::jaus;
namespace text = jauscat::text;
namespace wire = jauscat::wire;
using text::json;

struct memory {
    std::vector<std::byte> bytes = std::vector<std::byte>(4096);
    wire::arena lists{bytes};
};

/// What is wrong with some JSON as a message of type T.
template <class T> std::string wrong(const char* fields) {
    memory m;
    T message{};
    return text::from_json(json::parse(fields), message, m.lists).error().message;
}

} // namespace

TEST_CASE("fields are in wire order, scaled ones with value and raw integer") {
    const jaus::set_wrench_effort message{.propulsive_linear_effort_x = 50, .resistive_linear_effort_x = 0};
    CHECK(text::to_json(message).dump() == R"({"propulsive_linear_effort_x":{"value":50.0,"raw":16384},)"
                                           R"("resistive_linear_effort_x":{"value":0.0,"raw":0}})");
    CHECK(text::presence_vector_of(message).dump() == R"("0x0041")");
    CHECK(text::presence_vector_of(jaus::set_travel_speed{}).is_null());
    CHECK(text::to_json(jaus::resume{}).dump() == "{}");
}

TEST_CASE("enumerations, flags and stamps are integers") {
    CHECK(text::to_json(jaus::report_component_status{.primary_status_code = jaus::primary_status_code::standby})
              .dump() == R"({"primary_status_code":2,"secondary_status_code":0})");
    CHECK(text::to_json(jaus::set_camera_pose{.mode_indicator = {jaus::mode_indicator::linear_y_is_a_rate}}).dump() ==
          R"({"camera_id":0,"mode_indicator":2})");
    CHECK(text::to_json(jaus::report_time{.date_stamp = jaus::date_stamp{.day = 27, .month = 6, .year = 7}}).dump() ==
          R"({"date_stamp":3803})");
}

TEST_CASE("groups are arrays after their counts, with single values under their field's name") {
    CHECK(text::to_json(jaus::set_joint_efforts{.joint_effort = {100}}).dump() ==
          R"({"number_of_joints":1,"joint":[{"joint_effort":{"value":100.0,"raw":65535}}]})");
    const std::array components{jaus::configured_component{.component_id = 33, .instance_id = 1}};
    const std::array nodes{jaus::configured_node{.node_id = 1, .component = components}};
    CHECK(text::to_json(jaus::report_configuration{.node = nodes}).dump() ==
          R"({"number_of_nodes":1,"node":[{"node_id":1,"number_of_components":1,)"
          R"("component":[{"component_id":33,"instance_id":1}]}]})");
}

TEST_CASE("a record's own presence vector is among its fields, and values with a type code are objects") {
    const std::array events{
        jaus::reported_event{.upper_limit = jaus::typed_value{jaus::data_type::rgb, jaus::rgb{1, 2, 3}}, .event_id = 9},
        jaus::reported_event{.lower_limit = jaus::typed_value{jaus::data_type::integer, std::int32_t{-5}}}};
    CHECK(text::to_json(jaus::report_events{.event = events}).dump() ==
          R"({"number_of_events":2,"event":[)"
          R"({"presence_vector":40,"message_code":0,"event_type":0,)"
          R"("upper_limit":{"data_type":9,"value":{"red":1,"green":2,"blue":3}},"event_id":9},)"
          R"({"presence_vector":4,"message_code":0,"event_type":0,)"
          R"("lower_limit":{"data_type":2,"value":{"value":-5}}}]})");
}

TEST_CASE("a tree is nested under child, and bytes and embedded messages are hex") {
    const auto body = support::bytes(0xAB);
    const std::array commands{jaus::mission_command{
        .message_uid = 3,
        .message = {.header = {.priority = 0, .version = 0, .command_code = 0x4405, .data_size = 1},
                    .body = std::span{body}}}};
    const std::array<std::uint32_t, 1> offsets{13};
    const std::array tasks{jaus::mission_task{.task_id = 1, .number_of_children = 1, .offset = std::span{offsets}},
                           jaus::mission_task{.task_id = 2, .message = commands}};
    CHECK(text::to_json(jaus::spool_mission{.mission_tree = tasks})["mission_tree"].dump() ==
          R"({"task_id":1,"number_of_children":1,"child_offset":[{"offset":13}],"number_of_messages":0,"message":[],)"
          R"("child":[{"task_id":2,"number_of_children":0,"child_offset":[],"number_of_messages":1,"message":)"
          R"([{"mission_message":{"message_uid":3,"message":"0000054400000000000000000100)"
          R"(0000ab","blocking_flag":0}}],"child":[]}]})");
}

TEST_CASE("text that is not UTF-8, and NaN and infinity, survive JSON") {
    using namespace std::string_view_literals;
    memory m;
    for (const auto name : {"Gerät"sv, "Ger\xE4t"sv, "\xFF"sv, "a\0b\x1F"sv, ""sv}) {
        const jaus::report_camera_pose sent{.camera_name = name};
        const std::string written = text::to_json(sent).dump();
        INFO(written);
        jaus::report_camera_pose read{};
        CHECK(text::from_json(json::parse(written), read, m.lists));
        CHECK(read == sent);
    }
    CHECK(text::to_json(jaus::report_camera_pose{.camera_name = "\xFF\xFE"}).dump() ==
          R"({"camera_id":0,"camera_name":{"hex":"fffe"}})");

    using limits = std::numeric_limits<float>;
    for (const float number :
         {limits::quiet_NaN(), limits::infinity(), -limits::infinity(), limits::max(), limits::denorm_min(), -0.0F}) {
        const jaus::typed_value sent{jaus::data_type::float_, number};
        const std::string written = text::to_json(sent).dump();
        INFO(written);
        jaus::typed_value read{};
        CHECK(text::from_json(json::parse(written), read, m.lists));
        const float again = std::get<float>(read.value);
        CHECK((again == number || (again != again && number != number)));
    }
    CHECK(text::to_json(jaus::typed_value{jaus::data_type::float_, limits::quiet_NaN()}).dump() ==
          R"({"data_type":7,"value":{"value":"NaN"}})");
    CHECK(text::to_json(jaus::set_travel_speed{.desired_speed = limits::infinity()}).dump() == // does not encode
          R"({"desired_speed":{"value":"Infinity"}})");
}

TEST_CASE("integers of 64 bits survive JSON") {
    memory m;
    for (const jaus::typed_value& sent :
         {jaus::typed_value{jaus::data_type::unsigned_long_integer, ~std::uint64_t{}},
          jaus::typed_value{jaus::data_type::long_integer, std::numeric_limits<std::int64_t>::min()}}) {
        const std::string written = text::to_json(sent).dump();
        INFO(written);
        jaus::typed_value read{};
        CHECK(text::from_json(json::parse(written), read, m.lists));
        CHECK(read == sent);
    }
}

TEST_CASE("deeply nested JSON is refused without harm") {
    std::string deep, end;
    for (int i = 0; i != 100000; ++i) {
        deep += R"({"mission_tree":{"child":[)";
        end += "]}}";
    }
    CHECK(wrong<jaus::spool_mission>((deep + end).c_str()) == "append_flag is missing");
    CHECK(wrong<jaus::set_travel_speed>((std::string(100000, '[') + std::string(100000, ']')).c_str()) ==
          "is a structure with fields");
}

TEST_CASE("JSON that contradicts itself or the message is refused") {
    using effort = jaus::set_wrench_effort;
    CHECK(wrong<effort>(R"({"propulsive_linear_effort_x":{"value":50,"raw":16384}})").empty());
    CHECK(wrong<effort>(R"({"propulsive_linear_effort_x":{"value":50,"raw":7}})") ==
          "propulsive_linear_effort_x has the value 50 and the raw integer 7, which stands for 0.021362957");
    CHECK(wrong<effort>(R"({"propulsive_linear_effort_x":{"real":50}})") ==
          "propulsive_linear_effort_x is a single value, or a value and its raw integer");
    CHECK(wrong<effort>(R"({"propulsive_linear_effort_x":[50]})") ==
          "propulsive_linear_effort_x is a single value, or a value and its raw integer");
    CHECK(wrong<effort>(R"({"propulsive_linear_effort_x":null})").empty());
    CHECK(wrong<effort>("[]") == "is a structure with fields");
    CHECK(wrong<effort>("7") == "is a structure with fields");
    CHECK(wrong<jaus::report_component_status>(R"({"primary_status_code":2.5,"secondary_status_code":0})") ==
          "primary_status_code is '2.5', which is no value of it; there are initialize, ready, standby, shutdown, "
          "failure and emergency");
    CHECK(wrong<jaus::report_component_status>(R"({"primary_status_code":2,"secondary_status_code":-1})") ==
          "secondary_status_code is '-1', must be 0 to 4294967295");
    CHECK(wrong<jaus::report_time>(R"({"presence_vector":"0x02","time_stamp":1})") ==
          "presence_vector is 0x02, but the fields that are there make 0x01");
    CHECK(wrong<jaus::report_component_status>(
              R"({"presence_vector":"0x02","primary_status_code":2,"secondary_status_code":0})") ==
          "there is no field 'presence_vector'; there are primary_status_code and secondary_status_code");
    CHECK(wrong<jaus::set_joint_efforts>(R"({"joint":[{"joint_effort":1},7,{"joint_effort":"raw:0"}]})").empty());
    CHECK(wrong<jaus::set_joint_efforts>(R"({"joint":[{"joint_effort":1,"x":2}]})") ==
          "joint[0] has one field, joint_effort");
}
