// Options of a bridge.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/component_control.hpp>

#include <cstdint>

namespace jauscat {
inline namespace JAUSCAT_WAY {

struct bridge_options {
    /// An actuator is at rest within this time after its controller (or another sender that moves it), the link, the
    /// slave's state or this program is lost: 20 ms to 60 s, with process data 4 periods to 6.5 s. 0: 500 ms, with
    /// process data 100 ms or 4 periods.
    duration at_rest_within{};
    /// Of the process data: the slaves run in OP, and wrench efforts of component 33, and what the application has
    /// process parts for, go by their process data. 0: none, the slaves are in PRE-OP, and all messages go by their
    /// mailboxes.
    duration period{};
};

/// A component that a bridge has in front of a slave.
struct served_component {
    std::uint8_t component{}; ///< JAUS component ID, 1 to 254: 33 is a Primitive Driver
    std::uint8_t instance{1}; ///< 1 to 254
    std::uint8_t authority{}; ///< its own: a request for control needs a higher one, or the same
    /// Motion commands while no component has control: watched, refused or unwatched; see docs/safety.md.
    jaus::motion_without_control without_control{};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat
