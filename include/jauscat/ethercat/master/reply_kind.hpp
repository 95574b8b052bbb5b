// Result of passing a mailbox message to its protocol.
#pragma once

#include <jauscat/ethercat/master/master_errc.hpp>

#include <cstdint>

namespace jauscat::ethercat {

/// How a protocol has classified a mailbox message.
enum class reply_kind : std::uint8_t {
    unrelated, ///< not the answer: keep waiting
    fragment,  ///< a part of the answer: the next part comes unasked
    proceed,   ///< the answer; the protocol goes on with another request
    complete,  ///< the last answer: see the result
};

} // namespace jauscat::ethercat
