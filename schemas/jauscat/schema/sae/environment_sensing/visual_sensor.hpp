// VisualSensor 2.0, urn:jaus:jss:environmentSensing:VisualSensor.
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

/// Record QueryVisualSensorConfigurationRec.
struct query_visual_sensor_configuration_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    std::uint16_t query_presence_vector{};
    friend constexpr bool operator==(
        const query_visual_sensor_configuration_rec&,
        const query_visual_sensor_configuration_rec&) = default;

    struct schema : wire::items {
        using T = query_visual_sensor_configuration_rec;
        using type = layout<
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>,
            field<&T::query_presence_vector, u16le>>;
    };
};

/// QueryVisualSensorConfiguration: ID 2807h, input of VisualSensor.
struct query_visual_sensor_configuration {
    /// up to 65535 elements
    wire::list<query_visual_sensor_configuration_rec> query_visual_sensor_configuration_list{};
    friend constexpr bool operator==(
        const query_visual_sensor_configuration&,
        const query_visual_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2807;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_visual_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::query_visual_sensor_configuration_list,
                count<"number_of_query_visual_sensor_configuration_list", u16le>>>;
    };
};

/// Record QueryVisualSensorCapabilitiesRec.
struct query_visual_sensor_capabilities_query_visual_sensor_capabilities_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    std::uint16_t query_presence_vector{};
    friend constexpr bool operator==(
        const query_visual_sensor_capabilities_query_visual_sensor_capabilities_rec&,
        const query_visual_sensor_capabilities_query_visual_sensor_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = query_visual_sensor_capabilities_query_visual_sensor_capabilities_rec;
        using type = layout<
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>,
            field<&T::query_presence_vector, u16le>>;
    };
};

/// QueryVisualSensorCapabilities: ID 2806h, deprecated, input of VisualSensor.
struct query_visual_sensor_capabilities {
    /// up to 65535 elements
    wire::list<
        query_visual_sensor_capabilities_query_visual_sensor_capabilities_rec> query_visual_sensor_capabilities_list{};
    friend constexpr bool operator==(
        const query_visual_sensor_capabilities&,
        const query_visual_sensor_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2806;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = query_visual_sensor_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::query_visual_sensor_capabilities_list,
                count<"number_of_query_visual_sensor_capabilities_list", u16le>>>;
    };
};

/// Record QueryVisualSensorCapabilitiesRec.
struct query_visual_sensor_capabilities_ext_query_visual_sensor_capabilities_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    std::uint32_t query_presence_vector{};
    friend constexpr bool operator==(
        const query_visual_sensor_capabilities_ext_query_visual_sensor_capabilities_rec&,
        const query_visual_sensor_capabilities_ext_query_visual_sensor_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = query_visual_sensor_capabilities_ext_query_visual_sensor_capabilities_rec;
        using type = layout<
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>,
            field<&T::query_presence_vector, u32le>>;
    };
};

/// QueryVisualSensorCapabilitiesExt: ID 280Ah, input of VisualSensor.
struct query_visual_sensor_capabilities_ext {
    /// up to 65535 elements
    wire::list<query_visual_sensor_capabilities_ext_query_visual_sensor_capabilities_rec>
        query_visual_sensor_capabilities_list{};
    friend constexpr bool operator==(
        const query_visual_sensor_capabilities_ext&,
        const query_visual_sensor_capabilities_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x280A;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_visual_sensor_capabilities_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::query_visual_sensor_capabilities_list,
                count<"number_of_query_visual_sensor_capabilities_list", u16le>>>;
    };
};

/// Record RequestIdRec.
struct visual_sensor_request_id_rec {
    std::uint8_t request_id{};
    friend constexpr bool operator==(
        const visual_sensor_request_id_rec&,
        const visual_sensor_request_id_rec&) = default;

    struct schema : wire::items {
        using T = visual_sensor_request_id_rec;
        using type = layout<field<&T::request_id, u8>>;
    };
};

/// Values of ZoomMode.
enum class zoom_mode : std::uint8_t {
    mixed = 0,
    analog_only = 1,
    digital_only = 2,
    off = 3,
};

