// expect: image_table: a row names a field that the message or the image does not have
#include "small_image.hpp"

using namespace small;

struct percent_of_nothing {
    int value{};
};

using wrong = table_of<count_row, presence_row, mode_row, left_row, right_row, wide_row,
                       translate::caller_set<at<&percent_of_nothing::value>>>;
static_assert(error_of_nothing<wrong>() == translate::errc::no_space);
