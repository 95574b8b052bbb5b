// DigitalVideo 2.0, urn:jaus:jss:environmentSensing:DigitalVideo.
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

/// Values of StreamState.
enum class stream_state : std::uint8_t {
    play = 0,
    pause = 1,
    stop = 2,
};

/// ControlDigitalVideoSensorStream: ID 0805h, command, input of DigitalVideo.
struct control_digital_video_sensor_stream {
    std::uint16_t sensor_id{}; ///< 1 to 65535
    environment_sensing::stream_state stream_state{};
    friend constexpr bool operator==(
        const control_digital_video_sensor_stream&,
        const control_digital_video_sensor_stream&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0805;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = control_digital_video_sensor_stream;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::stream_state, in_value_set<enumeration<environment_sensing::stream_state, u8>, between<0, 2>>>>;
    };
};

/// Values of RequestedRecordingState.
enum class requested_recording_state : std::uint8_t {
    not_recording = 0,
    recording = 1,
};

/// ControlDigitalVideoSensorRecording: ID 0810h, command, input of DigitalVideo.
struct control_digital_video_sensor_recording {
    std::uint16_t sensor_id{}; ///< 1 to 65535
    environment_sensing::requested_recording_state requested_recording_state{};
    friend constexpr bool operator==(
        const control_digital_video_sensor_recording&,
        const control_digital_video_sensor_recording&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0810;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = control_digital_video_sensor_recording;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::requested_recording_state,
                in_value_set<enumeration<environment_sensing::requested_recording_state, u8>, between<0, 1>>>>;
    };
};

/// Record RequestIdRec.
struct digital_video_request_id_rec {
    std::uint8_t request_id{};
    friend constexpr bool operator==(
        const digital_video_request_id_rec&,
        const digital_video_request_id_rec&) = default;

    struct schema : wire::items {
        using T = digital_video_request_id_rec;
        using type = layout<field<&T::request_id, u8>>;
    };
};

/// Values of DigitalFormat.
enum class digital_format : std::uint8_t {
    avi = 0,
    mjpeg = 1,
    mpeg_2 = 2,                      ///< MPEG-2
    h_263_3 = 3,                     ///< H.263
    h_263_4 = 4,                     ///< H.263+
    mpeg_4_visual_mpeg_4_part_2 = 5, ///< MPEG-4 Visual (MPEG-4 Part 2)
    mpeg_4_avc = 6,                  ///< MPEG-4 AVC
};

/// Record DigitalVideoSensorConfigurationRec.
struct digital_video_sensor_configuration_rec {
    std::uint16_t sensor_id{}; ///< 1 to 65535
    std::optional<std::uint16_t> minimum_bit_rate{};
    std::optional<std::uint16_t> maximum_bit_rate{};
    std::optional<std::uint8_t> frame_rate{};
    std::optional<environment_sensing::frame_size> frame_size{};
    std::optional<environment_sensing::digital_format> digital_format{};
    friend constexpr bool operator==(
        const digital_video_sensor_configuration_rec&,
        const digital_video_sensor_configuration_rec&) = default;

    struct schema : wire::items {
        using T = digital_video_sensor_configuration_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
                field<&T::minimum_bit_rate, u16le>,
                field<&T::maximum_bit_rate, u16le>,
                field<&T::frame_rate, u8>,
                field<&T::frame_size, in_value_set<enumeration<environment_sensing::frame_size, u8>, between<0, 28>>>,
                field<&T::digital_format,
                    in_value_set<enumeration<environment_sensing::digital_format, u8>, between<0, 6>>>>>;
    };
};

/// SetDigitalVideoSensorConfiguration: ID 0804h, command, input of DigitalVideo.
struct set_digital_video_sensor_configuration {
    digital_video_request_id_rec request_id_rec{};
    wire::list<digital_video_sensor_configuration_rec> digital_video_sensor_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const set_digital_video_sensor_configuration&,
        const set_digital_video_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0804;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_digital_video_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::request_id_rec>,
            repeated<&T::digital_video_sensor_list, count<"number_of_digital_video_sensor_list", u16le>>>;
    };
};

/// Record QueryDigitalVideoConfigurationRec.
struct query_digital_video_configuration_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    std::uint8_t query_presence_vector{};
    friend constexpr bool operator==(
        const query_digital_video_configuration_rec&,
        const query_digital_video_configuration_rec&) = default;

    struct schema : wire::items {
        using T = query_digital_video_configuration_rec;
        using type = layout<
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>,
            field<&T::query_presence_vector, u8>>;
    };
};

