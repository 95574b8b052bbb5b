// The drive profile CiA 402 (IEC 61800-7-201): controlword, statusword, states, transitions, modes of operation.
#pragma once

#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::cia402 {

/// Modes of operation (6060h, 6061h). Negative values are the manufacturer's.
enum class mode : std::int8_t {
    none = 0,
    profile_position = 1,
    velocity = 2,
    profile_velocity = 3,
    profile_torque = 4,
    homing = 6,
    interpolated_position = 7,
    cyclic_synchronous_position = 8,
    cyclic_synchronous_velocity = 9,
    cyclic_synchronous_torque = 10,
    cyclic_synchronous_torque_with_angle = 11,
};

/// Whether `supported`, the value of 6502h, has the bit of `which`: bit 0 is mode 1.
[[nodiscard]] constexpr bool is_supported(std::uint32_t supported, mode which) noexcept {
    const auto number = static_cast<int>(which);
    return number >= 1 && number <= 32 && (supported >> (number - 1) & 1u) != 0;
}
/// The value of 6502h for these modes; those of the manufacturer have no bit.
template <class... Modes> [[nodiscard]] constexpr std::uint32_t supported_modes(Modes... modes) noexcept {
    std::uint32_t bits = 0;
    for (const mode each : {modes...})
        if (const auto number = static_cast<int>(each); number >= 1 && number <= 32) bits |= 1u << (number - 1);
    return bits;
}

/// Controlword (6040h), 2 bytes. `mode_4` to `mode_6` and `mode_9` depend on the mode of operation: see control_bits.
struct controlword {
    bool switch_on{};
    bool enable_voltage{};
    bool quick_stop{}; ///< false requests the quick stop
    bool enable_operation{};
    bool mode_4{};
    bool mode_5{};
    bool mode_6{};
    bool fault_reset{}; ///< its rising edge resets a fault
    bool halt{};
    bool mode_9{};
    std::uint8_t manufacturer{}; ///< 5 bits
    friend constexpr bool operator==(const controlword&, const controlword&) = default;

    struct schema : wire::items {
        using T = controlword;
        using type = layout<bit_fields<u16le,
            bit_field<&T::switch_on, 1>,
            bit_field<&T::enable_voltage, 1>,
            bit_field<&T::quick_stop, 1>,
            bit_field<&T::enable_operation, 1>,
            bit_field<&T::mode_4, 1>,
            bit_field<&T::mode_5, 1>,
            bit_field<&T::mode_6, 1>,
            bit_field<&T::fault_reset, 1>,
            bit_field<&T::halt, 1>,
            bit_field<&T::mode_9, 1>,
            reserved<1>,
            bit_field<&T::manufacturer, 5>>>;
    };
};

/// Statusword (6041h), 2 bytes. `mode_12` and `mode_13` depend on the mode of operation: see status_bits.
struct statusword {
    bool ready_to_switch_on{};
    bool switched_on{};
    bool operation_enabled{};
    bool fault{};
    bool voltage_enabled{};
    bool quick_stop{}; ///< false while a quick stop is active
    bool switch_on_disabled{};
    bool warning{};
    bool manufacturer_8{};
    bool remote{}; ///< the drive obeys the controlword
    bool target_reached{};
    bool internal_limit{}; ///< a limit of the drive is active
    bool mode_12{};
    bool mode_13{};
    std::uint8_t manufacturer{}; ///< bits 14 and 15
    friend constexpr bool operator==(const statusword&, const statusword&) = default;

    struct schema : wire::items {
        using T = statusword;
        using type = layout<bit_fields<u16le,
            bit_field<&T::ready_to_switch_on, 1>,
            bit_field<&T::switched_on, 1>,
            bit_field<&T::operation_enabled, 1>,
            bit_field<&T::fault, 1>,
            bit_field<&T::voltage_enabled, 1>,
            bit_field<&T::quick_stop, 1>,
            bit_field<&T::switch_on_disabled, 1>,
            bit_field<&T::warning, 1>,
            bit_field<&T::manufacturer_8, 1>,
            bit_field<&T::remote, 1>,
            bit_field<&T::target_reached, 1>,
            bit_field<&T::internal_limit, 1>,
            bit_field<&T::mode_12, 1>,
            bit_field<&T::mode_13, 1>,
            bit_field<&T::manufacturer, 2>>>;
    };
};

