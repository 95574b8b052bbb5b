// expect: table: a row names a field that the message or the packet does not have
#include "small_table.hpp"

using namespace small;

using foreign = translate::constant<at<&stranger::field>, 0>;

using wrong = table_of<index_row, subindex_row, size_row, spare_row, foreign, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
