// Environment sensor subgroup of RA 3.3 part 3: cameras, images, relative object positions.
#pragma once
#include <jauscat/schema/jaus/time_stamp.hpp>
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/schema.hpp>

namespace jauscat::jaus {

/// Select Camera: selects a camera.
/// Code 0802h, command class, 1 byte.
struct select_camera {
    static constexpr std::uint16_t command_code = 0x0802;
    std::uint8_t camera_id{}; ///< camera to select
    friend constexpr bool operator==(const select_camera&, const select_camera&) = default;
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
    static constexpr std::uint16_t command_code = 0x0806;
    std::uint8_t camera_id{};                         ///< which camera
    std::optional<jaus::audio_format> audio_format{}; ///< coding of the sound
    std::optional<jaus::image_format> image_format{}; ///< coding of the pictures
    std::optional<std::uint32_t> format_options{};    ///< 32 bits that RA 3.3 leaves open
    friend constexpr bool operator==(const set_camera_format_options&, const set_camera_format_options&) = default;
};

/// Query Camera Pose: asks where a camera is and where it looks.
/// Code 2800h, query class, 3 bytes.
struct query_camera_pose {
    static constexpr std::uint16_t command_code = 0x2800;
    std::uint16_t presence_vector{}; ///< the fields of Report Camera Pose that are asked for
    std::uint8_t camera_id{};        ///< which camera
    friend constexpr bool operator==(const query_camera_pose&, const query_camera_pose&) = default;
};

/// Query Camera Count: asks how many cameras there are.
/// Code 2801h, query class, no body.
struct query_camera_count {
    static constexpr std::uint16_t command_code = 0x2801;
    friend constexpr bool operator==(const query_camera_count&, const query_camera_count&) = default;
};

/// Query Relative Object Position: asks where an object is.
/// Code 2802h, query class, 1 byte.
struct query_relative_object_position {
    static constexpr std::uint16_t command_code = 0x2802;
    std::uint8_t presence_vector{}; ///< the fields of Report Relative Object Position that are asked for
    friend constexpr bool operator==(const query_relative_object_position&,
                                     const query_relative_object_position&) = default;
};

/// Query Selected Camera: asks which camera is selected.
/// Code 2804h, query class, no body.
struct query_selected_camera {
    static constexpr std::uint16_t command_code = 0x2804;
    friend constexpr bool operator==(const query_selected_camera&, const query_selected_camera&) = default;
};

/// Query Camera Capabilities: asks what a camera can do.
/// Code 2805h, query class, 3 bytes.
struct query_camera_capabilities {
    static constexpr std::uint16_t command_code = 0x2805;
    std::uint16_t presence_vector{}; ///< the fields of Report Camera Capabilities that are asked for
    std::uint8_t camera_id{};        ///< which camera
    friend constexpr bool operator==(const query_camera_capabilities&, const query_camera_capabilities&) = default;
};

/// Query Camera Format Options: asks which codings of sound and pictures a camera has.
/// Code 2806h, query class, 2 bytes.
struct query_camera_format_options {
    static constexpr std::uint16_t command_code = 0x2806;
    std::uint8_t presence_vector{}; ///< the fields of Report Camera Format Options that are asked for
    std::uint8_t camera_id{};       ///< which camera
    friend constexpr bool operator==(const query_camera_format_options&, const query_camera_format_options&) = default;
};

/// Query Image: asks for an image.
/// Code 2807h, query class, no body.
struct query_image {
    static constexpr std::uint16_t command_code = 0x2807;
    friend constexpr bool operator==(const query_image&, const query_image&) = default;
};

/// Report Camera Count: how many cameras there are.
/// Code 4801h, inform class, 1 byte.
struct report_camera_count {
    static constexpr std::uint16_t command_code = 0x4801;
    std::uint8_t camera_count{}; ///< cameras
    friend constexpr bool operator==(const report_camera_count&, const report_camera_count&) = default;
};

/// Report Relative Object Position: where an object is, in range, bearing and inclination.
/// Code 4802h, inform class, 5 to 32 bytes. Some peers take bit 6 for Object ID too: to those send bits 6 and 7
/// together or not at all.
struct report_relative_object_position {
    static constexpr std::uint16_t command_code = 0x4802;
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
};

/// Report Selected Camera: which camera is selected.
/// Code 4804h, inform class, 1 byte.
struct report_selected_camera {
    static constexpr std::uint16_t command_code = 0x4804;
    std::uint8_t camera_id{}; ///< camera selected
    friend constexpr bool operator==(const report_selected_camera&, const report_selected_camera&) = default;
};

/// Report Camera Format Options: the codings of sound and pictures that a camera has.
/// Code 4806h, inform class, 2 to 12 bytes.
struct report_camera_format_options {
    static constexpr std::uint16_t command_code = 0x4806;
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
};

} // namespace jauscat::jaus

// One line per field, as in the standard's table.
// clang-format off
namespace jauscat {

template <> struct wire::schema<jaus::select_camera> {
    using T = jaus::select_camera;
    using type = layout<field<&T::camera_id, u8>>;
};

template <> struct wire::schema<jaus::set_camera_format_options> {
    using T = jaus::set_camera_format_options;
    using type = layout<
        presence<u8,
            field<&T::camera_id, u8>,
            field<&T::audio_format, enumeration<jaus::audio_format, u8>>,
            field<&T::image_format, enumeration<jaus::image_format, u8>>,
            field<&T::format_options, u32le>>>;
};

template <> struct wire::schema<jaus::query_camera_pose> {
    using T = jaus::query_camera_pose;
    using type = layout<
        field<&T::presence_vector, u16le>,
        field<&T::camera_id, u8>>;
};

template <> struct wire::schema<jaus::query_camera_count> { using type = layout<>; };

template <> struct wire::schema<jaus::query_relative_object_position> {
    using T = jaus::query_relative_object_position;
    using type = layout<field<&T::presence_vector, u8>>;
};

template <> struct wire::schema<jaus::query_selected_camera> { using type = layout<>; };

template <> struct wire::schema<jaus::query_camera_capabilities> {
    using T = jaus::query_camera_capabilities;
    using type = layout<
        field<&T::presence_vector, u16le>,
        field<&T::camera_id, u8>>;
};

template <> struct wire::schema<jaus::query_camera_format_options> {
    using T = jaus::query_camera_format_options;
    using type = layout<
        field<&T::presence_vector, u8>,
        field<&T::camera_id, u8>>;
};

template <> struct wire::schema<jaus::query_image> { using type = layout<>; };

template <> struct wire::schema<jaus::report_camera_count> {
    using T = jaus::report_camera_count;
    using type = layout<field<&T::camera_count, u8>>;
};

template <> struct wire::schema<jaus::report_relative_object_position> {
    using T = jaus::report_relative_object_position;
    using type = layout<
        presence<u8,
            nested<&T::time_stamp>,
            field<&T::range, scaled<i32le, jaus::object_range>>,
            field<&T::range_error, scaled<u32le, jaus::object_range_error>>,
            field<&T::bearing, scaled<i32le, jaus::signed_angle>>,
            field<&T::bearing_error, scaled<u32le, jaus::positive_angle>>,
            field<&T::inclination, scaled<i32le, jaus::signed_angle>>,
            field<&T::inclination_error, scaled<u32le, jaus::positive_angle>>,
            field<&T::confidence, u8>,
            field<&T::object_id, u16le>>>;
};

template <> struct wire::schema<jaus::report_selected_camera> {
    using T = jaus::report_selected_camera;
    using type = layout<field<&T::camera_id, u8>>;
};

template <> struct wire::schema<jaus::report_camera_format_options> {
    using T = jaus::report_camera_format_options;
    using type = layout<
        presence<u8,
            field<&T::camera_id, u8>,
            field<&T::audio_format_1, enumeration<jaus::audio_format, u8>>,
            field<&T::audio_format_2, enumeration<jaus::audio_format, u8>>,
            field<&T::image_format_1, enumeration<jaus::image_format, u8>>,
            field<&T::image_format_2, enumeration<jaus::image_format, u8>>,
            field<&T::image_format_3, enumeration<jaus::image_format, u8>>,
            field<&T::image_format_4, enumeration<jaus::image_format, u8>>,
            field<&T::format_options, u32le>>>;
};

} // namespace jauscat
