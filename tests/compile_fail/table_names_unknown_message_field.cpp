// expect: table: a row names a field that the message or the packet does not have
#include "small_table.hpp"

using namespace small;

using foreign = translate::copy<at<&stranger::field>, at<&packet::spare>>;

using wrong = table_of<index_row, subindex_row, size_row, foreign, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
