// Environment sensor subgroup of RA 3.3 part 3: cameras, images, relative object positions.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/jaus/time_stamp.hpp>
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/schema.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// Axes of Set Camera Pose whose value is a rate; a position where the bit is clear. Bit numbers.
enum class mode_indicator : std::uint8_t {
    linear_x_is_a_rate = 0,
    linear_y_is_a_rate = 1,
    linear_z_is_a_rate = 2,
    angular_x_is_a_rate = 3,
    angular_y_is_a_rate = 4,
    angular_z_is_a_rate = 5,
};

/// Set Camera Pose: moves a camera along and about its axes.
/// Code 0801h, command class, 3 to 15 bytes.
struct set_camera_pose {
    std::uint8_t camera_id{};                               ///< which camera
    wire::bit_set<jaus::mode_indicator> mode_indicator{};   ///< axes given as rates
    std::optional<double> linear_x_displacement_or_rate{};  ///< percent, -100 to 100
    std::optional<double> linear_y_displacement_or_rate{};  ///< percent, -100 to 100
    std::optional<double> linear_z_displacement_or_rate{};  ///< percent, -100 to 100
    std::optional<double> angular_x_displacement_or_rate{}; ///< percent, -100 to 100
    std::optional<double> angular_y_displacement_or_rate{}; ///< percent, -100 to 100
    std::optional<double> angular_z_displacement_or_rate{}; ///< percent, -100 to 100
    friend constexpr bool operator==(const set_camera_pose&, const set_camera_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0801;
        using T = set_camera_pose;
        using type = layout<
            lenient_presence<u8,
                field<&T::camera_id, u8>,
                field<&T::mode_indicator, bit_set_codec<jaus::mode_indicator, u8>>,
                field<&T::linear_x_displacement_or_rate, scaled<i16le, signed_percent>>,
                field<&T::linear_y_displacement_or_rate, scaled<i16le, signed_percent>>,
                field<&T::linear_z_displacement_or_rate, scaled<i16le, signed_percent>>,
                field<&T::angular_x_displacement_or_rate, scaled<i16le, signed_percent>>,
                field<&T::angular_y_displacement_or_rate, scaled<i16le, signed_percent>>,
                field<&T::angular_z_displacement_or_rate, scaled<i16le, signed_percent>>>>;
    };
};

/// Select Camera: selects a camera.
/// Code 0802h, command class, 1 byte.
struct select_camera {
    std::uint8_t camera_id{}; ///< camera to select
    friend constexpr bool operator==(const select_camera&, const select_camera&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0802;
        using T = select_camera;
        using type = layout<field<&T::camera_id, u8>>;
    };
};

/// Controls of a camera's picture. Bit numbers.
enum class imaging_controls : std::uint16_t {
    auto_focus = 0,
    auto_exposure_iris = 1,
    image_stabilization = 2,
    white_balance = 3,
    sync_flash_strobe = 4,
    red_eye = 5,
    auto_shutter = 6,
    video_auto_gain = 7,
    interlaced_video = 8,
};

/// Controls of a camera's sound. Bit numbers.
enum class audio_controls : std::uint16_t {
    audio_enabled = 0,
    auto_gain = 1,
    stereo_audio = 2,
    directional_audio = 3,
    front_microphone = 4,
    rear_microphone = 5,
    left_microphone = 6,
    right_microphone = 7,
};

/// Set Camera Capabilities: sets lens, resolution, exposure and sound of a camera.
/// Code 0805h, command class, 3 to 22 bytes. Some peers take bit 7 for Shutter Speed, Imaging Controls and Audio
/// Controls too: to those send bits 7 to 10 together or not at all.
struct set_camera_capabilities {
    std::uint8_t camera_id{};                                                ///< which camera
    std::optional<double> horizontal_fov{};                                  ///< radians, 0 to pi
    std::optional<double> vertical_fov{};                                    ///< radians, 0 to pi
    std::optional<std::uint16_t> horizontal_resolution{};                    ///< pixels
    std::optional<std::uint16_t> vertical_resolution{};                      ///< pixels
    std::optional<double> focus{};                                           ///< percent, 0 to 100
    std::optional<double> iris{};                                            ///< percent, 0 to 100
    std::optional<double> gain{};                                            ///< percent, 0 to 100
    std::optional<std::uint16_t> frame_rate{};                               ///< frames per second
    std::optional<std::uint16_t> shutter_speed{};                            ///< seconds
    std::optional<wire::bit_set<jaus::imaging_controls>> imaging_controls{}; ///< what to switch on
    std::optional<wire::bit_set<jaus::audio_controls>> audio_controls{};     ///< what to switch on
    friend constexpr bool operator==(const set_camera_capabilities&, const set_camera_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0805;
        using T = set_camera_capabilities;
        using type = layout<
            lenient_presence<u16le,
                field<&T::camera_id, u8>,
                field<&T::horizontal_fov, scaled<u16le, positive_angle>>,
                field<&T::vertical_fov, scaled<u16le, positive_angle>>,
                field<&T::horizontal_resolution, in_units<u16le, pixels>>,
                field<&T::vertical_resolution, in_units<u16le, pixels>>,
                field<&T::focus, scaled<u8, percent>>,
                field<&T::iris, scaled<u8, percent>>,
                field<&T::gain, scaled<u8, percent>>,
                field<&T::frame_rate, in_units<u16le, frames_per_second>>,
                field<&T::shutter_speed, in_units<u16le, whole_seconds>>,
                field<&T::imaging_controls, bit_set_codec<jaus::imaging_controls, u16le>>,
                field<&T::audio_controls, bit_set_codec<jaus::audio_controls, u16le>>>>;
    };
};

/// Coding of a camera's sound. Other values are not assigned.
enum class audio_format : std::uint8_t {
    unused = 0,
    raw = 1,
    pcm = 2,
    au = 3,
    wav = 4,
    mid = 5,
    mp3 = 6,
    mp2 = 7,
    asf = 8,
};

/// Coding of a camera's pictures. Other values are not assigned.
enum class image_format : std::uint8_t {
    unused = 0,
    mpeg2 = 1,
    mpeg4 = 2,
    mjpeg = 3,
    ntsc = 4,
    pal = 5,
    tiff = 6,
    jpeg = 7,
    gif = 8,
    h263 = 9,
    h264 = 10,
    png = 11,
    bmp = 12,
    raw = 13,
    ppm = 14,
    pgm = 15,
    pnm = 16,
};

/// Set Camera Format Options: chooses the coding of sound and pictures.
/// Code 0806h, command class, 2 to 8 bytes.
struct set_camera_format_options {
    std::uint8_t camera_id{};                         ///< which camera
    std::optional<jaus::audio_format> audio_format{}; ///< coding of the sound
    std::optional<jaus::image_format> image_format{}; ///< coding of the pictures
    std::optional<std::uint32_t> format_options{};    ///< 32 bits that RA 3.3 leaves open
    friend constexpr bool operator==(const set_camera_format_options&, const set_camera_format_options&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0806;
        using T = set_camera_format_options;
        using type = layout<
            lenient_presence<u8,
                field<&T::camera_id, u8>,
                field<&T::audio_format, enumeration<jaus::audio_format, u8>>,
                field<&T::image_format, enumeration<jaus::image_format, u8>>,
                field<&T::format_options, u32le>>>;
    };
};

/// Query Camera Pose: requests position and direction of a camera.
/// Code 2800h, query class, 3 bytes.
struct query_camera_pose {
    std::uint16_t presence_vector{}; ///< the requested fields of Report Camera Pose
    std::uint8_t camera_id{};        ///< which camera
    friend constexpr bool operator==(const query_camera_pose&, const query_camera_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2800;
        using report = struct report_camera_pose;
        using T = query_camera_pose;
        using type = layout<
            field<&T::presence_vector, u16le>,
            field<&T::camera_id, u8>>;
    };
};

/// Query Camera Count: requests the number of cameras.
/// Code 2801h, query class, no body.
struct query_camera_count {
    friend constexpr bool operator==(const query_camera_count&, const query_camera_count&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2801;
        using report = struct report_camera_count;
        using type = layout<>;
    };
};

