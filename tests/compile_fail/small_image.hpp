// A small table into a process image that is right. Each image_*.cpp makes one mistake in it.
#pragma once
#include <jauscat/translate/image_translator.hpp>

namespace small {

struct percent {
    static constexpr double min = 0, max = 100;
};
struct command {
    std::uint8_t mode{};
    std::optional<double> left{}, right{};
};
struct image {
    std::uint16_t count{};
    std::uint8_t presence{};
    std::uint16_t mode{};
    std::uint8_t left{}, right{};
    std::uint32_t wide{};
};

} // namespace small

template <> struct jauscat::wire::schema<small::command> {
    using T = small::command;
    using type =
        layout<field<&T::mode, u8>,
               presence<u8, field<&T::left, scaled<u8, small::percent>>, field<&T::right, scaled<u8, small::percent>>>>;
};
template <> struct jauscat::wire::schema<small::image> {
    using T = small::image;
    using type = layout<field<&T::count, u16le>, field<&T::presence, u8>, field<&T::mode, u16le>, field<&T::left, u8>,
                        field<&T::right, u8>, field<&T::wide, u32le>>;
};

namespace small {

namespace translate = jauscat::translate;
using translate::at;

using count_row = translate::counter<at<&image::count>>;
using presence_row = translate::presence_bits<at<&image::presence>>;
using mode_row = translate::copy<at<&command::mode>, at<&image::mode>>;
using left_row = translate::element<at<&command::left>, at<&image::left>>;
using right_row = translate::element<at<&command::right>, at<&image::right>>;
using wide_row = translate::constant<at<&image::wide>, 0>;

template <class... Rows> using table_of = translate::image_table<command, image, Rows...>;

/// Translates with a table, as a program would.
template <class Table> constexpr translate::errc error_of_nothing() {
    return translate::image_translator<Table>::to_image({}, {}).error();
}

} // namespace small
