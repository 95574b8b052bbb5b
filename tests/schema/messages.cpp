// Knows that the groups exist, and must not see how they are made: that would make all of them here.
#include "schema/messages.hpp"

namespace messages {

const std::array<const group*, 10>& groups() {
    static const std::array all{&group_of<0x0>(), &group_of<0x1>(), &group_of<0x2>(), &group_of<0x4>(),
                                &group_of<0x6>(), &group_of<0x8>(), &group_of<0xA>(), &group_of<0xB>(),
                                &group_of<0xD>(), &group_of<0xE>()};
    return all;
}

std::vector<message> all() {
    std::vector<message> list;
    for (const group* one : groups())
        for (const functions& each : one->all) list.push_back({*jauscat::catalogue::ra_3_3().find(each.code), each});
    return list;
}

} // namespace messages
