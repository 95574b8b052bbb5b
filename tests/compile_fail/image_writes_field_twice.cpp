// expect: image_table: a field of the image is written by two rows
#include "small_image.hpp"

using namespace small;

using again = translate::constant<at<&image::mode>, 1>;

using wrong = table_of<count_row, presence_row, mode_row, left_row, right_row, wide_row, again>;
static_assert(error_of_nothing<wrong>() == translate::errc::no_space);
