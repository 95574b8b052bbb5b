// expect: no error
#include "object_table.hpp"

using row = translate::axis_row<&small::list_message::speeds, small::object, small::conversion>;
template struct translate::object_table<small::list_message, small::scale, row>;
