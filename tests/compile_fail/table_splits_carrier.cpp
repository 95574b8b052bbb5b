// expect: table: rest would split an integer that bit-fields share; use all of its fields or none
#include "small_table.hpp"

using namespace small;

using half = translate::copy<at<&head::priority>, at<&packet::spare>>;

using wrong = table_of<index_row, subindex_row, size_row, half, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
