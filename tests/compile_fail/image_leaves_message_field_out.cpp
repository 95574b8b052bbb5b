// expect: image_table: a field of the message is used by no row
#include "small_image.hpp"

using namespace small;

using wrong = table_of<count_row, presence_row, mode_row, left_row, wide_row, translate::caller_set<at<&image::right>>>;
static_assert(error_of_nothing<wrong>() == translate::errc::no_space);
