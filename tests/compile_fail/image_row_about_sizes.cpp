// expect: image_table: an image has a fixed size; rows about sizes and rest are for packets
#include "small_image.hpp"

using namespace small;

using wrong = table_of<count_row, presence_row, mode_row, left_row, right_row, wide_row, translate::rest>;
static_assert(error_of_nothing<wrong>() == translate::errc::no_space);
