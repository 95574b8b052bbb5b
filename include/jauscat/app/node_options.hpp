// Options of a node.
#pragma once
#include <jauscat/base/compilation.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace jauscat {
inline namespace JAUSCAT_WAY {

/// All options have defaults.
struct node_options {
    std::string config{"JausConfig.xml"}; ///< configuration file, see docs/configuration.md
    std::string config_text{};            ///< the configuration itself, instead of a file
    std::string this_system{};            ///< the system of the file that this program is; empty: its <thissystem>
    std::uint8_t node{};                  ///< JAUS node; 0: the one that the system's jausip names, or 1
    bool open{};                          ///< accepts messages of systems that the configuration does not have
    std::string name{};                   ///< of the program, in front of lines on standard error
    /// Gets a line for each message that was refused, unroutable or lost, and for each exception of a handler. By
    /// default they are written to standard error.
    std::function<void(std::string_view line)> log{};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat
