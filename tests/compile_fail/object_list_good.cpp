// expect: no error
#include "object_list_messages.hpp"

using namespace small;

using right = jauscat::bridging::object_list<right_table, 1, command, other_command>;
static_assert(right::index == 6901 && right::entries[0].subindex == 2 && right::entries[1].subindex == 3);
