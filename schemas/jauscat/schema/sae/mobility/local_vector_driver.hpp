// LocalVectorDriver 1.1, urn:jaus:jss:mobility:LocalVectorDriver.
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

/// SetLocalVector: ID 0408h, command, deprecated, input of LocalVectorDriver.
struct set_local_vector {
    double speed{};                  ///< meter per second, 0 to 327.67
    std::optional<double> z{};       ///< meter, -10000 to 35000
    std::optional<double> heading{}; ///< radian, -pi to pi
    std::optional<double> roll{};    ///< radian, -pi to pi
    std::optional<double> pitch{};   ///< radian, -pi to pi
    friend constexpr bool operator==(const set_local_vector&, const set_local_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0408;
        static constexpr bool is_command = true, is_deprecated = true;
        using T = set_local_vector;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::speed, scaled<u16le, meter_per_second_0_to_327_67>>,
                field<&T::z, scaled<u32le, meter_minus_10000_to_35000>>,
                field<&T::heading, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>>>;
    };
};

/// Values of ZPosition.
enum class local_vector_driver_z_position_form : std::uint8_t {
    altitude_agl = 0,
    altitude_msl = 1,
    altitude_asf = 2,
    depth = 3,
    z_local = 4,
};

/// ZPosition: a number in the form that is named before it.
struct local_vector_driver_z_position {
    local_vector_driver_z_position_form index{};
    double value{}; ///< meter, -50000 to 50000
    friend constexpr bool operator==(
        const local_vector_driver_z_position&,
        const local_vector_driver_z_position&) = default;

    struct schema : wire::items {
        using T = local_vector_driver_z_position;
        using type = layout<
            field<&T::index, enumeration<local_vector_driver_z_position_form, u8>>,
            selected<&T::value, by<&T::index>,
                when<local_vector_driver_z_position_form::altitude_agl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_vector_driver_z_position_form::altitude_msl, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_vector_driver_z_position_form::altitude_asf, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_vector_driver_z_position_form::depth, scaled<u32le, meter_minus_50000_to_50000>>,
                when<local_vector_driver_z_position_form::z_local, scaled<u32le, meter_minus_50000_to_50000>>>>;
    };
};

/// SetLocalVectorExt: ID 04A8h, command, input of LocalVectorDriver.
struct set_local_vector_ext {
    mobility::speed speed{};
    std::optional<local_vector_driver_z_position> z_position{};
    std::optional<double> roll{};    ///< radian, -pi to pi
    std::optional<double> pitch{};   ///< radian, -pi to pi
    std::optional<double> heading{}; ///< radian, -pi to pi
    std::optional<double> course{};  ///< radian, -pi to pi
    friend constexpr bool operator==(const set_local_vector_ext&, const set_local_vector_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x04A8;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_local_vector_ext;
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

/// QueryLocalVector: ID 2408h, deprecated, input of LocalVectorDriver.
struct query_local_vector {
    std::uint8_t presence_vector{};
    friend constexpr bool operator==(const query_local_vector&, const query_local_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2408;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = query_local_vector;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u8>>;
    };
};

/// QueryLocalVectorExt: ID 24A8h, input of LocalVectorDriver.
struct query_local_vector_ext {
    std::uint16_t presence_vector{};
    friend constexpr bool operator==(const query_local_vector_ext&, const query_local_vector_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x24A8;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_local_vector_ext;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u16le>>;
    };
};

/// ReportLocalVector: ID 4408h, deprecated, output of LocalVectorDriver.
struct report_local_vector {
    double speed{};                  ///< meter per second, 0 to 327.67
    std::optional<double> z{};       ///< meter, -10000 to 35000
    std::optional<double> heading{}; ///< radian, -pi to pi
    std::optional<double> roll{};    ///< radian, -pi to pi
    std::optional<double> pitch{};   ///< radian, -pi to pi
    friend constexpr bool operator==(const report_local_vector&, const report_local_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4408;
        static constexpr bool is_command = false, is_deprecated = true;
        using T = report_local_vector;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8,
                field<&T::speed, scaled<u16le, meter_per_second_0_to_327_67>>,
                field<&T::z, scaled<u32le, meter_minus_10000_to_35000>>,
                field<&T::heading, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::roll, scaled<u16le, radian_minus_pi_to_pi>>,
                field<&T::pitch, scaled<u16le, radian_minus_pi_to_pi>>>>;
    };
};

/// ReportLocalVectorExt: ID 44A8h, output of LocalVectorDriver.
struct report_local_vector_ext {
    mobility::speed speed{};
    std::optional<local_vector_driver_z_position> z_position{};
    std::optional<double> roll{};    ///< radian, -pi to pi
    std::optional<double> pitch{};   ///< radian, -pi to pi
    std::optional<double> heading{}; ///< radian, -pi to pi
    std::optional<double> course{};  ///< radian, -pi to pi
    friend constexpr bool operator==(const report_local_vector_ext&, const report_local_vector_ext&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x44A8;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_local_vector_ext;
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

/// LocalVectorDriver: what it is called, and its messages.
struct local_vector_driver {
    static constexpr std::string_view name = "LocalVectorDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:LocalVectorDriver";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_local_vector,
        set_local_vector_ext,
        query_local_vector,
        query_local_vector_ext>;
    using outputs = jaus::message_list<report_local_vector, report_local_vector_ext>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
