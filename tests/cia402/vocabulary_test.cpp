// The words of the drive profile: every state and command by its bits, every transition of the standard.
#include "support/catch.hpp"
#include <jauscat/schema/ethercat/cia402_objects.hpp>

#include <set>

using namespace jauscat::cia402;

TEST_CASE("every statusword stands for one state at most") {
    for (unsigned word = 0; word != 0x10000; ++word) {
        unsigned matches = 0;
        for (const auto& each : state_patterns) matches += (word & each.mask) == each.value ? 1u : 0u;
        REQUIRE(matches <= 1);
        REQUIRE((matches == 1) == state_of(static_cast<std::uint16_t>(word)).has_value());
    }
}

TEST_CASE("a drive's statusword is decoded whatever its other bits are") {
    STATIC_REQUIRE(state_of(0x0000) == state::not_ready_to_switch_on);
    STATIC_REQUIRE(state_of(0x0250) == state::switch_on_disabled);
    STATIC_REQUIRE(state_of(0x0670) == state::switch_on_disabled); // with quick stop set
    STATIC_REQUIRE(state_of(0x0231) == state::ready_to_switch_on);
    STATIC_REQUIRE(state_of(0x0233) == state::switched_on);
    STATIC_REQUIRE(state_of(0x1637) == state::operation_enabled);
    STATIC_REQUIRE(state_of(0x0217) == state::quick_stop_active);
    STATIC_REQUIRE(state_of(0x021F) == state::fault_reaction_active);
    STATIC_REQUIRE(state_of(0x0218) == state::fault);
    STATIC_REQUIRE(!state_of(0x0022)); // switched on without ready
    for (const auto& each : state_patterns) CHECK(state_of(status_of(each.state)) == each.state);
}

TEST_CASE("a command is decoded by its bits, and fault reset by its edge") {
    STATIC_REQUIRE(command_of(0x0006, 0) == command::shutdown);
    STATIC_REQUIRE(command_of(0x000E, 0) == command::shutdown);
    STATIC_REQUIRE(command_of(0x0007, 0) == command::switch_on);
    STATIC_REQUIRE(command_of(0x000F, 0) == command::enable_operation);
    STATIC_REQUIRE(command_of(0x001F, 0) == command::enable_operation);
    STATIC_REQUIRE(command_of(0x000D, 0) == command::disable_voltage);
    STATIC_REQUIRE(command_of(0x000B, 0) == command::quick_stop);
    STATIC_REQUIRE(command_of(0x0080, 0) == command::fault_reset);
    STATIC_REQUIRE(command_of(0x008F, 0x0F) == command::fault_reset);
    STATIC_REQUIRE(command_of(0x0080, 0x80) == command::none);
    for (const auto each : {command::shutdown, command::switch_on, command::enable_operation, command::disable_voltage,
                            command::quick_stop, command::fault_reset})
        CHECK(command_of(control_of(each), 0) == each);
}

TEST_CASE("the commands cause the transitions 2 to 12, 15 and 16") {
    std::set<int> numbers;
    for (const auto& each : transitions) {
        numbers.insert(each.number);
        const auto found = transition_of(each.from, each.cause);
        REQUIRE(found);
        CHECK(found->to == each.to);
    }
    CHECK(numbers == std::set{2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 15, 16});
    STATIC_REQUIRE(!transition_of(state::switch_on_disabled, command::enable_operation));
    STATIC_REQUIRE(!transition_of(state::fault, command::shutdown));
    STATIC_REQUIRE(!transition_of(state::fault_reaction_active, command::fault_reset));
}

TEST_CASE("the words have their bits by name") {
    STATIC_REQUIRE(word_of(controlword{.switch_on = true,
                                       .enable_voltage = true,
                                       .quick_stop = true,
                                       .enable_operation = true,
                                       .mode_4 = true,
                                       .halt = true}) == 0x011F);
    STATIC_REQUIRE(fields_of<controlword>(0x0080) == controlword{.fault_reset = true});
    STATIC_REQUIRE(fields_of<statusword>(0x1637) == statusword{.ready_to_switch_on = true,
                                                               .switched_on = true,
                                                               .operation_enabled = true,
                                                               .voltage_enabled = true,
                                                               .quick_stop = true,
                                                               .remote = true,
                                                               .target_reached = true,
                                                               .mode_12 = true});
    for (unsigned word = 0; word < 0x10000; word += 7)
        CHECK(word_of(fields_of<statusword>(static_cast<std::uint16_t>(word))) == word);
}

TEST_CASE("supported modes have bit 0 for mode 1") {
    STATIC_REQUIRE(supported_modes(mode::profile_position, mode::homing, mode::cyclic_synchronous_position) == 0xA1);
    STATIC_REQUIRE(is_supported(0x0380, mode::cyclic_synchronous_torque));
    STATIC_REQUIRE(!is_supported(0x0380, mode::homing));
    STATIC_REQUIRE(!is_supported(0xFFFFFFFF, mode::none));
    STATIC_REQUIRE(!is_supported(0xFFFFFFFF, mode{-1}));
}

TEST_CASE("objects of further axes are 800h apart") {
    STATIC_REQUIRE(objects::controlword.index_of(0) == 0x6040);
    STATIC_REQUIRE(objects::controlword.index_of(1) == 0x6840);
    STATIC_REQUIRE(objects::target_velocity.index_of(max_axes - 1) == 0x98FF);
    STATIC_REQUIRE(objects::target_velocity.bits == 32);
    STATIC_REQUIRE(objects::mode_display.data_type == jauscat::ethercat::data_types::integer8);
}
