// expect: object_list: a message has no rank in the table; append its command code to the table's list
#include "object_list_messages.hpp"

using namespace small;

using wrong = jauscat::bridging::object_list<right_table, 1, command, stranger_command>;
static_assert(wrong::entries.size() == 2);