/// Query Relative Object Position: requests the position of an object.
/// Code 2802h, query class, 1 byte.
struct query_relative_object_position {
    std::uint8_t presence_vector{}; ///< the requested fields of Report Relative Object Position
    friend constexpr bool operator==(const query_relative_object_position&,
                                     const query_relative_object_position&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2802;
        using report = struct report_relative_object_position;
        using T = query_relative_object_position;
        using type = layout<field<&T::presence_vector, u8>>;
    };
};

/// Query Selected Camera: requests the selected camera.
/// Code 2804h, query class, no body.
struct query_selected_camera {
    friend constexpr bool operator==(const query_selected_camera&, const query_selected_camera&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2804;
        using report = struct report_selected_camera;
        using type = layout<>;
    };
};

/// Query Camera Capabilities: requests the functions of a camera.
/// Code 2805h, query class, 3 bytes.
struct query_camera_capabilities {
    std::uint16_t presence_vector{}; ///< the requested fields of Report Camera Capabilities
    std::uint8_t camera_id{};        ///< which camera
    friend constexpr bool operator==(const query_camera_capabilities&, const query_camera_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2805;
        using report = struct report_camera_capabilities;
        using T = query_camera_capabilities;
        using type = layout<
            field<&T::presence_vector, u16le>,
            field<&T::camera_id, u8>>;
    };
};

/// Query Camera Format Options: requests the codings of sound and pictures of a camera.
/// Code 2806h, query class, 2 bytes.
struct query_camera_format_options {
    std::uint8_t presence_vector{}; ///< the requested fields of Report Camera Format Options
    std::uint8_t camera_id{};       ///< which camera
    friend constexpr bool operator==(const query_camera_format_options&, const query_camera_format_options&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2806;
        using report = struct report_camera_format_options;
        using T = query_camera_format_options;
        using type = layout<
            field<&T::presence_vector, u8>,
            field<&T::camera_id, u8>>;
    };
};

/// Query Image: asks for an image.
/// Code 2807h, query class, no body.
struct query_image {
    friend constexpr bool operator==(const query_image&, const query_image&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2807;
        using report = struct report_image;
        using type = layout<>;
    };
};

/// Report Camera Pose: where a camera is and where it looks.
/// Code 4800h, inform class, 3 to 36 bytes.
struct report_camera_pose {
    std::uint8_t camera_id{};                                 ///< which camera
    std::optional<std::string_view> camera_name{};            ///< up to 15 characters
    std::optional<double> x_camera_origin{};                  ///< metres, -32.767 to 32.767
    std::optional<double> y_camera_origin{};                  ///< metres, -32.767 to 32.767
    std::optional<double> z_camera_origin{};                  ///< metres, -32.767 to 32.767
    std::optional<double> x_camera_axis_direction_cosine_x{}; ///< -1 to 1
    std::optional<double> x_camera_axis_direction_cosine_y{}; ///< -1 to 1
    std::optional<double> x_camera_axis_direction_cosine_z{}; ///< -1 to 1
    std::optional<double> z_camera_axis_direction_cosine_x{}; ///< -1 to 1
    std::optional<double> z_camera_axis_direction_cosine_y{}; ///< -1 to 1
    std::optional<double> z_camera_axis_direction_cosine_z{}; ///< -1 to 1
    friend constexpr bool operator==(const report_camera_pose&, const report_camera_pose&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4800;
        using query = query_camera_pose;
        using T = report_camera_pose;
        using type = layout<
            lenient_presence<u16le,
                field<&T::camera_id, u8>,
                string<&T::camera_name, fixed<15>>,
                field<&T::x_camera_origin, scaled<i16le, camera_origin>>,
                field<&T::y_camera_origin, scaled<i16le, camera_origin>>,
                field<&T::z_camera_origin, scaled<i16le, camera_origin>>,
                field<&T::x_camera_axis_direction_cosine_x, scaled<i16le, unit_vector_component>>,
                field<&T::x_camera_axis_direction_cosine_y, scaled<i16le, unit_vector_component>>,
                field<&T::x_camera_axis_direction_cosine_z, scaled<i16le, unit_vector_component>>,
                field<&T::z_camera_axis_direction_cosine_x, scaled<i16le, unit_vector_component>>,
                field<&T::z_camera_axis_direction_cosine_y, scaled<i16le, unit_vector_component>>,
                field<&T::z_camera_axis_direction_cosine_z, scaled<i16le, unit_vector_component>>>>;
    };
};

