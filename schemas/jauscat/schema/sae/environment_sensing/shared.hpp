// Messages and types that several services of the set environment_sensing have.
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
namespace jauscat::sae::environment_sensing {

/// Values of SensorID.
enum class sensor_id : std::uint16_t {
    all_sensors = 0,
};

/// Record SensorIDQueryRec.
struct sensor_id_query_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    friend constexpr bool operator==(const sensor_id_query_rec&, const sensor_id_query_rec&) = default;

    struct schema : wire::items {
        using T = sensor_id_query_rec;
        using type = layout<field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>>;
    };
};

/// Record RequestIdRec.
struct shared_request_id_rec {
    std::uint8_t request_id{};
    friend constexpr bool operator==(const shared_request_id_rec&, const shared_request_id_rec&) = default;

    struct schema : wire::items {
        using T = shared_request_id_rec;
        using type = layout<field<&T::request_id, u8>>;
    };
};

/// Record SensorIdRec.
struct shared_sensor_id_rec {
    std::uint16_t sensor_id{}; ///< 1 to 65535
    friend constexpr bool operator==(const shared_sensor_id_rec&, const shared_sensor_id_rec&) = default;

    struct schema : wire::items {
        using T = shared_sensor_id_rec;
        using type = layout<field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>>;
    };
};

/// Values of RangeSensorErrorCode.
enum class range_sensor_error_code : std::uint8_t {
    unknown_sensor_id = 0,
    invalid_horizontal_field_of_view = 1,
    invalid_vertical_field_of_view = 2,
    invalid_update_rate = 3,
    invalid_sensor_range = 4,
    invalid_sensor_state = 5,
    multiple_invalid_parameters = 6,
    unknown_error_fault = 255, ///< Unknown Error / Fault
};

/// Record RangeSensorErrorRec.
struct range_sensor_error_rec {
    std::uint16_t sensor_id{};        ///< 1 to 65535
    environment_sensing::range_sensor_error_code range_sensor_error_code{};
    std::string_view error_message{}; ///< up to 255 characters
    friend constexpr bool operator==(const range_sensor_error_rec&, const range_sensor_error_rec&) = default;

    struct schema : wire::items {
        using T = range_sensor_error_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::range_sensor_error_code,
                in_value_set<
                    enumeration<environment_sensing::range_sensor_error_code, u8>,
                    between<0, 6>,
                    one_of<255>>>,
            string<&T::error_message, count<"error_message_size", u8>>>;
    };
};

/// Values of VisualSensorErrorCode.
enum class visual_sensor_error_code : std::uint8_t {
    unknown_sensor_id = 0,
    invalid_sensor_state = 1,
    invalid_zoom_mode = 2,
    invalid_zoom_value = 3,
    invalid_focus_mode = 4,
    invalid_focus_value = 5,
    invalid_white_balance = 6,
    invalid_imaging_mode = 7,
    invalid_exposure_mode = 8,
    invalid_metering_mode = 9,
    invalid_shutter_speed = 10,
    invalid_aperture_value = 11,
    invalid_light_sensitivity = 12,
    invalid_image_stabilization = 13,
    invalid_horizontal_fov = 14,
    invalid_vertical_fov = 15,
    multiple_invalid_parameters = 16,
    unknown_error_fault = 255, ///< Unknown Error / Fault
};

/// Record VisualSensorErrorRec.
struct visual_sensor_error_rec {
    std::uint16_t sensor_id{};        ///< 1 to 65535
    environment_sensing::visual_sensor_error_code visual_sensor_error_code{};
    std::string_view error_message{}; ///< up to 255 characters
    friend constexpr bool operator==(const visual_sensor_error_rec&, const visual_sensor_error_rec&) = default;

    struct schema : wire::items {
        using T = visual_sensor_error_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::visual_sensor_error_code,
                in_value_set<
                    enumeration<environment_sensing::visual_sensor_error_code, u8>,
                    between<0, 16>,
                    one_of<255>>>,
            string<&T::error_message, count<"error_message_size", u8>>>;
    };
};

/// Values of DigitalVideoErrorCode.
enum class digital_video_error_code : std::uint8_t {
    unknown_sensor_id = 0,
    invalid_minimum_bit_rate = 1,
    invalid_maximum_bit_rate = 2,
    requested_frame_rate_too_low = 3,
    requested_frame_rate_too_high = 4,
    invalid_frame_size = 5,
    invalid_format = 6,
    multiple_invalid_parameters = 7,
    unknown_error_fault = 255, ///< Unknown Error / Fault
};

