// expect: no error
#include "small_table.hpp"

using namespace small;

struct zero {
    using uses = translate::path_list<>;
    using writes = translate::path_list<at<&packet::spare>>;
    static constexpr translate::errc to_packet(const auto&, auto& packet, translate::sizes) noexcept {
        packet.spare = 0;
        return translate::errc::ok;
    }
    static constexpr translate::errc from_packet(const auto&, auto&, translate::sizes) noexcept {
        return translate::errc::ok;
    }
};
static_assert(translate::row<zero, head, packet>);

using right = table_of<index_row, subindex_row, size_row, zero, count_row, rest_row>;
static_assert(error_of_nothing<right>() == translate::errc::truncated);
