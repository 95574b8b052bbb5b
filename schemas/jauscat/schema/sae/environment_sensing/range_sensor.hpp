// RangeSensor 2.0, urn:jaus:jss:environmentSensing:RangeSensor.
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
struct range_sensor_request_id_rec {
    std::uint8_t request_id{};
    friend constexpr bool operator==(const range_sensor_request_id_rec&, const range_sensor_request_id_rec&) = default;

    struct schema : wire::items {
        using T = range_sensor_request_id_rec;
        using type = layout<field<&T::request_id, u8>>;
    };
};

/// Record RangeSensorConfigurationRec.
struct range_sensor_configuration_rec {
    std::uint16_t sensor_id{};                                    ///< 1 to 65535
    std::optional<double> horizontal_field_of_view_start_angle{}; ///< radian, -pi to pi
    std::optional<double> horizontal_field_of_view_stop_angle{};  ///< radian, -pi to pi
    std::optional<double> vertical_field_of_view_start_angle{};   ///< radian, -pi to pi
    std::optional<double> vertical_field_of_view_stop_angle{};    ///< radian, -pi to pi
    std::optional<double> update_rate{};                          ///< hertz, 0 to 1000
    std::optional<double> minimum_range{};                        ///< meter, 0 to 1000000
    std::optional<double> maximum_range{};                        ///< meter, 0 to 1000000
    std::optional<environment_sensing::sensor_state> sensor_state{};
    friend constexpr bool operator==(
        const range_sensor_configuration_rec&,
        const range_sensor_configuration_rec&) = default;

    struct schema : wire::items {
        using T = range_sensor_configuration_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
                field<&T::horizontal_field_of_view_start_angle, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::horizontal_field_of_view_stop_angle, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::vertical_field_of_view_start_angle, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::vertical_field_of_view_stop_angle, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::update_rate, scaled<u16le, hertz_0_to_1000>>,
                field<&T::minimum_range, scaled<u32le, meter_0_to_1000000>>,
                field<&T::maximum_range, scaled<u32le, meter_0_to_1000000>>,
                field<&T::sensor_state,
                    in_value_set<enumeration<environment_sensing::sensor_state, u8>, between<0, 2>>>>>;
    };
};

/// SetRangeSensorConfiguration: ID 0802h, command, input of RangeSensor.
struct set_range_sensor_configuration {
    range_sensor_request_id_rec request_id_rec{};
    wire::list<range_sensor_configuration_rec> range_sensor_configuration_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const set_range_sensor_configuration&,
        const set_range_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0802;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_range_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::request_id_rec>,
            repeated<&T::range_sensor_configuration_list, count<"number_of_range_sensor_configuration_list", u16le>>>;
    };
};

/// Values of DataCompression.
enum class data_compression : std::uint8_t {
    none = 0,
    deflate = 1,
    bzip2 = 2,
    lzma = 3,
};

/// Record QueryRangeSensorCompressedDataRec.
struct query_range_sensor_compressed_data_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    environment_sensing::report_coordinate_system report_coordinate_system{};
    environment_sensing::data_compression data_compression{};
    std::uint16_t query_presence_vector{};
    friend constexpr bool operator==(
        const query_range_sensor_compressed_data_rec&,
        const query_range_sensor_compressed_data_rec&) = default;

    struct schema : wire::items {
        using T = query_range_sensor_compressed_data_rec;
        using type = layout<
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>,
            field<&T::report_coordinate_system,
                in_value_set<enumeration<environment_sensing::report_coordinate_system, u8>, between<0, 1>>>,
            field<&T::data_compression,
                in_value_set<enumeration<environment_sensing::data_compression, u8>, between<0, 3>>>,
            field<&T::query_presence_vector, u16le>>;
    };
};

/// QueryRangeSensorCompressedData: ID 2804h, input of RangeSensor.
struct query_range_sensor_compressed_data {
    /// up to 65535 elements
    wire::list<query_range_sensor_compressed_data_rec> query_range_sensor_compressed_data_list{};
    friend constexpr bool operator==(
        const query_range_sensor_compressed_data&,
        const query_range_sensor_compressed_data&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2804;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_range_sensor_compressed_data;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::query_range_sensor_compressed_data_list,
                count<"number_of_query_range_sensor_compressed_data_list", u16le>>>;
    };
};

/// Record QueryRangeSensorDataRec.
struct query_range_sensor_data_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    environment_sensing::report_coordinate_system report_coordinate_system{};
    std::uint16_t query_presence_vector{};
    friend constexpr bool operator==(const query_range_sensor_data_rec&, const query_range_sensor_data_rec&) = default;

    struct schema : wire::items {
        using T = query_range_sensor_data_rec;
        using type = layout<
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>,
            field<&T::report_coordinate_system,
                in_value_set<enumeration<environment_sensing::report_coordinate_system, u8>, between<0, 1>>>,
            field<&T::query_presence_vector, u16le>>;
    };
};