/// Record DigitalVideoSensorErrorRec.
struct digital_video_sensor_error_rec {
    std::uint16_t sensor_id{};        ///< 1 to 65535
    environment_sensing::digital_video_error_code digital_video_error_code{};
    std::string_view error_message{}; ///< up to 255 characters
    friend constexpr bool operator==(
        const digital_video_sensor_error_rec&,
        const digital_video_sensor_error_rec&) = default;

    struct schema : wire::items {
        using T = digital_video_sensor_error_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::digital_video_error_code,
                in_value_set<
                    enumeration<environment_sensing::digital_video_error_code, u8>,
                    between<0, 7>,
                    one_of<255>>>,
            string<&T::error_message, count<"error_message_size", u8>>>;
    };
};

/// Values of AnalogVideoErrorCode.
enum class analog_video_error_code : std::uint8_t {
    unknown_sensor_id = 0,
    invalid_format = 1,
    unknown_error_fault = 255, ///< Unknown Error / Fault
};

/// Record AnalogVideoSensorErrorRec.
struct analog_video_sensor_error_rec {
    std::uint16_t sensor_id{};        ///< 1 to 65535
    environment_sensing::analog_video_error_code analog_video_error_code{};
    std::string_view error_message{}; ///< up to 255 characters
    friend constexpr bool operator==(
        const analog_video_sensor_error_rec&,
        const analog_video_sensor_error_rec&) = default;

    struct schema : wire::items {
        using T = analog_video_sensor_error_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::analog_video_error_code,
                in_value_set<
                    enumeration<environment_sensing::analog_video_error_code, u8>,
                    between<0, 1>,
                    one_of<255>>>,
            string<&T::error_message, count<"error_message_size", u8>>>;
    };
};

/// Values of StillImageErrorCode.
enum class still_image_error_code : std::uint8_t {
    unknown_sensor_id = 0,
    invalid_frame_size = 1,
    invalid_format = 2,
    multiple_invalid_parameters = 3,
    unknown_error_fault = 255, ///< Unknown Error / Fault
};

/// Record StillImageSensorErrorRec.
struct still_image_sensor_error_rec {
    std::uint16_t sensor_id{};        ///< 1 to 65535
    environment_sensing::still_image_error_code still_image_error_code{};
    std::string_view error_message{}; ///< up to 255 characters
    friend constexpr bool operator==(
        const still_image_sensor_error_rec&,
        const still_image_sensor_error_rec&) = default;

    struct schema : wire::items {
        using T = still_image_sensor_error_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::still_image_error_code,
                in_value_set<enumeration<environment_sensing::still_image_error_code, u8>, between<0, 3>, one_of<255>>>,
            string<&T::error_message, count<"error_message_size", u8>>>;
    };
};

/// Values of H264VideoEncodingErrorCode.
enum class h264_video_encoding_error_code : std::uint8_t {
    unknown_sensor_id = 0,
    invalid_profile = 1,
    invalid_preset = 2,
    invalid_group_of_pictures = 3,
    invalid_gdr = 4,
    invalid_region_of_interest = 5,
    invalid_intra_macro_refresh = 6,
    unknown_error_fault = 255, ///< Unknown Error / Fault
};

/// Record H264VideoEncodingErrorRec.
struct h264_video_encoding_error_rec {
    std::uint16_t sensor_id{};        ///< 1 to 65535
    environment_sensing::h264_video_encoding_error_code h264_video_encoding_error_code{};
    std::string_view error_message{}; ///< up to 255 characters
    friend constexpr bool operator==(
        const h264_video_encoding_error_rec&,
        const h264_video_encoding_error_rec&) = default;

    struct schema : wire::items {
        using T = h264_video_encoding_error_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::h264_video_encoding_error_code,
                in_value_set<
                    enumeration<environment_sensing::h264_video_encoding_error_code, u8>,
                    between<0, 6>,
                    one_of<255>>>,
            string<&T::error_message, count<"error_message_size", u8>>>;
    };
};

/// Values of DigitalAudioSensorErrorCode.
enum class digital_audio_sensor_error_code : std::uint8_t {
    unknown_sensor_id = 0,
    invalid_bit_rate = 1,
    invalid_format = 2,
    invalid_sample_rate = 3,
    invalid_bit_depth = 4,
    invalid_encoding_quality = 5,
    unknown_error_fault = 255, ///< Unknown Error / Fault
};

