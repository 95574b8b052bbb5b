// Objects of an axis that have to be right before its process data run.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/ethercat/cia402/axis_places.hpp>
#include <jauscat/schema/ethercat/cia402_objects.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace jauscat::cia402 {

/// Interpolation time period, 60C2h: `value` x 10^`index` seconds.
struct interpolation_period {
    std::uint8_t value{};
    std::int8_t index{};
    friend constexpr bool operator==(const interpolation_period&, const interpolation_period&) = default;
};

/// `cycle` as 60C2h has it: in milliseconds where that is possible. Nothing for 0, and for times that are no multiple
/// of a power of ten by 1 to 255.
[[nodiscard]] JAUSCAT_CONSTEXPR std::optional<interpolation_period> interpolation_period_of(duration cycle) noexcept;

/// An object and the value to write.
struct start_up_value {
    std::uint16_t index{};
    std::uint8_t subindex{};
    std::array<std::byte, 1> data{};
};

/// The start-up objects of one axis: 60C2h for the cycle time, and 6060h where the process data do not have it.
class axis_start_up {
  public:
    constexpr axis_start_up() noexcept = default;
    /// Without 60C2h where `cycle` has no interpolation_period.
    JAUSCAT_CONSTEXPR axis_start_up(duration cycle, const axis_places& places, std::size_t axis = 0) noexcept;

    /// To be written in PRE-OP, in this order.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::span<const start_up_value> values() const noexcept;

    static constexpr std::size_t capacity = 3;

  private:
    constexpr void append(const object& described, std::size_t axis, auto content) noexcept {
        values_[count_++] = {described.index_of(axis), described.subindex, {static_cast<std::byte>(content)}};
    }

    std::array<start_up_value, capacity> values_{};
    std::size_t count_{};
};

} // namespace jauscat::cia402

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/cia402/impl/start_up.ipp>
#endif