/// QueryDigitalVideoSensorConfiguration: ID 2809h, input of DigitalVideo.
struct query_digital_video_sensor_configuration {
    /// up to 65535 elements
    wire::list<query_digital_video_configuration_rec> query_digital_video_configuration_list{};
    friend constexpr bool operator==(
        const query_digital_video_sensor_configuration&,
        const query_digital_video_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2809;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_digital_video_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::query_digital_video_configuration_list,
                count<"number_of_query_digital_video_configuration_list", u16le>>>;
    };
};

/// Record QueryDigitalVideoSensorCapabilitiesRec.
struct query_digital_video_sensor_capabilities_rec {
    environment_sensing::sensor_id sensor_id{}; ///< 1 to 65535
    std::uint8_t query_presence_vector{};
    friend constexpr bool operator==(
        const query_digital_video_sensor_capabilities_rec&,
        const query_digital_video_sensor_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = query_digital_video_sensor_capabilities_rec;
        using type = layout<
            field<&T::sensor_id, enumeration<environment_sensing::sensor_id, u16le>>,
            field<&T::query_presence_vector, u8>>;
    };
};

/// QueryDigitalVideoSensorCapabilitiesExt: ID 281Dh, input of DigitalVideo.
struct query_digital_video_sensor_capabilities_ext {
    /// up to 65535 elements
    wire::list<query_digital_video_sensor_capabilities_rec> query_digital_video_sensor_capabilities_list{};
    friend constexpr bool operator==(
        const query_digital_video_sensor_capabilities_ext&,
        const query_digital_video_sensor_capabilities_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x281D;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_digital_video_sensor_capabilities_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::query_digital_video_sensor_capabilities_list,
                count<"number_of_query_digital_video_sensor_capabilities_list", u16le>>>;
    };
};

/// QueryDigitalVideoSensorStatus: ID 281Eh, input of DigitalVideo.
struct query_digital_video_sensor_status {
    wire::list<sensor_id_query_rec> sensor_id_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const query_digital_video_sensor_status&,
        const query_digital_video_sensor_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x281E;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_digital_video_sensor_status;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::sensor_id_list, count<"number_of_sensor_id_list", u16le>>>;
    };
};

/// Values of AVI.
enum class avi : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of MJPEG.
enum class mjpeg : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of MPEG2.
enum class mpeg2 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of h263.
enum class h263 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of h263plus.
enum class h263plus : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of MPEG4_Visual.
enum class mpeg4_visual : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Values of MPEG4_AVC_h264.
enum class mpeg4_avc_h264 : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Bits of SupportedDigitalFormats.
struct digital_video_supported_digital_formats {
    environment_sensing::avi avi{};
    environment_sensing::mjpeg mjpeg{};
    environment_sensing::mpeg2 mpeg2{};
    environment_sensing::h263 h263{};
    environment_sensing::h263plus h263plus{};
    environment_sensing::mpeg4_visual mpeg4_visual{};
    environment_sensing::mpeg4_avc_h264 mpeg4_avc_h264{};
    friend constexpr bool operator==(
        const digital_video_supported_digital_formats&,
        const digital_video_supported_digital_formats&) = default;

    struct schema : wire::items {
        using T = digital_video_supported_digital_formats;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::avi, 1>,
                bit_field<&T::mjpeg, 1>,
                bit_field<&T::mpeg2, 1>,
                bit_field<&T::h263, 1>,
                bit_field<&T::h263plus, 1>,
                bit_field<&T::mpeg4_visual, 1>,
                bit_field<&T::mpeg4_avc_h264, 1>,
                reserved<1>>>;
    };
};

/// Values of RecordingSupported.
enum class recording_supported : std::uint8_t {
    unsupported = 0,
    supported = 1,
};

