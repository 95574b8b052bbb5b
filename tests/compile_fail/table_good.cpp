// expect: no error
#include "small_table.hpp"

using namespace small;

static_assert(error_of_nothing<right_table>() == translate::errc::truncated);
