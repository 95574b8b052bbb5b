// VideoIlluminator 2.0, urn:jaus:jss:environmentSensing:VideoIlluminator.
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
struct video_illuminator_request_id_rec {
    std::uint8_t request_id{};
    friend constexpr bool operator==(
        const video_illuminator_request_id_rec&,
        const video_illuminator_request_id_rec&) = default;

    struct schema : wire::items {
        using T = video_illuminator_request_id_rec;
        using type = layout<field<&T::request_id, u8>>;
    };
};

/// Values of Mode.
enum class mode : std::uint8_t {
    visible = 0,
    infrared = 1,
    greyscale = 2,
    lowlight = 3,
};

/// Record IlluminatorRec.
struct illuminator_rec {
    std::uint16_t illuminator_id{};
    double level{};                                  ///< percent, 0 to 100
    std::optional<environment_sensing::mode> mode{}; ///< 4 to 20, 21 to 31
    std::optional<double> beam_width{};              ///< degree, 0 to 360
    std::optional<double> beam_height{};             ///< degree, 0 to 360
    friend constexpr bool operator==(const illuminator_rec&, const illuminator_rec&) = default;

    struct schema : wire::items {
        using T = illuminator_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::illuminator_id, u16le>,
                field<&T::level, scaled<u16le, percent_0_to_100>>,
                field<&T::mode, in_value_set<enumeration<environment_sensing::mode, u8>, between<0, 31>>>,
                field<&T::beam_width, scaled<u16le, degree_0_to_360>>,
                field<&T::beam_height, scaled<u16le, degree_0_to_360>>>>;
    };
};

/// SetVideoIlluminatorConfiguration: ID 081Ah, command, input of VideoIlluminator.
struct set_video_illuminator_configuration {
    video_illuminator_request_id_rec request_id_rec{};
    wire::list<illuminator_rec> illuminator_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const set_video_illuminator_configuration&,
        const set_video_illuminator_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x081A;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_video_illuminator_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::request_id_rec>,
            repeated<&T::illuminator_list, count<"number_of_illuminator_list", u16le>>>;
    };
};

/// Record IlluminatorIDRec.
struct illuminator_id_rec {
    std::uint16_t illuminator_id{};
    friend constexpr bool operator==(const illuminator_id_rec&, const illuminator_id_rec&) = default;

    struct schema : wire::items {
        using T = illuminator_id_rec;
        using type = layout<field<&T::illuminator_id, u16le>>;
    };
};

/// QueryVideoIlluminatorConfiguration: ID 281Ah, input of VideoIlluminator.
struct query_video_illuminator_configuration {
    wire::list<illuminator_id_rec> illuminator_id_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const query_video_illuminator_configuration&,
        const query_video_illuminator_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x281A;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_video_illuminator_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::illuminator_id_list, count<"number_of_illuminator_id_list", u16le>>>;
    };
};

/// QueryVideoIlluminatorCapabilities: ID 281Bh, input of VideoIlluminator.
struct query_video_illuminator_capabilities {
    wire::list<illuminator_id_rec> illuminator_id_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const query_video_illuminator_capabilities&,
        const query_video_illuminator_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x281B;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_video_illuminator_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::illuminator_id_list, count<"number_of_illuminator_id_list", u16le>>>;
    };
};

/// ReportVideoIlluminatorConfiguration: ID 481Ah, output of VideoIlluminator.
struct report_video_illuminator_configuration {
    wire::list<illuminator_rec> illumination_rec_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_video_illuminator_configuration&,
        const report_video_illuminator_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x481A;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_video_illuminator_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::illumination_rec_list, count<"number_of_illumination_rec_list", u16le>>>;
    };
};

/// Values of Visible.
enum class visible : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of Infrared.
enum class video_illuminator_infrared : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of GreyScale.
enum class grey_scale : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Values of LowLight.
enum class low_light : std::uint8_t {
    not_supported = 0,
    supported = 1,
};

/// Bits of SupportedIlluminationModes.
struct supported_illumination_modes {
    environment_sensing::visible visible{};
    video_illuminator_infrared infrared{};
    environment_sensing::grey_scale grey_scale{};
    environment_sensing::low_light low_light{};
    std::uint32_t reserved_for_future_use{};                             ///< 0 to 1
    std::uint16_t reserved_for_program_or_implementation_specific_use{}; ///< 0 to 1
    friend constexpr bool operator==(
        const supported_illumination_modes&,
        const supported_illumination_modes&) = default;

