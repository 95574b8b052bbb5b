// What the protocols in a slave's mailbox and the exchange that carries their messages say to each other.
#pragma once

#include <jauscat/ethercat/master/master_errc.hpp>

#include <cstdint>

namespace jauscat::ethercat {

/// What a mailbox message meant to the protocol that waits for it.
enum class reply_kind : std::uint8_t {
    unrelated, ///< not the answer: keep waiting
    fragment,  ///< a part of the answer: the next part comes unasked
    proceed,   ///< the answer; the protocol goes on with another request
    complete,  ///< the last answer: see the outcome
};

} // namespace jauscat::ethercat
