// expect: axis_row: the object has another unit than the conversion gives
#include "object_table.hpp"

using row = translate::axis_row<&small::list_message::speeds, small::position, small::conversion>;
template struct translate::object_table<small::list_message, small::scale, row>;
