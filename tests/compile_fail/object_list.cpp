#include "object_list_messages.hpp"

using namespace small;

#ifdef GOOD
// expect: no error
using right = jauscat::bridging::object_list<right_table, 1, command, other_command>;
static_assert(right::index == 6901 && right::entries[0].subindex == 2 && right::entries[1].subindex == 3);
#endif

#ifdef MESSAGE_TWICE
// expect: object_list: a message is listed twice
using wrong = jauscat::bridging::object_list<right_table, 1, command, other_command, command>;
static_assert(wrong::entries.size() == 3);
#endif

#ifdef NO_RANK
// expect: object_list: a message has no rank in the table; append its command code to the table's list
using wrong = jauscat::bridging::object_list<right_table, 1, command, stranger_command>;
static_assert(wrong::entries.size() == 2);
#endif