/// Values of FocusMode.
enum class focus_mode : std::uint8_t {
    auto_focus = 0,
    manual_focus = 1,
};

/// Values of WhiteBalance.
enum class set_visual_sensor_configuration_white_balance : std::uint8_t {
    auto_value = 0, ///< Auto
    daylight = 1,
    cloudy = 2,
    shade = 3,
    tungsten = 4,
    flurescent = 5,
    flash = 6,
};

/// Values of ImagingMode.
enum class imaging_mode : std::uint8_t {
    color = 0,
    greyscale = 1,
    infrared = 2,
    low_light = 3,
    thermal_white_hot = 4,
    thermal_black_hot = 5,
    thermal_rainbow = 6,
};

/// Values of ExposureMode.
enum class exposure_mode : std::uint8_t {
    auto_value = 0, ///< Auto
    manual = 1,
    shutter_priority = 2,
    aperture_priority = 3,
};

/// Values of MeteringMode.
enum class metering_mode : std::uint8_t {
    auto_value = 0, ///< Auto
    center_weighted = 1,
    spot = 2,
};

/// Values of LightSensitivity.
enum class light_sensitivity : std::uint8_t {
    auto_value = 0, ///< Auto
    iso_100 = 1,
    iso_200 = 2,
    iso_400 = 3,
    iso_800 = 4,
    iso_1600 = 5,
    iso_3200 = 6,
};

/// Values of ImageStabilization.
enum class set_visual_sensor_configuration_image_stabilization : std::uint8_t {
    off = 0,
    on = 1,
};

/// Record VisualSensorConfigurationRec.
struct visual_sensor_configuration_rec {
    std::uint16_t sensor_id{};                                       ///< 1 to 65535
    std::optional<environment_sensing::sensor_state> sensor_state{};
    std::optional<environment_sensing::zoom_mode> zoom_mode{};
    std::optional<double> zoom_level{};                              ///< percent, 0 to 100
    std::optional<double> focal_length{};                            ///< meter, 0 to 2
    std::optional<double> horizontal_field_of_view{};                ///< radian, -pi to pi
    std::optional<double> vertical_field_of_view{};                  ///< radian, -pi to pi
    std::optional<environment_sensing::focus_mode> focus_mode{};
    std::optional<double> focus_value{};                             ///< percent, 0 to 100
    std::optional<set_visual_sensor_configuration_white_balance> white_balance{};
    std::optional<environment_sensing::imaging_mode> imaging_mode{}; ///< 7 to 20, 21 to 31
    std::optional<environment_sensing::exposure_mode> exposure_mode{};
    std::optional<environment_sensing::metering_mode> metering_mode{};
    std::optional<double> shutter_speed{};                           ///< second, 0 to 60
    std::optional<double> aperture{};                                ///< 0.1 to 128
    std::optional<environment_sensing::light_sensitivity> light_sensitivity{};
    std::optional<set_visual_sensor_configuration_image_stabilization> image_stabilization{};
    friend constexpr bool operator==(
        const visual_sensor_configuration_rec&,
        const visual_sensor_configuration_rec&) = default;

