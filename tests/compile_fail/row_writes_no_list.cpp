// expect: table: a row has no path_list `writes`
#include "small_table.hpp"

using namespace small;

struct zero {
    using uses = translate::path_list<>;
    using writes = at<&packet::spare>;
    static constexpr translate::errc to_packet(const auto&, auto& packet, translate::sizes) noexcept {
        packet.spare = 0;
        return translate::errc::ok;
    }
    static constexpr translate::errc from_packet(const auto&, auto&, translate::sizes) noexcept {
        return translate::errc::ok;
    }
};
using wrong = table_of<index_row, subindex_row, size_row, zero, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