/// Report Camera Count: how many cameras there are.
/// Code 4801h, inform class, 1 byte.
struct report_camera_count {
    std::uint8_t camera_count{}; ///< cameras
    friend constexpr bool operator==(const report_camera_count&, const report_camera_count&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4801;
        using query = query_camera_count;
        using T = report_camera_count;
        using type = layout<field<&T::camera_count, u8>>;
    };
};

/// Report Relative Object Position: where an object is, in range, bearing and inclination.
/// Code 4802h, inform class, 5 to 32 bytes. Some peers take bit 6 for Object ID too: to those send bits 6 and 7
/// together or not at all.
struct report_relative_object_position {
    jaus::time_stamp time_stamp{};             ///< time of the measurement
    std::optional<double> range{};             ///< metres, -10000 to 10000
    std::optional<double> range_error{};       ///< metres, 0 to 1000
    std::optional<double> bearing{};           ///< radians, -pi to pi
    std::optional<double> bearing_error{};     ///< radians, 0 to pi
    std::optional<double> inclination{};       ///< radians, -pi to pi
    std::optional<double> inclination_error{}; ///< radians, 0 to pi
    std::optional<std::uint8_t> confidence{};  ///< 0 to 255
    std::optional<std::uint16_t> object_id{};  ///< which object
    friend constexpr bool operator==(const report_relative_object_position&,
                                     const report_relative_object_position&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4802;
        using query = query_relative_object_position;
        using T = report_relative_object_position;
        using type = layout<
            lenient_presence<u8,
                nested<&T::time_stamp>,
                field<&T::range, scaled<i32le, object_range>>,
                field<&T::range_error, scaled<u32le, object_range_error>>,
                field<&T::bearing, scaled<i32le, signed_angle>>,
                field<&T::bearing_error, scaled<u32le, positive_angle>>,
                field<&T::inclination, scaled<i32le, signed_angle>>,
                field<&T::inclination_error, scaled<u32le, positive_angle>>,
                field<&T::confidence, u8>,
                field<&T::object_id, u16le>>>;
    };
};

/// Report Selected Camera: which camera is selected.
/// Code 4804h, inform class, 1 byte.
struct report_selected_camera {
    std::uint8_t camera_id{}; ///< camera selected
    friend constexpr bool operator==(const report_selected_camera&, const report_selected_camera&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4804;
        using query = query_selected_camera;
        using T = report_selected_camera;
        using type = layout<field<&T::camera_id, u8>>;
    };
};

/// Report Camera Capabilities: the functions of a camera; a control bit means that the control is available.
/// Code 4805h, inform class, 3 to 81 bytes.
struct report_camera_capabilities {
    std::uint8_t camera_id{};                                                ///< which camera
    std::optional<std::string_view> description{};                           ///< up to 50 characters
    std::optional<double> maximum_horizontal_fov{};                          ///< radians, 0 to pi
    std::optional<double> minimum_horizontal_fov{};                          ///< radians, 0 to pi
    std::optional<double> maximum_vertical_fov{};                            ///< radians, 0 to pi
    std::optional<double> minimum_vertical_fov{};                            ///< radians, 0 to pi
    std::optional<std::uint16_t> maximum_horizontal_resolution{};            ///< pixels
    std::optional<std::uint16_t> minimum_horizontal_resolution{};            ///< pixels
    std::optional<std::uint16_t> maximum_vertical_resolution{};              ///< pixels
    std::optional<std::uint16_t> minimum_vertical_resolution{};              ///< pixels
    std::optional<std::uint16_t> maximum_frame_rate{};                       ///< frames per second
    std::optional<std::uint16_t> minimum_frame_rate{};                       ///< frames per second
    std::optional<std::uint16_t> maximum_shutter_speed{};                    ///< seconds
    std::optional<std::uint16_t> minimum_shutter_speed{};                    ///< seconds
    std::optional<wire::bit_set<jaus::imaging_controls>> imaging_controls{}; ///< what is available
    std::optional<wire::bit_set<jaus::audio_controls>> audio_controls{};     ///< what is available
    friend constexpr bool operator==(const report_camera_capabilities&, const report_camera_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4805;
        using query = query_camera_capabilities;
        using T = report_camera_capabilities;
        using type = layout<
            lenient_presence<u16le,
                field<&T::camera_id, u8>,
                string<&T::description, fixed<50>>,
                field<&T::maximum_horizontal_fov, scaled<u16le, positive_angle>>,
                field<&T::minimum_horizontal_fov, scaled<u16le, positive_angle>>,
                field<&T::maximum_vertical_fov, scaled<u16le, positive_angle>>,
                field<&T::minimum_vertical_fov, scaled<u16le, positive_angle>>,
                field<&T::maximum_horizontal_resolution, in_units<u16le, pixels>>,
                field<&T::minimum_horizontal_resolution, in_units<u16le, pixels>>,
                field<&T::maximum_vertical_resolution, in_units<u16le, pixels>>,
                field<&T::minimum_vertical_resolution, in_units<u16le, pixels>>,
                field<&T::maximum_frame_rate, in_units<u16le, frames_per_second>>,
                field<&T::minimum_frame_rate, in_units<u16le, frames_per_second>>,
                field<&T::maximum_shutter_speed, in_units<u16le, whole_seconds>>,
                field<&T::minimum_shutter_speed, in_units<u16le, whole_seconds>>,
                field<&T::imaging_controls, bit_set_codec<jaus::imaging_controls, u16le>>,
                field<&T::audio_controls, bit_set_codec<jaus::audio_controls, u16le>>>>;
    };
};

