#include "standard_messages.hpp"

#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/schema/translation/seed_table.hpp>

std::span<const jauscat::bridging::sub_object> standard_messages() {
    using namespace jauscat;
    return bridging::object_list<translation::seed_table, 1, jaus::messages>::entries;
}
