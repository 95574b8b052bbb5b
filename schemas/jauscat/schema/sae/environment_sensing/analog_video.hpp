// AnalogVideo 2.0, urn:jaus:jss:environmentSensing:AnalogVideo.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/environment_sensing/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::environment_sensing {

/// Record RequestIdRec.
struct analog_video_request_id_rec {
    std::uint8_t request_id{};
    friend constexpr bool operator==(const analog_video_request_id_rec&, const analog_video_request_id_rec&) = default;

    struct schema : wire::items {
        using T = analog_video_request_id_rec;
        using type = layout<field<&T::request_id, u8>>;
    };
};

/// Values of AnalogFormat.
enum class analog_format : std::uint8_t {
    ntsc_m = 0,    ///< NTSC-M
    ntsc_j = 1,    ///< NTSC-J
    pal_n = 2,     ///< PAL-N
    pal_m = 3,     ///< PAL-M
    secam_l = 4,   ///< SECAM-L
    secam_b_g = 5, ///< SECAM-B/G
};

/// Record AnalogVideoSensorConfigurationRec.
struct analog_video_sensor_configuration_rec {
    std::uint16_t sensor_id{}; ///< 1 to 65535
    environment_sensing::analog_format analog_format{};
    friend constexpr bool operator==(
        const analog_video_sensor_configuration_rec&,
        const analog_video_sensor_configuration_rec&) = default;

    struct schema : wire::items {
        using T = analog_video_sensor_configuration_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::analog_format, in_value_set<enumeration<environment_sensing::analog_format, u8>, between<0, 5>>>>;
    };
};

/// SetAnalogVideoSensorConfiguration: ID 0806h, command, input of AnalogVideo.
struct set_analog_video_sensor_configuration {
    analog_video_request_id_rec request_id_rec{};
    wire::list<analog_video_sensor_configuration_rec> analog_video_sensor_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const set_analog_video_sensor_configuration&,
        const set_analog_video_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0806;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_analog_video_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::request_id_rec>,
            repeated<&T::analog_video_sensor_list, count<"number_of_analog_video_sensor_list", u16le>>>;
    };
};

/// QueryAnalogVideoSensorConfiguration: ID 2811h, input of AnalogVideo.
struct query_analog_video_sensor_configuration {
    wire::list<sensor_id_query_rec> sensor_id_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const query_analog_video_sensor_configuration&,
        const query_analog_video_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2811;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_analog_video_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::sensor_id_list, count<"number_of_sensor_id_list", u16le>>>;
    };
};

/// QueryAnalogVideoSensorCapabilities: ID 2810h, input of AnalogVideo.
struct query_analog_video_sensor_capabilities {
    wire::list<sensor_id_query_rec> sensor_id_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const query_analog_video_sensor_capabilities&,
        const query_analog_video_sensor_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2810;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_analog_video_sensor_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::sensor_id_list, count<"number_of_sensor_id_list", u16le>>>;
    };
};

/// ReportAnalogVideoSensorConfiguration: ID 4811h, output of AnalogVideo.
struct report_analog_video_sensor_configuration {
    /// up to 65535 elements
    wire::list<analog_video_sensor_configuration_rec> analog_video_sensor_configuration_list{};
    friend constexpr bool operator==(
        const report_analog_video_sensor_configuration&,
        const report_analog_video_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4811;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_analog_video_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::analog_video_sensor_configuration_list,
                count<"number_of_analog_video_sensor_configuration_list", u16le>>>;
    };
};

/// Values of NTSCM.
enum class ntscm : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of NTSCJ.
enum class ntscj : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of PALN.
enum class paln : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of PALM.
enum class palm : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of SECAML.
enum class secaml : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of SECAMBG.
enum class secambg : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Bits of SupportedAnalogFormats.
struct supported_analog_formats {
    environment_sensing::ntscm ntscm{};
    environment_sensing::ntscj ntscj{};
    environment_sensing::paln paln{};
    environment_sensing::palm palm{};
    environment_sensing::secaml secaml{};
    environment_sensing::secambg secambg{};
    friend constexpr bool operator==(const supported_analog_formats&, const supported_analog_formats&) = default;

    struct schema : wire::items {
        using T = supported_analog_formats;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::ntscm, 1>,
                bit_field<&T::ntscj, 1>,
                bit_field<&T::paln, 1>,
                bit_field<&T::palm, 1>,
                bit_field<&T::secaml, 1>,
                bit_field<&T::secambg, 1>,
                reserved<2>>>;
    };
};

/// Record AnalogVideoSensorCapabilitiesRec.
struct analog_video_sensor_capabilities_rec {
    std::uint16_t sensor_id{}; ///< 1 to 65535
    environment_sensing::supported_analog_formats supported_analog_formats{};
    friend constexpr bool operator==(
        const analog_video_sensor_capabilities_rec&,
        const analog_video_sensor_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = analog_video_sensor_capabilities_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            nested<&T::supported_analog_formats>>;
    };
};

/// ReportAnalogVideoSensorCapabilities: ID 4810h, output of AnalogVideo.
struct report_analog_video_sensor_capabilities {
    wire::list<analog_video_sensor_capabilities_rec> analog_video_sensor_capabilities_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_analog_video_sensor_capabilities&,
        const report_analog_video_sensor_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4810;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_analog_video_sensor_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::analog_video_sensor_capabilities_list,
                count<"number_of_analog_video_sensor_capabilities_list", u16le>>>;
    };
};

namespace services {

/// AnalogVideo: what it is called, and its messages.
struct analog_video {
    static constexpr std::string_view name = "AnalogVideo";
    static constexpr std::string_view uri = "urn:jaus:jss:environmentSensing:AnalogVideo";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:environmentSensing:VisualSensor";
    static constexpr std::string_view parent_version = "2.0";
    using inputs = jaus::message_list<
        set_analog_video_sensor_configuration,
        query_analog_video_sensor_configuration,
        query_analog_video_sensor_capabilities>;
    using outputs = jaus::message_list<
        report_analog_video_sensor_configuration,
        report_analog_video_sensor_capabilities>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::environment_sensing
