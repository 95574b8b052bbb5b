// Six joints and their emulated drives, one or several axes each.
#pragma once

#include "support/catch.hpp"
#include <jauscat/bridge/joints/joint_group.hpp>
#include <jauscat/ethercat/cia402/emulated_drive.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <array>

namespace jauscat::test {

/// A slave that is a drive of `Axes` axes.
template <std::size_t Axes> struct joint_device {
    cia402::emulated_drive<Axes> drive{};
    ethercat::standard_objects dictionary{cia402::drive_description<Axes>, drive};
    ethercat::slave slave{cia402::drive_description<Axes>, dictionary};
    bool connected{true};
};

/// `Axes` axes to a drive, joint after joint.
template <std::size_t Axes> std::array<bridging::joint_options, 6> joint_arm() {
    cia402::pdo_layout<Axes * 8> outputs, inputs;
    for (const auto& each : cia402::drive_outputs<Axes>)
        REQUIRE(outputs.append({each.bits, each.subindex, each.index}));
    for (const auto& each : cia402::drive_inputs<Axes>) REQUIRE(inputs.append({each.bits, each.subindex, each.index}));
    std::array<bridging::joint_options, 6> made{};
    for (std::size_t i = 0; i != made.size(); ++i)
        made[i] = {.slave = i / Axes,
                   .drive_axis = i % Axes,
                   .places = cia402::places_of(outputs, inputs, i % Axes),
                   .axis = {.max_velocity = 200'000, .acceleration = 2'000'000, .deceleration = 2'000'000},
                   .scale = {.increments_per_radian = 10'000, .reversed = i % 2 == 1, .max_velocity = 100'000}};
    return made;
}

} // namespace jauscat::test
