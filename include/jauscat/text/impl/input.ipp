// Parses words and paths.
#pragma once
#include <jauscat/text/input.hpp>

#include <charconv>
#include <system_error>
#include <utility>

namespace jauscat::text {

namespace detail {

/// One character between quotes, behind a backslash or not.
[[nodiscard]] inline bool unescape(std::string_view line, std::size_t& at, std::string& out) {
    if (line[at] != '\\') {
        out += line[at++];
        return true;
    }
    if (++at == line.size()) return false;
    if (line[at] == 'x') {
        if (line.size() - at < 3) return false;
        const auto high = hex_digit(line[at + 1]), low = hex_digit(line[at + 2]);
        if (!high || !low) return false;
        out += static_cast<char>(*high * 16 + *low);
        at += 3;
    } else {
        out += line[at++];
    }
    return true;
}

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL result<std::vector<std::string>, error> split(std::string_view line) {
    std::vector<std::string> words;
    for (std::size_t at = 0;;) {
        while (at != line.size() && detail::is_space(line[at])) ++at;
        if (at == line.size()) return words;
        std::string word;
        while (at != line.size() && !detail::is_space(line[at])) {
            if (line[at] != '"') {
                word += line[at++];
                continue;
            }
            const std::size_t opened = at++;
            while (at != line.size() && line[at] != '"')
                if (!detail::unescape(line, at, word))
                    return error{.code = errc::unfinished_escape,
                                 .offset = at,
                                 .message = "no character behind the backslash in: " + std::string{line}};
            if (at++ == line.size())
                return error{.code = errc::unfinished_quote,
                             .offset = opened,
                             .message = "no quote at the end of: " + std::string{line.substr(opened)}};
        }
        words.push_back(std::move(word));
    }
}

JAUSCAT_DECL result<void, error> assign(std::string_view word, input& tree) {
    const std::size_t equals = word.find('=');
    if (equals == 0 || equals == std::string_view::npos)
        return error{.code = errc::not_an_assignment,
                     .value = std::string{word},
                     .message = "'" + std::string{word} + "' is not of the form field=value"};
    const std::string_view path = word.substr(0, equals);
    const auto wrong = [&](errc code, std::string_view why) {
        return error{
            .code = code, .field = std::string{path}, .message = "'" + std::string{path} + "' " + std::string{why}};
    };
    input* here = &tree;
    for (std::size_t at = 0, level = 0;; ++level) {
        if (level == max_levels) return wrong(errc::too_deep, "has too many dots");
        const std::size_t end = std::min(path.find_first_of(".[", at), path.size());
        if (end == at) return wrong(errc::invalid_path, "lacks a name");
        if (here->what == input::kind::nothing) here->what = input::kind::object;
        if (here->what != input::kind::object)
            return wrong(errc::duplicate, "stands beside another value of the same name");
        const std::string_view name = path.substr(at, end - at);
        const auto found = std::ranges::find(here->parts, name, &input::name);
        here = found != here->parts.end() ? &*found : &here->parts.emplace_back(input{.name = std::string{name}});
        at = end;
        if (at != path.size() && path[at] == '[') {
            std::size_t index{};
            const auto [stop, failed] = std::from_chars(path.data() + at + 1, path.data() + path.size(), index);
            const auto behind = static_cast<std::size_t>(stop - path.data());
            if (failed != std::errc{} || behind == path.size() || path[behind] != ']')
                return wrong(errc::invalid_path, "needs the number of an element between its brackets, from 0");
            if (index >= max_elements)
                return wrong(errc::index_too_large,
                             "is beyond the " + std::to_string(max_elements) + " elements a list may have");
            if (here->what == input::kind::nothing) here->what = input::kind::array;
            if (here->what != input::kind::array)
                return wrong(errc::duplicate, "stands beside another value of the same name");
            if (index >= here->parts.size()) here->parts.resize(index + 1);
            here = &here->parts[index];
            at = behind + 1;
        }
        if (at == path.size()) break;
        if (path[at] != '.') return wrong(errc::invalid_path, "lacks a dot");
        ++at;
    }
    if (here->what != input::kind::nothing) return wrong(errc::duplicate, "is given twice");
    here->what = input::kind::leaf;
    here->text = word.substr(equals + 1);
    return {};
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::text
