// Text becomes a message, or gives an error message.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/stamps.hpp>

namespace {

namespace jaus = jauscat::jaus;
namespace text = jauscat::text;
namespace wire = jauscat::wire;
using jauscat::test::to_hex;

using known_messages =
    jaus::message_list<jaus::set_wrench_effort, jaus::set_emergency, jaus::report_component_status, jaus::report_time,
                       jaus::set_joint_efforts, jaus::set_joint_motion, jaus::create_event, jaus::set_camera_pose,
                       jaus::create_vector_knowledge_store_objects, jaus::report_identification,
                       jaus::report_camera_pose, jaus::spool_mission, jaus::report_image>;

/// The body that a line makes, in hex, or what is wrong with the line.
std::string body_of(std::string_view line) {
    std::vector<std::byte> lists(1 << 16);
    wire::arena memory{lists};
    std::string body;
    const auto read = text::from_text(line, memory, known_messages{}, [&](const auto& message) {
        std::vector<std::byte> bytes(wire::encoded_size(message));
        const auto written = wire::encode(message, bytes);
        body = written ? to_hex(bytes) : std::string{wire::describe(written.error())};
        if (written) std::erase(body, ' ');
    });
    return read ? body : std::string{describe(read.error())};
}

} // namespace

TEST_CASE("stamps are read in the form in which they are written only") {
    for (const char* const line : {"12:34:56.789, day 5", "00:00:00.000, day 31", "23:59:59.999, day 1"}) {
        jaus::time_stamp time{};
        REQUIRE(text::from_text(time, line));
        CHECK(text::to_text(time) == line);
    }
    for (const char* const line :
         {"12:34:56.-1, day 5", "12:34:56.7, day 5", "12:34:56.70, day 5", "12:34: 6.789, day 5", "+1:-0:+2.+3, day +5",
          "1:34:56.789, day 5", "12:34:56.789,day 5", "12:34:56.789, day ", "12:34:56.789, day 5 ",
          "12:34:56.7890, day 5", "24:00:00.000, day 5", "12:60:00.000, day 5", "12:00:60.000, day 5",
          "12:00:00.000, day 0", "12:00:00.000, day 32", "12:00:00.000, day 005", ""}) {
        CAPTURE(line);
        jaus::time_stamp time{};
        CHECK(!text::from_text(time, line));
        CHECK(time == jaus::time_stamp{});
    }
    for (const char* const line : {"2007-06-27", "2000-02-29", "2127-12-31"}) {
        jaus::date_stamp date{};
        REQUIRE(text::from_text(date, line));
        CHECK(text::to_text(date) == line);
    }
    for (const char* const line :
         {"2007-02-31", "2007-02-29", "2100-02-29", "2007--1-05", "2007-6-27", "2007-06-7", "1999-12-31", "2128-01-01",
          "2007-13-01", "2007-00-01", "2007-06-27 ", "+007-06-27"}) {
        CAPTURE(line);
        jaus::date_stamp date{};
        CHECK(!text::from_text(date, line));
        CHECK(date == jaus::date_stamp{});
    }
}

TEST_CASE("a line of names and values becomes a message") {
    CHECK(body_of("set_wrench_effort propulsive_linear_effort_x=50") == "01000040");
    CHECK(body_of("set_wrench_effort") == "0000");
    CHECK(body_of("  set_wrench_effort\tpropulsive_linear_effort_y=-100  ") == "02000180");
    CHECK(body_of("report_component_status primary_status_code=standby secondary_status_code=258") == "0202010000");
}

TEST_CASE("a message is named by its schema's name, the standard's name or its code") {
    for (const char* const name :
         {"set_wrench_effort", "\"Set Wrench Effort\"", "\"set wrench effort\"", "0405", "0405h", "0x0405", "0X405"}) {
        INFO(name);
        CHECK(body_of(std::string{name} + " resistive_linear_effort_x=100") == "4000ff");
    }
    CHECK(body_of("set_wrench_efort") == "there is no message 'set_wrench_efort'; did you mean set_wrench_effort?");
    CHECK(body_of("0x0999") == "there is no message with the code 0x0999");
    CHECK(body_of("qqqqqqqqqqqqqq") == "there is no message 'qqqqqqqqqqqqqq'");
    CHECK(body_of("query_time") == "the message query_time is not handled here");
    CHECK(body_of(" ") == "the name of a message is missing");
}

