// Messages that a component does not know when it is compiled.
#include "two_nodes.hpp"
#include <jauscat/catalogue/of.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <optional>
#include <vector>

namespace {

using namespace app_test;
namespace catalogue = jauscat::catalogue;
using jauscat::node_errc;

const catalogue::list& known() {
    return catalogue::of<jaus::message_list<jaus::set_travel_speed, jaus::set_camera_pose, jaus::set_joint_efforts>>();
}

struct robot_of_entries : operator_and_robot {
    std::vector<std::string> seen{};
    std::optional<error_code> error{};

    robot_of_entries() {
        for (const auto& type : known())
            driver.on(type, [this](const catalogue::any_message& message, const jaus::header& head) {
                seen.push_back(std::string{message.type().name()} + message.to_text());
                return head.source == unit.address() ? jaus::message_outcome::handled : jaus::message_outcome::refused;
            });
        driver.ready();
        start();
    }
    error_code send(std::uint16_t code, const std::vector<std::byte>& body) {
        error.reset();
        unit.async_send(arm, code, body, [this](error_code what) { error = what; });
        REQUIRE(until([&] { return error.has_value(); }));
        return *error;
    }
};

} // namespace

TEST_CASE("a component handles messages that are chosen at run time, and answers for them") {
    robot_of_entries robot;
    const auto speed = known().from_text("set_travel_speed desired_speed=2.5");
    REQUIRE(speed);
    CHECK(robot.send(speed->command_code(), *speed->encode()) == error_code{});
    const auto efforts = known().from_text("set_joint_efforts joint[0].joint_effort=-100 joint[1].joint_effort=100");
    REQUIRE(efforts);
    CHECK(robot.send(efforts->command_code(), *efforts->encode()) == error_code{});
    REQUIRE(robot.seen.size() == 2);
    CHECK(robot.seen[0].find("set_travel_speed  desired_speed = 2.4414") == 0);
    CHECK(robot.seen[1].find("joint[1].joint_effort = 100 %") != std::string::npos);
}

TEST_CASE("a body that is not that of its message is refused, and the handler does not see it") {
    robot_of_entries robot;
    CHECK(robot.send(jaus::command_code_of<jaus::set_travel_speed>, {std::byte{1}}) == node_errc::refused);
    CHECK(robot.seen.empty());
}

TEST_CASE("a message that is made at run time is sent") {
    operator_and_robot pair;
    std::optional<jaus::set_travel_speed> heard;
    pair.driver.on([&](const jaus::set_travel_speed& told) { heard = told; });
    pair.driver.ready();
    pair.start();
    const auto speed = known().from_text("set_travel_speed desired_speed=2.5");
    REQUIRE(speed);
    CHECK(pair.unit.send(pair.driver.address(), *speed));
    REQUIRE(pair.until([&] { return heard.has_value(); }));
    CHECK(heard->desired_speed == Approx(2.5).margin(0.1));
}

TEST_CASE("a message chosen at run time has one handler, as others have") {
    operator_and_robot pair;
    const auto& type = **known().find("set_travel_speed");
    pair.driver.on([](const jaus::set_travel_speed&) {});
    CHECK_THROWS_AS(pair.driver.on(type, [](const catalogue::any_message&) {}), std::logic_error);
}
