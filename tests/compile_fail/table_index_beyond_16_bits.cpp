// expect: offset: base plus the largest value does not fit an object index of 16 bits
#include "small_table.hpp"

using namespace small;

using high = translate::offset<at<&head::component>, at<&packet::index>, 0xFF01>;

using wrong = table_of<high, subindex_row, size_row, spare_row, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
