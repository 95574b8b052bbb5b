// ListManager 1.1, urn:jaus:jss:core:ListManager.
// Written by jauscat-jsidl: do not edit it, write it again.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/core/shared.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::sae::core {

/// Record RequestIDRec.
struct request_id_rec {
    std::uint8_t request_id{};
    friend constexpr bool operator==(const request_id_rec&, const request_id_rec&) = default;

    struct schema : wire::items {
        using T = request_id_rec;
        using type = layout<field<&T::request_id, u8>>;
    };
};

/// Values of ElementData.
enum class element_data_format : std::uint8_t {
    jaus_message = 0,
    user_defined = 1,
};

/// ElementData: octets in the format that is named before them.
struct element_data {
    element_data_format format{};
    wire::embedded_message data{}; ///< up to 65535 octets
    friend constexpr bool operator==(const element_data&, const element_data&) = default;

    struct schema : wire::items {
        using T = element_data;
        using type = layout<
            field<&T::format, in_value_set<enumeration<element_data_format, u8>, between<0, 1>>>,
            embedded<&T::data, count<"data_size", u16le>>>;
    };
};

/// Record ElementRec.
struct element_rec {
    std::uint16_t element_uid{};
    std::uint16_t previous_uid{};
    std::uint16_t next_uid{};
    core::element_data element_data{};
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

/// SetElement: ID 041Ah, command, input of ListManager.
struct set_element {
    core::request_id_rec request_id_rec{};
    wire::list<element_rec> element_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const set_element&, const set_element&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x041A;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = set_element;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::request_id_rec>,
            repeated<&T::element_list, count<"number_of_element_list", u8>>>;
    };
};

/// Record DeleteElementRec.
struct delete_element_rec {
    std::uint16_t element_uid{};
    friend constexpr bool operator==(const delete_element_rec&, const delete_element_rec&) = default;

    struct schema : wire::items {
        using T = delete_element_rec;
        using type = layout<field<&T::element_uid, u16le>>;
    };
};

/// DeleteElement: ID 041Bh, command, input of ListManager.
struct delete_element {
    core::request_id_rec request_id_rec{};
    wire::list<delete_element_rec> delete_element_list{}; ///< up to 255 elements
    friend constexpr bool operator==(const delete_element&, const delete_element&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x041B;
        static constexpr bool is_command = true, is_deprecated = false;
        using T = delete_element;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            nested<&T::request_id_rec>,
            repeated<&T::delete_element_list, count<"number_of_delete_element_list", u8>>>;
    };
};

/// QueryElement: ID 241Ah, input of ListManager.
struct query_element {
    std::uint16_t element_uid{};
    friend constexpr bool operator==(const query_element&, const query_element&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x241A;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = query_element;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::element_uid, u16le>>;
    };
};

/// QueryElementList: ID 241Bh, input of ListManager.
struct query_element_list {
    friend constexpr bool operator==(const query_element_list&, const query_element_list&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x241B;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// QueryElementCount: ID 241Ch, input of ListManager.
struct query_element_count {
    friend constexpr bool operator==(const query_element_count&, const query_element_count&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x241C;
        static constexpr bool is_command = false, is_deprecated = false;
        using type = layout<constant<"message_id", u16le, message_id>>;
    };
};

/// ConfirmElementRequest: ID 041Ch, output of ListManager.
struct confirm_element_request {
    std::uint8_t request_id{};
    friend constexpr bool operator==(const confirm_element_request&, const confirm_element_request&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x041C;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = confirm_element_request;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::request_id, u8>>;
    };
};

/// Values of ResponseCode.
enum class list_manager_response_code : std::uint8_t {
    invalid_element_id = 1,
    invalid_previous_element = 2,
    invalid_next_element = 3,
    unsupported_element_type = 4,
    element_id_not_found = 5,
    out_of_memory = 6,
    unspecified_error = 7,
};

/// RejectElementRequest: ID 041Dh, output of ListManager.
struct reject_element_request {
    std::uint8_t request_id{};
    list_manager_response_code response_code{};
    friend constexpr bool operator==(const reject_element_request&, const reject_element_request&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x041D;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = reject_element_request;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::request_id, u8>,
            field<&T::response_code, in_value_set<enumeration<list_manager_response_code, u8>, between<1, 7>>>>;
    };
};

/// ReportElement: ID 441Ah, output of ListManager.
struct report_element {
    std::uint16_t element_uid{};
    std::uint16_t previous_uid{};
    std::uint16_t next_uid{};
    core::element_data element_data{};
    friend constexpr bool operator==(const report_element&, const report_element&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x441A;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_element;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::element_uid, u16le>,
            field<&T::previous_uid, u16le>,
            field<&T::next_uid, u16le>,
            nested<&T::element_data>>;
    };
};

/// Record ElementListRec.
struct element_list_rec {
    std::uint16_t element_uid{};
    friend constexpr bool operator==(const element_list_rec&, const element_list_rec&) = default;

    struct schema : wire::items {
        using T = element_list_rec;
        using type = layout<field<&T::element_uid, u16le>>;
    };
};

/// ReportElementList: ID 441Bh, output of ListManager.
struct report_element_list {
    wire::list<element_list_rec> element_list{}; ///< up to 65535 elements
    friend constexpr bool operator==(const report_element_list&, const report_element_list&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x441B;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_element_list;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            repeated<&T::element_list, count<"number_of_element_list", u16le>>>;
    };
};

/// ReportElementCount: ID 441Ch, output of ListManager.
struct report_element_count {
    std::uint16_t element_count{};
    friend constexpr bool operator==(const report_element_count&, const report_element_count&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t message_id = 0x441C;
        static constexpr bool is_command = false, is_deprecated = false;
        using T = report_element_count;
        using type = layout<
            constant<"message_id", u16le, message_id>,
            field<&T::element_count, u16le>>;
    };
};

namespace services {

/// ListManager: what it is called, and its messages.
struct list_manager {
    static constexpr std::string_view name = "ListManager";
    static constexpr std::string_view uri = "urn:jaus:jss:core:ListManager";
    static constexpr std::string_view version = "1.1";
    static constexpr std::string_view parent_uri = "urn:jaus:jss:core:Management";
    static constexpr std::string_view parent_version = "1.1";
    using inputs = jaus::message_list<
        set_element,
        delete_element,
        query_element,
        query_element_list,
        query_element_count>;
    using outputs = jaus::message_list<
        confirm_element_request,
        reject_element_request,
        report_element,
        report_element_list,
        report_element_count>;
    using messages = jaus::joined_lists<inputs, outputs>;
};

} // namespace services

} // namespace jauscat::sae::core