/// QueryRangeSensorData: ID 2803h, input of RangeSensor.
struct query_range_sensor_data {
    wire::list<query_range_sensor_data_rec> query_range_sensor_data_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(const query_range_sensor_data&, const query_range_sensor_data&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2803;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_range_sensor_data;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::query_range_sensor_data_list, count<"number_of_query_range_sensor_data_list", u16le>>>;
    };
};

/// Record QueryRangeSensorCapabilitiesRec.
struct query_range_sensor_capabilities_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    std::uint16_t query_presence_vector{};
    friend constexpr bool operator==(
        const query_range_sensor_capabilities_rec&,
        const query_range_sensor_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = query_range_sensor_capabilities_rec;
        using type = layout<
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>,
            field<&T::query_presence_vector, u16le>>;
    };
};

/// QueryRangeSensorCapabilities: ID 2801h, input of RangeSensor.
struct query_range_sensor_capabilities {
    wire::list<query_range_sensor_capabilities_rec> range_sensor_capabilities_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const query_range_sensor_capabilities&,
        const query_range_sensor_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2801;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_range_sensor_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::range_sensor_capabilities_list, count<"number_of_range_sensor_capabilities_list", u16le>>>;
    };
};

/// Record QueryRangeSensorConfigurationRec.
struct query_range_sensor_configuration_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    std::uint16_t query_presence_vector{};
    friend constexpr bool operator==(
        const query_range_sensor_configuration_rec&,
        const query_range_sensor_configuration_rec&) = default;

    struct schema : wire::items {
        using T = query_range_sensor_configuration_rec;
        using type = layout<
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>,
            field<&T::query_presence_vector, u16le>>;
    };
};

/// QueryRangeSensorConfiguration: ID 2802h, input of RangeSensor.
struct query_range_sensor_configuration {
    wire::list<query_range_sensor_configuration_rec> range_sensor_configuration_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const query_range_sensor_configuration&,
        const query_range_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2802;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_range_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::range_sensor_configuration_list, count<"number_of_range_sensor_configuration_list", u16le>>>;
    };
};

/// Values of NoCompression.
enum class no_compression : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of DEFLATE.
enum class deflate : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of bzip2.
enum class bzip2 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of LZMA.
enum class lzma : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Bits of SupportedCompression.
struct supported_compression {
    environment_sensing::no_compression no_compression{};
    environment_sensing::deflate deflate{};
    environment_sensing::bzip2 bzip2{};
    environment_sensing::lzma lzma{};
    friend constexpr bool operator==(const supported_compression&, const supported_compression&) = default;

    struct schema : wire::items {
        using T = supported_compression;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::no_compression, 1>,
                bit_field<&T::deflate, 1>,
                bit_field<&T::bzip2, 1>,
                bit_field<&T::lzma, 1>,
                reserved<4>>>;
    };
};

/// Values of CoordinateTransformationSupported.
enum class coordinate_transformation_supported : std::uint8_t {
    false_value = 0, ///< False
    true_value = 1,  ///< True
};

/// Record RangeSensorCapabilitiesRec.
struct range_sensor_capabilities_rec {
    std::uint16_t sensor_id{};                                            ///< 1 to 65535
    std::string_view sensor_name{};                                       ///< up to 255 characters
    std::optional<environment_sensing::supported_states> supported_states{};
    std::optional<double> minimum_horizontal_field_of_view_start_angle{}; ///< radian, -pi to pi
    std::optional<double> maximum_horizontal_field_of_view_stop_angle{};  ///< radian, -pi to pi
    std::optional<double> minimum_vertical_field_of_view_start_angle{};   ///< radian, -pi to pi
    std::optional<double> maximum_vertical_field_of_view_stop_angle{};    ///< radian, -pi to pi
    std::optional<double> miniumum_update_rate{};                         ///< hertz, 0 to 1000
    std::optional<double> maximum_update_rate{};                          ///< hertz, 0 to 1000
    std::optional<double> minimum_range{};                                ///< meter, 0 to 1000000
    std::optional<double> maximum_range{};                                ///< meter, 0 to 1000000
    std::optional<environment_sensing::supported_compression> supported_compression{};
    std::optional<environment_sensing::coordinate_transformation_supported> coordinate_transformation_supported{};
    friend constexpr bool operator==(
        const range_sensor_capabilities_rec&,
        const range_sensor_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = range_sensor_capabilities_rec;
        using type = layout<
            lenient_presence<u16le,
                field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
                string<&T::sensor_name, count<"sensor_name_size", u8>>,
                nested<&T::supported_states>,
                field<&T::minimum_horizontal_field_of_view_start_angle, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::maximum_horizontal_field_of_view_stop_angle, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::minimum_vertical_field_of_view_start_angle, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::maximum_vertical_field_of_view_stop_angle, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::miniumum_update_rate, scaled<u16le, hertz_0_to_1000>>,
                field<&T::maximum_update_rate, scaled<u16le, hertz_0_to_1000>>,
                field<&T::minimum_range, scaled<u32le, meter_0_to_1000000>>,
                field<&T::maximum_range, scaled<u32le, meter_0_to_1000000>>,
                nested<&T::supported_compression>,
                field<&T::coordinate_transformation_supported,
                    in_value_set<enumeration<environment_sensing::coordinate_transformation_supported, u8>,
                        between<0, 1>>>>>;
    };
};