    struct schema : wire::items {
        using T = supported_illumination_modes;
        using type = layout<
            bit_fields<u32le,
                bit_field<&T::visible, 1>,
                bit_field<&T::infrared, 1>,
                bit_field<&T::grey_scale, 1>,
                bit_field<&T::low_light, 1>,
                bit_field_in_set<&T::reserved_for_future_use, 17, between<0, 1>>,
                bit_field_in_set<&T::reserved_for_program_or_implementation_specific_use, 11, between<0, 1>>>>;
    };
};

/// Record IlluminatorCapabilitiesRec.
struct illuminator_capabilities_rec {
    std::uint16_t illuminator_id{};
    std::string_view illuminator_name{};                   ///< up to 255 characters
    environment_sensing::supported_illumination_modes supported_illumination_modes{};
    std::optional<std::uint16_t> minimum_intensity{};      ///< lumen
    std::optional<std::uint16_t> maximum_intensity{};      ///< lumen
    std::optional<double> minimum_supported_beam_width{};  ///< degree, 0 to 360
    std::optional<double> maximum_supported_beam_width{};  ///< degree, 0 to 360
    std::optional<double> minimum_supported_beam_height{}; ///< degree, 0 to 360
    std::optional<double> maximum_supported_beam_height{}; ///< degree, 0 to 360
    friend constexpr bool operator==(
        const illuminator_capabilities_rec&,
        const illuminator_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = illuminator_capabilities_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::illuminator_id, u16le>,
                string<&T::illuminator_name, count<"illuminator_name_size", u8>>,
                nested<&T::supported_illumination_modes>,
                field<&T::minimum_intensity, in_units<u16le, lumen>>,
                field<&T::maximum_intensity, in_units<u16le, lumen>>,
                field<&T::minimum_supported_beam_width, scaled<u16le, degree_0_to_360>>,
                field<&T::maximum_supported_beam_width, scaled<u16le, degree_0_to_360>>,
                field<&T::minimum_supported_beam_height, scaled<u16le, degree_0_to_360>>,
                field<&T::maximum_supported_beam_height, scaled<u16le, degree_0_to_360>>>>;
    };
};

/// Record SensorIDRec.
struct video_illuminator_sensor_id_rec {
    std::uint16_t sensor_id{};
    friend constexpr bool operator==(
        const video_illuminator_sensor_id_rec&,
        const video_illuminator_sensor_id_rec&) = default;

    struct schema : wire::items {
        using T = video_illuminator_sensor_id_rec;
        using type = layout<field<&T::sensor_id, u16le>>;
    };
};

/// Sequence IlluminatorCapabilitiesSeq.
struct illuminator_capabilities_seq {
    environment_sensing::illuminator_capabilities_rec illuminator_capabilities_rec{};
    wire::list<video_illuminator_sensor_id_rec> sensor_id_list{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const illuminator_capabilities_seq&,
        const illuminator_capabilities_seq&) = default;

    struct schema : wire::items {
        using T = illuminator_capabilities_seq;
        using type = layout<
            nested<&T::illuminator_capabilities_rec>,
            repeated<&T::sensor_id_list, count<"number_of_sensor_id_list", u8>>>;
    };
};

/// ReportVideoIlluminatorCapabilities: ID 481Bh, output of VideoIlluminator.
struct report_video_illuminator_capabilities {
    wire::list<illuminator_capabilities_seq> illuminator_capabilities_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_video_illuminator_capabilities&,
        const report_video_illuminator_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x481B;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_video_illuminator_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::illuminator_capabilities_list, count<"number_of_illuminator_capabilities_list", u16le>>>;
    };
};

namespace services {

/// VideoIlluminator: what it is called, and its messages.
struct video_illuminator {
    static constexpr std::string_view name = "VideoIlluminator";
    static constexpr std::string_view uri = "urn:jaus:jss:environmentSensing:VideoIlluminator";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_video_illuminator_configuration,
        query_video_illuminator_configuration,
        query_video_illuminator_capabilities>;
    using outputs = jaus::message_list<
        confirm_sensor_configuration,
        report_video_illuminator_configuration,
        report_video_illuminator_capabilities>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::environment_sensing
