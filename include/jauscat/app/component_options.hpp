// Options of a component.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>

#include <chrono>
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
    /// Control ends when its controller was silent for this time; 0: only when that disappears.
    duration controller_timeout{std::chrono::milliseconds{500}};
    /// Of messages that this component sends and that must be acknowledged.
    retry_policy retry{.interval = std::chrono::milliseconds{250}, .attempts = 4};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat
