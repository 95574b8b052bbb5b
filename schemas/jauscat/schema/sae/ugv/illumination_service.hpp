// IlluminationService 1.0, urn:jaus:jss:ugv:IlluminationService.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/ranges.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::ugv {

/// QueryIlluminationState: ID 2513h, input of IlluminationService.
struct query_illumination_state {
    friend constexpr bool operator==(const query_illumination_state&, const query_illumination_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2513;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// QueryIlluminationConfiguration: ID 2514h, input of IlluminationService.
struct query_illumination_configuration {
    friend constexpr bool operator==(
        const query_illumination_configuration&,
        const query_illumination_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2514;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Values of Headlights.
enum class set_illumination_state_headlights : std::uint8_t {
    off = 0,
    on = 1,
};

/// Values of LeftTurnSignal.
enum class set_illumination_state_left_turn_signal : std::uint8_t {
    off = 0,
    on = 1,
};

/// Values of RightTurnSignal.
enum class set_illumination_state_right_turn_signal : std::uint8_t {
    off = 0,
    on = 1,
};

/// Values of RunningLights.
enum class set_illumination_state_running_lights : std::uint8_t {
    off = 0,
    on = 1,
};

/// Values of BrakeLights.
enum class set_illumination_state_brake_lights : std::uint8_t {
    off = 0,
    on = 1,
};

/// Values of BackupLights.
enum class set_illumination_state_backup_lights : std::uint8_t {
    off = 0,
    on = 1,
};

/// Values of VisibleLightSource.
enum class set_illumination_state_visible_light_source : std::uint8_t {
    off = 0,
    on = 1,
};

/// Values of IRLightSource.
enum class set_illumination_state_ir_light_source : std::uint8_t {
    off = 0,
    on = 1,
};

/// Values of HighBeams.
enum class set_illumination_state_high_beams : std::uint8_t {
    off = 0,
    on = 1,
};

/// Values of ParkingLights.
enum class set_illumination_state_parking_lights : std::uint8_t {
    off = 0,
    on = 1,
};

/// Values of FogLights.
enum class set_illumination_state_fog_lights : std::uint8_t {
    off = 0,
    on = 1,
};

/// Values of HazardLights.
enum class set_illumination_state_hazard_lights : std::uint8_t {
    off = 0,
    on = 1,
};

/// Bits of illumination.
struct illumination {
    set_illumination_state_headlights headlights{};
    set_illumination_state_left_turn_signal left_turn_signal{};
    set_illumination_state_right_turn_signal right_turn_signal{};
    set_illumination_state_running_lights running_lights{};
    set_illumination_state_brake_lights brake_lights{};
    set_illumination_state_backup_lights backup_lights{};
    set_illumination_state_visible_light_source visible_light_source{};
    set_illumination_state_ir_light_source ir_light_source{};
    std::uint8_t variable_light1{}; ///< 0 to 15
    std::uint8_t variable_light2{}; ///< 0 to 15
    std::uint8_t variable_light3{}; ///< 0 to 15
    std::uint8_t variable_light4{}; ///< 0 to 15
    set_illumination_state_high_beams high_beams{};
    set_illumination_state_parking_lights parking_lights{};
    set_illumination_state_fog_lights fog_lights{};
    set_illumination_state_hazard_lights hazard_lights{};
    friend constexpr bool operator==(const illumination&, const illumination&) = default;

    struct schema : wire::items {
        using T = illumination;
        using type = layout<
            bit_fields<u32le,
                bit_field<&T::headlights, 1>,
                bit_field<&T::left_turn_signal, 1>,
                bit_field<&T::right_turn_signal, 1>,
                bit_field<&T::running_lights, 1>,
                bit_field<&T::brake_lights, 1>,
                bit_field<&T::backup_lights, 1>,
                bit_field<&T::visible_light_source, 1>,
                bit_field<&T::ir_light_source, 1>,
                bit_field<&T::variable_light1, 4>,
                bit_field<&T::variable_light2, 4>,
                bit_field<&T::variable_light3, 4>,
                bit_field<&T::variable_light4, 4>,
                bit_field<&T::high_beams, 1>,
                bit_field<&T::parking_lights, 1>,
                bit_field<&T::fog_lights, 1>,
                bit_field<&T::hazard_lights, 1>,
                reserved<4>>>;
    };
};

/// SetIlluminationState: ID 0513h, command, input of IlluminationService.
struct set_illumination_state {
    ugv::illumination illumination{};
    friend constexpr bool operator==(const set_illumination_state&, const set_illumination_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0513;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_illumination_state;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::illumination>>;
    };
};

/// ReportIlluminationState: ID 4513h, output of IlluminationService.
struct report_illumination_state {
    ugv::illumination illumination{};
    friend constexpr bool operator==(const report_illumination_state&, const report_illumination_state&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4513;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_illumination_state;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::illumination>>;
    };
};

/// Values of Headlights.
enum class report_illumination_configuration_headlights : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of LeftTurnSignal.
enum class report_illumination_configuration_left_turn_signal : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of RightTurnSignal.
enum class report_illumination_configuration_right_turn_signal : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of RunningLights.
enum class report_illumination_configuration_running_lights : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of BrakeLights.
enum class report_illumination_configuration_brake_lights : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of BackupLights.
enum class report_illumination_configuration_backup_lights : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of VisibleLightSource.
enum class report_illumination_configuration_visible_light_source : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of IRLightSource.
enum class report_illumination_configuration_ir_light_source : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of VariableLight1.
enum class variable_light1 : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of VariableLight2.
enum class variable_light2 : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of VariableLight3.
enum class variable_light3 : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of VariableLight4.
enum class variable_light4 : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of HighBeams.
enum class report_illumination_configuration_high_beams : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of ParkingLights.
enum class report_illumination_configuration_parking_lights : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of FogLights.
enum class report_illumination_configuration_fog_lights : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of HazardLights.
enum class report_illumination_configuration_hazard_lights : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Bits of types.
struct types {
    report_illumination_configuration_headlights headlights{};
    report_illumination_configuration_left_turn_signal left_turn_signal{};
    report_illumination_configuration_right_turn_signal right_turn_signal{};
    report_illumination_configuration_running_lights running_lights{};
    report_illumination_configuration_brake_lights brake_lights{};
    report_illumination_configuration_backup_lights backup_lights{};
    report_illumination_configuration_visible_light_source visible_light_source{};
    report_illumination_configuration_ir_light_source ir_light_source{};
    ugv::variable_light1 variable_light1{};
    ugv::variable_light2 variable_light2{};
    ugv::variable_light3 variable_light3{};
    ugv::variable_light4 variable_light4{};
    report_illumination_configuration_high_beams high_beams{};
    report_illumination_configuration_parking_lights parking_lights{};
    report_illumination_configuration_fog_lights fog_lights{};
    report_illumination_configuration_hazard_lights hazard_lights{};
    friend constexpr bool operator==(const types&, const types&) = default;

    struct schema : wire::items {
        using T = types;
        using type = layout<
            bit_fields<u32le,
                bit_field<&T::headlights, 1>,
                bit_field<&T::left_turn_signal, 1>,
                bit_field<&T::right_turn_signal, 1>,
                bit_field<&T::running_lights, 1>,
                bit_field<&T::brake_lights, 1>,
                bit_field<&T::backup_lights, 1>,
                bit_field<&T::visible_light_source, 1>,
                bit_field<&T::ir_light_source, 1>,
                bit_field<&T::variable_light1, 1>,
                bit_field<&T::variable_light2, 1>,
                bit_field<&T::variable_light3, 1>,
                bit_field<&T::variable_light4, 1>,
                bit_field<&T::high_beams, 1>,
                bit_field<&T::parking_lights, 1>,
                bit_field<&T::fog_lights, 1>,
                bit_field<&T::hazard_lights, 1>,
                reserved<16>>>;
    };
};

/// ReportIlluminationConfiguration: ID 4514h, output of IlluminationService.
struct report_illumination_configuration {
    ugv::types types{};
    friend constexpr bool operator==(
        const report_illumination_configuration&,
        const report_illumination_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4514;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_illumination_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::types>>;
    };
};

namespace services {

/// IlluminationService: what it is called, and its messages.
struct illumination_service {
    static constexpr std::string_view name = "IlluminationService";
    static constexpr std::string_view uri = "urn:jaus:jss:ugv:IlluminationService";
    static constexpr std::string_view version = "1.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        query_illumination_state,
        query_illumination_configuration,
        set_illumination_state>;
    using outputs = jaus::message_list<report_illumination_state, report_illumination_configuration>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::ugv