TEST_CASE("real values may have their unit, and the word raw sets the integer on the wire") {
    for (const char* const value : {"12.5", "12.5%", "\"12.5 %\"", "+12.5", "1.25e1", "raw:32", "raw:0x20"}) {
        INFO(value);
        CHECK(body_of("set_wrench_effort resistive_linear_effort_x=" + std::string{value}) == "400020");
    }
    CHECK(body_of("set_wrench_effort propulsive_linear_effort_x=raw:-32767") == "01000180");
    CHECK(body_of("set_wrench_effort propulsive_linear_effort_x=raw:-32768") ==
          "propulsive_linear_effort_x is '-32768', a raw value that stands for nothing");
    CHECK(body_of("set_wrench_effort propulsive_linear_effort_x=raw:32768") ==
          "propulsive_linear_effort_x is '32768', must be -32768 to 32767");
    CHECK(body_of("set_wrench_effort propulsive_linear_effort_x=100.5") ==
          "propulsive_linear_effort_x is '100.5', must be -100 to 100 %");
    CHECK(body_of("set_wrench_effort propulsive_linear_effort_x=NaN") ==
          "propulsive_linear_effort_x is 'NaN', must be -100 to 100 %");
    CHECK(body_of("set_wrench_effort propulsive_linear_effort_x=fast") ==
          "propulsive_linear_effort_x is 'fast', which is no number");
    CHECK(body_of("set_wrench_effort propulsive_linear_effort_x=12m") ==
          "propulsive_linear_effort_x is '12m', which is no number");
}

TEST_CASE("an unknown name is answered with a similar one that exists") {
    CHECK(body_of("set_wrench_effort propulsive_linear_efort_x=50") ==
          "there is no field 'propulsive_linear_efort_x'; did you mean propulsive_linear_effort_x?");
    CHECK(body_of("set_wrench_effort linear_effort_y=50") ==
          "there is no field 'linear_effort_y'; did you mean propulsive_linear_effort_y?");
    CHECK(body_of("report_component_status colour=red") ==
          "there is no field 'colour'; there are primary_status_code and secondary_status_code");
    CHECK(body_of("set_joint_motion pose[0].pose_tim=1") == "pose[0] has no field 'pose_tim'; did you mean pose_time?");
}

TEST_CASE("enumerators and flags are given by name or number") {
    CHECK(body_of("report_component_status primary_status_code=200 secondary_status_code=0") == "c800000000");
    CHECK(body_of("report_component_status primary_status_code=redy secondary_status_code=0") ==
          "primary_status_code is 'redy', which is no value of it; did you mean ready?");
    CHECK(body_of("report_component_status primary_status_code=256 secondary_status_code=0") ==
          "primary_status_code is '256', must be 0 to 255");
    for (const char* const value :
         {"linear_x_is_a_rate|angular_z_is_a_rate", "\"angular_z_is_a_rate | bit 0\"", "0x21", "33"}) {
        INFO(value);
        CHECK(body_of("set_camera_pose camera_id=7 mode_indicator=" + std::string{value}) == "000721");
    }
    CHECK(body_of("set_camera_pose camera_id=7 mode_indicator=none") == "000700");
    CHECK(body_of("set_camera_pose camera_id=7 mode_indicator=linear_x_is_a_rate|linear_w_is_a_rate") ==
          "mode_indicator is 'linear_w_is_a_rate', which is no flag; did you mean linear_x_is_a_rate?");
    CHECK(body_of("set_camera_pose camera_id=7 mode_indicator=") == "mode_indicator is '', which is no flag; there are "
                                                                    "linear_x_is_a_rate, linear_y_is_a_rate, "
                                                                    "linear_z_is_a_rate, angular_x_is_a_rate, "
                                                                    "angular_y_is_a_rate and angular_z_is_a_rate");
}

