// expect: table: a message field is used by no row, and there is no row `rest` to carry it
#include "small_table.hpp"

using namespace small;

using wrong = table_of<index_row, subindex_row, size_row, spare_row, count_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
