// expect: object_list: a message is listed twice
#include "object_list_messages.hpp"

using namespace small;

using wrong = jauscat::bridging::object_list<right_table, 1, command, other_command, command>;
static_assert(wrong::entries.size() == 3);
