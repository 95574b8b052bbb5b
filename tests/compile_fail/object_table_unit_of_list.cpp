// expect: object_table: a list has another unit than the conversion takes
#include "object_table.hpp"

using row = translate::axis_row<&small::list_message::speeds, small::object, small::of_radians>;
template struct translate::object_table<small::list_message, small::scale, row>;