TEST_CASE("missing required fields are errors") {
    CHECK(body_of("report_component_status primary_status_code=ready") == "secondary_status_code is missing");
    CHECK(body_of("set_camera_pose mode_indicator=none") == "camera_id is missing");
    CHECK(body_of("report_identification query_type=1 authority_code=1 type=1") == "identification is missing");
    CHECK(body_of("create_event local_request_id=1 message_code=0x4405 event_type=periodic lower_limit.value=5") ==
          "lower_limit.data_type is missing");
}

TEST_CASE("lists are filled by indices from 0, and their counts are derived") {
    CHECK(body_of("set_joint_efforts joint[1].joint_effort=100 joint[0].joint_effort=-100") == "020000ffff");
    CHECK(body_of("set_joint_efforts joint[0]=100") == "01ffff");
    CHECK(body_of("set_joint_efforts") == "00");
    CHECK(body_of("set_joint_efforts number_of_joints=1 joint[0]=100") == "01ffff");
    CHECK(body_of("set_joint_efforts number_of_joints=2 joint[0]=100") == "number_of_joints is 2, but joint has 1");
    CHECK(body_of("set_joint_efforts number_of_joints=2") == "number_of_joints is 2, but there is no joint");
    CHECK(body_of("set_joint_efforts joint[1]=100") == "joint[0] is missing");
    CHECK(body_of("set_joint_efforts joint[0].joint_position=1") == "joint[0] has one field, joint_effort");
    CHECK(body_of("set_joint_efforts joint=1") == "joint is a list");
    CHECK(body_of("set_joint_efforts joint[300]=1") == "joint has 301 elements, must have at most 255");
    CHECK(body_of("set_joint_efforts joint[x]=1") ==
          "'joint[x]' needs the number of an element between its brackets, from 0");
    CHECK(body_of("set_joint_efforts joint[65536]=1") == "'joint[65536]' is beyond the 65536 elements a list may have");
}

TEST_CASE("a count outside of the list is derived from the lists that it counts") {
    const std::string joint = ".joint_position=0 pose[0].joint[0].joint_maximum_velocity=0 "
                              "pose[0].joint[0].joint_maximum_acceleration=0 "
                              "pose[0].joint[0].joint_maximum_deceleration=0";
    CHECK(body_of("set_joint_motion pose[0].pose_time=0 pose[0].joint[0]" + joint) ==
          "010100000000"
          "00000080000000800000008000000080");
    CHECK(body_of("set_joint_motion pose[1].pose_time=0 pose[0].pose_time=0 pose[0].joint[0]" + joint) ==
          "pose[1].joint has 0, but number_of_joints is 1");
    CHECK(body_of("set_joint_motion") == "number_of_joints is missing");
}

TEST_CASE("a flag that announces members of elements is derived from them") {
    const std::string line = "create_vector_knowledge_store_objects local_request_id=7 message_properties=none ";
    CHECK(body_of(line + "object[0].object_type=line") == "0000070100"
                                                          "01000000");
    CHECK(body_of(line + "object[0].object_type=line object[0].object_buffer=1") == "0100070100"
                                                                                    "010000803f000000");
    CHECK(body_of(line + "object[0].object_type=line object[0].object_buffer=1 object[1].object_type=line") ==
          "object[1].object_buffer is missing, although object_buffer_present is set");
    CHECK(body_of(line + "object[0].object_type=line object_buffer_present=true") ==
          "object[0].object_buffer is missing, although object_buffer_present is set");
    CHECK(body_of(line + "object[0].object_type=line object[0].object_buffer=1 object_buffer_present=false") ==
          "object[0].object_buffer is there, although object_buffer_present is not set");
    CHECK(body_of(line + "object_buffer_present=yes") == "object_buffer_present is 'yes', must be true or false");
    CHECK(body_of(line + "presence_vector=1") == "0100070000");
}