/// ReportRangeSensorCapabilities: ID 4801h, output of RangeSensor.
struct report_range_sensor_capabilities {
    wire::list<range_sensor_capabilities_rec> range_sensor_capabilities_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_range_sensor_capabilities&,
        const report_range_sensor_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4801;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_range_sensor_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::range_sensor_capabilities_list, count<"number_of_range_sensor_capabilities_list", u16le>>>;
    };
};

/// ReportRangeSensorConfiguration: ID 4802h, output of RangeSensor.
struct report_range_sensor_configuration {
    wire::list<range_sensor_configuration_rec> range_sensor_configuration_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_range_sensor_configuration&,
        const report_range_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4802;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_range_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::range_sensor_configuration_list, count<"number_of_range_sensor_configuration_list", u16le>>>;
    };
};

/// Values of DataErrorCode.
enum class data_error_code : std::uint8_t {
    sensor_is_not_active = 0,
    invalid_compression_format = 1,
    unknown_error_failure = 255, ///< Unknown Error / Failure
};

/// Record RangeSensorDataErrorRec.
struct range_sensor_data_error_rec {
    std::uint16_t sensor_id{};        ///< 1 to 65535
    environment_sensing::data_error_code data_error_code{};
    std::string_view error_message{}; ///< up to 255 characters
    friend constexpr bool operator==(const range_sensor_data_error_rec&, const range_sensor_data_error_rec&) = default;

    struct schema : wire::items {
        using T = range_sensor_data_error_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::data_error_code,
                in_value_set<enumeration<environment_sensing::data_error_code, u8>, between<0, 1>, one_of<255>>>,
            string<&T::error_message, count<"error_message_size", u8>>>;
    };
};

/// Record RangeSensorDataRec.
struct range_sensor_data_rec {
    std::uint16_t sensor_id{}; ///< 1 to 65535
    environment_sensing::report_coordinate_system report_coordinate_system{};
    environment_sensing::time_stamp time_stamp{};
    friend constexpr bool operator==(const range_sensor_data_rec&, const range_sensor_data_rec&) = default;

    struct schema : wire::items {
        using T = range_sensor_data_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::report_coordinate_system,
                in_value_set<enumeration<environment_sensing::report_coordinate_system, u8>, between<0, 1>>>,
            nested<&T::time_stamp>>;
    };
};

/// Values of RangeValidity.
enum class range_validity : std::uint8_t {
    false_value = 0, ///< False
    true_value = 1,  ///< True
};

/// Values of BearingValidity.
enum class bearing_validity : std::uint8_t {
    false_value = 0, ///< False
    true_value = 1,  ///< True
};

/// Values of InclinationValidity.
enum class inclination_validity : std::uint8_t {
    false_value = 0, ///< False
    true_value = 1,  ///< True
};

/// Record RangeSensorDataPointRec.
struct range_sensor_data_point_rec {
    std::optional<std::uint32_t> point_id{};
    double range{};                                ///< meter, 0 to 1000000
    std::optional<environment_sensing::range_validity> range_validity{};
    std::optional<double> range_error_rms{};       ///< meter, 0 to 100000
    double bearing{};                              ///< radian, -pi to pi
    std::optional<environment_sensing::bearing_validity> bearing_validity{};
    std::optional<double> bearing_error_rms{};     ///< radian, 0 to pi
    double inclination{};                          ///< radian, -pi to pi
    std::optional<environment_sensing::inclination_validity> inclination_validity{};
    std::optional<double> inclination_error_rms{}; ///< radian, 0 to pi
    friend constexpr bool operator==(const range_sensor_data_point_rec&, const range_sensor_data_point_rec&) = default;

