// expect: ignoring return
#include <jauscat/wire/list.hpp>

void add(jauscat::wire::inline_list<int, 4>& numbers) { numbers.push_back(1); }
