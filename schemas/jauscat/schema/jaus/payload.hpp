// Payload subgroup of RA 3.3 part 3: a payload describes its own commands and measurements, then exchanges their
// values.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/jaus/types.hpp>
#include <jauscat/wire/schema.hpp>

#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// Type Code of an interface: the type of its value.
enum class payload_type : std::uint8_t {
    short_integer = 1,
    integer = 2,
    long_integer = 3,
    byte = 4,
    unsigned_short_integer = 5,
    unsigned_integer = 6,
    unsigned_long_integer = 7,
    float_ = 8,
    long_float = 9,
    scaled_byte = 10,                   ///< scaled: between the interface's minimum and maximum
    scaled_short_integer = 11,          ///< scaled
    scaled_unsigned_short_integer = 12, ///< scaled
    scaled_integer = 13,                ///< scaled
    scaled_unsigned_integer = 14,       ///< scaled
    scaled_long_integer = 15,           ///< scaled
    scaled_unsigned_long_integer = 16,  ///< scaled
    enumeration = 17,                   ///< place in the interface's enumeration
    boolean = 18,
    string = 19,
    byte_tuple = 20,
    unsigned_short_integer_tuple = 21,
    unsigned_integer_tuple = 22,
};

/// Two numbers of the same type.
template <class Integer> struct payload_tuple {
    Integer first{};  ///< any value
    Integer second{}; ///< any value
    friend constexpr bool operator==(const payload_tuple&, const payload_tuple&) = default;

    struct schema : wire::items {
        using T = payload_tuple;
        using number = wire::integer<Integer, boost::endian::order::little>;
        using type = layout<field<&T::first, number>, field<&T::second, number>>;
    };
};

/// The text of a payload value. 2 bytes or more.
struct payload_string {
    std::string_view value{}; ///< up to 65535 characters
    friend constexpr bool operator==(const payload_string&, const payload_string&) = default;

    struct schema : wire::items {
        using T = payload_string;
        using type = layout<string<&T::value, count<"length", u16le>>>;
    };
};

/// The value of one payload data element. 1 byte or more. The type does not travel with it: it is what Report Payload
/// Interface gave for the interface, and is set before decoding.
struct payload_value {
    payload_type type_code{}; ///< what `value` holds; a scaled type holds the raw integer
    std::variant<std::int16_t, std::int32_t, std::int64_t, std::uint8_t, std::uint16_t, std::uint32_t, std::uint64_t,
                 float, double, payload_string, payload_tuple<std::uint8_t>, payload_tuple<std::uint16_t>,
                 payload_tuple<std::uint32_t>>
        value{}; ///< as `type_code` says
    friend constexpr bool operator==(const payload_value&, const payload_value&) = default;

    struct schema : wire::items {
        using T = payload_value;
        using type = layout<
            not_on_wire<&T::type_code>,
            selected<&T::value, by<&T::type_code>,
                when<payload_type::short_integer, i16le>,
                when<payload_type::integer, i32le>,
                when<payload_type::long_integer, i64le>,
                when<payload_type::byte, u8>,
                when<payload_type::unsigned_short_integer, u16le>,
                when<payload_type::unsigned_integer, u32le>,
                when<payload_type::unsigned_long_integer, u64le>,
                when<payload_type::float_, f32le>,
                when<payload_type::long_float, f64le>,
                when<payload_type::scaled_byte, u8>,
                when<payload_type::scaled_short_integer, i16le>,
                when<payload_type::scaled_unsigned_short_integer, u16le>,
                when<payload_type::scaled_integer, i32le>,
                when<payload_type::scaled_unsigned_integer, u32le>,
                when<payload_type::scaled_long_integer, i64le>,
                when<payload_type::scaled_unsigned_long_integer, u64le>,
                when<payload_type::enumeration, u16le>,
                when<payload_type::boolean, u8>,
                when<payload_type::string, payload_string>,
                when<payload_type::byte_tuple, payload_tuple<std::uint8_t>>,
                when<payload_type::unsigned_short_integer_tuple, payload_tuple<std::uint16_t>>,
                when<payload_type::unsigned_integer_tuple, payload_tuple<std::uint32_t>>>>;
    };
};