/// Record DigitalVideoSensorCapabilitiesRec.
struct digital_video_sensor_capabilities_rec {
    std::uint16_t sensor_id{}; ///< 1 to 65535
    std::optional<std::uint16_t> minimum_bit_rate{};
    std::optional<std::uint16_t> maximum_bit_rate{};
    std::optional<std::uint8_t> minimum_frame_rate{};
    std::optional<std::uint8_t> maximum_frame_rate{};
    std::optional<environment_sensing::supported_frame_sizes> supported_frame_sizes{};
    std::optional<digital_video_supported_digital_formats> supported_digital_formats{};
    std::optional<environment_sensing::recording_supported> recording_supported{};
    friend constexpr bool operator==(
        const digital_video_sensor_capabilities_rec&,
        const digital_video_sensor_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = digital_video_sensor_capabilities_rec;
        using type = layout<
            lenient_presence<u8,
                field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
                field<&T::minimum_bit_rate, u16le>,
                field<&T::maximum_bit_rate, u16le>,
                field<&T::minimum_frame_rate, u8>,
                field<&T::maximum_frame_rate, u8>,
                nested<&T::supported_frame_sizes>,
                nested<&T::supported_digital_formats>,
                field<&T::recording_supported,
                    in_value_set<enumeration<environment_sensing::recording_supported, u8>, between<0, 1>>>>>;
    };
};

/// ReportDigitalVideoSensorCapabilitiesExt: ID 481Dh, output of DigitalVideo.
struct report_digital_video_sensor_capabilities_ext {
    wire::list<digital_video_sensor_capabilities_rec> digital_video_sensor_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_digital_video_sensor_capabilities_ext&,
        const report_digital_video_sensor_capabilities_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x481D;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_digital_video_sensor_capabilities_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::digital_video_sensor_list, count<"number_of_digital_video_sensor_list", u16le>>>;
    };
};

/// ReportDigitalVideoSensorConfiguration: ID 4809h, output of DigitalVideo.
struct report_digital_video_sensor_configuration {
    /// up to 65535 elements
    wire::list<digital_video_sensor_configuration_rec> digital_video_sensor_configuration_list{};
    friend constexpr bool operator==(
        const report_digital_video_sensor_configuration&,
        const report_digital_video_sensor_configuration&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4809;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_digital_video_sensor_configuration;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::digital_video_sensor_configuration_list,
                count<"number_of_digital_video_sensor_configuration_list", u16le>>>;
    };
};

/// Values of StreamingState.
enum class streaming_state : std::uint8_t {
    play = 0,
    pause = 1,
    stop = 2,
};

/// Values of RecordingState.
enum class recording_state : std::uint8_t {
    not_recording = 0,
    recording = 1,
};

/// Record DigitalVideoSensorStatusRec.
struct digital_video_sensor_status_rec {
    std::uint16_t sensor_id{}; ///< 1 to 65535
    environment_sensing::streaming_state streaming_state{};
    environment_sensing::recording_state recording_state{};
    friend constexpr bool operator==(
        const digital_video_sensor_status_rec&,
        const digital_video_sensor_status_rec&) = default;

    struct schema : wire::items {
        using T = digital_video_sensor_status_rec;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::streaming_state,
                in_value_set<enumeration<environment_sensing::streaming_state, u8>, between<0, 2>>>,
            field<&T::recording_state,
                in_value_set<enumeration<environment_sensing::recording_state, u8>, between<0, 1>>>>;
    };
};

/// ReportDigitalVideoSensorStatus: ID 481Eh, output of DigitalVideo.
struct report_digital_video_sensor_status {
    wire::list<digital_video_sensor_status_rec> digital_video_sensor_status_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(
        const report_digital_video_sensor_status&,
        const report_digital_video_sensor_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x481E;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_digital_video_sensor_status;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::digital_video_sensor_status_list, count<"number_of_digital_video_sensor_status_list", u16le>>>;
    };
};

namespace services {

/// DigitalVideo: what it is called, and its messages.
struct digital_video {
    static constexpr std::string_view name = "DigitalVideo";
    static constexpr std::string_view uri = "urn:jaus:jss:environmentSensing:DigitalVideo";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:environmentSensing:VisualSensor";
    static constexpr std::string_view parent_version = "2.0";
    using inputs = jaus::message_list<
        control_digital_video_sensor_stream,
        control_digital_video_sensor_recording,
        set_digital_video_sensor_configuration,
        query_digital_video_sensor_configuration,
        query_digital_video_sensor_capabilities_ext,
        query_digital_video_sensor_status>;
    using outputs = jaus::message_list<
        report_digital_video_sensor_capabilities_ext,
        report_digital_video_sensor_configuration,
        report_digital_video_sensor_status>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::environment_sensing
