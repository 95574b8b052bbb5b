// Options of a node.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/jaus/component/component_outcome.hpp>
#include <jauscat/jaus/routing/node_description.hpp>
#include <jauscat/schema/jaus/header.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
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
    std::uint8_t primary{};               ///< the node that relays within the subsystem; 0: none
    std::optional<jaus::subsystem_type> type{}; ///< of its subsystem; without, that of the configuration
    bool open{};                                ///< accepts messages of systems that the configuration does not have
    bool reuse_address{};                       ///< shares address and port with other programs (SO_REUSEADDR)
    std::string name{};                         ///< of the program, in front of lines on standard error
    /// Gets a line for each message that was refused, unroutable or lost, and for each exception of a handler. By
    /// default they are written to standard error.
    std::function<void(std::string_view line)> log{};
    /// The field and byte at which a message does not decode, for its line in the log: text::why_malformed says it for
    /// the messages of a list. Without, the line has the error alone.
    std::function<std::string(std::uint16_t command_code, std::span<const std::byte> body)> explain_malformed{};
    /// For traces. Called for each message before a component of this node gets it, with its outcome after that, and
    /// for each message that a component sends. The node manager is a component, too.
    std::function<void(const jaus::address& component, const jaus::header& head, std::span<const std::byte> body)>
        on_received{};
    std::function<void(const jaus::address& component, const jaus::header& head, std::span<const std::byte> body,
                       jaus::component_outcome what)>
        on_handled{};
    std::function<void(std::span<const std::byte> message)> on_sent{};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat
