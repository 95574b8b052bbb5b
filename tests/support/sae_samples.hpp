// Messages of SAE JAUS, one for each construct of JSIDL, written by hand.
#pragma once
#include <jauscat/wire/wire.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// clang-format off
namespace sae {

namespace wire = jauscat::wire;

struct update_rate { static constexpr double min = 0, max = 1092; };
struct position { static constexpr double min = -20'000'000, max = 20'000'000; };
struct altitude { static constexpr double min = -50'000, max = 50'000; };
struct latitude { static constexpr double min = -90, max = 90; };
struct longitude { static constexpr double min = -180, max = 180; };
struct speed { static constexpr double min = 0, max = 327.67; };
struct velocity { static constexpr double min = -327.68, max = 327.67; };
struct gps_altitude { static constexpr double min = -10'000, max = 35'000; };
struct sensor_position { static constexpr double min = -30, max = 30; };
struct quaternion { static constexpr double min = -1, max = 1; };
struct range { static constexpr double min = 0, max = 1'000'000; };
struct range_error { static constexpr double min = 0, max = 100'000; };
struct angle { static constexpr double min = -3.141592653589793, max = 3.141592653589793; };
struct angle_error { static constexpr double min = 0, max = 3.141592653589793; };

enum class event_type : std::uint8_t { periodic, every_change };

/// A message inside a message.
struct create_event {
    std::uint8_t request_id{};
    sae::event_type event_type{};
    double requested_periodic_rate{};
    wire::embedded_message query_message{};
    friend constexpr bool operator==(const create_event&, const create_event&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x01F0;
        using T = create_event;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::request_id, u8>,
            field<&T::event_type, in_value_set<enumeration<sae::event_type, u8>, between<0, 1>>>,
            field<&T::requested_periodic_rate, scaled<u16le, update_rate>>,
            embedded<&T::query_message, count_between<"query_message_size", u32le, 2, 2147483647>>>;
    };
};

/// A variant as the whole body.
struct message_id_rec {
    std::uint16_t message_code{};
    friend constexpr bool operator==(const message_id_rec&, const message_id_rec&) = default;
    struct schema : wire::items { using type = layout<field<&message_id_rec::message_code, u16le>>; };
};
struct event_type_rec {
    sae::event_type event_type{};
    friend constexpr bool operator==(const event_type_rec&, const event_type_rec&) = default;
    struct schema : wire::items { using type = layout<field<&event_type_rec::event_type, in_value_set<enumeration<sae::event_type, u8>, between<0, 1>>>>; };
};
struct event_id_rec {
    std::uint8_t event_id{};
    friend constexpr bool operator==(const event_id_rec&, const event_id_rec&) = default;
    struct schema : wire::items { using type = layout<field<&event_id_rec::event_id, u8>>; };
};
struct all_events_rec {
    std::uint8_t all_events{};
    friend constexpr bool operator==(const all_events_rec&, const all_events_rec&) = default;
    struct schema : wire::items { using type = layout<field<&all_events_rec::all_events, in_value_set<u8, one_of<0>>>>; };
};
struct query_events {
    std::variant<message_id_rec, event_type_rec, event_id_rec, all_events_rec> query_events_var{};
    friend constexpr bool operator==(const query_events&, const query_events&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x21F0;
        using T = query_events;
        using type = layout<constant<"message_id", u16le, message_id>, variant<&T::query_events_var, u8>>;
    };
};

/// A fixed string that may be absent.
struct reject_event_request {
    std::uint8_t request_id{};
    std::optional<std::uint8_t> response_code{};
    std::optional<std::string_view> error_message{};
    friend constexpr bool operator==(const reject_event_request&, const reject_event_request&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x01F4;
        using T = reject_event_request;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            presence<u8,
                field<&T::request_id, u8>,
                field<&T::response_code, in_value_set<u8, between<1, 6>>>,
                string<&T::error_message, fixed<80>>>>;
    };
};

/// A blob with a format.
enum class element_format : std::uint8_t { jaus_message, user_defined };
struct element_data {
    element_format format{};
    wire::embedded_message data{};
    friend constexpr bool operator==(const element_data&, const element_data&) = default;
    struct schema : wire::items {
        using T = element_data;
        using type = layout<
            field<&T::format, in_value_set<enumeration<element_format, u8>, between<0, 1>>>,
            embedded<&T::data, count<"data_size", u16le>>>;
    };
};
struct element_rec {
    std::uint16_t element_uid{};
    std::uint16_t previous_uid{};
    std::uint16_t next_uid{};
    sae::element_data element_data{};
    friend constexpr bool operator==(const element_rec&, const element_rec&) = default;
    struct schema : wire::items {
        using T = element_rec;
        using type = layout<
            field<&T::element_uid, u16le>,
            field<&T::previous_uid, u16le>,
            field<&T::next_uid, u16le>,
            nested<&T::element_data>>;
    };
};
struct set_element {
    std::uint8_t request_id{};
    wire::list<element_rec> element_list{};
    friend constexpr bool operator==(const set_element&, const set_element&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x041A;
        using T = set_element;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::request_id, u8>,
            repeated<&T::element_list, count<"number_of_element_list", u8>>>;
    };
};

/// Lists of lists; a number whose index selects its scale.
struct z_position {
    std::uint8_t index{};
    double value{};
    friend constexpr bool operator==(const z_position&, const z_position&) = default;
    struct schema : wire::items {
        using T = z_position;
        using type = layout<
            field<&T::index, u8>,
            selected<&T::value, by<&T::index>,
                when<std::uint8_t{0}, scaled<u32le, altitude>>,
                when<std::uint8_t{1}, scaled<u32le, altitude>>,
                when<std::uint8_t{2}, scaled<u32le, altitude>>,
                when<std::uint8_t{3}, scaled<u32le, altitude>>,
                when<std::uint8_t{4}, scaled<u32le, altitude>>>>;
    };
};
struct polygon_point {
    double x{};
    double y{};
    std::optional<z_position> min_z_position{};
    std::optional<z_position> max_z_position{};
    friend constexpr bool operator==(const polygon_point&, const polygon_point&) = default;
    struct schema : wire::items {
        using T = polygon_point;
        using type = layout<
            presence<u8,
                field<&T::x, scaled<u32le, position>>,
                field<&T::y, scaled<u32le, position>>,
                nested<&T::min_z_position>,
                nested<&T::max_z_position>>>;
    };
};
struct exclusion_zone_point {
    std::uint16_t zone_id{};
    polygon_point point{};
    friend constexpr bool operator==(const exclusion_zone_point&, const exclusion_zone_point&) = default;
    struct schema : wire::items {
        using T = exclusion_zone_point;
        using type = layout<
            field<&T::zone_id, in_value_set<u16le, one_of<0, 1>, between<2, 65535>>>,
            nested<&T::point>>;
    };
};
struct exclusion_zone {
    wire::list<exclusion_zone_point> points{};
    friend constexpr bool operator==(const exclusion_zone&, const exclusion_zone&) = default;
    struct schema : wire::items { using type = layout<repeated<&exclusion_zone::points, count<"number_of_points", u8>>>; };
};
struct set_local_operating_zone {
    wire::list<polygon_point> local_operating_zone{};
    wire::list<exclusion_zone> local_exclusion_zones{};
    friend constexpr bool operator==(const set_local_operating_zone&, const set_local_operating_zone&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0427;
        using T = set_local_operating_zone;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::local_operating_zone, count<"number_of_local_operating_zone", u8>>,
            repeated<&T::local_exclusion_zones, count<"number_of_local_exclusion_zones", u8>>>;
    };
};

/// Arrays; a variant without alternatives.
struct no_geometric_properties {
    friend constexpr bool operator==(const no_geometric_properties&, const no_geometric_properties&) = default;
    struct schema : wire::items { using type = layout<constant<"index", u8, 0>>; };
};
struct static_geometric_properties {
    std::array<double, 3> sensor_position{};
    std::array<double, 4> unit_quaternion{};
    friend constexpr bool operator==(const static_geometric_properties&, const static_geometric_properties&) = default;
    struct schema : wire::items {
        using T = static_geometric_properties;
        using type = layout<
            array<&T::sensor_position, scaled<u32le, sae::sensor_position>>,
            array<&T::unit_quaternion, scaled<u32le, quaternion>>>;
    };
};
struct manipulator_geometric_properties {
    std::uint16_t subsystem_id{};
    std::uint8_t node_id{};
    std::uint8_t component_id{};
    std::uint8_t joint_number{};
    std::array<double, 3> sensor_position{};
    std::array<double, 4> unit_quaternion{};
    friend constexpr bool operator==(const manipulator_geometric_properties&, const manipulator_geometric_properties&) = default;
    struct schema : wire::items {
        using T = manipulator_geometric_properties;
        using type = layout<
            field<&T::subsystem_id, u16le>,
            field<&T::node_id, u8>,
            field<&T::component_id, u8>,
            field<&T::joint_number, u8>,
            array<&T::sensor_position, scaled<u32le, sae::sensor_position>>,
            array<&T::unit_quaternion, scaled<u32le, quaternion>>>;
    };
};
struct geometric_properties {
    std::uint16_t sensor_id{};
    std::variant<no_geometric_properties, static_geometric_properties, manipulator_geometric_properties> properties{};
    friend constexpr bool operator==(const geometric_properties&, const geometric_properties&) = default;
    struct schema : wire::items {
        using T = geometric_properties;
        using type = layout<field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>, variant<&T::properties, u8>>;
    };
};
struct report_sensor_geometric_properties {
    wire::list<geometric_properties> geometric_properties_list{};
    friend constexpr bool operator==(const report_sensor_geometric_properties&, const report_sensor_geometric_properties&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4805;
        using T = report_sensor_geometric_properties;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::geometric_properties_list, count<"number_of_geometric_properties_list", u16le>>>;
    };
};

/// A variant in an optional slot.
struct gps_fix {
    std::uint32_t time_seconds{};
    std::uint32_t time_nano_seconds{};
    std::optional<double> latitude{};
    std::optional<double> longitude{};
    std::optional<double> true_course{};
    std::optional<double> speed_over_ground{};
    friend constexpr bool operator==(const gps_fix&, const gps_fix&) = default;
    struct schema : wire::items {
        using T = gps_fix;
        using type = layout<
            presence<u8,
                field<&T::time_seconds, u32le>,
                field<&T::time_nano_seconds, u32le>,
                field<&T::latitude, scaled<u32le, sae::latitude>>,
                field<&T::longitude, scaled<u32le, sae::longitude>>,
                field<&T::true_course, scaled<u32le, sae::longitude>>,
                field<&T::speed_over_ground, scaled<u16le, sae::speed>>>>;
    };
};
struct min_gps {
    std::uint8_t validity{};
    double magnetic_variation{};
    friend constexpr bool operator==(const min_gps&, const min_gps&) = default;
    struct schema : wire::items {
        using T = min_gps;
        using type = layout<
            field<&T::validity, in_value_set<u8, between<0, 1>>>,
            field<&T::magnetic_variation, scaled<u32le, latitude>>>;
    };
};
struct alt_gps {
    std::uint8_t status{};
    std::uint8_t fix_command_status{};
    std::uint8_t lat_lon_valid{};
    std::optional<double> velocity_east{};
    std::optional<double> velocity_north{};
    std::optional<double> velocity_down{};
    std::optional<double> altitude{};
    std::optional<std::uint8_t> satellites_seen{};
    std::optional<std::uint8_t> satellites_in_solution{};
    friend constexpr bool operator==(const alt_gps&, const alt_gps&) = default;
    struct schema : wire::items {
        using T = alt_gps;
        using type = layout<
            presence<u8,
                field<&T::status, in_value_set<u8, between<0, 3>>>,
                field<&T::fix_command_status, in_value_set<u8, between<0, 2>>>,
                field<&T::lat_lon_valid, in_value_set<u8, between<0, 1>>>,
                field<&T::velocity_east, scaled<u32le, velocity>>,
                field<&T::velocity_north, scaled<u32le, velocity>>,
                field<&T::velocity_down, scaled<u32le, velocity>>,
                field<&T::altitude, scaled<u32le, gps_altitude>>,
                field<&T::satellites_seen, u8>,
                field<&T::satellites_in_solution, u8>>>;
    };
};
struct report_gps_fix {
    sae::gps_fix gps_fix{};
    std::optional<std::variant<min_gps, alt_gps>> gps_status{};
    friend constexpr bool operator==(const report_gps_fix&, const report_gps_fix&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4428;
        using T = report_gps_fix;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            presence<u8,
                nested<&T::gps_fix>,
                variant<&T::gps_status, u8>>>;
    };
};

/// Lists of variants; an alternative that is a sequence with a list; bit-fields; a blob.
struct time_stamp {
    std::uint16_t milliseconds{};
    std::uint8_t seconds{};
    std::uint8_t minutes{};
    std::uint8_t hour{};
    std::uint8_t day{};
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
struct range_sensor_data_error {
    std::uint16_t sensor_id{};
    std::uint8_t data_error_code{};
    std::string_view error_message{};
    friend constexpr bool operator==(const range_sensor_data_error&, const range_sensor_data_error&) = default;
    struct schema : wire::items {
        using T = range_sensor_data_error;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::data_error_code, in_value_set<u8, between<0, 1>, one_of<255>>>,
            string<&T::error_message, count<"error_message_size", u8>>>;
    };
};
struct range_sensor_data_point {
    std::optional<std::uint32_t> point_id{};
    double range{};
    std::optional<std::uint8_t> range_validity{};
    std::optional<double> range_error_rms{};
    double bearing{};
    std::optional<std::uint8_t> bearing_validity{};
    std::optional<double> bearing_error_rms{};
    double inclination{};
    std::optional<std::uint8_t> inclination_validity{};
    std::optional<double> inclination_error_rms{};
    friend constexpr bool operator==(const range_sensor_data_point&, const range_sensor_data_point&) = default;
    struct schema : wire::items {
        using T = range_sensor_data_point;
        using type = layout<
            presence<u8,
                field<&T::point_id, u32le>,
                field<&T::range, scaled<u32le, sae::range>>,
                field<&T::range_validity, in_value_set<u8, between<0, 1>>>,
                field<&T::range_error_rms, scaled<u32le, range_error>>,
                field<&T::bearing, scaled<u32le, angle>>,
                field<&T::bearing_validity, in_value_set<u8, between<0, 1>>>,
                field<&T::bearing_error_rms, scaled<u32le, angle_error>>,
                field<&T::inclination, scaled<u32le, angle>>,
                field<&T::inclination_validity, in_value_set<u8, between<0, 1>>>,
                field<&T::inclination_error_rms, scaled<u32le, angle_error>>>>;
    };
};
struct range_sensor_data {
    std::uint16_t sensor_id{};
    std::uint8_t report_coordinate_system{};
    sae::time_stamp time_stamp{};
    wire::list<range_sensor_data_point> points{};
    friend constexpr bool operator==(const range_sensor_data&, const range_sensor_data&) = default;
    struct schema : wire::items {
        using T = range_sensor_data;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::report_coordinate_system, in_value_set<u8, between<0, 1>>>,
            nested<&T::time_stamp>,
            repeated<&T::points, count<"number_of_points", u16le>>>;
    };
};
struct range_sensor_data_variant {
    std::variant<range_sensor_data_error, range_sensor_data> value{};
    friend constexpr bool operator==(const range_sensor_data_variant&, const range_sensor_data_variant&) = default;
    struct schema : wire::items { using type = layout<variant<&range_sensor_data_variant::value, u8>>; };
};
struct report_range_sensor_data {
    wire::list<range_sensor_data_variant> range_sensor_data_list{};
    friend constexpr bool operator==(const report_range_sensor_data&, const report_range_sensor_data&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4803;
        using T = report_range_sensor_data;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::range_sensor_data_list, count<"number_of_range_sensor_data_list", u16le>>>;
    };
};
struct range_sensor_compressed_data {
    std::uint16_t sensor_id{};
    std::uint8_t report_coordinate_system{};
    sae::time_stamp time_stamp{};
    std::uint8_t data_compression{};
    wire::blob compressed_data{};
    friend constexpr bool operator==(const range_sensor_compressed_data&, const range_sensor_compressed_data&) = default;
    struct schema : wire::items {
        using T = range_sensor_compressed_data;
        using type = layout<
            field<&T::sensor_id, in_value_set<u16le, between<1, 65535>>>,
            field<&T::report_coordinate_system, in_value_set<u8, between<0, 1>>>,
            nested<&T::time_stamp>,
            field<&T::data_compression, in_value_set<u8, between<0, 3>>>,
            bytes<&T::compressed_data, count_between<"compressed_data_size", u32le, 0, 2147483647>>>;
    };
};
struct range_sensor_compressed_data_variant {
    std::variant<range_sensor_data_error, range_sensor_compressed_data> value{};
    friend constexpr bool operator==(const range_sensor_compressed_data_variant&, const range_sensor_compressed_data_variant&) = default;
    struct schema : wire::items { using type = layout<variant<&range_sensor_compressed_data_variant::value, u8>>; };
};
struct report_range_sensor_compressed_data {
    wire::list<range_sensor_compressed_data_variant> range_sensor_compressed_data_list{};
    friend constexpr bool operator==(const report_range_sensor_compressed_data&, const report_range_sensor_compressed_data&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4804;
        using T = report_range_sensor_compressed_data;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::range_sensor_compressed_data_list, count<"number_of_range_sensor_compressed_data_list", u16le>>>;
    };
};

} // namespace sae
