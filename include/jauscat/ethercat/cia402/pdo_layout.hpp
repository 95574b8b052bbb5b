// Where objects are in a slave's outputs and inputs: at compile time for known PDOs, at run time for those read.
#pragma once

#include <jauscat/schema/ethercat/cia402_objects.hpp>
#include <jauscat/schema/ethercat/pdo.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <type_traits>

namespace jauscat::cia402 {

/// The place of an object in outputs or inputs. Values are little endian and start at any bit.
struct pdo_place {
    std::uint32_t first_bit{};
    std::uint8_t bits{};     ///< 0: the process data do not have the object
    std::uint8_t subindex{}; ///< of the object
    std::uint16_t index{};   ///< 0: not known, as of a place that was not found in a layout

    [[nodiscard]] constexpr bool is_mapped() const noexcept { return bits != 0; }
    [[nodiscard]] constexpr bool fits(std::size_t bytes) const noexcept {
        return std::uint64_t{first_bit} + bits <= std::uint64_t{bytes} * 8;
    }
    friend constexpr bool operator==(const pdo_place&, const pdo_place&) = default;
};

/// Stores an integer or enumeration in the place's bits, sign-extended where the place is wider. Changes nothing where
/// it is not mapped or does not fit.
template <class Value> constexpr void store(pdo_place place, std::span<std::byte> image, Value value) noexcept {
    if (!place.is_mapped() || !place.fits(image.size())) return;
    auto rest = static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
    std::size_t at = place.first_bit / 8;
    unsigned skip = place.first_bit % 8;
    for (unsigned left = place.bits; left != 0; ++at, skip = 0) {
        const unsigned taken = std::min(8 - skip, left);
        const auto mask = static_cast<unsigned>((0xFFu >> (8 - taken)) << skip);
        const auto kept = std::to_integer<unsigned>(image[at]) & ~mask;
        image[at] = static_cast<std::byte>(kept | ((static_cast<unsigned>(rest & 0xFF) << skip) & mask));
        rest >>= taken;
        left -= taken;
    }
}
/// The place's bits, sign-extended where `Value` is signed; 0 where the place is not mapped or does not fit.
template <class Value> [[nodiscard]] constexpr Value load(pdo_place place, std::span<const std::byte> image) noexcept {
    if (!place.is_mapped() || !place.fits(image.size())) return Value{};
    std::uint64_t value = 0;
    std::size_t at = place.first_bit / 8;
    unsigned skip = place.first_bit % 8;
    unsigned got = 0;
    const unsigned wanted = std::min<unsigned>(place.bits, 64);
    for (; got < wanted; ++at, skip = 0) {
        const unsigned taken = std::min(8 - skip, wanted - got);
        const auto bits = std::to_integer<unsigned>(image[at]) >> skip & (0xFFu >> (8 - taken));
        value |= std::uint64_t{bits} << got;
        got += taken;
    }
    using number = typename std::conditional_t<std::is_enum_v<Value>, std::underlying_type<Value>,
                                               std::type_identity<Value>>::type;
    if constexpr (std::is_signed_v<number>) {
        const auto sign = std::uint64_t{1} << (wanted - 1);
        value = (value ^ sign) - sign;
    }
    return static_cast<Value>(static_cast<number>(value));
}

/// An entry of a PDO as 1600h to 1BFFh have it: index << 16 | subindex << 8 | bits.
[[nodiscard]] constexpr ethercat::pdo_mapping mapping_of(std::uint32_t value) noexcept {
    return {.bits = static_cast<std::uint8_t>(value),
            .subindex = static_cast<std::uint8_t>(value >> 8),
            .index = static_cast<std::uint16_t>(value >> 16)};
}
[[nodiscard]] constexpr ethercat::pdo_mapping mapping_of(const object& object, std::size_t axis = 0) noexcept {
    return {.bits = object.bits, .subindex = object.subindex, .index = object.index_of(axis)};
}
/// `bits` without an object.
[[nodiscard]] constexpr ethercat::pdo_mapping padding(std::uint8_t bits) noexcept { return {.bits = bits}; }

/// All entries of a slave's outputs or inputs, in the order of the assigned PDOs (1C12h or 1C13h) and of their entries.
template <std::size_t Capacity = 64> class pdo_layout {
  public:
    constexpr pdo_layout() noexcept = default;
    constexpr pdo_layout(std::initializer_list<ethercat::pdo_mapping> entries) noexcept {
        for (const auto& each : entries) static_cast<void>(append(each));
    }

    /// False where there is no more capacity: bits behind the last entry have no place.
    [[nodiscard]] constexpr bool append(const ethercat::pdo_mapping& mapped) noexcept {
        if (count_ == Capacity) return false;
        entries_[count_++] = {
            .first_bit = bits_, .bits = mapped.bits, .subindex = mapped.subindex, .index = mapped.index};
        bits_ += mapped.bits;
        return true;
    }
    /// Bytes of the process data.
    [[nodiscard]] constexpr std::size_t size() const noexcept { return (bits_ + 7) / 8; }

    /// Not mapped where no entry has the object; the first one where several have it.
    [[nodiscard]] constexpr pdo_place find(std::uint16_t index, std::uint8_t subindex) const noexcept {
        if (index == 0) return {}; // padding
        for (std::size_t i = 0; i != count_; ++i)
            if (entries_[i].index == index && entries_[i].subindex == subindex) return entries_[i];
        return {};
    }
    [[nodiscard]] constexpr pdo_place find(const object& object, std::size_t axis = 0) const noexcept {
        return find(object.index_of(axis), object.subindex);
    }

  private:
    std::array<pdo_place, Capacity> entries_{};
    std::size_t count_{};
    std::uint32_t bits_{};
};

/// RxPDO and TxPDO that most drives have or can map: the cyclic modes in one mapping. Multi-axis drives repeat it.
inline constexpr pdo_layout<8> cyclic_outputs{
    mapping_of(objects::controlword),     mapping_of(objects::mode_of_operation), padding(8),
    mapping_of(objects::target_position), mapping_of(objects::target_velocity),   mapping_of(objects::target_torque)};
inline constexpr pdo_layout<8> cyclic_inputs{
    mapping_of(objects::statusword),      mapping_of(objects::mode_display),    padding(8),
    mapping_of(objects::position_actual), mapping_of(objects::velocity_actual), mapping_of(objects::torque_actual),
    mapping_of(objects::error_code)};

} // namespace jauscat::cia402
