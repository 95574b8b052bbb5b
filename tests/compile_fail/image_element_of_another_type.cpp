// expect: element: the image's field has not the type that the optional element has on the wire
#include "small_image.hpp"

using namespace small;

using wrong_row = translate::element<at<&command::right>, at<&image::wide>>;

using wrong =
    table_of<count_row, presence_row, mode_row, left_row, wrong_row, translate::caller_set<at<&image::right>>>;
static_assert(error_of_nothing<wrong>() == translate::errc::no_space);
