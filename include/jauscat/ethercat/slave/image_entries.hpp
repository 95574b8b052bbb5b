// The PDO entries of a process image, generated from the schema of its struct, so that the slave's description and the
// table always agree.
#pragma once
#include <jauscat/ethercat/slave/pdo_entry.hpp>
#include <jauscat/schema/ethercat/data_types.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>

namespace jauscat::ethercat {

namespace detail {

template <class Codec> consteval std::uint8_t data_type_of() noexcept {
    using value = typename Codec::value_type;
    if constexpr (std::is_enum_v<value>) {
        return data_type_of<wire::integer<std::underlying_type_t<value>, boost::endian::order::little>>();
    } else {
        static_assert(std::is_integral_v<value> || std::is_floating_point_v<value>,
                      "image_entries: a field of an image must be a number");
        using namespace data_types;
        constexpr std::size_t size = Codec::size;
        if (std::is_floating_point_v<value>) return size == 4 ? real32 : real64;
        if (std::is_signed_v<value>)
            return size == 1 ? integer8 : size == 2 ? integer16 : size == 4 ? integer32 : integer64;
        return size == 1 ? unsigned8 : size == 2 ? unsigned16 : size == 4 ? unsigned32 : unsigned64;
    }
}

struct entry_numbers {
    std::uint16_t index{};
    std::uint8_t subindex{};
};

template <class Item> struct entries_of; // no specialisation: an image has numbers and bits
template <auto Member, class Codec> struct entries_of<wire::field<Member, Codec>> {
    static constexpr std::size_t count = 1;
    static constexpr void put(pdo_entry*& out, entry_numbers& next) noexcept {
        *out++ = {.index = next.index,
                  .subindex = ++next.subindex,
                  .bits = static_cast<std::uint8_t>(Codec::size * 8),
                  .data_type = data_type_of<Codec>(),
                  .name = wire::member_name<Member>};
    }
};
template <auto Member, std::size_t Width> struct entries_of<wire::bit_field<Member, Width>> {
    static constexpr std::size_t count = 1;
    static constexpr void put(pdo_entry*& out, entry_numbers& next) noexcept {
        static_assert(Width <= 8, "image_entries: a field of bits has 8 at most, BIT1 to BIT8; declare it as a number");
        static_assert(!wire::bit_field<Member, Width>::is_signed,
                      "image_entries: EtherCAT has no data type for a signed field of bits; declare it as a number");
        constexpr auto type =
            std::is_same_v<wire::member_t<Member>, bool> ? data_types::boolean : data_types::bit1 + Width - 1;
        *out++ = {.index = next.index,
                  .subindex = ++next.subindex,
                  .bits = Width,
                  .data_type = static_cast<std::uint8_t>(type),
                  .name = wire::member_name<Member>};
    }
};
template <std::size_t Width> struct entries_of<wire::reserved<Width>> { // a gap: index 0
    static constexpr std::size_t count = 1;
    static constexpr void put(pdo_entry*& out, entry_numbers&) noexcept { *out++ = {.bits = Width}; }
};
template <class... Items> struct entries_of_all {
    static constexpr std::size_t count = (entries_of<Items>::count + ... + 0);
    static constexpr void put(pdo_entry*& out, entry_numbers& next) noexcept {
        (entries_of<Items>::put(out, next), ...);
    }
};
template <class Carrier, class... Fields>
struct entries_of<wire::bit_fields<Carrier, Fields...>> : entries_of_all<Fields...> {};
template <class... Items> struct entries_of<wire::layout<Items...>> : entries_of_all<Items...> {};

} // namespace detail

/// The entries of `Image` in wire order, as subindices from 1 of the object `Index`: for slave_description::outputs or
/// inputs. ETG.5001 has outputs at 7000h and inputs at 6000h.
template <wire::fixed_message Image, std::uint16_t Index>
inline constexpr auto image_entries = [] {
    using made = detail::entries_of<wire::layout_of<Image>>;
    static_assert(made::count <= process_memory::max_entries, "image_entries: too many fields");
    std::array<pdo_entry, made::count> entries{};
    pdo_entry* out = entries.data();
    detail::entry_numbers next{.index = Index};
    made::put(out, next);
    return entries;
}();

/// First object indices of process data, ETG.5001.
namespace image_objects {
inline constexpr std::uint16_t inputs = 0x6000;
inline constexpr std::uint16_t outputs = 0x7000;
} // namespace image_objects

} // namespace jauscat::ethercat
