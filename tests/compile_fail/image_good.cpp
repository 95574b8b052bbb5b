// expect: no error
#include "small_image.hpp"

using namespace small;

using right = table_of<count_row, presence_row, mode_row, left_row, right_row, wide_row>;
static_assert(error_of_nothing<right>() == translate::errc::no_space);
