// ManipulatorListDriver 2.0, urn:jaus:jss:manipulator:ManipulatorListDriver.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/manipulator/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::manipulator {

/// ExecuteList: ID 061Eh, input of ManipulatorListDriver.
struct execute_list {
    std::optional<std::uint16_t> element_uid{};
    friend constexpr bool operator==(const execute_list&, const execute_list&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x061E;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = execute_list;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            lenient_presence<u8, field<&T::element_uid, u16le>>>;
    };
};

/// QueryActiveElement: ID 261Eh, input of ManipulatorListDriver.
struct query_active_element {
    friend constexpr bool operator==(const query_active_element&, const query_active_element&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x261E;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ReportActiveElement: ID 461Eh, output of ManipulatorListDriver.
struct report_active_element {
    std::uint16_t element_uid{};
    friend constexpr bool operator==(const report_active_element&, const report_active_element&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x461E;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_active_element;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::element_uid, u16le>>;
    };
};

namespace services {

/// ManipulatorListDriver: what it is called, and its messages.
struct manipulator_list_driver {
    static constexpr std::string_view name = "ManipulatorListDriver";
    static constexpr std::string_view uri = "urn:jaus:jss:manipulator:ManipulatorListDriver";
    static constexpr std::string_view version = "2.0";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:ListManager";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<execute_list, query_active_element>;
    using outputs = jaus::message_list<report_active_element>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::manipulator
