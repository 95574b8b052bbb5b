#include "object_table.hpp"

#ifdef GOOD
// expect: no error
using row = translate::axis_row<&small::list_message::speeds, small::object, small::conversion>;
template struct translate::object_table<small::list_message, small::scale, row>;
#endif

#ifdef LEAVES_LIST_OUT
// expect: object_table: each list of the message needs one row
using row = translate::axis_row<&small::message::speeds, small::object, small::conversion>;
template struct translate::object_table<small::message, small::scale, row>;
#endif

#ifdef UNIT_OF_LIST
// expect: object_table: a list has another unit than the conversion takes
using row = translate::axis_row<&small::list_message::speeds, small::object, small::of_radians>;
template struct translate::object_table<small::list_message, small::scale, row>;
#endif

#ifdef UNIT_OF_OBJECT
// expect: axis_row: the object has another unit than the conversion gives
using row = translate::axis_row<&small::list_message::speeds, small::position, small::conversion>;
template struct translate::object_table<small::list_message, small::scale, row>;
#endif
