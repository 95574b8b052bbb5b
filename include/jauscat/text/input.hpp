// Parsed input: a tree of names, texts and lists. It comes from words like `pose[1].pose_time=2.5` or from JSON.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/text/error.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::text {

/// Input from text or JSON, not yet checked against a message.
struct input {
    /// A leaf is a number, a word or a text.
    enum class kind : std::uint8_t { nothing, leaf, object, array };
    kind what{};                ///< which of these it is
    std::string name{};         ///< in an object
    std::string text{};         ///< of a leaf
    std::vector<input> parts{}; ///< of an object or array

    /// The part of an object with this name; nullptr where there is none.
    [[nodiscard]] const input* find(std::string_view part) const noexcept {
        const auto found = std::ranges::find(parts, part, &input::name);
        return what == kind::object && found != parts.end() && found->what != kind::nothing ? &*found : nullptr;
    }
};

/// Most elements a list may have: an index beyond it is a typing error.
inline constexpr std::size_t max_elements = 65536;
/// Most structures and lists inside each other: no message has nearly as many.
inline constexpr std::size_t max_levels = 128;

namespace detail {

inline bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

[[nodiscard]] inline std::optional<unsigned> hex_digit(char c) {
    if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
    if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
    if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
    return std::nullopt;
}

} // namespace detail

inline namespace JAUSCAT_WAY {
/// The words of a line. Quotes keep spaces together and are left out, as in a shell: `name="left arm"` is one word.
/// Between quotes a backslash takes the next character as it is, and `\xHH` is an octet. Errors: unfinished_escape,
/// unfinished_quote.
[[nodiscard]] JAUSCAT_DECL result<std::vector<std::string>, error> split(std::string_view line);

/// Puts a word like `pose[1].pose_time=2.5` into the tree. Errors: not_an_assignment, invalid_path, index_too_large,
/// duplicate, too_deep.
[[nodiscard]] JAUSCAT_DECL result<void, error> assign(std::string_view word, input& tree);
} // namespace JAUSCAT_WAY

} // namespace jauscat::text

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/text/impl/input.ipp>
#endif
