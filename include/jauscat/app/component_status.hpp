// What a node knows of a component.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/header.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace jauscat {

/// A component of the node, or one that it hears.
struct component_status {
    jaus::address id{};
    bool is_own{};
    std::string name{};                               ///< of an own one, by the configuration or the program
    std::optional<jaus::primary_status_code> state{}; ///< of an own one
    std::optional<jaus::address> controller{};        ///< of an own one; nothing: no component has control
    std::uint8_t authority{};                         ///< of the controller; 0 where it is not known
    std::optional<duration> age{};                    ///< of another one: since its last message
};

} // namespace jauscat
