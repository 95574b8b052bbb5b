// expect: table: a message field is used by two rows
#include "small_table.hpp"

using namespace small;

using again = translate::copy<at<&head::component>, at<&packet::spare>>;

using wrong = table_of<index_row, subindex_row, size_row, again, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
