// Text of where and why a message does not encode or decode.
#pragma once
#include <jauscat/wire/diagnosis.hpp>

#include <cstddef>
#include <string>

namespace jauscat::text {

namespace detail {

/// `object[2].point[0].`: the structures and lists around a field.
inline std::string path_text(const wire::diagnosis& at) {
    std::string text;
    for (std::size_t i = 0; i != at.depth; ++i) {
        text += at.path[i].name;
        if (at.path[i].element != wire::diagnosis_step::no_element)
            ((text += '[') += std::to_string(at.path[i].element)) += ']';
        text += ".";
    }
    return text;
}

} // namespace detail

/// The field at fault with what is around it: `object[2].point[0].latitude`, `joint[3]` for an element of a list of
/// values. Empty where no field is.
[[nodiscard]] inline std::string field_path(const wire::diagnosis& why) {
    if (why.field.empty()) return {};
    std::string name = detail::path_text(why);
    if (why.depth != 0 && why.parent().name == why.field)
        name.pop_back(); // the dot
    else
        name += why.field;
    return name;
}

/// Where and why decoding failed, in one line: `truncated: ...: object[2].point[0].latitude at byte 40 needs 4 bytes, 1
/// left`.
[[nodiscard]] inline std::string to_text(const wire::diagnosis& why, std::size_t first_offset = 0) {
    std::string text{wire::describe(why.error)};
    if (!why.field.empty()) text += ": " + field_path(why);
    text += " at byte " + std::to_string(first_offset + why.offset);
    if (why.needed > why.available)
        text += " needs " + std::to_string(why.needed) + " bytes, " + std::to_string(why.available) + " left";
    return text;
}

} // namespace jauscat::text