    struct schema : wire::items {
        using T = visual_sensor_configuration_rec;
        using type = layout<
            lenient_presence<u16le,
                field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
                field<&T::sensor_state,
                    in_value_set<enumeration<environment_sensing::sensor_state, u8>, between<0, 2>>>,
                field<&T::zoom_mode, in_value_set<enumeration<environment_sensing::zoom_mode, u8>, between<0, 3>>>,
                field<&T::zoom_level, scaled<u16le, percent_0_to_100>>,
                field<&T::focal_length, scaled<u32le, meter_0_to_2>>,
                field<&T::horizontal_field_of_view, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::vertical_field_of_view, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::focus_mode, in_value_set<enumeration<environment_sensing::focus_mode, u8>, between<0, 1>>>,
                field<&T::focus_value, scaled<u16le, percent_0_to_100>>,
                field<&T::white_balance,
                    in_value_set<enumeration<set_visual_sensor_configuration_white_balance, u8>, between<0, 6>>>,
                field<&T::imaging_mode,
                    in_value_set<enumeration<environment_sensing::imaging_mode, u8>, between<0, 31>>>,
                field<&T::exposure_mode,
                    in_value_set<enumeration<environment_sensing::exposure_mode, u8>, between<0, 3>>>,
                field<&T::metering_mode,
                    in_value_set<enumeration<environment_sensing::metering_mode, u8>, between<0, 2>>>,
                field<&T::shutter_speed, scaled<u16le, second_0_to_60>>,
                field<&T::aperture, scaled<u16le, one_0_1_to_128>>,
                field<&T::light_sensitivity,
                    in_value_set<enumeration<environment_sensing::light_sensitivity, u8>, between<0, 6>>>,
                field<&T::image_stabilization,
                    in_value_set<enumeration<set_visual_sensor_configuration_image_stabilization, u8>,
                        between<0, 1>>>>>;
    };
};

/// SetVisualSensorConfiguration: ID 0803h, command, input of VisualSensor.
struct set_visual_sensor_configuration {
    visual_sensor_request_id_rec request_id_rec{};
    wire::list<visual_sensor_configuration_rec> visual_sensor_configuration_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const set_visual_sensor_configuration&,
        const set_visual_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0803;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_visual_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::request_id_rec>,
            repeated<&T::visual_sensor_configuration_list, count<"number_of_visual_sensor_configuration_list", u16le>>>;
    };
};

/// ReportVisualSensorConfiguration: ID 4807h, output of VisualSensor.
struct report_visual_sensor_configuration {
    wire::list<visual_sensor_configuration_rec> visual_sensor_configuration_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_visual_sensor_configuration&,
        const report_visual_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4807;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_visual_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::visual_sensor_configuration_list, count<"number_of_visual_sensor_configuration_list", u16le>>>;
    };
};

/// Values of Mixed.
enum class mixed : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of AnalogOnly.
enum class analog_only : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of DigitalOnly.
enum class digital_only : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of None.
enum class none : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Bits of ZoomModes.
struct zoom_modes {
    environment_sensing::mixed mixed{};
    environment_sensing::analog_only analog_only{};
    environment_sensing::digital_only digital_only{};
    environment_sensing::none none{};
    friend constexpr bool operator==(const zoom_modes&, const zoom_modes&) = default;

    struct schema : wire::items {
        using T = zoom_modes;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::mixed, 1>,
                bit_field<&T::analog_only, 1>,
                bit_field<&T::digital_only, 1>,
                bit_field<&T::none, 1>,
                reserved<4>>>;
    };
};

/// Values of AutoFocus.
enum class auto_focus : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of ManualFocus.
enum class manual_focus : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Bits of FocusModes.
struct focus_modes {
    environment_sensing::auto_focus auto_focus{};
    environment_sensing::manual_focus manual_focus{};
    friend constexpr bool operator==(const focus_modes&, const focus_modes&) = default;

    struct schema : wire::items {
        using T = focus_modes;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::auto_focus, 1>,
                bit_field<&T::manual_focus, 1>,
                reserved<6>>>;
    };
};

/// Values of Auto.
enum class auto_type : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of Daylight.
enum class daylight : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of Cloudy.
enum class cloudy : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of Shade.
enum class shade : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of Tungsten.
enum class tungsten : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of Flurescent.
enum class flurescent : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of Flash.
enum class flash : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Bits of WhiteBalance.
struct report_visual_sensor_capabilities_white_balance {
    auto_type auto_{};
    environment_sensing::daylight daylight{};
    environment_sensing::cloudy cloudy{};
    environment_sensing::shade shade{};
    environment_sensing::tungsten tungsten{};
    environment_sensing::flurescent flurescent{};
    environment_sensing::flash flash{};
    friend constexpr bool operator==(
        const report_visual_sensor_capabilities_white_balance&,
        const report_visual_sensor_capabilities_white_balance&) = default;

