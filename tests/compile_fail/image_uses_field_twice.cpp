// expect: image_table: a field of the message is used by two rows
#include "small_image.hpp"

using namespace small;

using again = translate::copy<at<&command::mode>, at<&image::wide>>;

using wrong = table_of<count_row, presence_row, mode_row, left_row, right_row, again>;
static_assert(error_of_nothing<wrong>() == translate::errc::no_space);
