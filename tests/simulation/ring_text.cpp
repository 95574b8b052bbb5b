#include "simulation/ring.hpp"
#include "simulation/story.hpp"
#include <jauscat/text/value.hpp>

namespace simulation {

std::string ring_text(const happening& one, const std::vector<std::string>& names) {
    const auto& name = names[one.who];
    const auto value = std::to_string(one.value);
    switch (static_cast<ring_deed>(one.number)) {
    case ring_deed::frame_lost: return one.value == 0 ? "a frame is lost" : "a frame is lost on its way back";
    case ring_deed::frame_delayed: return "a frame comes back " + value + " us later";
    case ring_deed::cable_out: return "the cable is out before " + name;
    case ring_deed::cable_back: return "the cable is back before " + name;
    case ring_deed::freezes: return name + ": its application does nothing for " + value + " ms";
    case ring_deed::goes_on: return name + ": its application goes on";
    case ring_deed::restarts: return name + " loses its supply for " + value + " ms";
    case ring_deed::comes_back: return name + " has its supply back";
    case ring_deed::aborts_next: return name + " aborts the next " + value + " writes";
    case ring_deed::falls_back: return name + " is asked for AL state " + value + " by another";
    case ring_deed::recounts: return name + " counts mailbox messages in its own way";
    case ring_deed::taken: return name + " gets another station address from another master";
    case ring_deed::odd_watchdog:
        return name + " has a left-over watchdog: divider " + std::to_string(one.value >> 16U) + ", time " +
               std::to_string(one.value & 0xFFFFU);
    case ring_deed::al_state:
        return name + " is in " + jauscat::text::to_text(static_cast<ethercat::al_state>(one.value));
    case ring_deed::frame_doubled: return "a frame comes back again " + value + " us later";
    case ring_deed::frame_damaged:
        return one.value == 0 ? "a frame is damaged and discarded by a slave" : value + " bytes of a frame come back";
    case ring_deed::swapped: return name + " and " + names[one.value] + " change places";
    case ring_deed::doubled: return name + " gets the station address of " + names[one.value];
    case ring_deed::drive_fault: return name + " has a fault whose cause is there for " + value + " ms";
    case ring_deed::unpowered: return name + ": its power stage has no supply for " + value + " ms";
    case ring_deed::deaf: return name + " ignores controlwords for " + value + " ms";
    case ring_deed::keeps_watchdog: return name + " ignores writes of its watchdog for " + value + " ms";
    case ring_deed::slow: return name + " takes " + value + " ms for each message";
    case ring_deed::reports_error: return name + " reports SAFE-OP with an error for " + value + " ms";
    case ring_deed::repaired: return name + " works as before";
    case ring_deed::emergency: return name + " sends emergency " + value;
    case ring_deed::unknown_state: return name + ": its AL state cannot be read for " + value + " ms";
    }
    return name + ": something happens";
}

} // namespace simulation
