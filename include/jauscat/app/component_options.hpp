// Options of a component.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/component_control.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {

struct component_options {
    std::uint8_t id{};        ///< component ID, 1 to 254: 33 is a Primitive Driver, see docs/jaus-concepts.md
    std::uint8_t instance{1}; ///< 1 to 254
    std::string name{}; ///< of Report Identification, up to 80 characters; a name in the configuration has precedence
    std::uint8_t authority{}; ///< its own authority: a request for control needs a higher one, or the same
    /// Motion commands are refused unless the component is Ready; see docs/safety.md.
    bool obeys_only_when_ready{true};
    /// Private messages that move nothing: taken from every sender, in every state.
    std::vector<std::uint16_t> harmless{};
    /// Control ends when its controller was silent for this time; 0: only when that disappears. The component is
    /// stopped after the same time without a message of another sender whose motion command is in force.
    duration controller_timeout{std::chrono::milliseconds{500}};
    /// Motion commands while no component has control: watched, refused or unwatched; see docs/safety.md.
    jaus::motion_without_control without_control{};
    /// Of messages that this component sends and that must be acknowledged.
    retry_policy retry{.interval = std::chrono::milliseconds{250}, .attempts = 4};
    /// Places of 24 bytes for messages of the last two seconds that this component has acknowledged, so that it knows
    /// their repeats: twice as many as one sender, such as the controller, sends of them in that time. By default 2,048
    /// a second. What has no place is dropped with a line in the log, and its sender gets `no_answer`.
    std::size_t remembered{8192};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat
