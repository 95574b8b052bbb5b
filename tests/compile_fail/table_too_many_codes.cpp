// expect: code_rank: more than 254 command codes do not fit a subindex (255 is reserved)
#include "small_table.hpp"

using namespace small;

constexpr auto many_codes = [] {
    std::array<std::uint16_t, 255> codes{};
    for (std::size_t i = 0; i != codes.size(); ++i) codes[i] = static_cast<std::uint16_t>(i);
    return codes;
}();
using many = translate::code_rank<at<&head::code>, at<&packet::subindex>, many_codes>;

using wrong = table_of<index_row, many, size_row, spare_row, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
