// What components and their typed handlers share: messages as bytes. Compiled once.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/message_outcome.hpp>
#include <jauscat/jaus/events/report_field.hpp>
#include <jauscat/net/error.hpp>
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/wire/diagnosis.hpp>

#include <boost/system/error_code.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

using bytes = std::span<const std::byte>;

class node_state;
class component_state;
struct end_node {
    JAUSCAT_DECL void operator()(node_state* node) const noexcept;
};

/// A message for a handler.
struct incoming {
    const jaus::header& head;
    bytes body;
    component_state& component;
};
/// A type of message that a component takes.
struct taken_message {
    std::uint16_t command_code{};
    std::uint16_t answer_code{}; ///< of the message that the handler returns; 0: none
    std::uint32_t presence_bits{};
    std::function<jaus::message_outcome(const incoming&)> handle{};
};

/// The fields of a report that are wanted: by the body of its query, or by presence bits.
struct report_request {
    const bytes* query{}; ///< null: none
    std::uint32_t presence_bits{0xFFFFFFFF};
};
/// A type of report that a component gives.
struct given_report {
    std::uint16_t command_code{};
    std::uint16_t query_code{};
    std::uint32_t presence_bits{};
    double max_rate{};
    jaus::field_reader read_field{};
    bool on_change{true}; ///< its events may be sent on change
    /// Writes the body; refused: there is no report now, or it does not encode.
    std::function<jaus::message_outcome(const report_request&, std::vector<std::byte>& body, component_state&)> write{};
};

JAUSCAT_DECL void take(component_state&, taken_message);
JAUSCAT_DECL void give(component_state&, given_report);
/// Sends `body` to the sender of `request`; false, and a line in the log, where that cannot be sent.
JAUSCAT_DECL bool answer(component_state&, const jaus::header& request, std::uint16_t command_code, bytes body);
/// Memory for the lists of a received message: grows by `at_least` bytes where it is too small.
[[nodiscard]] JAUSCAT_DECL std::span<std::byte> list_memory(component_state&, std::size_t at_least);
/// Why the last message was malformed, for the log.
JAUSCAT_DECL jaus::message_outcome malformed(component_state&, wire::errc why);
/// A value of the application that does not encode: a line in the log.
JAUSCAT_DECL void log_not_encodable(component_state&, std::uint16_t command_code, const wire::diagnosis& why);
/// The errors of a message that does not encode, with its name and the field's.
[[nodiscard]] JAUSCAT_DECL boost::system::error_code not_encodable(std::uint16_t command_code, const wire::diagnosis&);
[[nodiscard]] JAUSCAT_DECL net::error not_sent(std::uint16_t command_code, const wire::diagnosis&);

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
