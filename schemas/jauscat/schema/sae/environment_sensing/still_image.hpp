// StillImage 2.0, urn:jaus:jss:environmentSensing:StillImage.
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
struct still_image_request_id_rec {
    std::uint8_t request_id{};
    friend constexpr bool operator==(const still_image_request_id_rec&, const still_image_request_id_rec&) = default;

    struct schema : wire::items {
        using T = still_image_request_id_rec;
        using type = layout<field<&T::request_id, u8>>;
    };
};

/// Values of StillImageFormat.
enum class still_image_format : std::uint8_t {
    jpeg = 0,
    gif = 1,
    png = 2,
    bmp = 3,
    tiff = 4,
    ppm = 5,
    pgm = 6,
    pnm = 7,
    nef = 8,
    cr2 = 9,
    dng = 10,
};

/// Record StillImageSensorConfigurationRec.
struct still_image_sensor_configuration_rec {
    std::uint16_t sensor_id{}; ///< 1 to 65535
    std::optional<environment_sensing::frame_size> frame_size{};
    std::optional<environment_sensing::still_image_format> still_image_format{};
    friend constexpr bool operator==(
        const still_image_sensor_configuration_rec&,
        const still_image_sensor_configuration_rec&) = default;

    struct schema : wire::items {
        using T = still_image_sensor_configuration_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
                field<&T::frame_size, in_value_set<enumeration<environment_sensing::frame_size, u8>, between<0, 28>>>,
                field<&T::still_image_format,
                    in_value_set<enumeration<environment_sensing::still_image_format, u8>, between<0, 10>>>>>;
    };
};

/// SetStillImageSensorConfiguration: ID 0807h, command, input of StillImage.
struct set_still_image_sensor_configuration {
    still_image_request_id_rec request_id_rec{};
    wire::list<still_image_sensor_configuration_rec> still_image_sensor_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const set_still_image_sensor_configuration&,
        const set_still_image_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0807;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_still_image_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::request_id_rec>,
            repeated<&T::still_image_sensor_list, count<"number_of_still_image_sensor_list", u16le>>>;
    };
};

/// Record QueryStillImageDataRec.
struct query_still_image_data_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    environment_sensing::report_coordinate_system report_coordinate_system{};
    std::uint8_t query_presence_vector{};
    friend constexpr bool operator==(const query_still_image_data_rec&, const query_still_image_data_rec&) = default;

    struct schema : wire::items {
        using T = query_still_image_data_rec;
        using type = layout<
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>,
            field<&T::report_coordinate_system,
                in_value_set<enumeration<environment_sensing::report_coordinate_system, u8>, between<0, 1>>>,
            field<&T::query_presence_vector, u8>>;
    };
};

/// QueryStillImageDataExt: ID 281Ch, input of StillImage.
struct query_still_image_data_ext {
    wire::list<query_still_image_data_rec> query_still_image_data_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(const query_still_image_data_ext&, const query_still_image_data_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x281C;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_still_image_data_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::query_still_image_data_list, count<"number_of_query_still_image_data_list", u16le>>>;
    };
};

/// Record QueryStillImageSensorConfigurationRec.
struct query_still_image_sensor_configuration_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    std::uint8_t query_presence_vector{};
    friend constexpr bool operator==(
        const query_still_image_sensor_configuration_rec&,
        const query_still_image_sensor_configuration_rec&) = default;

    struct schema : wire::items {
        using T = query_still_image_sensor_configuration_rec;
        using type = layout<
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>,
            field<&T::query_presence_vector, u8>>;
    };
};

/// QueryStillImageSensorConfiguration: ID 2813h, input of StillImage.
struct query_still_image_sensor_configuration {
    /// up to 65535 elements
    wire::list<query_still_image_sensor_configuration_rec> query_still_image_sensor_configuration_list{};
    friend constexpr bool operator==(
        const query_still_image_sensor_configuration&,
        const query_still_image_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2813;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_still_image_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::query_still_image_sensor_configuration_list,
                count<"number_of_query_still_image_sensor_configuration_list", u16le>>>;
    };
};

/// Record QueryStillImageSensorCapabilitiesRec.
struct query_still_image_sensor_capabilities_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    std::uint8_t query_presence_vector{};
    friend constexpr bool operator==(
        const query_still_image_sensor_capabilities_rec&,
        const query_still_image_sensor_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = query_still_image_sensor_capabilities_rec;
        using type = layout<
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>,
            field<&T::query_presence_vector, u8>>;
    };
};

/// QueryStillImageSensorCapabilities: ID 2812h, input of StillImage.
struct query_still_image_sensor_capabilities {
    /// up to 65535 elements
    wire::list<query_still_image_sensor_capabilities_rec> query_still_image_sensor_capabilities_list{};
    friend constexpr bool operator==(
        const query_still_image_sensor_capabilities&,
        const query_still_image_sensor_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2812;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_still_image_sensor_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::query_still_image_sensor_capabilities_list,
                count<"number_of_query_still_image_sensor_capabilities_list", u16le>>>;
    };
};

/// Values of ImageFrame.
enum class image_frame_format : std::uint8_t {
    jpeg = 0,
    gif = 1,
    png = 2,
    bmp = 3,
    tiff = 4,
    ppm = 5,
    pgm = 6,
    pnm = 7,
    nef = 8,
    cr2 = 9,
    dng = 10,
};

/// ImageFrame: octets in the format that is named before them.
struct image_frame {
    image_frame_format format{};
    wire::blob data{}; ///< up to 2147483647 octets
    friend constexpr bool operator==(const image_frame&, const image_frame&) = default;

