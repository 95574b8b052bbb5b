// expect: table: exactly one row must say which packet field counts the data
#include "small_table.hpp"

using namespace small;

using uncounted = translate::constant<at<&packet::count>, 0>;

using wrong = table_of<index_row, subindex_row, size_row, spare_row, uncounted, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
