// A robot arm: a JAUS component whose actuator is six CiA 402 drives on one ring, a joint each.
//     six_joints --this b
#include <jauscat/app.hpp>
#include <jauscat/bridge/joints/joint_part.hpp>
#include <jauscat/schema/translation/seed_table.hpp>

#include <array>
#include <chrono>
#include <memory>
#include <vector>

namespace cia402 = jauscat::cia402;

/// All joints are alike: 10,000 increments of the encoder are one radian, and at most 2 radians a second are allowed,
/// from which the ramp takes 100 ms: less than 0.3 of the time in which the arm has to be at rest.
std::array<jauscat::bridging::joint_options, 6> joints() {
    std::array<jauscat::bridging::joint_options, 6> made{};
    for (std::size_t i = 0; i != made.size(); ++i)
        made[i] = {.slave = i,
                   .places = cia402::places_of(cia402::cyclic_outputs, cia402::cyclic_inputs),
                   .axis = {.max_velocity = 20'000, .acceleration = 200'000, .deceleration = 200'000},
                   .scale = {.increments_per_radian = 10'000, .max_velocity = 20'000}};
    return made;
}

int main(int argc, char** argv) {
    using namespace std::chrono_literals;
    jauscat::node node{argc, argv};
    jauscat::bus bus{node.context(), "udp:127.0.0.1", {.thread = true}}; // or a network interface, "eth0"
    jauscat::bridge bridge{node, bus, jauscat::translation::seed_table{}, {.at_rest_within = 400ms, .period = 5ms}};
    std::vector<jauscat::slave> drives;
    for (std::uint16_t position = 0; position != 6; ++position) drives.push_back(bus.slave({.position = position}));
    bridge.serve({.component = 54}, drives, std::make_unique<jauscat::bridging::joint_part<6>>(joints()));
    return node.run();
}