    struct schema : wire::items {
        using T = report_visual_sensor_capabilities_white_balance;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::auto_, 1>,
                bit_field<&T::daylight, 1>,
                bit_field<&T::cloudy, 1>,
                bit_field<&T::shade, 1>,
                bit_field<&T::tungsten, 1>,
                bit_field<&T::flurescent, 1>,
                bit_field<&T::flash, 1>,
                reserved<1>>>;
    };
};

/// Values of Color.
enum class color : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of Greyscale.
enum class greyscale : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of Infrared.
enum class visual_sensor_infrared : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of Lowlight.
enum class lowlight : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of ThermalWhiteHot.
enum class thermal_white_hot : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of ThermalBlackHot.
enum class thermal_black_hot : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of ThermalRainbow.
enum class thermal_rainbow : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of ReservedForFutureUse.
enum class report_visual_sensor_capabilities_reserved_for_future_use : std::uint8_t {
    reserved = 0,
};

/// Bits of ImagingModes.
struct report_visual_sensor_capabilities_imaging_modes {
    environment_sensing::color color{};
    environment_sensing::greyscale greyscale{};
    visual_sensor_infrared infrared{};
    environment_sensing::lowlight lowlight{};
    environment_sensing::thermal_white_hot thermal_white_hot{};
    environment_sensing::thermal_black_hot thermal_black_hot{};
    environment_sensing::thermal_rainbow thermal_rainbow{};
    report_visual_sensor_capabilities_reserved_for_future_use reserved_for_future_use{};
    friend constexpr bool operator==(
        const report_visual_sensor_capabilities_imaging_modes&,
        const report_visual_sensor_capabilities_imaging_modes&) = default;

    struct schema : wire::items {
        using T = report_visual_sensor_capabilities_imaging_modes;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::color, 1>,
                bit_field<&T::greyscale, 1>,
                bit_field<&T::infrared, 1>,
                bit_field<&T::lowlight, 1>,
                bit_field<&T::thermal_white_hot, 1>,
                bit_field<&T::thermal_black_hot, 1>,
                bit_field<&T::thermal_rainbow, 1>,
                bit_field_in_set<&T::reserved_for_future_use, 1, one_of<0>>>>;
    };
};

/// Values of Manual.
enum class manual : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of ShutterPriority.
enum class shutter_priority : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of AperturePriority.
enum class aperture_priority : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Bits of ExposureModes.
struct exposure_modes {
    auto_type auto_{};
    environment_sensing::manual manual{};
    environment_sensing::shutter_priority shutter_priority{};
    environment_sensing::aperture_priority aperture_priority{};
    friend constexpr bool operator==(const exposure_modes&, const exposure_modes&) = default;

    struct schema : wire::items {
        using T = exposure_modes;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::auto_, 1>,
                bit_field<&T::manual, 1>,
                bit_field<&T::shutter_priority, 1>,
                bit_field<&T::aperture_priority, 1>,
                reserved<4>>>;
    };
};

/// Values of MatrixOrAuto.
enum class matrix_or_auto : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of CenterWeighted.
enum class center_weighted : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of Spot.
enum class spot : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Bits of MeteringModes.
struct metering_modes {
    environment_sensing::matrix_or_auto matrix_or_auto{};
    environment_sensing::center_weighted center_weighted{};
    environment_sensing::spot spot{};
    friend constexpr bool operator==(const metering_modes&, const metering_modes&) = default;

    struct schema : wire::items {
        using T = metering_modes;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::matrix_or_auto, 1>,
                bit_field<&T::center_weighted, 1>,
                bit_field<&T::spot, 1>,
                reserved<5>>>;
    };
};

/// Values of ISO100.
enum class iso100 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of ISO200.
enum class iso200 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of ISO400.
enum class iso400 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of ISO800.
enum class iso800 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of ISO1600.
enum class iso1600 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of ISO3200.
enum class iso3200 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Bits of LightSensitivityLevels.
struct light_sensitivity_levels {
    auto_type auto_{};
    environment_sensing::iso100 iso100{};
    environment_sensing::iso200 iso200{};
    environment_sensing::iso400 iso400{};
    environment_sensing::iso800 iso800{};
    environment_sensing::iso1600 iso1600{};
    environment_sensing::iso3200 iso3200{};
    friend constexpr bool operator==(const light_sensitivity_levels&, const light_sensitivity_levels&) = default;

