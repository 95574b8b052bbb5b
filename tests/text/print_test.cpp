// Messages as readable text.
#include "support/bytes.hpp"
#include "support/catch.hpp"
#include <jauscat/schema/ethercat/frame.hpp>
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/text/jaus.hpp>
#include <jauscat/text/print.hpp>

#include <array>

namespace jaus = jauscat::jaus;
namespace text = jauscat::text;

TEST_CASE("a message is printed one field a line, with units, raw integers and names") {
    CHECK(text::to_text(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50}) ==
          "  presence_vector = 0x0001\n"
          "  propulsive_linear_effort_x = 50 % (raw 16384)\n");
    CHECK(text::to_text(jaus::report_component_status{.primary_status_code = jaus::primary_status_code::standby,
                                                      .secondary_status_code = 9},
                        0) == "primary_status_code = standby (2)\n"
                              "secondary_status_code = 9\n");
    CHECK(text::to_text(jaus::report_component_status{.primary_status_code = jaus::primary_status_code{200}}, 0) ==
          "primary_status_code = 0xC8\n"
          "secondary_status_code = 0\n");
    CHECK(text::to_text(jaus::resume{}).empty());
    CHECK(text::to_text(jaus::create_service_connection{.command_code = 0x4405,
                                                        .requested_periodic_update_rate = 1092,
                                                        .requested_presence_vector = 7},
                        0) == "command_code = 0x4405 (Report Wrench Effort)\n"
                              "requested_periodic_update_rate = 1092 Hz (raw 65535)\n"
                              "requested_presence_vector = 0x00000007\n");
}

TEST_CASE("a value that does not encode is printed without a raw integer") {
    CHECK(text::to_text(jaus::set_travel_speed{.desired_speed = -1}) == "  desired_speed = -1 m/s\n");
}

TEST_CASE("lists are printed with their indices, structures below their name") {
    const std::array joints{jaus::joint_motion{.joint_position = 1}};
    const std::array poses{jaus::joint_motion_pose{.pose_time = 6000, .joint = joints}, jaus::joint_motion_pose{}};
    CHECK(text::to_text(jaus::set_joint_motion{.number_of_joints = 1, .pose = poses}, 0) ==
          "number_of_joints = 1\n"
          "number_of_poses = 2\n"
          "pose[0]\n"
          "  pose_time = 6000 s (raw 4294967295)\n"
          "  joint[0]\n"
          "    joint_position = 1 rad (raw 2232929307)\n"
          "    joint_maximum_velocity = 0 rad/s (raw 2147483648)\n"
          "    joint_maximum_acceleration = 0 rad/s^2 (raw 2147483648)\n"
          "    joint_maximum_deceleration = 0 rad/s^2 (raw 2147483648)\n"
          "pose[1]\n"
          "  pose_time = 0 s (raw 0)\n"
          "  joint = none\n");
    CHECK(text::to_text(jaus::set_joint_efforts{.joint_effort = {-100, 100}}, 0) ==
          "number_of_joints = 2\n"
          "joint[0].joint_effort = -100 % (raw 0)\n"
          "joint[1].joint_effort = 100 % (raw 65535)\n");
}

TEST_CASE("flags are printed by name, times and dates in readable form") {
    CHECK(text::to_text(jaus::set_camera_pose{
              .camera_id = 1, .mode_indicator = {jaus::mode_indicator::linear_y_is_a_rate, jaus::mode_indicator{7}}}) ==
          "  presence_vector = 0x00\n"
          "  camera_id = 1\n"
          "  mode_indicator = linear_y_is_a_rate | bit 7 (0x82)\n");
    CHECK(text::to_text(
              jaus::report_time{
                  .time_stamp =
                      jaus::time_stamp{.milliseconds = 789, .seconds = 56, .minutes = 34, .hours = 12, .day = 5},
                  .date_stamp = jaus::date_stamp{.day = 27, .month = 6, .year = 7}},
              0) == "presence_vector = 0x03\n"
                    "time_stamp = 12:34:56.789, day 5 (raw 723706645)\n"
                    "date_stamp = 2007-06-27 (raw 3803)\n");
}

