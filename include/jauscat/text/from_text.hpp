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
#include <jauscat/schema/jaus/catalog.hpp>
#include <jauscat/schema/jaus/command_code.hpp>
#include <jauscat/text/describe.hpp>
#include <jauscat/text/error.hpp>
#include <jauscat/text/filler.hpp>

namespace jauscat::text {

/// Fills a message from a tree of names and values. Its lists, texts and bytes lie in `memory`. After an error the
/// message is valid but unspecified.
template <wire::message T>
[[nodiscard]] result<void, error> from_input(const input& in, T& message, wire::arena& memory) {
    message = T{};
    return detail::filler{memory}.fill(describe<T>(), &message, in);
}
/// The same for a value-initialised object of which only the structure is known.
[[nodiscard]] inline result<void, error> from_input(const input& in, const structure& type, void* object,
                                                    wire::arena& memory) {
    return detail::filler{memory}.fill(type, object, in);
}

/// From words like `pose[1].pose_time=2.5`, as a shell hands them over, for a value-initialised object.
[[nodiscard]] inline result<void, error> from_words(std::span<const std::string> words, const structure& type,
                                                    void* object, wire::arena& memory) {
    input tree{.what = input::kind::object};
    for (const std::string& word : words)
        if (auto assigned = assign(word, tree); !assigned) return assigned;
    return from_input(tree, type, object, memory);
}
/// The same for a typed message.
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

/// "Set End-Effector Path Motion" to "set_end_effector_path_motion".
[[nodiscard]] inline std::string snake_case(std::string_view standard_name) {
    std::string made;
    for (const char c : standard_name) {
        const bool upper = c >= 'A' && c <= 'Z';
        const bool kept = upper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (kept)
            made += upper ? static_cast<char>(c - 'A' + 'a') : c;
        else if (!made.empty() && made.back() != '_')
            made += '_';
    }
    while (made.ends_with('_')) made.pop_back();
    return made;
}

/// The command code of a message that is named as in its schema, as in the standard, or by its code in hex: 0405,
/// 0405h, 0x0405. Error: unknown_message.
[[nodiscard]] inline result<std::uint16_t, error> find_message(std::string_view name) {
    const auto unknown = [&](const std::string& message) {
        return error{.code = errc::unknown_message, .value = std::string{name}, .message = message};
    };
    std::string_view digits = name;
    if (digits.starts_with("0x") || digits.starts_with("0X")) digits.remove_prefix(2);
    if (digits.ends_with('h') || digits.ends_with('H')) digits.remove_suffix(1);
    std::uint16_t code{};
    const auto [stop, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (failed == std::errc{} && stop == digits.data() + digits.size()) {
        if (std::ranges::find(jaus::catalog, code, &jaus::catalog_entry::command_code) != jaus::catalog.end())
            return code;
        return unknown("there is no message with the code " + hex_number(code, 4));
    }
    const std::string wanted = snake_case(name);
    std::vector<std::string> names;
    for (const jaus::catalog_entry& entry : jaus::catalog) {
        names.push_back(snake_case(entry.name));
        if (names.back() == wanted) return entry.command_code;
    }
    const std::vector<std::string_view> views{names.begin(), names.end()};
    return unknown("there is no message '" + std::string{name} + "'" + suggestion(wanted, views));
}

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
