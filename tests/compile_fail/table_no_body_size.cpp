// expect: table: exactly one row must say which message field states the body's size
#include "small_table.hpp"

using namespace small;

using wrong = table_of<index_row, subindex_row, spare_row, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