TEST_CASE("a given presence vector must match the fields") {
    CHECK(body_of("set_wrench_effort presence_vector=0x0001 propulsive_linear_effort_x=50") == "01000040");
    CHECK(body_of("set_wrench_effort presence_vector=3 propulsive_linear_effort_x=50") ==
          "presence_vector is 0x0003, but the fields that are there make 0x0001");
}

TEST_CASE("the type code determines the type of a value") {
    const std::string line = "create_event local_request_id=1 message_code=0x4405 event_type=periodic ";
    CHECK(body_of(line + "lower_limit.data_type=short_integer lower_limit.value=-2") == "0401054400"
                                                                                        "01feff");
    CHECK(body_of(line + "lower_limit.data_type=rgb lower_limit.value.red=1 lower_limit.value.green=2 "
                         "lower_limit.value.blue=3") == "0401054400"
                                                        "09010203");
    CHECK(body_of(line + "lower_limit.data_type=none") == "0401054400"
                                                          "ff");
    CHECK(body_of(line + "lower_limit.data_type=none lower_limit.value=1") ==
          "lower_limit.value has no value for this data_type");
    CHECK(body_of(line + "lower_limit.data_type=77 lower_limit.value=1") ==
          "lower_limit.value has no form for this data_type");
    CHECK(body_of(line + "lower_limit.data_type=byte lower_limit.value=256") ==
          "lower_limit.value is '256', must be 0 to 255");
    CHECK(body_of(line + "lower_limit.data_type=float lower_limit.value=1e39") ==
          "lower_limit.value is '1e39', must be -3.4028235e+38 to 3.4028235e+38");
}

TEST_CASE("times and dates are written in readable form or as their integer") {
    CHECK(body_of("report_time time_stamp=\"12:34:56.789, day 5\"") == "01"
                                                                       "15e3222b");
    CHECK(body_of("report_time time_stamp=0x2b22e315") == "01"
                                                          "15e3222b");
    CHECK(body_of("report_time time_stamp.hours=12 time_stamp.minutes=34 time_stamp.seconds=56 "
                  "time_stamp.milliseconds=789 time_stamp.day=5") == "01"
                                                                     "15e3222b");
    CHECK(body_of("report_time date_stamp=2007-06-27") == "02"
                                                          "db0e");
    CHECK(body_of("report_time date_stamp=27.6.2007") ==
          "date_stamp is '27.6.2007', which is neither of the form '2000-00-00' nor a raw integer");
    CHECK(body_of("report_time time_stamp=\"25:00:00.000, day 5\"") ==
          "time_stamp is '25:00:00.000, day 5', which is neither of the form '00:00:00.000, day 0' nor a raw integer");
    CHECK(body_of("report_time time_stamp.hours=12 time_stamp.minutes=34") == "time_stamp.milliseconds is missing");
    CHECK(body_of("report_time time_stamp.hours=32") == "time_stamp.hours is '32', must be 0 to 31");
}

TEST_CASE("text with spaces is quoted") {
    CHECK(body_of("report_camera_pose camera_id=1 camera_name=\"left \\\"eye\\\" \\x07\"") == "010001"
                                                                                              "6c65667420226579652220"
                                                                                              "07000000");
    CHECK(body_of("report_camera_pose camera_id=1 camera_name=0123456789abcdef") ==
          "camera_name has 16 characters, must have at most 15");
    CHECK(body_of("report_camera_pose camera_id=1 camera_name=\"left") == "no quote at the end of: \"left");
    CHECK(body_of("report_camera_pose camera_id=1 camera_name=\"\\x0g\"") ==
          "no character behind the backslash in: report_camera_pose camera_id=1 camera_name=\"\\x0g\"");
}