/// Report Camera Format Options: the codings of sound and pictures that a camera has.
/// Code 4806h, inform class, 2 to 12 bytes.
struct report_camera_format_options {
    std::uint8_t camera_id{};                      ///< which camera
    std::optional<audio_format> audio_format_1{};  ///< coding of sound available
    std::optional<audio_format> audio_format_2{};  ///< coding of sound available
    std::optional<image_format> image_format_1{};  ///< coding of pictures available
    std::optional<image_format> image_format_2{};  ///< coding of pictures available
    std::optional<image_format> image_format_3{};  ///< coding of pictures available
    std::optional<image_format> image_format_4{};  ///< coding of pictures available
    std::optional<std::uint32_t> format_options{}; ///< 32 bits that RA 3.3 leaves open
    friend constexpr bool operator==(const report_camera_format_options&,
                                     const report_camera_format_options&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4806;
        using query = query_camera_format_options;
        using T = report_camera_format_options;
        using type = layout<
            lenient_presence<u8,
                field<&T::camera_id, u8>,
                field<&T::audio_format_1, enumeration<audio_format, u8>>,
                field<&T::audio_format_2, enumeration<audio_format, u8>>,
                field<&T::image_format_1, enumeration<image_format, u8>>,
                field<&T::image_format_2, enumeration<image_format, u8>>,
                field<&T::image_format_3, enumeration<image_format, u8>>,
                field<&T::image_format_4, enumeration<image_format, u8>>,
                field<&T::format_options, u32le>>>;
    };
};

/// Report Image: an image; a large one comes in several packets.
/// Code 4807h, inform class, 2 bytes or more. Contested: some peers send the image data alone.
struct report_image {
    std::uint8_t camera_id{};    ///< which camera
    image_format video_format{}; ///< coding of the image
    wire::blob image_data{};     ///< in the coding above
    friend constexpr bool operator==(const report_image&, const report_image&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4807;
        using query = query_image;
        using T = report_image;
        using type = layout<
            field<&T::camera_id, u8>,
            field<&T::video_format, enumeration<image_format, u8>>,
            bytes<&T::image_data, rest>>;
    };
};

/// The messages of the subgroup, by command code.
using environment_sensor_subgroup = message_list<
    set_camera_pose,
    select_camera,
    set_camera_capabilities,
    set_camera_format_options,
    query_camera_pose,
    query_camera_count,
    query_relative_object_position,
    query_selected_camera,
    query_camera_capabilities,
    query_camera_format_options,
    query_image,
    report_camera_pose,
    report_camera_count,
    report_relative_object_position,
    report_selected_camera,
    report_camera_capabilities,
    report_camera_format_options,
    report_image>;

} // namespace jauscat::jaus
