// expect: path_list: a row names what is no field; write at<&T::member>
#include "small_table.hpp"

using namespace small;

using no_path = translate::caller_set<packet>;
using wrong = table_of<index_row, subindex_row, size_row, no_path, count_row, rest_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::truncated);
