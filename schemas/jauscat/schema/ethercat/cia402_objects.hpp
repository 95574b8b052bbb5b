// The objects of the drive profile CiA 402: index, type, access, direction in process data, unit.
#pragma once

#include <jauscat/schema/ethercat/cia402.hpp>
#include <jauscat/schema/ethercat/data_types.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

namespace jauscat::cia402 {

/// What an object's value counts. Those of position, velocity and acceleration are the drive's own: increments of its
/// encoder unless it is configured otherwise.
enum class unit : std::uint8_t {
    none,
    position,      ///< user units of position, mostly increments
    velocity,      ///< user units of velocity: increments/s, rpm or fractions of them, by the drive (60A9h)
    acceleration,  ///< user units of acceleration
    rated_torque,  ///< per mille of the rated torque (6076h)
    torque_slope,  ///< per mille of the rated torque a second
    rated_current, ///< per mille of the rated current (6075h)
    milliampere,
    millinewton_metre,
    millisecond,
    revolution_per_minute,
};

/// Direction in which process data carry an object, seen from the drive.
enum class mapping : std::uint8_t {
    none,    ///< SDO only
    outputs, ///< RxPDO: master to drive
    inputs,  ///< TxPDO: drive to master
};

/// Distance of the objects of two axes of one drive.
inline constexpr std::uint16_t axis_offset = 0x800;
/// Axes that fit below 9FFFh.
inline constexpr std::size_t max_axes = 8;

/// One object of axis 0.
struct object {
    std::uint16_t index{};
    std::uint8_t subindex{};
    std::uint8_t bits{};
    std::uint16_t data_type{}; ///< of `ethercat::data_types`
    bool writable{};
    cia402::mapping mapping{};
    cia402::unit unit{};
    std::string_view name{};

