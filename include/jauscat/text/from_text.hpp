// Parses messages from text:
//
//     set_wrench_effort propulsive_linear_effort_x=50 resistive_linear_effort_x=raw:51
//     set_joint_motion pose[0].pose_time=2.5 pose[0].joint[0].joint_position=0.785 ...
//     set_emergency emergency_code=transition_to_emergency
//     report_identification query_type=system_identification authority_code=1 type=10001 identification="left arm"
//
// Names are those of to_text and JSON. Numbers may carry their unit; enumerators are named or numbered, flags joined by
// |; bytes are hex; counts may be left out. `error::message` is for the author of the line.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/schema/jaus/command_code.hpp>
#include <jauscat/text/describe.hpp>
#include <jauscat/text/error.hpp>
#include <jauscat/text/input.hpp>
#include <jauscat/wire/arena.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace jauscat::text {

inline namespace JAUSCAT_WAY {
/// Fills a value-initialised object, of which only the structure is known, from a tree of names and values. Its lists,
/// texts and bytes lie in `memory`. After an error the object is valid but unspecified.
[[nodiscard]] JAUSCAT_DECL result<void, error> from_input(const input& in, const structure& type, void* object,
                                                          wire::arena& memory);

/// From words like `pose[1].pose_time=2.5`, as a shell hands them over, for a value-initialised object.
[[nodiscard]] JAUSCAT_DECL result<void, error> from_words(std::span<const std::string> words, const structure& type,
                                                          void* object, wire::arena& memory);
} // namespace JAUSCAT_WAY

/// `from_input` for a typed message.
template <wire::message T>
[[nodiscard]] result<void, error> from_input(const input& in, T& message, wire::arena& memory) {
    message = T{};
    return from_input(in, describe<T>(), &message, memory);
}
/// `from_words` for a typed message.
template <wire::message T>
[[nodiscard]] result<void, error> from_words(std::span<const std::string> words, T& message, wire::arena& memory) {
    message = T{};
    return from_words(words, describe<T>(), &message, memory);
}

/// The same from one line, in which quotes keep spaces together.
template <wire::message T>
[[nodiscard]] result<void, error> from_text(std::string_view line, T& message, wire::arena& memory) {
    const auto words = split(line);
    if (!words) return words.error();
    return from_words(*words, message, memory);
}

inline namespace JAUSCAT_WAY {
/// "Set End-Effector Path Motion" to "set_end_effector_path_motion".
[[nodiscard]] JAUSCAT_DECL std::string snake_case(std::string_view standard_name);

/// A command code in hex: 0405, 0405h, 0x0405; nothing where it is none.
[[nodiscard]] JAUSCAT_DECL std::optional<std::uint16_t> command_code_from(std::string_view digits);

/// The command code of a message that is named as in its schema, as in the standard, or by its code in hex: 0405,
/// 0405h, 0x0405. Error: unknown_message.
[[nodiscard]] JAUSCAT_DECL result<std::uint16_t, error> find_message(std::string_view name);

/// A message that may be named; `name` in snake_case.
struct named_message {
    std::uint16_t command_code{};
    std::string name{};
};
/// The same among some messages.
[[nodiscard]] JAUSCAT_DECL result<std::uint16_t, error> find_message(std::string_view name,
                                                                     std::span<const named_message> among);
} // namespace JAUSCAT_WAY

/// Calls use.template operator()<Message>() for the message type of a code; false where the list has none.
template <template <class...> class List, class... Messages>
[[nodiscard]] bool with_message(std::uint16_t command_code, List<Messages...>, auto&& use) {
    return (... || (jaus::command_code_of<Messages> == command_code && (use.template operator()<Messages>(), true)));
}

/// The message that a line names in its first word, with the fields of the others: calls use(message). Memory as in
/// from_input; `messages` are those it may be.
template <class List>
[[nodiscard]] result<void, error> from_text(std::string_view line, wire::arena& memory, List messages, auto&& use) {
    const auto words = split(line);
    if (!words) return words.error();
    if (words->empty()) return error{.code = errc::missing_name, .message = "the name of a message is missing"};
    const std::string& name = words->front();
    const auto command_code = find_message(name);
    if (!command_code) return command_code.error();
    result<void, error> filled;
    const bool known = with_message(*command_code, messages, [&]<class Message>() {
        Message message{};
        filled = from_words(std::span{*words}.subspan(1), message, memory);
        if (filled) use(message);
    });
    if (known) return filled;
    return error{
        .code = errc::unhandled_message, .value = name, .message = "the message " + name + " is not handled here"};
}

} // namespace jauscat::text

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/text/impl/from_text.ipp>
#endif
