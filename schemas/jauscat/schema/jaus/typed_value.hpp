// A value that says its own type. RA 3.3 part 3: event limits of the event messages, feature class attributes of the
// world model messages.
#pragma once
#include <jauscat/wire/schema.hpp>

#include <variant>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// Type of a typed value.
enum class data_type : std::uint8_t {
    byte = 0,
    short_integer = 1,
    integer = 2,
    long_integer = 3,
    unsigned_short_integer = 4,
    unsigned_integer = 5,
    unsigned_long_integer = 6,
    float_ = 7,
    long_float = 8,
    rgb = 9,
    none = 255, ///< no value; only as a feature class attribute
};

/// A colour. 3 bytes.
struct rgb {
    std::uint8_t red{};   ///< 0 to 255
    std::uint8_t green{}; ///< 0 to 255
    std::uint8_t blue{};  ///< 0 to 255
    friend constexpr bool operator==(const rgb&, const rgb&) = default;

    struct schema : wire::items {
        using T = rgb;
        using type = layout<
            field<&T::red, u8>,
            field<&T::green, u8>,
            field<&T::blue, u8>>;
    };
};

/// A type and a value of that type. 1 to 9 bytes.
struct typed_value {
    jaus::data_type data_type{}; ///< what `value` holds
    std::variant<std::uint8_t, std::int16_t, std::int32_t, std::int64_t, std::uint16_t, std::uint32_t, std::uint64_t,
                 float, double, rgb, std::monostate>
        value{}; ///< as the type code says
    friend constexpr bool operator==(const typed_value&, const typed_value&) = default;

    struct schema : wire::items {
        using T = typed_value;
        using type = layout<
            field<&T::data_type, enumeration<jaus::data_type, u8>>,
            selected<&T::value, by<&T::data_type>,
                when<jaus::data_type::byte, u8>,
                when<jaus::data_type::short_integer, i16le>,
                when<jaus::data_type::integer, i32le>,
                when<jaus::data_type::long_integer, i64le>,
                when<jaus::data_type::unsigned_short_integer, u16le>,
                when<jaus::data_type::unsigned_integer, u32le>,
                when<jaus::data_type::unsigned_long_integer, u64le>,
                when<jaus::data_type::float_, f32le>,
                when<jaus::data_type::long_float, f64le>,
                when<jaus::data_type::rgb, rgb>,
                when<jaus::data_type::none>>>;
    };
};

} // namespace jauscat::jaus
