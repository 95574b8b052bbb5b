// expect: image_table: a field of the image is not written by any row
#include "small_image.hpp"

using namespace small;

using wrong = table_of<count_row, presence_row, mode_row, left_row, right_row>;
static_assert(error_of_nothing<wrong>() == translate::errc::no_space);
