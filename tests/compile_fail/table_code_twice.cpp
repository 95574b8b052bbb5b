// expect: code_index: a code is listed twice
#include "small_table.hpp"

using namespace small;

constexpr std::array<std::uint16_t, 3> repeated_codes{0x0001, 0x0405, 0x0001};
using repeated = translate::code_rank<at<&head::code>, at<&packet::subindex>, repeated_codes>;

using wrong = table_of<index_row, repeated, size_row, spare_row, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