/// Record DigitalAudioSensorErrorRec.
struct digital_audio_sensor_error_rec {
    std::uint16_t sensor_id{};        ///< 1 to 65535
    environment_sensing::digital_audio_sensor_error_code digital_audio_sensor_error_code{};
    std::string_view error_message{}; ///< up to 255 characters
    friend constexpr bool operator==(
        const digital_audio_sensor_error_rec&,
        const digital_audio_sensor_error_rec&) = default;

    struct schema : wire::items {
        using T = digital_audio_sensor_error_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::digital_audio_sensor_error_code,
                in_value_set<
                    enumeration<environment_sensing::digital_audio_sensor_error_code, u8>,
                    between<0, 5>,
                    one_of<255>>>,
            string<&T::error_message, count<"error_message_size", u8>>>;
    };
};

/// Values of DigitalAudioOutputErrorCode.
enum class digital_audio_output_error_code : std::uint8_t {
    unknown_sensor_id = 0,
    stream_not_found = 1,
    stream_not_supported = 2,
    unknown_error_fault = 255, ///< Unknown Error / Fault
};

/// Record DigitalAudioOutputErrorRec.
struct digital_audio_output_error_rec {
    std::uint16_t sensor_id{};        ///< 1 to 65535
    environment_sensing::digital_audio_output_error_code digital_audio_output_error_code{};
    std::string_view error_message{}; ///< up to 255 characters
    friend constexpr bool operator==(
        const digital_audio_output_error_rec&,
        const digital_audio_output_error_rec&) = default;

    struct schema : wire::items {
        using T = digital_audio_output_error_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::digital_audio_output_error_code,
                in_value_set<
                    enumeration<environment_sensing::digital_audio_output_error_code, u8>,
                    between<0, 2>,
                    one_of<255>>>,
            string<&T::error_message, count<"error_message_size", u8>>>;
    };
};

/// Values of VideoIlluminatorErrorRecCode.
enum class video_illuminator_error_rec_code : std::uint8_t {
    unknown_sensor_id = 0,
    unsupported_mode = 1,
    unsupported_beam_width = 2,
    unsupported_beam_height = 3,
    unknown_error_fault = 255, ///< Unknown Error / Fault
};

/// Record VideoIlluminatorErrorRec.
struct video_illuminator_error_rec {
    std::uint16_t illuminator_id{};
    environment_sensing::video_illuminator_error_rec_code video_illuminator_error_rec_code{};
    std::string_view error_message{}; ///< up to 255 characters
    friend constexpr bool operator==(const video_illuminator_error_rec&, const video_illuminator_error_rec&) = default;

    struct schema : wire::items {
        using T = video_illuminator_error_rec;
        using type = layout<
            field<&T::illuminator_id, u16le>,
            field<&T::video_illuminator_error_rec_code,
                in_value_set<
                    enumeration<environment_sensing::video_illuminator_error_rec_code, u8>,
                    between<0, 3>,
                    one_of<255>>>,
            string<&T::error_message, count<"error_message_size", u8>>>;
    };
};

/// Variant ConfirmSensorConfigurationVariant.
struct confirm_sensor_configuration_variant {
    std::variant<
        shared_sensor_id_rec,
        range_sensor_error_rec,
        visual_sensor_error_rec,
        digital_video_sensor_error_rec,
        analog_video_sensor_error_rec,
        still_image_sensor_error_rec,
        h264_video_encoding_error_rec,
        digital_audio_sensor_error_rec,
        digital_audio_output_error_rec,
        video_illuminator_error_rec> value{};
    friend constexpr bool operator==(
        const confirm_sensor_configuration_variant&,
        const confirm_sensor_configuration_variant&) = default;

    struct schema : wire::items {
        using T = confirm_sensor_configuration_variant;
        using type = layout<variant<&T::value, u8>>;
    };
};

/// ConfirmSensorConfiguration: ID 0801h, output of DigitalAudioOutput, RangeSensor, VideoIlluminator, VisualSensor.
struct confirm_sensor_configuration {
    shared_request_id_rec request_id_rec{};
    wire::list<confirm_sensor_configuration_variant> confirm_sensor_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const confirm_sensor_configuration&,
        const confirm_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0801;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = confirm_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::request_id_rec>,
            repeated<&T::confirm_sensor_list, count<"number_of_confirm_sensor_list", u16le>>>;
    };
};

