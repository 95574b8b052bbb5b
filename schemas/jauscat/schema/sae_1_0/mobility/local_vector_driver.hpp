// LocalVectorDriver 1.0, urn:jaus:jss:mobility:LocalVectorDriver.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae_1_0/ranges.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae_1_0::mobility {

/// SetLocalVector: ID 0408h, command, input of LocalVectorDriver.
struct set_local_vector {
    std::optional<double> speed{};   ///< meter per second, 0 to 327.67
    std::optional<double> z{};       ///< meter, -10000 to 35000
    std::optional<double> heading{}; ///< radian, -pi to pi
    std::optional<double> roll{};    ///< radian, -pi to pi
    std::optional<double> pitch{};   ///< radian, -pi to pi
    friend constexpr bool operator==(const set_local_vector&, const set_local_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0408;
        static constexpr bool is_command = true, is_deprecated = false;
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

/// ReportLocalVector: ID 4408h, output of LocalVectorDriver.
struct report_local_vector {
    std::optional<double> speed{};   ///< meter per second, 0 to 327.67
    std::optional<double> z{};       ///< meter, -10000 to 35000
    std::optional<double> heading{}; ///< radian, -pi to pi
    std::optional<double> roll{};    ///< radian, -pi to pi
    std::optional<double> pitch{};   ///< radian, -pi to pi
    friend constexpr bool operator==(const report_local_vector&, const report_local_vector&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4408;
        static constexpr bool is_command = false, is_deprecated = false;
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

namespace services {

/// LocalVectorDriver: what it is called, and its messages.
struct local_vector_driver {
    static constexpr std::string_view name = "LocalVectorDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:LocalVectorDriver";
    static constexpr std::string_view version = "1.0";
    static constexpr std::string_view parent_uri{};
    static constexpr std::string_view parent_version{};
    using inputs = jaus::message_list<set_local_vector>;
    using outputs = jaus::message_list<report_local_vector>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae_1_0::mobility