    struct schema : wire::items {
        using T = image_frame;
        using type = layout<
            field<&T::format, in_value_set<enumeration<image_frame_format, u8>, between<0, 10>>>,
            bytes<&T::data, count_between<"data_size", u32le, 0, 2147483647>>>;
    };
};

/// Record StillImageDataRec.
struct still_image_data_rec {
    std::uint16_t sensor_id{};                         ///< 1 to 65535
    environment_sensing::report_coordinate_system report_coordinate_system{};
    std::optional<environment_sensing::time_stamp> time_stamp{};
    std::optional<environment_sensing::image_frame> image_frame{};
    std::optional<std::string_view> still_image_uri{}; ///< up to 255 characters
    friend constexpr bool operator==(const still_image_data_rec&, const still_image_data_rec&) = default;

    struct schema : wire::items {
        using T = still_image_data_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
                field<&T::report_coordinate_system,
                    in_value_set<enumeration<environment_sensing::report_coordinate_system, u8>, between<0, 1>>>,
                nested<&T::time_stamp>,
                nested<&T::image_frame>,
                string<&T::still_image_uri, count<"still_image_uri_size", u8>>>>;
    };
};

/// ReportStillImageDataExt: ID 481Ch, output of StillImage.
struct report_still_image_data_ext {
    wire::list<still_image_data_rec> still_image_data_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(const report_still_image_data_ext&, const report_still_image_data_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x481C;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_still_image_data_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::still_image_data_list, count<"number_of_still_image_data_list", u16le>>>;
    };
};

/// ReportStillImageSensorConfiguration: ID 4813h, output of StillImage.
struct report_still_image_sensor_configuration {
    wire::list<still_image_sensor_configuration_rec> still_image_sensor_configuration_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_still_image_sensor_configuration&,
        const report_still_image_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4813;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_still_image_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::still_image_sensor_configuration_list,
                count<"number_of_still_image_sensor_configuration_list", u16le>>>;
    };
};

/// Values of JPEG.
enum class jpeg : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of GIF.
enum class gif : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of PNG.
enum class png : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of BMP.
enum class bmp : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of TIFF.
enum class tiff : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of PPM.
enum class ppm : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of PGM.
enum class pgm : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of PNM.
enum class pnm : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of NEF_Nikon_RAW.
enum class nef_nikon_raw : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of CR2_Canon_RAW.
enum class cr2_canon_raw : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of DNG_Adobe_RAW.
enum class dng_adobe_raw : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Bits of SupportedImageFormats.
struct supported_image_formats {
    environment_sensing::jpeg jpeg{};
    environment_sensing::gif gif{};
    environment_sensing::png png{};
    environment_sensing::bmp bmp{};
    environment_sensing::tiff tiff{};
    environment_sensing::ppm ppm{};
    environment_sensing::pgm pgm{};
    environment_sensing::pnm pnm{};
    environment_sensing::nef_nikon_raw nef_nikon_raw{};
    environment_sensing::cr2_canon_raw cr2_canon_raw{};
    environment_sensing::dng_adobe_raw dng_adobe_raw{};
    friend constexpr bool operator==(const supported_image_formats&, const supported_image_formats&) = default;

    struct schema : wire::items {
        using T = supported_image_formats;
        using type = layout<
            bit_fields<u16le,
                bit_field<&T::jpeg, 1>,
                bit_field<&T::gif, 1>,
                bit_field<&T::png, 1>,
                bit_field<&T::bmp, 1>,
                bit_field<&T::tiff, 1>,
                bit_field<&T::ppm, 1>,
                bit_field<&T::pgm, 1>,
                bit_field<&T::pnm, 1>,
                bit_field<&T::nef_nikon_raw, 1>,
                bit_field<&T::cr2_canon_raw, 1>,
                bit_field<&T::dng_adobe_raw, 1>,
                reserved<5>>>;
    };
};

/// Record StillImageSensorCapabilitiesRec.
struct still_image_sensor_capabilities_rec {
    std::uint16_t sensor_id{}; ///< 1 to 65535
    std::optional<environment_sensing::supported_frame_sizes> supported_frame_sizes{};
    std::optional<environment_sensing::supported_image_formats> supported_image_formats{};
    friend constexpr bool operator==(
        const still_image_sensor_capabilities_rec&,
        const still_image_sensor_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = still_image_sensor_capabilities_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
                nested<&T::supported_frame_sizes>,
                nested<&T::supported_image_formats>>>;
    };
};

/// ReportStillImageSensorCapabilities: ID 4812h, output of StillImage.
struct report_still_image_sensor_capabilities {
    wire::list<still_image_sensor_capabilities_rec> still_image_sensor_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_still_image_sensor_capabilities&,
        const report_still_image_sensor_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4812;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_still_image_sensor_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::still_image_sensor_list, count<"number_of_still_image_sensor_list", u16le>>>;
    };
};

namespace services {

/// StillImage: what it is called, and its messages.
struct still_image {
    static constexpr std::string_view name = "StillImage";
    static constexpr std::string_view uri = "urn:jaus:jss:environmentSensing:StillImage";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:environmentSensing:VisualSensor";
    static constexpr std::string_view parent_version = "2.0";
    using inputs = jaus::message_list<
        set_still_image_sensor_configuration,
        query_still_image_data_ext,
        query_still_image_sensor_configuration,
        query_still_image_sensor_capabilities>;
    using outputs = jaus::message_list<
        report_still_image_data_ext,
        report_still_image_sensor_configuration,
        report_still_image_sensor_capabilities>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::environment_sensing