/// Values of FrameSize.
enum class frame_size : std::uint8_t {
    value_128x96_sqcif = 0,      ///< 128x96 (sqcif)
    value_176x144_qcif = 1,      ///< 176x144 (qcif)
    value_352x288_cif = 2,       ///< 352x288 (cif)
    value_704x576_4cif = 3,      ///< 704x576 (4cif)
    value_1408x1152_16cif = 4,   ///< 1408x1152 (16cif)
    value_160x120_qqvga = 5,     ///< 160x120 (qqvga)
    value_320x240_qvga = 6,      ///< 320x240 (qvga)
    value_640x480_vga = 7,       ///< 640x480 (vga)
    value_800x600_svga = 8,      ///< 800x600 (svga)
    value_1024x768_xga = 9,      ///< 1024x768 (xga)
    value_1600x1200_uxga = 10,   ///< 1600x1200 (uxga)
    value_2048x1536_qxga = 11,   ///< 2048x1536 (qxga)
    value_1280x1024_sxga = 12,   ///< 1280x1024 (sxga)
    value_2560x2048_qsxga = 13,  ///< 2560x2048 (qsxga)
    value_5120x4096_hsxga = 14,  ///< 5120x4096 (hsxga)
    value_852x480_wvga = 15,     ///< 852x480 (wvga)
    value_1366x768_wxga = 16,    ///< 1366x768 (wxga)
    value_1600x1024_wsxga = 17,  ///< 1600x1024 (wsxga)
    value_1920x1200_wuxga = 18,  ///< 1920x1200 (wuxga)
    value_2560x1600_woxga = 19,  ///< 2560x1600 (woxga)
    value_3200x2048_wqsxga = 20, ///< 3200x2048 (wqsxga)
    value_3840x2400_wquxga = 21, ///< 3840x2400 (wquxga)
    value_6400x4096_whsxga = 22, ///< 6400x4096 (whsxga)
    value_7680x4800_whuxga = 23, ///< 7680x4800 (whuxga)
    value_320x200_cga = 24,      ///< 320x200 (cga)
    value_640x350_ega = 25,      ///< 640x350 (ega)
    value_852x480_hd480 = 26,    ///< 852x480 (hd480)
    value_1280x720_hd720 = 27,   ///< 1280x720 (hd720)
    value_1920x1080_hd1080 = 28, ///< 1920x1080 (hd1080)
};

/// Values of sqcif_128x96.
enum class sqcif_128x96 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of qcif_176x144.
enum class qcif_176x144 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of cif_352x288.
enum class cif_352x288 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of cif4_704x576.
enum class cif4_704x576 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of cif16_1408x1152.
enum class cif16_1408x1152 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of qqvga_160x120.
enum class qqvga_160x120 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of qvga_320x240.
enum class qvga_320x240 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of vga_640x480.
enum class vga_640x480 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of svga_800x600.
enum class svga_800x600 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of xga_1024x768.
enum class xga_1024x768 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of uxga_1600x1200.
enum class uxga_1600x1200 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of qxga_2048x1536.
enum class qxga_2048x1536 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of sxga_1280x1024.
enum class sxga_1280x1024 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of qsxga_2560x2048.
enum class qsxga_2560x2048 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of hsxga_5120x4096.
enum class hsxga_5120x4096 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of wvga_852x480.
enum class wvga_852x480 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of wxga_1366x768.
enum class wxga_1366x768 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of wsxga_1600x1024.
enum class wsxga_1600x1024 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of wuxga_1920x1200.
enum class wuxga_1920x1200 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of woxga_2560x1600.
enum class woxga_2560x1600 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of wqsxga_3200x2048.
enum class wqsxga_3200x2048 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of wquxga_3840x2400.
enum class wquxga_3840x2400 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of whsxga_6400x4096.
enum class whsxga_6400x4096 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of whuxga_7680x4800.
enum class whuxga_7680x4800 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of cga_320x200.
enum class cga_320x200 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of ega_640x350.
enum class ega_640x350 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of hd480_852x480.
enum class hd480_852x480 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of hd720_1280x720.
enum class hd720_1280x720 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of hd1080_1920x1080.
enum class hd1080_1920x1080 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Bits of SupportedFrameSizes.
struct supported_frame_sizes {
    environment_sensing::sqcif_128x96 sqcif_128x96{};
    environment_sensing::qcif_176x144 qcif_176x144{};
    environment_sensing::cif_352x288 cif_352x288{};
    environment_sensing::cif4_704x576 cif4_704x576{};
    environment_sensing::cif16_1408x1152 cif16_1408x1152{};
    environment_sensing::qqvga_160x120 qqvga_160x120{};
    environment_sensing::qvga_320x240 qvga_320x240{};
    environment_sensing::vga_640x480 vga_640x480{};
    environment_sensing::svga_800x600 svga_800x600{};
    environment_sensing::xga_1024x768 xga_1024x768{};
    environment_sensing::uxga_1600x1200 uxga_1600x1200{};
    environment_sensing::qxga_2048x1536 qxga_2048x1536{};
    environment_sensing::sxga_1280x1024 sxga_1280x1024{};
    environment_sensing::qsxga_2560x2048 qsxga_2560x2048{};
    environment_sensing::hsxga_5120x4096 hsxga_5120x4096{};
    environment_sensing::wvga_852x480 wvga_852x480{};
    environment_sensing::wxga_1366x768 wxga_1366x768{};
    environment_sensing::wsxga_1600x1024 wsxga_1600x1024{};
    environment_sensing::wuxga_1920x1200 wuxga_1920x1200{};
    environment_sensing::woxga_2560x1600 woxga_2560x1600{};
    environment_sensing::wqsxga_3200x2048 wqsxga_3200x2048{};
    environment_sensing::wquxga_3840x2400 wquxga_3840x2400{};
    environment_sensing::whsxga_6400x4096 whsxga_6400x4096{};
    environment_sensing::whuxga_7680x4800 whuxga_7680x4800{};
    environment_sensing::cga_320x200 cga_320x200{};
    environment_sensing::ega_640x350 ega_640x350{};
    environment_sensing::hd480_852x480 hd480_852x480{};
    environment_sensing::hd720_1280x720 hd720_1280x720{};
    environment_sensing::hd1080_1920x1080 hd1080_1920x1080{};
    friend constexpr bool operator==(const supported_frame_sizes&, const supported_frame_sizes&) = default;

