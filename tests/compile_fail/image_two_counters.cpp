// expect: image_table: presence_bits and counter may be there once
#include "small_image.hpp"

using namespace small;

using wrong = table_of<count_row, presence_row, mode_row, left_row, right_row, translate::counter<at<&image::wide>>>;
static_assert(error_of_nothing<wrong>() == translate::errc::no_space);
