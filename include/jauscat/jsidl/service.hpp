// A service definition without its prose: messages, their elements in wire order, units, limits and named values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace jauscat::jsidl {

/// Type of a number on the wire, little-endian.
enum class scalar : std::uint8_t { u8, u16, u32, u64, i8, i16, i32, i64, f32, f64 };

enum class kind : std::uint8_t {
    number,         ///< fixed_field
    choice,         ///< variable_field: an index, then a number in the form of one of the children
    choice_form,    ///< type_and_units_enum
    bits,           ///< bit_field: the children in one number
    bit_part,       ///< sub_field
    fixed_string,   ///< fixed_length_string
    string,         ///< variable_length_string
    blob,           ///< variable_length_field: octets in one format
    formatted_blob, ///< variable_format_field: the index of a format, then octets
    format,         ///< format_enum
    array,          ///< the child, as often as the product of the dimensions says
    record,
    sequence,
    list,    ///< a count, then the child as often
    variant, ///< a tag, then the child with this number
};

/// Real limits of a scaled number: `min` is 0 on the wire, `max` the largest number.
struct scale {
    double min{};
    double max{};
    friend bool operator==(const scale&, const scale&) = default;
};

struct named_value {
    std::int64_t value{};
    std::string name{};
    friend bool operator==(const named_value&, const named_value&) = default;
};

struct value_range {
    double min{};
    double max{};
    bool with_min{true}; ///< the limit is in the range
    bool with_max{true};
    friend bool operator==(const value_range&, const value_range&) = default;
};

/// A part of a message. Which members count depends on its kind.
struct element {
    jsidl::kind kind{};
    std::string name{};
    bool optional{};
    scalar type{};                    ///< of a number, choice_form, bits; of a count, tag or index before the value
    std::optional<scalar> presence{}; ///< record, sequence: type of the presence vector
    std::string unit{};               ///< number, choice_form; "one" without a unit
    std::optional<jsidl::scale> scale{};
    std::vector<named_value> names{};
    std::vector<value_range> ranges{};
    std::uint64_t min_count{};               ///< of a count
    std::uint64_t max_count{};               ///< of a count; the length of a fixed_string
    std::vector<std::uint32_t> dimensions{}; ///< array
    std::uint32_t first_bit{};               ///< bit_part
    std::uint32_t last_bit{};                ///< bit_part
    std::uint32_t index{};                   ///< choice_form, format: the number on the wire
    std::string format{};                    ///< blob, format
    std::vector<element> children{};
    /// list: elements that the message holds; 0: they are in memory of the caller. No file says so: the writer of
    /// schemas does.
    std::size_t capacity{};
    std::size_t line{}; ///< of the file, from 1

    /// Equal on the wire and in its names. The lines are not compared.
    friend bool operator==(const element& a, const element& b) {
        return a.kind == b.kind && a.name == b.name && a.optional == b.optional && a.type == b.type &&
               a.presence == b.presence && a.unit == b.unit && a.scale == b.scale && a.names == b.names &&
               a.ranges == b.ranges && a.min_count == b.min_count && a.max_count == b.max_count &&
               a.dimensions == b.dimensions && a.first_bit == b.first_bit && a.last_bit == b.last_bit &&
               a.index == b.index && a.format == b.format && a.children == b.children && a.capacity == b.capacity;
    }
};

struct message {
    std::string name{};
    std::uint16_t id{};
    bool is_command{};
    bool is_deprecated{};
    std::optional<element> body{}; ///< none: the message has no body
    std::size_t line{};

    friend bool operator==(const message& a, const message& b) {
        return a.name == b.name && a.id == b.id && a.is_command == b.is_command && a.is_deprecated == b.is_deprecated &&
               a.body == b.body;
    }
};

struct service_reference {
    std::string name{}; ///< under which the definition refers to the service
    std::string id{};
    std::string version{};
    friend bool operator==(const service_reference&, const service_reference&) = default;
};

struct service {
    std::string name{};
    std::string id{}; ///< its URI, such as urn:jaus:jss:core:Events
    std::string version{};
    std::optional<service_reference> inherits{};
    std::vector<service_reference> uses{}; ///< client_of
    std::vector<message> inputs{};
    std::vector<message> outputs{};
    std::string source{}; ///< the file's name in messages
    std::size_t line{};

    friend bool operator==(const service& a, const service& b) {
        return a.name == b.name && a.id == b.id && a.version == b.version && a.inherits == b.inherits &&
               a.uses == b.uses && a.inputs == b.inputs && a.outputs == b.outputs;
    }
};

} // namespace jauscat::jsidl