/// Minimum, default or maximum of an interface, by its type code: the type itself, for the scaled types a float.
using payload_limit = std::variant<std::int16_t, std::int32_t, std::int64_t, std::uint8_t, std::uint16_t, std::uint32_t,
                                   std::uint64_t, float, double, payload_tuple<std::uint8_t>,
                                   payload_tuple<std::uint16_t>, payload_tuple<std::uint32_t>>;

/// A `payload_limit` member on the wire, laid out by the record's type code.
template <auto Value, auto TypeCode> using payload_limit_item = wire::selected<Value, wire::by<TypeCode>,
    wire::when<payload_type::short_integer, wire::i16le>,
    wire::when<payload_type::integer, wire::i32le>,
    wire::when<payload_type::long_integer, wire::i64le>,
    wire::when<payload_type::byte, wire::u8>,
    wire::when<payload_type::unsigned_short_integer, wire::u16le>,
    wire::when<payload_type::unsigned_integer, wire::u32le>,
    wire::when<payload_type::unsigned_long_integer, wire::u64le>,
    wire::when<payload_type::float_, wire::f32le>,
    wire::when<payload_type::long_float, wire::f64le>,
    wire::when<payload_type::scaled_byte, wire::f32le>,
    wire::when<payload_type::scaled_short_integer, wire::f32le>,
    wire::when<payload_type::scaled_unsigned_short_integer, wire::f32le>,
    wire::when<payload_type::scaled_integer, wire::f32le>,
    wire::when<payload_type::scaled_unsigned_integer, wire::f32le>,
    wire::when<payload_type::scaled_long_integer, wire::f32le>,
    wire::when<payload_type::scaled_unsigned_long_integer, wire::f32le>,
    wire::when<payload_type::enumeration, wire::u8>,
    wire::when<payload_type::boolean, wire::u8>,
    wire::when<payload_type::string, wire::u8>,
    wire::when<payload_type::byte_tuple, payload_tuple<std::uint8_t>>,
    wire::when<payload_type::unsigned_short_integer_tuple, payload_tuple<std::uint16_t>>,
    wire::when<payload_type::unsigned_integer_tuple, payload_tuple<std::uint32_t>>>;

/// Blocking Flag of a command interface. Which value means which is uncertain.
enum class payload_blocking_flag : std::uint8_t {
    blocking = 0,
    non_blocking = 1,
};

/// One command that a payload takes.
struct payload_command_interface {
    std::string_view command_identifier{};            ///< name of the command
    payload_type type_code{};                         ///< type of its value
    std::uint8_t units{};                             ///< code of the value's unit
    payload_blocking_flag blocking_flag{};            ///< whether the payload finishes it before the next
    payload_limit minimum_value{};                    ///< of the type code's type
    payload_limit default_value{};                    ///< of the type code's type
    payload_limit maximum_value{};                    ///< of the type code's type
    std::string_view enumeration{};                   ///< names between commas, a zero at the end; empty for none
    std::optional<std::uint8_t> hmi_recommendation{}; ///< how an operator's display may show it
    std::optional<std::uint16_t> hmi_recommended_x_position{}; ///< pixels
    std::optional<std::uint16_t> hmi_recommended_y_position{}; ///< pixels
    std::optional<std::uint16_t> hmi_recommended_width{};      ///< pixels
    std::optional<std::uint16_t> hmi_recommended_height{};     ///< pixels
    friend constexpr bool operator==(const payload_command_interface&, const payload_command_interface&) = default;

    struct schema; ///< below the message, whose flags it goes by
};