/// Bits of the controlword.
namespace control_bits {
inline constexpr std::uint16_t new_set_point = 0x0010;      ///< profile position: rising edge
inline constexpr std::uint16_t change_immediately = 0x0020; ///< profile position: do not finish the set-point before
inline constexpr std::uint16_t relative = 0x0040;           ///< profile position: counts from the target before
inline constexpr std::uint16_t start_homing = 0x0010;       ///< homing: rising edge, stays set until it has ended
inline constexpr std::uint16_t fault_reset = 0x0080;
inline constexpr std::uint16_t halt = 0x0100;
} // namespace control_bits

/// Bits of the statusword.
namespace status_bits {
inline constexpr std::uint16_t voltage_enabled = 0x0010;
inline constexpr std::uint16_t quick_stop = 0x0020;
inline constexpr std::uint16_t warning = 0x0080;
inline constexpr std::uint16_t remote = 0x0200;
inline constexpr std::uint16_t target_reached = 0x0400;
inline constexpr std::uint16_t internal_limit = 0x0800;
inline constexpr std::uint16_t follows_target = 0x1000;         ///< cyclic synchronous modes
inline constexpr std::uint16_t set_point_acknowledged = 0x1000; ///< profile position
inline constexpr std::uint16_t speed_is_zero = 0x1000;          ///< profile velocity
inline constexpr std::uint16_t homing_attained = 0x1000;        ///< homing
inline constexpr std::uint16_t following_error = 0x2000;        ///< position modes
inline constexpr std::uint16_t homing_error = 0x2000;           ///< homing
} // namespace status_bits

/// States of the drive. Below `operation_enabled` there is no torque.
enum class state : std::uint8_t {
    not_ready_to_switch_on,
    switch_on_disabled,
    ready_to_switch_on,
    switched_on,
    operation_enabled,
    quick_stop_active,
    fault_reaction_active,
    fault,
};

/// How a state shows in the statusword: `statusword & mask` is `value`.
struct state_pattern {
    cia402::state state{};
    std::uint16_t mask{};
    std::uint16_t value{};
};
inline constexpr std::array state_patterns{
    state_pattern{state::not_ready_to_switch_on, 0x004F, 0x0000},
    state_pattern{state::switch_on_disabled, 0x004F, 0x0040},
    state_pattern{state::ready_to_switch_on, 0x006F, 0x0021},
    state_pattern{state::switched_on, 0x006F, 0x0023},
    state_pattern{state::operation_enabled, 0x006F, 0x0027},
    state_pattern{state::quick_stop_active, 0x006F, 0x0007},
    state_pattern{state::fault_reaction_active, 0x004F, 0x000F},
    state_pattern{state::fault, 0x004F, 0x0008},
};

/// The state in a statusword; nothing where its bits stand for none.
[[nodiscard]] constexpr std::optional<state> state_of(std::uint16_t statusword) noexcept {
    for (const auto& each : state_patterns)
        if ((statusword & each.mask) == each.value) return each.state;
    return {};
}
/// The bits by which `state` is recognised; quick stop (bit 5) is set where the state leaves it open.
[[nodiscard]] constexpr std::uint16_t status_of(state state) noexcept {
    for (const auto& each : state_patterns)
        if (each.state == state) return static_cast<std::uint16_t>(each.value | (~each.mask & status_bits::quick_stop));
    return 0;
}

/// Commands of the controlword. `switch_on` and `disable_operation` have the same bits: the state decides.
enum class command : std::uint8_t {
    none, ///< bits that stand for no command, such as fault reset without its edge
    shutdown,
    switch_on,
    enable_operation,
    disable_voltage,
    quick_stop,
    fault_reset,
};

/// Bits 0 to 3 and 7 of the controlword for a command; the mode's bits are 0.
[[nodiscard]] constexpr std::uint16_t control_of(command command) noexcept {
    switch (command) {
    case command::shutdown: return 0x0006;
    case command::switch_on: return 0x0007;
    case command::enable_operation: return 0x000F;
    case command::quick_stop: return 0x0002;
    case command::fault_reset: return control_bits::fault_reset;
    case command::none:
    case command::disable_voltage: break;
    }
    return 0x0000;
}
/// The command in a controlword that follows `before`.
[[nodiscard]] constexpr command command_of(std::uint16_t controlword, std::uint16_t before) noexcept {
    if ((controlword & control_bits::fault_reset) != 0)
        return (before & control_bits::fault_reset) == 0 ? command::fault_reset : command::none;
    if ((controlword & 0x02) == 0) return command::disable_voltage;
    if ((controlword & 0x04) == 0) return command::quick_stop;
    if ((controlword & 0x01) == 0) return command::shutdown;
    return (controlword & 0x08) == 0 ? command::switch_on : command::enable_operation;
}