    struct schema : wire::items {
        using T = supported_frame_sizes;
        using type = layout<
            bit_fields<u32le,
                bit_field<&T::sqcif_128x96, 1>,
                bit_field<&T::qcif_176x144, 1>,
                bit_field<&T::cif_352x288, 1>,
                bit_field<&T::cif4_704x576, 1>,
                bit_field<&T::cif16_1408x1152, 1>,
                bit_field<&T::qqvga_160x120, 1>,
                bit_field<&T::qvga_320x240, 1>,
                bit_field<&T::vga_640x480, 1>,
                bit_field<&T::svga_800x600, 1>,
                bit_field<&T::xga_1024x768, 1>,
                bit_field<&T::uxga_1600x1200, 1>,
                bit_field<&T::qxga_2048x1536, 1>,
                bit_field<&T::sxga_1280x1024, 1>,
                bit_field<&T::qsxga_2560x2048, 1>,
                bit_field<&T::hsxga_5120x4096, 1>,
                bit_field<&T::wvga_852x480, 1>,
                bit_field<&T::wxga_1366x768, 1>,
                bit_field<&T::wsxga_1600x1024, 1>,
                bit_field<&T::wuxga_1920x1200, 1>,
                bit_field<&T::woxga_2560x1600, 1>,
                bit_field<&T::wqsxga_3200x2048, 1>,
                bit_field<&T::wquxga_3840x2400, 1>,
                bit_field<&T::whsxga_6400x4096, 1>,
                bit_field<&T::whuxga_7680x4800, 1>,
                bit_field<&T::cga_320x200, 1>,
                bit_field<&T::ega_640x350, 1>,
                bit_field<&T::hd480_852x480, 1>,
                bit_field<&T::hd720_1280x720, 1>,
                bit_field<&T::hd1080_1920x1080, 1>,
                reserved<3>>>;
    };
};

/// Values of SensorState.
enum class sensor_state : std::uint8_t {
    active = 0,
    standby = 1,
    off = 2,
};

/// QuerySensorGeometricProperties: ID 2805h, input of RangeSensor, VisualSensor.
struct query_sensor_geometric_properties {
    wire::list<sensor_id_query_rec> sensor_id_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const query_sensor_geometric_properties&,
        const query_sensor_geometric_properties&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2805;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_sensor_geometric_properties;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::sensor_id_list, count<"number_of_sensor_id_list", u16le>>>;
    };
};

/// Values of ReportCoordinateSystem.
enum class report_coordinate_system : std::uint8_t {
    native_coordinate_system = 0,
    vehicle_coordinate_system = 1,
};

