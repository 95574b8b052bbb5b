// expect: object_table: each list of the message needs one row
#include "object_table.hpp"

using row = translate::axis_row<&small::message::speeds, small::object, small::conversion>;
template struct translate::object_table<small::message, small::scale, row>;