    /// Index of the same object of axis `axis`, from 0.
    [[nodiscard]] constexpr std::uint16_t index_of(std::size_t axis) const noexcept {
        return static_cast<std::uint16_t>(index + axis * axis_offset);
    }
};

/// An object whose value is a `Value`, an integer.
template <class Value> struct object_of : object {
    using value_type = Value;

    constexpr object_of(std::uint16_t number, std::uint8_t entry, bool is_writable, cia402::mapping direction,
                        cia402::unit counts, std::string_view called) noexcept
        : object{.index = number,
                 .subindex = entry,
                 .bits = std::numeric_limits<std::make_unsigned_t<Value>>::digits,
                 .data_type = type(),
                 .writable = is_writable,
                 .mapping = direction,
                 .unit = counts,
                 .name = called} {}

  private:
    static constexpr std::uint16_t type() noexcept {
        using namespace ethercat::data_types;
        constexpr std::size_t size = sizeof(Value);
        if (std::is_signed_v<Value>) return size == 1 ? integer8 : size == 2 ? integer16 : integer32;
        return size == 1 ? unsigned8 : size == 2 ? unsigned16 : unsigned32;
    }
};

namespace detail {
inline constexpr bool rw = true, ro = false;
using i8 = object_of<std::int8_t>;
using i16 = object_of<std::int16_t>;
using i32 = object_of<std::int32_t>;
using u8 = object_of<std::uint8_t>;
using u16 = object_of<std::uint16_t>;
using u32 = object_of<std::uint32_t>;
} // namespace detail

// One line per object, as in the standard's tables.
// clang-format off
namespace objects {
inline constexpr detail::u16 error_code             {0x603F, 0, detail::ro, mapping::inputs,  unit::none,              "Error code"};
inline constexpr detail::u16 controlword            {0x6040, 0, detail::rw, mapping::outputs, unit::none,              "Controlword"};
inline constexpr detail::u16 statusword             {0x6041, 0, detail::ro, mapping::inputs,  unit::none,              "Statusword"};
inline constexpr detail::i16 quick_stop_option      {0x605A, 0, detail::rw, mapping::none,    unit::none,              "Quick stop option code"};
inline constexpr detail::i16 shutdown_option        {0x605B, 0, detail::rw, mapping::none,    unit::none,              "Shutdown option code"};
inline constexpr detail::i16 disable_option         {0x605C, 0, detail::rw, mapping::none,    unit::none,              "Disable operation option code"};
inline constexpr detail::i16 halt_option            {0x605D, 0, detail::rw, mapping::none,    unit::none,              "Halt option code"};
inline constexpr detail::i16 fault_reaction_option  {0x605E, 0, detail::rw, mapping::none,    unit::none,              "Fault reaction option code"};
inline constexpr detail::i8  mode_of_operation      {0x6060, 0, detail::rw, mapping::outputs, unit::none,              "Modes of operation"};
inline constexpr detail::i8  mode_display           {0x6061, 0, detail::ro, mapping::inputs,  unit::none,              "Modes of operation display"};
inline constexpr detail::i32 position_demand        {0x6062, 0, detail::ro, mapping::inputs,  unit::position,          "Position demand value"};
inline constexpr detail::i32 position_actual        {0x6064, 0, detail::ro, mapping::inputs,  unit::position,          "Position actual value"};
inline constexpr detail::u32 following_error_window {0x6065, 0, detail::rw, mapping::none,    unit::position,          "Following error window"};
inline constexpr detail::u16 following_error_time   {0x6066, 0, detail::rw, mapping::none,    unit::millisecond,       "Following error time out"};
inline constexpr detail::u32 position_window        {0x6067, 0, detail::rw, mapping::none,    unit::position,          "Position window"};
inline constexpr detail::u16 position_window_time   {0x6068, 0, detail::rw, mapping::none,    unit::millisecond,       "Position window time"};
inline constexpr detail::i32 velocity_demand        {0x606B, 0, detail::ro, mapping::inputs,  unit::velocity,          "Velocity demand value"};
inline constexpr detail::i32 velocity_actual        {0x606C, 0, detail::ro, mapping::inputs,  unit::velocity,          "Velocity actual value"};
inline constexpr detail::i16 target_torque          {0x6071, 0, detail::rw, mapping::outputs, unit::rated_torque,      "Target torque"};
inline constexpr detail::u16 max_torque             {0x6072, 0, detail::rw, mapping::outputs, unit::rated_torque,      "Max torque"};
inline constexpr detail::i16 torque_demand          {0x6074, 0, detail::ro, mapping::inputs,  unit::rated_torque,      "Torque demand"};
inline constexpr detail::u32 rated_current          {0x6075, 0, detail::ro, mapping::none,    unit::milliampere,       "Motor rated current"};
inline constexpr detail::u32 rated_torque           {0x6076, 0, detail::ro, mapping::none,    unit::millinewton_metre, "Motor rated torque"};
inline constexpr detail::i16 torque_actual          {0x6077, 0, detail::ro, mapping::inputs,  unit::rated_torque,      "Torque actual value"};
inline constexpr detail::i16 current_actual         {0x6078, 0, detail::ro, mapping::inputs,  unit::rated_current,     "Current actual value"};
inline constexpr detail::i32 target_position        {0x607A, 0, detail::rw, mapping::outputs, unit::position,          "Target position"};
inline constexpr detail::i32 home_offset            {0x607C, 0, detail::rw, mapping::none,    unit::position,          "Home offset"};
inline constexpr detail::i32 min_position_limit     {0x607D, 1, detail::rw, mapping::none,    unit::position,          "Min position limit"};
inline constexpr detail::i32 max_position_limit     {0x607D, 2, detail::rw, mapping::none,    unit::position,          "Max position limit"};
inline constexpr detail::u32 max_profile_velocity   {0x607F, 0, detail::rw, mapping::none,    unit::velocity,          "Max profile velocity"};
inline constexpr detail::u32 max_motor_speed        {0x6080, 0, detail::rw, mapping::none,    unit::revolution_per_minute, "Max motor speed"};
inline constexpr detail::u32 profile_velocity       {0x6081, 0, detail::rw, mapping::outputs, unit::velocity,          "Profile velocity"};
inline constexpr detail::u32 profile_acceleration   {0x6083, 0, detail::rw, mapping::none,    unit::acceleration,      "Profile acceleration"};
inline constexpr detail::u32 profile_deceleration   {0x6084, 0, detail::rw, mapping::none,    unit::acceleration,      "Profile deceleration"};
inline constexpr detail::u32 quick_stop_deceleration{0x6085, 0, detail::rw, mapping::none,    unit::acceleration,      "Quick stop deceleration"};
inline constexpr detail::u32 torque_slope           {0x6087, 0, detail::rw, mapping::none,    unit::torque_slope,      "Torque slope"};
inline constexpr detail::i8  homing_method          {0x6098, 0, detail::rw, mapping::none,    unit::none,              "Homing method"};
inline constexpr detail::i32 position_offset        {0x60B0, 0, detail::rw, mapping::outputs, unit::position,          "Position offset"};
inline constexpr detail::i32 velocity_offset        {0x60B1, 0, detail::rw, mapping::outputs, unit::velocity,          "Velocity offset"};
inline constexpr detail::i16 torque_offset          {0x60B2, 0, detail::rw, mapping::outputs, unit::rated_torque,      "Torque offset"};
inline constexpr detail::u8  interpolation_time     {0x60C2, 1, detail::rw, mapping::none,    unit::none,              "Interpolation time period value"};
inline constexpr detail::i8  interpolation_index    {0x60C2, 2, detail::rw, mapping::none,    unit::none,              "Interpolation time index"};
inline constexpr detail::i32 following_error        {0x60F4, 0, detail::ro, mapping::inputs,  unit::position,          "Following error actual value"};
inline constexpr detail::u32 digital_inputs         {0x60FD, 0, detail::ro, mapping::inputs,  unit::none,              "Digital inputs"};
inline constexpr detail::i32 target_velocity        {0x60FF, 0, detail::rw, mapping::outputs, unit::velocity,          "Target velocity"};
inline constexpr detail::u32 supported_modes        {0x6502, 0, detail::ro, mapping::none,    unit::none,              "Supported drive modes"};
} // namespace objects
// clang-format on

} // namespace jauscat::cia402
