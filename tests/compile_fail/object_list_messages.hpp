// Messages for an object list under the small table. Each object_list_*.cpp makes one mistake with them.
#pragma once
#include "small_table.hpp"
#include <jauscat/bridge/object_list.hpp>

namespace small {

template <std::uint16_t Code> struct message_of_code {
    std::uint8_t value{};
};
using command = message_of_code<0x0405>;
using other_command = message_of_code<0x0404>;
using stranger_command = message_of_code<0x7777>; // not in the table's list

} // namespace small

template <std::uint16_t Code> struct jauscat::wire::schema<small::message_of_code<Code>> {
    static constexpr std::uint16_t command_code = Code;
    using type = layout<field<&small::message_of_code<Code>::value, u8>>;
};
