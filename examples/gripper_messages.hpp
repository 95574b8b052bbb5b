// A private message: the message, its layout, and the list of a program's private messages.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/wire.hpp>

#include <cstdint>
#include <optional>
#include <string_view>

namespace gripper {

namespace jaus = jauscat::jaus;
struct opening_range {
    static constexpr double min = 0, max = 200;
    static constexpr std::string_view unit = "mm";
};

/// Set Gripper: opens or closes the gripper. Code D101h, in the range that RA 3.3 leaves to experimental messages.
struct set_gripper {
    std::uint8_t finger{};           ///< 1 is the first; 0 moves all of them
    std::optional<double> opening{}; ///< millimetres, 0 to 200
    std::optional<double> force{};   ///< percent of the most, 0 to 100
    friend constexpr bool operator==(const set_gripper&, const set_gripper&) = default;

    struct schema : jauscat::wire::items {
        static constexpr std::uint16_t command_code = 0xD101;
        using T = set_gripper;
        using type = layout<field<&T::finger, u8>, presence<u8, field<&T::opening, scaled<u16le, opening_range>>,
                                                            field<&T::force, scaled<u8, jaus::percent>>>>;
    };
};

} // namespace gripper

using private_messages = jauscat::jaus::message_list<gripper::set_gripper>;