TEST_CASE("bytes and messages inside messages are hex") {
    CHECK(body_of("report_image camera_id=1 video_format=0 image_data=00ffA5") == "010000ffa5");
    CHECK(body_of("report_image camera_id=1 video_format=0 image_data=\"00 ff\"") == "010000ff");
    CHECK(body_of("report_image camera_id=1 video_format=0 image_data=") == "0100");
    CHECK(body_of("report_image camera_id=1 video_format=0 image_data=0") ==
          "image_data is not in hex: pairs of digits");
    const std::string mission = "spool_mission mission_id=1 append_flag=0 mission_tree.task_id=2 "
                                "mission_tree.message[0].mission_message.message_uid=3 "
                                "mission_tree.message[0].mission_message.blocking_flag=0 "
                                "mission_tree.message[0].mission_message.message=";
    const std::string message = "06020200ffff2101ffff200100000000";
    CHECK(body_of(mission + message) == "010000"
                                        "0200"
                                        "0000"
                                        "0100"
                                        "0300" +
                                            message + "00");
    CHECK(body_of(mission + message + "00") == "mission_tree.message[0].mission_message.message is no whole message");
    CHECK(body_of(mission + "xy") ==
          "mission_tree.message[0].mission_message.message is a whole message in hex: pairs of digits");
}

TEST_CASE("a tree is written with the indices of its branches") {
    const std::string root = "spool_mission mission_id=1 append_flag=0 mission_tree.task_id=2 ";
    CHECK(body_of(root + "mission_tree.child_offset[0]=13 mission_tree.child[0].task_id=3") == "010000"
                                                                                               "020001000d0000000000"
                                                                                               "030000000000");
    CHECK(body_of(root + "mission_tree.child[0].task_id=3") ==
          "mission_tree[0].child_offset has 0, but number_of_children is 1");
    CHECK(body_of(root + "mission_tree.number_of_children=1") ==
          "mission_tree.number_of_children is 1, but child has 0");
    std::string deep = root + "mission_tree";
    for (int level = 0; level != 16; ++level) deep += ".child[0]";
    CHECK(body_of(deep + ".task_id=1") == "mission_tree has more than 16 levels");
    CHECK(body_of("spool_mission mission_id=1 append_flag=0") == "mission_tree is missing");
}

TEST_CASE("words that are not assignments are reported") {
    CHECK(body_of("set_wrench_effort fast") == "'fast' is not of the form field=value");
    CHECK(body_of("set_wrench_effort =1") == "'=1' is not of the form field=value");
    CHECK(body_of("set_joint_motion pose[0].pose_time=1 pose[0].pose_time=2") == "'pose[0].pose_time' is given twice");
    std::string deep = "set_joint_motion pose";
    for (int i = 0; i != 100000; ++i) deep += ".pose";
    CHECK(body_of(deep + "=1").ends_with("' has too many dots"));
    CHECK(body_of("set_joint_motion pose[0]pose_time=1") == "'pose[0]pose_time' lacks a dot");
    CHECK(body_of("set_joint_motion pose..pose_time=1") == "'pose..pose_time' lacks a name");
    CHECK(body_of("set_joint_motion pose[0].pose_time=1 pose.pose_time=1") ==
          "'pose.pose_time' stands beside another value of the same name");
    CHECK(body_of("report_component_status primary_status_code.x=1") == "primary_status_code is a single value");
}

