// A small table that is right. Each table_*.cpp makes one mistake in it.
#pragma once
#include <jauscat/translate/translator.hpp>

#include <array>

namespace small {

struct head {
    std::uint8_t component{};
    std::uint16_t code{};
    std::uint8_t priority{}, flag{};
    std::uint16_t size{};
};
struct packet {
    std::uint32_t index{}, subindex{}, spare{}, count{};
};
struct stranger {
    std::uint32_t field{};
};

} // namespace small

template <> struct jauscat::wire::schema<small::head> {
    using T = small::head;
    using type = layout<field<&T::component, u8>, field<&T::code, u16le>,
                        bit_fields<u8, bit_field<&T::priority, 4>, bit_field<&T::flag, 4>>, field<&T::size, u16le>>;
};
template <> struct jauscat::wire::schema<small::packet> {
    using T = small::packet;
    using type =
        layout<field<&T::index, u32le>, field<&T::subindex, u32le>, field<&T::spare, u32le>, field<&T::count, u32le>>;
};
template <> struct jauscat::wire::schema<small::stranger> {
    using T = small::stranger;
    using type = layout<field<&T::field, u32le>>;
};

namespace small {

namespace translate = jauscat::translate;
using translate::at;

inline constexpr std::array<std::uint16_t, 3> codes{0x0001, 0x0405, 0x0404};

using index_row = translate::offset<at<&head::component>, at<&packet::index>, 6900>;
using subindex_row = translate::code_rank<at<&head::code>, at<&packet::subindex>, codes>;
using size_row = translate::body_size<at<&head::size>>;
using spare_row = translate::constant<at<&packet::spare>, 0>;
using count_row = translate::data_count<at<&packet::count>>;
using rest_row = translate::rest;

template <class... Rows> using table_of = translate::table<head, packet, 100, Rows...>;
using right_table = table_of<index_row, subindex_row, size_row, spare_row, count_row, rest_row>;

/// Translates with a table, as a program would.
template <class Table> constexpr translate::errc error_of_nothing() {
    return translate::translator<Table>::to_packet({}, {}).error();
}

} // namespace small
