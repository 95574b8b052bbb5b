// StabilizerDriver 1.0, urn:jaus:jss:ugv:StabilizerDriver.
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
namespace jauscat::sae::ugv {

/// Record queryStabilizerRec.
struct query_stabilizer_rec {
    std::uint8_t stabilizer_id{};
    friend constexpr bool operator==(const query_stabilizer_rec&, const query_stabilizer_rec&) = default;

    struct schema : wire::items {
        using T = query_stabilizer_rec;
        using type = layout<field<&T::stabilizer_id, u8>>;
    };
};

/// QueryStabilizerEffort: ID 2503h, input of StabilizerDriver.
struct query_stabilizer_effort {
    wire::list<query_stabilizer_rec> stabilizer_id{}; ///< up to 255 elements
    friend constexpr bool operator==(const query_stabilizer_effort&, const query_stabilizer_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2503;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_stabilizer_effort;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::stabilizer_id, count<"number_of_stabilizer_id", u8>>>;
    };
};

/// QueryStabilizerCapabilities: ID 2505h, input of StabilizerDriver.
struct query_stabilizer_capabilities {
    friend constexpr bool operator==(
        const query_stabilizer_capabilities&,
        const query_stabilizer_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2505;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// Record stabilizerEffortRec.
struct stabilizer_effort_rec {
    std::uint8_t stabilizer_id{};
    double effort{}; ///< -100 to 100
    friend constexpr bool operator==(const stabilizer_effort_rec&, const stabilizer_effort_rec&) = default;

    struct schema : wire::items {
        using T = stabilizer_effort_rec;
        using type = layout<
            field<&T::stabilizer_id, u8>,
            field<&T::effort, scaled<u16le, one_minus_100_to_100>>>;
    };
};

/// SetStabilizerEffort: ID 0503h, command, input of StabilizerDriver.
struct set_stabilizer_effort {
    wire::list<stabilizer_effort_rec> stabilizer_effort{}; ///< up to 255 elements
    friend constexpr bool operator==(const set_stabilizer_effort&, const set_stabilizer_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0503;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_stabilizer_effort;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::stabilizer_effort, count<"number_of_stabilizer_effort", u8>>>;
    };
};

/// Record stabilizerPositionRec.
struct set_stabilizer_position_stabilizer_position_rec {
    std::uint8_t stabilizer_id{};
    double position{}; ///< radian, -3.14159 to 3.14159
    friend constexpr bool operator==(
        const set_stabilizer_position_stabilizer_position_rec&,
        const set_stabilizer_position_stabilizer_position_rec&) = default;

    struct schema : wire::items {
        using T = set_stabilizer_position_stabilizer_position_rec;
        using type = layout<
            field<&T::stabilizer_id, u8>,
            field<&T::position, scaled<u16le, radian_minus_3_14159_to_3_14159>>>;
    };
};

/// SetStabilizerPosition: ID 0504h, command, input of StabilizerDriver.
struct set_stabilizer_position {
    wire::list<set_stabilizer_position_stabilizer_position_rec> stabilizer_position{}; ///< up to 255 elements
    friend constexpr bool operator==(const set_stabilizer_position&, const set_stabilizer_position&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x0504;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_stabilizer_position;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::stabilizer_position, count<"number_of_stabilizer_position", u8>>>;
    };
};

/// QueryStabilizerPosition: ID 2504h, input of StabilizerDriver.
struct query_stabilizer_position {
    wire::list<query_stabilizer_rec> stabilizer_id{}; ///< up to 255 elements
    friend constexpr bool operator==(const query_stabilizer_position&, const query_stabilizer_position&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x2504;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_stabilizer_position;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::stabilizer_id, count<"number_of_stabilizer_id", u8>>>;
    };
};

/// Record stabilizerPositionRec.
struct report_stabilizer_position_stabilizer_position_rec {
    std::uint8_t stabilizer_id{};
    double commanded_position{}; ///< radian, -3.14159 to 3.14159
    double actual_position{};    ///< radian, -3.14159 to 3.14159
    friend constexpr bool operator==(
        const report_stabilizer_position_stabilizer_position_rec&,
        const report_stabilizer_position_stabilizer_position_rec&) = default;

    struct schema : wire::items {
        using T = report_stabilizer_position_stabilizer_position_rec;
        using type = layout<
            field<&T::stabilizer_id, u8>,
            field<&T::commanded_position, scaled<u16le, radian_minus_3_14159_to_3_14159>>,
            field<&T::actual_position, scaled<u16le, radian_minus_3_14159_to_3_14159>>>;
    };
};

/// ReportStabilizerPosition: ID 4504h, output of StabilizerDriver.
struct report_stabilizer_position {
    wire::list<report_stabilizer_position_stabilizer_position_rec> stabilizer_position{}; ///< up to 255 elements
    friend constexpr bool operator==(const report_stabilizer_position&, const report_stabilizer_position&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4504;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_stabilizer_position;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::stabilizer_position, count<"number_of_stabilizer_position", u8>>>;
    };
};

/// Record stabilizerCapabilitiesRec.
struct stabilizer_capabilities_rec {
    std::uint8_t stabilizer_id{};
    double maximum_up_angle{};   ///< radian, 0 to 3.14159
    double maximum_down_angle{}; ///< radian, -3.14158 to 0
    friend constexpr bool operator==(const stabilizer_capabilities_rec&, const stabilizer_capabilities_rec&) = default;

    struct schema : wire::items {
        using T = stabilizer_capabilities_rec;
        using type = layout<
            field<&T::stabilizer_id, u8>,
            field<&T::maximum_up_angle, scaled<u16le, radian_0_to_3_14159>>,
            field<&T::maximum_down_angle, scaled<u16le, radian_minus_3_14158_to_0>>>;
    };
};

/// Record points.
struct points {
    double point_x{}; ///< meter, -32.768 to 32.767
    double point_y{}; ///< meter, -32.768 to 32.767
    double point_z{}; ///< meter, -32.768 to 32.767
    friend constexpr bool operator==(const points&, const points&) = default;

    struct schema : wire::items {
        using T = points;
        using type = layout<
            field<&T::point_x, scaled<u16le, meter_minus_32_768_to_32_767>>,
            field<&T::point_y, scaled<u16le, meter_minus_32_768_to_32_767>>,
            field<&T::point_z, scaled<u16le, meter_minus_32_768_to_32_767>>>;
    };
};

/// Sequence stabilizerCapabilitiesSeq.
struct stabilizer_capabilities_seq {
    ugv::stabilizer_capabilities_rec stabilizer_capabilities_rec{};
    wire::list<points> stabilizer_dimensions_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const stabilizer_capabilities_seq&, const stabilizer_capabilities_seq&) = default;

    struct schema : wire::items {
        using T = stabilizer_capabilities_seq;
        using type = layout<
            nested<&T::stabilizer_capabilities_rec>,
            repeated<&T::stabilizer_dimensions_list, count<"number_of_stabilizer_dimensions_list", u8>>>;
    };
};

/// ReportStabilizerCapabilities: ID 4505h, output of StabilizerDriver.
struct report_stabilizer_capabilities {
    wire::list<stabilizer_capabilities_seq> stabilizer_capabilities{}; ///< up to 255 elements
    friend constexpr bool operator==(
        const report_stabilizer_capabilities&,
        const report_stabilizer_capabilities&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4505;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_stabilizer_capabilities;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::stabilizer_capabilities, count<"number_of_stabilizer_capabilities", u8>>>;
    };
};

/// ReportStabilizerEffort: ID 4503h, output of StabilizerDriver.
struct report_stabilizer_effort {
    wire::list<stabilizer_effort_rec> stabilizer_effort{}; ///< up to 255 elements
    friend constexpr bool operator==(const report_stabilizer_effort&, const report_stabilizer_effort&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x4503;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_stabilizer_effort;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::stabilizer_effort, count<"number_of_stabilizer_effort", u8>>>;
    };
};

namespace services {

/// StabilizerDriver: what it is called, and its messages.
struct stabilizer_driver {
    static constexpr std::string_view name = "StabilizerDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:ugv:StabilizerDriver";
    static constexpr std::string_view version = "1.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        query_stabilizer_effort,
        query_stabilizer_capabilities,
        set_stabilizer_effort,
        set_stabilizer_position,
        query_stabilizer_position>;
    using outputs = jaus::message_list<
        report_stabilizer_position,
        report_stabilizer_capabilities,
        report_stabilizer_effort>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::ugv
