// GlobalVectorDriver 1.1, urn:jaus:jss:mobility:GlobalVectorDriver.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/mobility/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::mobility {

/// SetGlobalVector: ID 0407h, command, deprecated, input of GlobalVectorDriver.
struct set_global_vector {
    std::optional<double> speed{};    ///< meter per second, 0 to 327.67
    std::optional<double> altitude{}; ///< meter, -10000 to 35000
    std::optional<double> heading{};  ///< radian, -pi to pi
    std::optional<double> roll{};     ///< radian, -pi to pi
    std::optional<double> pitch{};    ///< radian, -pi to pi
    friend constexpr bool operator==(const set_global_vector&, const set_global_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0407;
        static constexpr bool is_command = true, is_deprecated = true;
        using T = set_global_vector;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::speed, scaled<u16le, meter_per_second_0_to_327_67>>,
                field<&T::altitude, scaled<u32le, meter_minus_10000_to_35000>>,
                field<&T::heading, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>>>;
    };
};

/// Values of ZPosition.
enum class global_vector_driver_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
};

/// ZPosition: a number in the form that is named before it.
struct global_vector_driver_z_position {
    global_vector_driver_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const global_vector_driver_z_position&,
        const global_vector_driver_z_position&) = default;

    struct schema : wire::items {
        using T = global_vector_driver_z_position;
        using type = layout<
            field<&T::index, enumeration<global_vector_driver_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<global_vector_driver_z_position_form::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_vector_driver_z_position_form::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_vector_driver_z_position_form::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                when<global_vector_driver_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// SetGlobalVectorExt: ID 04A7h, command, input of GlobalVectorDriver.
struct set_global_vector_ext {
    mobility::speed speed{};
    std::optional<global_vector_driver_z_position> z_position{};
    std::optional<double> roll{};    ///< radian, -pi to pi
    std::optional<double> pitch{};   ///< radian, -pi to pi
    std::optional<double> heading{}; ///< radian, -pi to pi
    std::optional<double> course{};  ///< radian, -pi to pi
    friend constexpr bool operator==(const set_global_vector_ext&, const set_global_vector_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x04A7;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_global_vector_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                nested<&T::speed>,
                nested<&T::z_position>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::heading, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::course, scaled<u16le, radian_minus_pi_to_pi>>>>;
    };
};

/// QueryGlobalVector: ID 2407h, deprecated, input of GlobalVectorDriver.
struct query_global_vector {
    std::uint8_t presence_vector{};
    friend constexpr bool operator==(const query_global_vector&, const query_global_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2407;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = query_global_vector;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u8>>;
    };
};

/// QueryGlobalVectorExt: ID 24A7h, input of GlobalVectorDriver.
struct query_global_vector_ext {
    std::uint16_t presence_vector{};
    friend constexpr bool operator==(const query_global_vector_ext&, const query_global_vector_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x24A7;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_global_vector_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u16le>>;
    };
};

/// ReportGlobalVector: ID 4407h, deprecated, output of GlobalVectorDriver.
struct report_global_vector {
    std::optional<double> speed{};    ///< meter per second, 0 to 327.67
    std::optional<double> altitude{}; ///< meter, -10000 to 35000
    std::optional<double> heading{};  ///< radian, -pi to pi
    std::optional<double> roll{};     ///< radian, -pi to pi
    std::optional<double> pitch{};    ///< radian, -pi to pi
    friend constexpr bool operator==(const report_global_vector&, const report_global_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4407;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = report_global_vector;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::speed, scaled<u16le, meter_per_second_0_to_327_67>>,
                field<&T::altitude, scaled<u32le, meter_minus_10000_to_35000>>,
                field<&T::heading, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>>>;
    };
};

/// ReportGlobalVectorExt: ID 44A7h, output of GlobalVectorDriver.
struct report_global_vector_ext {
    mobility::speed speed{};
    std::optional<global_vector_driver_z_position> z_position{};
    std::optional<double> roll{};    ///< radian, -pi to pi
    std::optional<double> pitch{};   ///< radian, -pi to pi
    std::optional<double> heading{}; ///< radian, -pi to pi
    std::optional<double> course{};  ///< radian, -pi to pi
    friend constexpr bool operator==(const report_global_vector_ext&, const report_global_vector_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x44A7;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_global_vector_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                nested<&T::speed>,
                nested<&T::z_position>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::heading, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::course, scaled<u16le, radian_minus_pi_to_pi>>>>;
    };
};

namespace services {

/// GlobalVectorDriver: what it is called, and its messages.
struct global_vector_driver {
    static constexpr std::string_view name = "GlobalVectorDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:GlobalVectorDriver";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_global_vector,
        set_global_vector_ext,
        query_global_vector,
        query_global_vector_ext>;
    using outputs = jaus::message_list<report_global_vector, report_global_vector_ext>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