/// One measurement that a payload gives.
struct payload_information_interface {
    std::string_view information_identifier{};        ///< name of the measurement
    std::uint8_t command_interface_association{};     ///< command that it belongs to, from 1; 0 for none
    payload_type type_code{};                         ///< type of its value
    std::uint8_t units{};                             ///< code of the value's unit
    payload_limit minimum_value{};                    ///< of the type code's type
    payload_limit default_value{};                    ///< of the type code's type
    payload_limit maximum_value{};                    ///< of the type code's type
    std::string_view enumeration{};                   ///< names between commas, a zero at the end; empty for none
    std::optional<std::uint8_t> hmi_recommendation{}; ///< how an operator's display may show it
    std::optional<std::uint16_t> hmi_recommended_x_position{}; ///< pixels
    std::optional<std::uint16_t> hmi_recommended_y_position{}; ///< pixels
    std::optional<std::uint16_t> hmi_recommended_width{};      ///< pixels
    std::optional<std::uint16_t> hmi_recommended_height{};     ///< pixels
    friend constexpr bool operator==(const payload_information_interface&,
                                     const payload_information_interface&) = default;

    struct schema; ///< below the message, whose flags it goes by
};

/// Set Payload Data Element: gives commands to a payload.
/// Code 0D01h, command class, 1 byte or more.
struct set_payload_data_element {
    std::uint8_t number_of_payload_command_elements{}; ///< elements in the bytes that follow
    wire::blob element{}; ///< for each: number of the command interface from 1 (1 byte), then a payload_value
    friend constexpr bool operator==(const set_payload_data_element&, const set_payload_data_element&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0D01;
        using T = set_payload_data_element;
        using type = layout<
            field<&T::number_of_payload_command_elements, u8>,
            bytes<&T::element, rest>>;
    };
};

/// Query Payload Interface: asks for Report Payload Interface.
/// Code 2D00h, query class, no body.
struct query_payload_interface {
    friend constexpr bool operator==(const query_payload_interface&, const query_payload_interface&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2D00;
        using report = struct report_payload_interface;
        using type = layout<>;
    };
};

/// Query Payload Data Element: asks for Report Payload Data Element.
/// Code 2D01h, query class, 1 byte or more.
struct query_payload_data_element {
    wire::inline_list<std::uint8_t, 255> information_interface_number{}; ///< what is asked for, from 1
    friend constexpr bool operator==(const query_payload_data_element&, const query_payload_data_element&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2D01;
        using report = struct report_payload_data_element;
        using T = query_payload_data_element;
        using type = layout<
            repeated<&T::information_interface_number, count<"number_of_payload_information_elements", u8>,
                element<"element", u8>>>;
    };
};

/// Report Payload Interface: the commands that a payload takes and the measurements that it gives.
/// Code 4D00h, inform class, 3 bytes or more.
struct report_payload_interface {
    bool hmi_recommendation_present{};                                 ///< in every interface
    bool hmi_recommended_x_position_present{};                         ///< in every interface
    bool hmi_recommended_y_position_present{};                         ///< in every interface
    bool hmi_recommended_width_present{};                              ///< in every interface
    bool hmi_recommended_height_present{};                             ///< in every interface
    std::uint8_t number_of_command_interfaces{};                       ///< size of `command_interface`
    std::uint8_t number_of_information_interfaces{};                   ///< size of `information_interface`
    wire::list<payload_command_interface> command_interface{};         ///< numbered from 1
    wire::list<payload_information_interface> information_interface{}; ///< numbered from 1
    friend constexpr bool operator==(const report_payload_interface&, const report_payload_interface&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4D00;
        using query = query_payload_interface;
        using T = report_payload_interface;
        using type = layout<
            lenient_presence<u8,
                presence_flag<&T::hmi_recommendation_present>,
                presence_flag<&T::hmi_recommended_x_position_present>,
                presence_flag<&T::hmi_recommended_y_position_present>,
                presence_flag<&T::hmi_recommended_width_present>,
                presence_flag<&T::hmi_recommended_height_present>,
                field<&T::number_of_command_interfaces, u8>,
                field<&T::number_of_information_interfaces, u8>,
                repeated<&T::command_interface, counted_by<&T::number_of_command_interfaces>>,
                repeated<&T::information_interface, counted_by<&T::number_of_information_interfaces>>>>;
    };
};