    struct schema : wire::items {
        using T = range_sensor_data_point_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::point_id, u32le>,
                field<&T::range, scaled<u32le, meter_0_to_1000000>>,
                field<&T::range_validity,
                    in_value_set<enumeration<environment_sensing::range_validity, u8>, between<0, 1>>>,
                field<&T::range_error_rms, scaled<u32le, meter_0_to_100000>>,
                field<&T::bearing, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::bearing_validity,
                    in_value_set<enumeration<environment_sensing::bearing_validity, u8>, between<0, 1>>>,
                field<&T::bearing_error_rms, scaled<u32le, radian_0_to_pi>>,
                field<&T::inclination, scaled<u32le, radian_minus_pi_to_pi>>,
                field<&T::inclination_validity,
                    in_value_set<enumeration<environment_sensing::inclination_validity, u8>, between<0, 1>>>,
                field<&T::inclination_error_rms, scaled<u32le, radian_0_to_pi>>>>;
    };
};

/// Sequence RangeSensorDataSeq.
struct range_sensor_data_seq {
    environment_sensing::range_sensor_data_rec range_sensor_data_rec{};
    wire::list<range_sensor_data_point_rec> range_sensor_data_point_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(const range_sensor_data_seq&, const range_sensor_data_seq&) = default;

    struct schema : wire::items {
        using T = range_sensor_data_seq;
        using type = layout<
            nested<&T::range_sensor_data_rec>,
            repeated<&T::range_sensor_data_point_list, count<"number_of_range_sensor_data_point_list", u16le>>>;
    };
};

/// Variant RangeSensorDataVariant.
struct range_sensor_data_variant {
    std::variant<range_sensor_data_error_rec, range_sensor_data_seq> value{};
    friend constexpr bool operator==(const range_sensor_data_variant&, const range_sensor_data_variant&) = default;

    struct schema : wire::items {
        using T = range_sensor_data_variant;
        using type = layout<variant<&T::value, u8>>;
    };
};

/// ReportRangeSensorData: ID 4803h, output of RangeSensor.
struct report_range_sensor_data {
    wire::list<range_sensor_data_variant> range_sensor_data_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(const report_range_sensor_data&, const report_range_sensor_data&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4803;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_range_sensor_data;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::range_sensor_data_list, count<"number_of_range_sensor_data_list", u16le>>>;
    };
};

/// Record RangeSensorCompressedDataRec.
struct range_sensor_compressed_data_rec {
    std::uint16_t sensor_id{};    ///< 1 to 65535
    environment_sensing::report_coordinate_system report_coordinate_system{};
    environment_sensing::time_stamp time_stamp{};
    environment_sensing::data_compression data_compression{};
    wire::blob compressed_data{}; ///< RangeSensorDataPointList, up to 2147483647 octets
    friend constexpr bool operator==(
        const range_sensor_compressed_data_rec&,
        const range_sensor_compressed_data_rec&) = default;

    struct schema : wire::items {
        using T = range_sensor_compressed_data_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::report_coordinate_system,
                in_value_set<enumeration<environment_sensing::report_coordinate_system, u8>, between<0, 1>>>,
            nested<&T::time_stamp>,
            field<&T::data_compression,
                in_value_set<enumeration<environment_sensing::data_compression, u8>, between<0, 3>>>,
            bytes<&T::compressed_data, count_between<"compressed_data_size", u32le, 0, 2147483647>>>;
    };
};

/// Variant RangeSensorCompressedDataVariant.
struct range_sensor_compressed_data_variant {
    std::variant<range_sensor_data_error_rec, range_sensor_compressed_data_rec> value{};
    friend constexpr bool operator==(
        const range_sensor_compressed_data_variant&,
        const range_sensor_compressed_data_variant&) = default;

    struct schema : wire::items {
        using T = range_sensor_compressed_data_variant;
        using type = layout<variant<&T::value, u8>>;
    };
};

/// ReportRangeSensorCompressedData: ID 4804h, output of RangeSensor.
struct report_range_sensor_compressed_data {
    wire::list<range_sensor_compressed_data_variant> range_sensor_compressed_data_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_range_sensor_compressed_data&,
        const report_range_sensor_compressed_data&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4804;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_range_sensor_compressed_data;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::range_sensor_compressed_data_list,
                count<"number_of_range_sensor_compressed_data_list", u16le>>>;
    };
};

namespace services {

/// RangeSensor: what it is called, and its messages.
struct range_sensor {
    static constexpr std::string_view name = "RangeSensor";
    static constexpr std::string_view uri = "urn:jaus:jss:environmentSensing:RangeSensor";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:AccessControl";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_range_sensor_configuration,
        query_sensor_geometric_properties,
        query_range_sensor_compressed_data,
        query_range_sensor_data,
        query_range_sensor_capabilities,
        query_range_sensor_configuration>;
    using outputs = jaus::message_list<
        confirm_sensor_configuration,
        report_range_sensor_capabilities,
        report_range_sensor_configuration,
        report_range_sensor_data,
        report_range_sensor_compressed_data,
        report_sensor_geometric_properties>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::environment_sensing