TEST_CASE("each error of a text has a code, the field and the value concerned") {
    const auto error_of = [](std::string_view line) {
        std::array<std::byte, 64> lists{};
        wire::arena memory{lists};
        return text::from_text(line, memory, known_messages{}, [](const auto&) {}).error();
    };
    struct row {
        std::string_view line;
        text::errc code;
        std::string_view field{}, value{};
    };
    const std::string deep =
        "spool_mission mission_tree.child[0].child[0].child[0].child[0].child[0].child[0].child[0]."
        "child[0].child[0].child[0].child[0].child[0].child[0].child[0].child[0].child[0].task_id=1 "
        "mission_id=1 append_flag=0 mission_tree.task_id=2";
    for (const row& one : std::initializer_list<row>{
             {"set_wrench_effort fast", text::errc::not_an_assignment, "", "fast"},
             {"set_joint_motion pose..pose_time=1", text::errc::invalid_path, "pose..pose_time"},
             {"set_joint_motion pose[0]pose_time=1", text::errc::invalid_path, "pose[0]pose_time"},
             {"set_joint_efforts joint[x]=1", text::errc::invalid_path, "joint[x]"},
             {"set_joint_efforts joint[65536]=1", text::errc::index_too_large, "joint[65536]"},
             {"set_joint_efforts joint[0]=1 joint[0]=2", text::errc::duplicate, "joint[0]"},
             {"set_joint_efforts joint[0]=1 joint.x=2", text::errc::duplicate, "joint.x"},
             {" ", text::errc::missing_name},
             {"set_wrench_efort", text::errc::unknown_message, "", "set_wrench_efort"},
             {"0x0999", text::errc::unknown_message, "", "0x0999"},
             {"query_time", text::errc::unhandled_message, "", "query_time"},
             {"set_wrench_effort speed=1", text::errc::unknown_field, "speed"},
             {"set_joint_motion pose[0].pose_tim=1", text::errc::unknown_field, "pose[0].pose_tim"},
             {"set_joint_efforts joint[1]=100", text::errc::missing_field, "joint[0]"},
             {"report_time time_stamp.hours=12", text::errc::missing_field, "time_stamp.milliseconds"},
             {"set_joint_efforts joint=1", text::errc::wrong_kind, "joint"},
             {"report_component_status primary_status_code.x=1", text::errc::wrong_kind, "primary_status_code"},
             {"set_joint_efforts joint[0]=fast", text::errc::invalid_value, "joint[0]", "fast"},
             {"report_time date_stamp=2007-02-31", text::errc::invalid_value, "date_stamp", "2007-02-31"},
             {"report_image camera_id=1 video_format=0 image_data=0", text::errc::invalid_value, "image_data"},
             {"set_joint_efforts joint[0]=100.5", text::errc::out_of_range, "joint[0]", "100.5"},
             {"set_joint_efforts joint[300]=1", text::errc::wrong_size, "joint"},
             {"report_camera_pose camera_id=1 camera_name=0123456789abcdef", text::errc::wrong_size, "camera_name"},
             {"set_joint_efforts number_of_joints=2 joint[0]=1", text::errc::inconsistent, "number_of_joints"},
             {"set_wrench_effort presence_vector=1", text::errc::inconsistent, "presence_vector"},
             {deep, text::errc::too_deep, "mission_tree"},
             {"report_image camera_id=1 video_format=0 image_data="
              "000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000"
              "000000000000000000000000000000000000",
              text::errc::arena_full, "image_data"},
         }) {
        CAPTURE(one.line);
        const text::error found = error_of(one.line);
        CHECK(found.code == one.code);
        CHECK(found.field == one.field);
        CHECK(found.value == one.value);
        CHECK(!describe(found).empty());
        CHECK(describe(found.code) != "unknown error");
    }
    CHECK(error_of("set_wrench_effort") == text::error{});

    constexpr std::string_view open = "report_camera_pose camera_name=\"left";
    CHECK(error_of(open).code == text::errc::unfinished_quote);
    CHECK(error_of(open).offset == open.find('"'));
    constexpr std::string_view escape = "report_camera_pose camera_name=\"\\x0g\"";
    CHECK(error_of(escape).code == text::errc::unfinished_escape);
    CHECK(error_of(escape).offset == escape.find('x'));
}

TEST_CASE("a stamp of another form and one that does not exist have different errors") {
    jaus::time_stamp time{};
    CHECK(text::from_text(time, "12:34").error() == text::errc::invalid_value);
    CHECK(text::from_text(time, "24:00:00.000, day 5").error() == text::errc::out_of_range);
    jaus::date_stamp date{};
    CHECK(text::from_text(date, "27.6.2007").error() == text::errc::invalid_value);
    CHECK(text::from_text(date, "2007-02-31").error() == text::errc::out_of_range);
}

TEST_CASE("lists that exceed their memory are reported") {
    std::array<std::byte, 8> little{};
    wire::arena memory{little};
    jaus::set_joint_motion message{};
    const auto read = text::from_text("pose[0].pose_time=1", message, memory);
    CHECK(read.error().code == text::errc::arena_full);
    CHECK(describe(read.error()) == "pose does not fit into the memory for lists");
}
