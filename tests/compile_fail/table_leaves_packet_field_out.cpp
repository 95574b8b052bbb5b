// expect: table: a packet field is not written by any row
#include "small_table.hpp"

using namespace small;

using wrong = table_of<index_row, subindex_row, size_row, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