/// Values of Active.
enum class active : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of Standby.
enum class standby : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of Off.
enum class off : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Bits of SupportedStates.
struct supported_states {
    environment_sensing::active active{};
    environment_sensing::standby standby{};
    environment_sensing::off off{};
    friend constexpr bool operator==(const supported_states&, const supported_states&) = default;

    struct schema : wire::items {
        using T = supported_states;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::active, 1>,
                bit_field<&T::standby, 1>,
                bit_field<&T::off, 1>,
                reserved<5>>>;
    };
};

/// Bits of TimeStamp.
struct time_stamp {
    std::uint16_t milliseconds{}; ///< 0 to 999
    std::uint8_t seconds{};       ///< 0 to 59
    std::uint8_t minutes{};       ///< 0 to 59
    std::uint8_t hour{};          ///< 0 to 23
    std::uint8_t day{};           ///< 1 to 31
    friend constexpr bool operator==(const time_stamp&, const time_stamp&) = default;

    struct schema : wire::items {
        using T = time_stamp;
        using type = layout<
            bit_fields<u32le,
                bit_field_in_set<&T::milliseconds, 10, between<0, 999>>,
                bit_field_in_set<&T::seconds, 6, between<0, 59>>,
                bit_field_in_set<&T::minutes, 6, between<0, 59>>,
                bit_field_in_set<&T::hour, 5, between<0, 23>>,
                bit_field_in_set<&T::day, 5, between<1, 31>>>>;
    };
};

/// Variant NoGeometricPropertiesVariant, which has no alternative.
struct no_geometric_properties_variant {
    friend constexpr bool operator==(
        const no_geometric_properties_variant&,
        const no_geometric_properties_variant&) = default;

    struct schema : wire::items {
        using type = layout<constant<"index", u8, 0>>;
    };
};

/// Record StaticGeometricPropertiesRec.
struct static_geometric_properties_rec {
    std::array<double, 3> sensor_position{}; ///< meter, -30 to 30
    std::array<double, 4> unit_quaternion{}; ///< -1 to 1
    friend constexpr bool operator==(
        const static_geometric_properties_rec&,
        const static_geometric_properties_rec&) = default;

    struct schema : wire::items {
        using T = static_geometric_properties_rec;
        using type = layout<
            array<&T::sensor_position, scaled<u32le, meter_minus_30_to_30>>,
            array<&T::unit_quaternion, scaled<u32le, one_minus_1_to_1>>>;
    };
};

/// Record ManipulatorGeometricPropertiesRec.
struct manipulator_geometric_properties_rec {
    std::uint16_t subsystem_id{};
    std::uint8_t node_id{};
    std::uint8_t component_id{};
    std::uint8_t joint_number{};
    std::array<double, 3> sensor_position{}; ///< meter, -30 to 30
    std::array<double, 4> unit_quaternion{}; ///< -1 to 1
    friend constexpr bool operator==(
        const manipulator_geometric_properties_rec&,
        const manipulator_geometric_properties_rec&) = default;

    struct schema : wire::items {
        using T = manipulator_geometric_properties_rec;
        using type = layout<
            field<&T::subsystem_id, u16le>,
            field<&T::node_id, u8>,
            field<&T::component_id, u8>,
            field<&T::joint_number, u8>,
            array<&T::sensor_position, scaled<u32le, meter_minus_30_to_30>>,
            array<&T::unit_quaternion, scaled<u32le, one_minus_1_to_1>>>;
    };
};

/// Sequence GeometricPropertiesSequence.
struct geometric_properties_sequence {
    shared_sensor_id_rec sensor_id_rec{};
    std::variant<
        no_geometric_properties_variant,
        static_geometric_properties_rec,
        manipulator_geometric_properties_rec> geometric_properties_variant{};
    friend constexpr bool operator==(
        const geometric_properties_sequence&,
        const geometric_properties_sequence&) = default;

    struct schema : wire::items {
        using T = geometric_properties_sequence;
        using type = layout<
            nested<&T::sensor_id_rec>,
            variant<&T::geometric_properties_variant, u8>>;
    };
};

/// ReportSensorGeometricProperties: ID 4805h, output of RangeSensor, VisualSensor.
struct report_sensor_geometric_properties {
    wire::list<geometric_properties_sequence> geometric_properties_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_sensor_geometric_properties&,
        const report_sensor_geometric_properties&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4805;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_sensor_geometric_properties;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::geometric_properties_list, count<"number_of_geometric_properties_list", u16le>>>;
    };
};

} // namespace jauscat::sae::environment_sensing