    struct schema : wire::items {
        using T = light_sensitivity_levels;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::auto_, 1>,
                bit_field<&T::iso100, 1>,
                bit_field<&T::iso200, 1>,
                bit_field<&T::iso400, 1>,
                bit_field<&T::iso800, 1>,
                bit_field<&T::iso1600, 1>,
                bit_field<&T::iso3200, 1>,
                reserved<1>>>;
    };
};

/// Values of ImageStabilization.
enum class report_visual_sensor_capabilities_image_stabilization : std::uint8_t {
    false_value = 0, ///< False
    true_value = 1,  ///< True
};

/// Record VisualSensorCapabilitiesRec.
struct report_visual_sensor_capabilities_visual_sensor_capabilities_rec {
    std::uint16_t sensor_id{};                     ///< 1 to 65535
    std::string_view sensor_name{};                ///< up to 255 characters
    std::optional<environment_sensing::supported_states> supported_states{};
    std::optional<environment_sensing::zoom_modes> zoom_modes{};
    std::optional<environment_sensing::focus_modes> focus_modes{};
    std::optional<report_visual_sensor_capabilities_white_balance> white_balance{};
    std::optional<report_visual_sensor_capabilities_imaging_modes> imaging_modes{};
    std::optional<environment_sensing::exposure_modes> exposure_modes{};
    std::optional<environment_sensing::metering_modes> metering_modes{};
    std::optional<double> minimum_shutter_speed{}; ///< second, 0 to 60
    std::optional<double> maximum_shutter_speed{}; ///< second, 0 to 60
    std::optional<double> minimum_aperture{};      ///< 0.1 to 128
    std::optional<double> maximum_aperture{};      ///< 0.1 to 128
    std::optional<double> minimum_focal_length{};  ///< meter, 0 to 2
    std::optional<double> maximum_focal_length{};  ///< meter, 0 to 2
    std::optional<environment_sensing::light_sensitivity_levels> light_sensitivity_levels{};
    std::optional<report_visual_sensor_capabilities_image_stabilization> image_stabilization{};
    friend constexpr bool operator==(
        const report_visual_sensor_capabilities_visual_sensor_capabilities_rec&,
        const report_visual_sensor_capabilities_visual_sensor_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = report_visual_sensor_capabilities_visual_sensor_capabilities_rec;
        using type = layout<
            lenient_presence<u16le,
                field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
                string<&T::sensor_name, count<"sensor_name_size", u8>>,
                nested<&T::supported_states>,
                nested<&T::zoom_modes>,
                nested<&T::focus_modes>,
                nested<&T::white_balance>,
                nested<&T::imaging_modes>,
                nested<&T::exposure_modes>,
                nested<&T::metering_modes>,
                field<&T::minimum_shutter_speed, scaled<u16le, second_0_to_60>>,
                field<&T::maximum_shutter_speed, scaled<u16le, second_0_to_60>>,
                field<&T::minimum_aperture, scaled<u16le, one_0_1_to_128>>,
                field<&T::maximum_aperture, scaled<u16le, one_0_1_to_128>>,
                field<&T::minimum_focal_length, scaled<u32le, meter_0_to_2>>,
                field<&T::maximum_focal_length, scaled<u32le, meter_0_to_2>>,
                nested<&T::light_sensitivity_levels>,
                field<&T::image_stabilization,
                    in_value_set<enumeration<report_visual_sensor_capabilities_image_stabilization, u8>,
                        between<0, 1>>>>>;
    };
};

/// ReportVisualSensorCapabilities: ID 4806h, deprecated, output of VisualSensor.
struct report_visual_sensor_capabilities {
    /// up to 65535 elements
    wire::list<report_visual_sensor_capabilities_visual_sensor_capabilities_rec> visual_sensor_capabilities_list{};
    friend constexpr bool operator==(
        const report_visual_sensor_capabilities&,
        const report_visual_sensor_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4806;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = report_visual_sensor_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::visual_sensor_capabilities_list, count<"number_of_visual_sensor_capabilities_list", u16le>>>;
    };
};

