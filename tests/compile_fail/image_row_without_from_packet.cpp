// expect: table: a row has no static from_packet(const auto& packet, auto& message, sizes) noexcept that returns an
// errc
#include "small_image.hpp"

using namespace small;

struct zero {
    using uses = translate::path_list<>;
    using writes = translate::path_list<at<&image::wide>>;
    static constexpr translate::errc to_packet(const auto&, auto&, translate::sizes) noexcept {
        return translate::errc::ok;
    }
};
using wrong = table_of<count_row, presence_row, mode_row, left_row, right_row, zero>;
static_assert(error_of_nothing<wrong>() == translate::errc::no_space);
