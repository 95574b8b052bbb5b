// PrimitiveDriver 1.1, urn:jaus:jss:mobility:PrimitiveDriver.
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

/// SetWrenchEffort: ID 0405h, command, input of PrimitiveDriver.
struct set_wrench_effort {
    std::optional<double> propulsive_linear_effort_x{};     ///< percent, -100 to 100
    std::optional<double> propulsive_linear_effort_y{};     ///< percent, -100 to 100
    std::optional<double> propulsive_linear_effort_z{};     ///< percent, -100 to 100
    std::optional<double> propulsive_rotational_effort_x{}; ///< percent, -100 to 100
    std::optional<double> propulsive_rotational_effort_y{}; ///< percent, -100 to 100
    std::optional<double> propulsive_rotational_effort_z{}; ///< percent, -100 to 100
    std::optional<double> resistive_linear_effort_x{};      ///< percent, 0 to 100
    std::optional<double> resistive_linear_effort_y{};      ///< percent, 0 to 100
    std::optional<double> resistive_linear_effort_z{};      ///< percent, 0 to 100
    std::optional<double> resistive_rotational_effort_x{};  ///< percent, 0 to 100
    std::optional<double> resistive_rotational_effort_y{};  ///< percent, 0 to 100
    std::optional<double> resistive_rotational_effort_z{};  ///< percent, 0 to 100
    friend constexpr bool operator==(const set_wrench_effort&, const set_wrench_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0405;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_wrench_effort;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u16le,
                field<&T::propulsive_linear_effort_x, scaled<u16le, percent_minus_100_to_100>>,
                field<&T::propulsive_linear_effort_y, scaled<u16le, percent_minus_100_to_100>>,
                field<&T::propulsive_linear_effort_z, scaled<u16le, percent_minus_100_to_100>>,
                field<&T::propulsive_rotational_effort_x, scaled<u16le, percent_minus_100_to_100>>,
                field<&T::propulsive_rotational_effort_y, scaled<u16le, percent_minus_100_to_100>>,
                field<&T::propulsive_rotational_effort_z, scaled<u16le, percent_minus_100_to_100>>,
                field<&T::resistive_linear_effort_x, scaled<u8, percent_0_to_100>>,
                field<&T::resistive_linear_effort_y, scaled<u8, percent_0_to_100>>,
                field<&T::resistive_linear_effort_z, scaled<u8, percent_0_to_100>>,
                field<&T::resistive_rotational_effort_x, scaled<u8, percent_0_to_100>>,
                field<&T::resistive_rotational_effort_y, scaled<u8, percent_0_to_100>>,
                field<&T::resistive_rotational_effort_z, scaled<u8, percent_0_to_100>>>>;
    };
};

/// QueryWrenchEffort: ID 2405h, input of PrimitiveDriver.
struct query_wrench_effort {
    std::uint16_t presence_vector{};
    friend constexpr bool operator==(const query_wrench_effort&, const query_wrench_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2405;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_wrench_effort;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::presence_vector, u16le>>;
    };
};

/// ReportWrenchEffort: ID 4405h, output of PrimitiveDriver.
struct report_wrench_effort {
    std::optional<double> propulsive_linear_effort_x{};     ///< percent, -100 to 100
    std::optional<double> propulsive_linear_effort_y{};     ///< percent, -100 to 100
    std::optional<double> propulsive_linear_effort_z{};     ///< percent, -100 to 100
    std::optional<double> propulsive_rotational_effort_x{}; ///< percent, -100 to 100
    std::optional<double> propulsive_rotational_effort_y{}; ///< percent, -100 to 100
    std::optional<double> propulsive_rotational_effort_z{}; ///< percent, -100 to 100
    std::optional<double> resistive_linear_effort_x{};      ///< percent, 0 to 100
    std::optional<double> resistive_linear_effort_y{};      ///< percent, 0 to 100
    std::optional<double> resistive_linear_effort_z{};      ///< percent, 0 to 100
    std::optional<double> resistive_rotational_effort_x{};  ///< percent, 0 to 100
    std::optional<double> resistive_rotational_effort_y{};  ///< percent, 0 to 100
    std::optional<double> resistive_rotational_effort_z{};  ///< percent, 0 to 100
    friend constexpr bool operator==(const report_wrench_effort&, const report_wrench_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4405;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_wrench_effort;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u16le,
                field<&T::propulsive_linear_effort_x, scaled<u16le, percent_minus_100_to_100>>,
                field<&T::propulsive_linear_effort_y, scaled<u16le, percent_minus_100_to_100>>,
                field<&T::propulsive_linear_effort_z, scaled<u16le, percent_minus_100_to_100>>,
                field<&T::propulsive_rotational_effort_x, scaled<u16le, percent_minus_100_to_100>>,
                field<&T::propulsive_rotational_effort_y, scaled<u16le, percent_minus_100_to_100>>,
                field<&T::propulsive_rotational_effort_z, scaled<u16le, percent_minus_100_to_100>>,
                field<&T::resistive_linear_effort_x, scaled<u8, percent_0_to_100>>,
                field<&T::resistive_linear_effort_y, scaled<u8, percent_0_to_100>>,
                field<&T::resistive_linear_effort_z, scaled<u8, percent_0_to_100>>,
                field<&T::resistive_rotational_effort_x, scaled<u8, percent_0_to_100>>,
                field<&T::resistive_rotational_effort_y, scaled<u8, percent_0_to_100>>,
                field<&T::resistive_rotational_effort_z, scaled<u8, percent_0_to_100>>>>;
    };
};

namespace services {

/// PrimitiveDriver: what it is called, and its messages.
struct primitive_driver {
    static constexpr std::string_view name = "PrimitiveDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:mobility:PrimitiveDriver";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<set_wrench_effort, query_wrench_effort>;
    using outputs = jaus::message_list<report_wrench_effort>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::mobility