/// Bits of WhiteBalance.
struct report_visual_sensor_capabilities_ext_white_balance {
    auto_type auto_{};
    environment_sensing::daylight daylight{};
    environment_sensing::cloudy cloudy{};
    environment_sensing::shade shade{};
    environment_sensing::tungsten tungsten{};
    environment_sensing::flurescent flurescent{};
    environment_sensing::flash flash{};
    friend constexpr bool operator==(
        const report_visual_sensor_capabilities_ext_white_balance&,
        const report_visual_sensor_capabilities_ext_white_balance&) = default;

    struct schema : wire::items {
        using T = report_visual_sensor_capabilities_ext_white_balance;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::auto_, 1>,
                bit_field<&T::daylight, 1>,
                bit_field<&T::cloudy, 1>,
                bit_field<&T::shade, 1>,
                bit_field<&T::tungsten, 1>,
                bit_field<&T::flurescent, 1>,
                bit_field<&T::flash, 1>,
                reserved<1>>>;
    };
};

/// Values of ReservedForFutureUse.
enum class report_visual_sensor_capabilities_ext_reserved_for_future_use : std::uint16_t {
    reserved = 0,
};

/// Values of ReservedForProgramSpecificUse.
enum class reserved_for_program_specific_use : std::uint16_t {
    reserved = 0,
};

/// Bits of ImagingModes.
struct report_visual_sensor_capabilities_ext_imaging_modes {
    environment_sensing::color color{};
    environment_sensing::greyscale greyscale{};
    visual_sensor_infrared infrared{};
    environment_sensing::lowlight lowlight{};
    environment_sensing::thermal_white_hot thermal_white_hot{};
    environment_sensing::thermal_black_hot thermal_black_hot{};
    environment_sensing::thermal_rainbow thermal_rainbow{};
    report_visual_sensor_capabilities_ext_reserved_for_future_use reserved_for_future_use{};
    environment_sensing::reserved_for_program_specific_use reserved_for_program_specific_use{};
    friend constexpr bool operator==(
        const report_visual_sensor_capabilities_ext_imaging_modes&,
        const report_visual_sensor_capabilities_ext_imaging_modes&) = default;

    struct schema : wire::items {
        using T = report_visual_sensor_capabilities_ext_imaging_modes;
        using type = layout<
            bit_fields<u32le,
                bit_field<&T::color, 1>,
                bit_field<&T::greyscale, 1>,
                bit_field<&T::infrared, 1>,
                bit_field<&T::lowlight, 1>,
                bit_field<&T::thermal_white_hot, 1>,
                bit_field<&T::thermal_black_hot, 1>,
                bit_field<&T::thermal_rainbow, 1>,
                bit_field_in_set<&T::reserved_for_future_use, 14, one_of<0>>,
                bit_field_in_set<&T::reserved_for_program_specific_use, 11, one_of<0>>>>;
    };
};

/// Values of ImageStabilization.
enum class report_visual_sensor_capabilities_ext_image_stabilization : std::uint8_t {
    false_value = 0, ///< False
    true_value = 1,  ///< True
};

