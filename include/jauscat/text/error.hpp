// Errors of parsing text and JSON: a code to branch on, the field and value concerned, and a line for the author.
#pragma once
#include <jauscat/base/result.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace jauscat::text {

/// Behind each: the members of `error` that have a value, besides the message.
enum class errc : std::uint8_t {
    ok,
    unfinished_escape, ///< no character follows a backslash; offset
    unfinished_quote,  ///< a quote is not closed; offset
    not_an_assignment, ///< a word is not of the form field=value; value
    invalid_path,      ///< the path of a field lacks a name, a dot or the number of an element; field
    index_too_large,   ///< the number of an element is `max_elements` or more; field
    duplicate,         ///< a field is given twice, or both as a value and with parts; field
    missing_name,      ///< the line names no message
    unknown_message,   ///< no message of the standard; value
    unhandled_message, ///< a message that is not among those of the call; value
    unknown_field,     ///< the message has no such field; field
    missing_field,     ///< a required field or element is not given; field
    wrong_kind,        ///< a value, structure or list where another one of these belongs; field
    invalid_value,     ///< no number, enumerator, flag or hex; field, value unless it is binary
    out_of_range,      ///< beyond the limits of its field; field, value
    wrong_size,        ///< too many or too few elements, characters or bytes; field
    inconsistent,      ///< a count, flag, type code or raw integer disagrees with what it describes; field
    too_deep,          ///< more levels than a path or a tree may have; field
    arena_full,        ///< the memory for lists, texts and bytes is used up; field
};

/// The error in one line. `describe(const error&)` says more.
[[nodiscard]] constexpr std::string_view describe(errc code) noexcept {
    switch (code) {
    case errc::ok: return "ok";
    case errc::unfinished_escape: return "no character follows a backslash";
    case errc::unfinished_quote: return "a quote is not closed";
    case errc::not_an_assignment: return "a word is not of the form field=value";
    case errc::invalid_path: return "the path of a field lacks a name, a dot or the number of an element";
    case errc::index_too_large: return "the number of an element is beyond the elements that a list may have";
    case errc::duplicate: return "a field is given twice";
    case errc::missing_name: return "the name of a message is missing";
    case errc::unknown_message: return "there is no such message";
    case errc::unhandled_message: return "the message is not handled here";
    case errc::unknown_field: return "there is no such field";
    case errc::missing_field: return "a required field is missing";
    case errc::wrong_kind: return "a value, structure or list where another one of these belongs";
    case errc::invalid_value: return "a value is not one of its field";
    case errc::out_of_range: return "a value exceeds the limits of its field";
    case errc::wrong_size: return "too many or too few elements, characters or bytes";
    case errc::inconsistent: return "a count, flag, type code or raw integer disagrees with what it describes";
    case errc::too_deep: return "more levels than a path or a tree may have";
    case errc::arena_full: return "the memory for lists, texts and bytes is used up";
    }
    return "unknown error";
}

/// Why a text is not a message. Only the members that errc names for the code have a value.
struct error {
    errc code{};
    std::string field{};   ///< its path, such as pose[1].pose_time
    std::string value{};   ///< as it was given
    std::size_t offset{};  ///< byte of the line, from 0: of the open quote, or behind the backslash
    std::string message{}; ///< what is wrong and, where it helps, what to write instead

    friend bool operator==(const error&, const error&) = default;
};

/// What is wrong, for the author of the text.
[[nodiscard]] inline std::string_view describe(const error& why) noexcept { return why.message; }

} // namespace jauscat::text