/// A transition that a command causes. Those without a row are automatic: 0, 1, 13 (any state to fault reaction), 14.
struct transition {
    std::uint8_t number{};
    state from{};
    command cause{};
    state to{};
};
/// `switch_on` in `operation_enabled` is the command disable operation. 3 with `enable_operation` is followed by 4.
/// Transition 12 also happens by itself, and 16 only in drives that stay in quick stop (605Ah: 5 to 8).
inline constexpr std::array transitions{
    transition{2, state::switch_on_disabled, command::shutdown, state::ready_to_switch_on},
    transition{3, state::ready_to_switch_on, command::switch_on, state::switched_on},
    transition{3, state::ready_to_switch_on, command::enable_operation, state::switched_on},
    transition{4, state::switched_on, command::enable_operation, state::operation_enabled},
    transition{5, state::operation_enabled, command::switch_on, state::switched_on},
    transition{6, state::switched_on, command::shutdown, state::ready_to_switch_on},
    transition{7, state::ready_to_switch_on, command::disable_voltage, state::switch_on_disabled},
    transition{7, state::ready_to_switch_on, command::quick_stop, state::switch_on_disabled},
    transition{8, state::operation_enabled, command::shutdown, state::ready_to_switch_on},
    transition{9, state::operation_enabled, command::disable_voltage, state::switch_on_disabled},
    transition{10, state::switched_on, command::disable_voltage, state::switch_on_disabled},
    transition{10, state::switched_on, command::quick_stop, state::switch_on_disabled},
    transition{11, state::operation_enabled, command::quick_stop, state::quick_stop_active},
    transition{12, state::quick_stop_active, command::disable_voltage, state::switch_on_disabled},
    transition{15, state::fault, command::fault_reset, state::switch_on_disabled},
    transition{16, state::quick_stop_active, command::enable_operation, state::operation_enabled},
};
/// The transition that `cause` triggers in `from`; nothing where the command has no effect.
[[nodiscard]] constexpr std::optional<transition> transition_of(state from, command cause) noexcept {
    for (const auto& each : transitions)
        if (each.from == from && each.cause == cause) return each;
    return {};
}

/// The state by its name in the standard, for logs.
[[nodiscard]] constexpr std::string_view describe(state state) noexcept {
    switch (state) {
    case state::not_ready_to_switch_on: return "not ready to switch on";
    case state::switch_on_disabled: return "switch on disabled";
    case state::ready_to_switch_on: return "ready to switch on";
    case state::switched_on: return "switched on";
    case state::operation_enabled: return "operation enabled";
    case state::quick_stop_active: return "quick stop active";
    case state::fault_reaction_active: return "fault reaction active";
    case state::fault: return "fault";
    }
    return "unknown state";
}

/// What a drive does to stop (605Ah to 605Eh). In 605Ah, 4 more keeps it in quick stop active afterwards: 5 to 8.
enum class stop_option : std::int16_t {
    power_off = 0,
    slow_down_ramp = 1,  ///< 6084h
    quick_stop_ramp = 2, ///< 6085h
    current_limit = 3,
    voltage_limit = 4,
};

/// Error codes (603Fh) that this library uses; others pass through. IEC 61800-7-201, annex.
namespace error_codes {
inline constexpr std::uint16_t none = 0x0000;
inline constexpr std::uint16_t over_current = 0x2310;
inline constexpr std::uint16_t over_temperature = 0x4310;
inline constexpr std::uint16_t communication = 0x7500;
inline constexpr std::uint16_t following_error = 0x8611;
} // namespace error_codes

} // namespace jauscat::cia402

namespace jauscat {

namespace cia402 {

/// The word as an integer; 0 where `manufacturer` has more bits than its field.
[[nodiscard]] constexpr std::uint16_t word_of(const auto& word) noexcept {
    std::array<std::byte, 2> bytes{};
    if (!wire::encode(word, bytes)) return 0;
    return static_cast<std::uint16_t>(std::to_integer<unsigned>(bytes[0]) | std::to_integer<unsigned>(bytes[1]) << 8);
}
/// The bits of an integer by name: `fields_of<statusword>(0x0637)`.
template <class Word> [[nodiscard]] constexpr Word fields_of(std::uint16_t word) noexcept {
    const std::array bytes{static_cast<std::byte>(word & 0xFF), static_cast<std::byte>(word >> 8)};
    Word fields{};
    static_cast<void>(wire::decode(fields, bytes)); // two bytes always decode
    return fields;
}

} // namespace cia402

} // namespace jauscat
