// expect: table: a row has no static to_packet(const auto& message, auto& packet, sizes) noexcept that returns an errc
#include "small_table.hpp"

using namespace small;

struct zero {
    using uses = translate::path_list<>;
    using writes = translate::path_list<at<&packet::spare>>;
    static constexpr translate::errc to_packet(const auto&, auto&) noexcept { return translate::errc::ok; }
    static constexpr translate::errc from_packet(const auto&, auto&, translate::sizes) noexcept {
        return translate::errc::ok;
    }
};
using wrong = table_of<index_row, subindex_row, size_row, zero, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