TEST_CASE("text is printed quoted and safe for a terminal, bytes with their count") {
    using namespace std::string_view_literals;
    CHECK(text::quoted("left \"arm\" \\") == R"("left \"arm\" \\")");
    CHECK(text::quoted("\x1B[31m\0"sv) == R"("\x1b[31m\x00")");
    CHECK(text::quoted("Gerät") == "\"Gerät\"");
    CHECK(text::quoted("Ger\xE4t") == R"("Ger\xe4t")");
    CHECK(text::is_utf8("\xF0\x9F\x99\x82"));
    for (const auto wrong : {"\x80"sv, "\xC0\x80"sv, "\xE0\x80\x80"sv, "\xED\xA0\x80"sv, "\xF4\x90\x80\x80"sv,
                             "\xF5\x80\x80\x80"sv, "\xC3"sv, "\xE2\x82"sv, "\xE2\x28\xA1"sv}) {
        INFO(text::quoted(wrong));
        CHECK_FALSE(text::is_utf8(wrong));
    }

    const auto image = support::bytes(0xFA, 0x00);
    CHECK(text::to_text(jaus::report_image{.camera_id = 1, .image_data = std::span{image}}, 0)
              .ends_with("\nimage_data = 2 bytes: fa 00\n"));
    const std::vector<std::byte> large(33);
    CHECK(text::to_text(jaus::report_image{.image_data = std::span{large}}, 0).ends_with(" 00 ...\n"));
}

TEST_CASE("a value that contradicts its type code is reported") {
    CHECK(text::to_text(jaus::typed_value{.data_type = jaus::data_type::byte, .value = std::int16_t{1}}, 0) ==
          "data_type = byte (0)\nvalue = of another type\n");
    CHECK(text::to_text(jaus::typed_value{.data_type = jaus::data_type::none, .value = std::monostate{}}, 0) ==
          "data_type = none (255)\nvalue = none\n");
    CHECK(text::to_text(jaus::typed_value{.data_type = jaus::data_type::rgb, .value = jaus::rgb{1, 2, 3}}, 0) ==
          "data_type = rgb (9)\nvalue\n  red = 1\n  green = 2\n  blue = 3\n");
}

TEST_CASE("structures of other protocols are printed the same way") {
    namespace ethercat = jauscat::ethercat;
    ethercat::ethernet_header head{.ether_type = 0x88A4};
    head.source[5] = std::byte{0x2A};
    CHECK(text::to_text(head, 0) == "destination = 6 bytes: 00 00 00 00 00 00\n"
                                    "source = 6 bytes: 00 00 00 00 00 2a\n"
                                    "ether_type = 34980\n");
    CHECK(text::to_text(ethercat::frame_header{.length = 44, .type = ethercat::frame_type::datagrams}, 0) ==
          "length = 44\ntype = datagrams (1)\n");
}

TEST_CASE("text of devices that is not UTF-8 is taken for Latin-1") {
    CHECK(text::as_utf8("1\xC2\xB5s") == "1\xC2\xB5s");
    CHECK(text::as_utf8("1\xB5s") == "1\xC2\xB5s");
    CHECK(text::as_utf8("\xE9\xFF") == "\xC3\xA9\xC3\xBF");
    CHECK(text::as_utf8("plain") == "plain");
    CHECK(text::as_utf8("") == "");
}

namespace {
struct share {
    static constexpr double min = 0, max = 100; // without a unit
};
struct shares {
    double level{};
    std::optional<double> reserve{};
    struct schema : jauscat::wire::items {
        using type =
            layout<field<&shares::level, scaled<u8, share>>, presence<u8, field<&shares::reserve, scaled<u8, share>>>>;
    };
};
} // namespace

TEST_CASE("values of a range without a unit have none") {
    CHECK(text::to_text(shares{.level = 20}, 0) == "level = 20 (raw 51)\npresence_vector = 0x00\n");
    const std::array bytes{std::byte{51}, std::byte{1}, std::byte{255}};
    const auto lines = text::annotate<shares>(bytes);
    CHECK(lines.find("reserve = 100 (raw 255)") != std::string::npos);
}