/// Record VisualSensorCapabilitiesRec.
struct report_visual_sensor_capabilities_ext_visual_sensor_capabilities_rec {
    std::uint16_t sensor_id{};                                ///< 1 to 65535
    std::string_view sensor_name{};                           ///< up to 255 characters
    std::optional<environment_sensing::supported_states> supported_states{};
    std::optional<environment_sensing::zoom_modes> zoom_modes{};
    std::optional<environment_sensing::focus_modes> focus_modes{};
    std::optional<report_visual_sensor_capabilities_ext_white_balance> white_balance{};
    std::optional<report_visual_sensor_capabilities_ext_imaging_modes> imaging_modes{};
    std::optional<environment_sensing::exposure_modes> exposure_modes{};
    std::optional<environment_sensing::metering_modes> metering_modes{};
    std::optional<double> minimum_shutter_speed{};            ///< second, 0 to 60
    std::optional<double> maximum_shutter_speed{};            ///< second, 0 to 60
    std::optional<double> minimum_aperture{};                 ///< 0.1 to 128
    std::optional<double> maximum_aperture{};                 ///< 0.1 to 128
    std::optional<double> minimum_focal_length{};             ///< meter, 0 to 2
    std::optional<double> maximum_focal_length{};             ///< meter, 0 to 2
    std::optional<environment_sensing::light_sensitivity_levels> light_sensitivity_levels{};
    std::optional<report_visual_sensor_capabilities_ext_image_stabilization> image_stabilization{};
    std::optional<double> minimum_horizontal_field_of_view{}; ///< radian, -pi to pi
    std::optional<double> maximum_horizontal_field_of_view{}; ///< radian, -pi to pi
    std::optional<double> minimum_vertical_field_of_view{};   ///< radian, -pi to pi
    std::optional<double> maximum_vertical_field_of_view{};   ///< radian, -pi to pi
    friend constexpr bool operator==(
        const report_visual_sensor_capabilities_ext_visual_sensor_capabilities_rec&,
        const report_visual_sensor_capabilities_ext_visual_sensor_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = report_visual_sensor_capabilities_ext_visual_sensor_capabilities_rec;
        using type = layout<
            lenient_presence<u32le,
                field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
                string<&T::sensor_name, count<"sensor_name_size", u8>>,
                nested<&T::supported_states>,
                nested<&T::zoom_modes>,
                nested<&T::focus_modes>,
                nested<&T::white_balance>,
                nested<&T::imaging_modes>,
                nested<&T::exposure_modes>,
                nested<&T::metering_modes>,
                field<&T::minimum_shutter_speed, scaled<u16le, second_0_to_60>>,
                field<&T::maximum_shutter_speed, scaled<u16le, second_0_to_60>>,
                field<&T::minimum_aperture, scaled<u16le, one_0_1_to_128>>,
                field<&T::maximum_aperture, scaled<u16le, one_0_1_to_128>>,
                field<&T::minimum_focal_length, scaled<u32le, meter_0_to_2>>,
                field<&T::maximum_focal_length, scaled<u32le, meter_0_to_2>>,
                nested<&T::light_sensitivity_levels>,
                field<&T::image_stabilization,
                    in_value_set<enumeration<report_visual_sensor_capabilities_ext_image_stabilization, u8>,
                        between<0, 1>>>,
                field<&T::minimum_horizontal_field_of_view, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::maximum_horizontal_field_of_view, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::minimum_vertical_field_of_view, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::maximum_vertical_field_of_view, scaled<u32le, radian_minus_pi_to_pi>>>>;
    };
};

/// ReportVisualSensorCapabilitiesExt: ID 480Ah, output of VisualSensor.
struct report_visual_sensor_capabilities_ext {
    /// up to 65535 elements
    wire::list<report_visual_sensor_capabilities_ext_visual_sensor_capabilities_rec> visual_sensor_capabilities_list{};
    friend constexpr bool operator==(
        const report_visual_sensor_capabilities_ext&,
        const report_visual_sensor_capabilities_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x480A;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_visual_sensor_capabilities_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::visual_sensor_capabilities_list, count<"number_of_visual_sensor_capabilities_list", u16le>>>;
    };
};

namespace services {

/// VisualSensor: what it is called, and its messages.
struct visual_sensor {
    static constexpr std::string_view name = "VisualSensor";
    static constexpr std::string_view uri = "urn:jaus:jss:environmentSensing:VisualSensor";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        query_sensor_geometric_properties,
        query_visual_sensor_configuration,
        query_visual_sensor_capabilities,
        query_visual_sensor_capabilities_ext,
        set_visual_sensor_configuration>;
    using outputs = jaus::message_list<
        confirm_sensor_configuration,
        report_sensor_geometric_properties,
        report_visual_sensor_configuration,
        report_visual_sensor_capabilities,
        report_visual_sensor_capabilities_ext>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::environment_sensing