struct payload_command_interface::schema : wire::items {
    using T = payload_command_interface;
    using M = report_payload_interface;
    using type = layout<
        string<&T::command_identifier, zero_terminated>,
        field<&T::type_code, wire::enumeration<payload_type, u8>>,
        field<&T::units, u8>,
        field<&T::blocking_flag, wire::enumeration<payload_blocking_flag, u8>>,
        payload_limit_item<&T::minimum_value, &T::type_code>,
        payload_limit_item<&T::default_value, &T::type_code>,
        payload_limit_item<&T::maximum_value, &T::type_code>,
        string<&T::enumeration, count<"enumeration_length", u16le>>,
        gated_by<&M::hmi_recommendation_present, field<&T::hmi_recommendation, u8>>,
        gated_by<&M::hmi_recommended_x_position_present,
            field<&T::hmi_recommended_x_position, in_units<u16le, pixels>>>,
        gated_by<&M::hmi_recommended_y_position_present,
            field<&T::hmi_recommended_y_position, in_units<u16le, pixels>>>,
        gated_by<&M::hmi_recommended_width_present, field<&T::hmi_recommended_width, in_units<u16le, pixels>>>,
        gated_by<&M::hmi_recommended_height_present, field<&T::hmi_recommended_height, in_units<u16le, pixels>>>>;
};

struct payload_information_interface::schema : wire::items {
    using T = payload_information_interface;
    using M = report_payload_interface;
    using type = layout<
        string<&T::information_identifier, zero_terminated>,
        field<&T::command_interface_association, u8>,
        field<&T::type_code, wire::enumeration<payload_type, u8>>,
        field<&T::units, u8>,
        payload_limit_item<&T::minimum_value, &T::type_code>,
        payload_limit_item<&T::default_value, &T::type_code>,
        payload_limit_item<&T::maximum_value, &T::type_code>,
        string<&T::enumeration, count<"enumeration_length", u16le>>,
        gated_by<&M::hmi_recommendation_present, field<&T::hmi_recommendation, u8>>,
        gated_by<&M::hmi_recommended_x_position_present,
            field<&T::hmi_recommended_x_position, in_units<u16le, pixels>>>,
        gated_by<&M::hmi_recommended_y_position_present,
            field<&T::hmi_recommended_y_position, in_units<u16le, pixels>>>,
        gated_by<&M::hmi_recommended_width_present, field<&T::hmi_recommended_width, in_units<u16le, pixels>>>,
        gated_by<&M::hmi_recommended_height_present, field<&T::hmi_recommended_height, in_units<u16le, pixels>>>>;
};

/// Report Payload Data Element: measurements of a payload.
/// Code 4D01h, inform class, 1 byte or more.
struct report_payload_data_element {
    std::uint8_t number_of_payload_information_elements{}; ///< elements in the bytes that follow
    wire::blob element{}; ///< for each: number of the information interface from 1 (1 byte), then a payload_value
    friend constexpr bool operator==(const report_payload_data_element&, const report_payload_data_element&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4D01;
        using query = query_payload_data_element;
        using T = report_payload_data_element;
        using type = layout<
            field<&T::number_of_payload_information_elements, u8>,
            bytes<&T::element, rest>>;
    };
};

/// The messages of the subgroup, by command code.
using payload_subgroup = message_list<
    set_payload_data_element,
    query_payload_interface,
    query_payload_data_element,
    report_payload_interface,
    report_payload_data_element>;

} // namespace jauscat::jaus
