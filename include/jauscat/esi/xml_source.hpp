// ESI document with its text, for errors with file, line and element.
#pragma once

#include <jauscat/esi/error.hpp>
#include <jauscat/esi/text_values.hpp>
#include <jauscat/text/quoted.hpp>

#include <pugixml.hpp>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace jauscat::esi::detail {

/// What `read()` returns, or the error of the `esi_error` that it throws.
template <class Read> result<std::invoke_result_t<Read>, error> caught(Read&& read) {
    try {
        return read();
    } catch (const esi_error& thrown) {
        return thrown.error();
    }
}

/// The file's text. Throws `esi_error`.
inline std::string text_of(const std::filesystem::path& path) {
    std::ifstream file{path, std::ios::binary};
    file.peek(); // a directory can be opened, and fails here
    if (!file && !file.eof())
        throw esi_error{{.code = errc::unreadable,
                         .message = path.string() + ": cannot be read: " + std::generic_category().message(errno)}};
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

class xml_source {
  public:
    /// `source` is the file's name in messages. Text that is not UTF-8 is taken for Latin-1, whatever its declaration
    /// says, but for UTF-16 with a byte order mark.
    xml_source(std::string_view text, std::string source)
        : is_wide_{text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE")},
          text_{is_wide_ ? std::string{text} : text::as_utf8(text)},
          source_{std::move(source)} {
        for (std::size_t at = 0; (at = text_.find('\n', at)) != text_.npos; ++at) line_ends_.push_back(at);
    }

    /// Parses the text and returns the root element.
    pugi::xml_node load() {
        const auto parsed = document_.load_buffer(text_.data(), text_.size(), pugi::parse_default,
                                                  is_wide_ ? pugi::encoding_auto : pugi::encoding_utf8);
        if (!parsed)
            fail(errc::not_xml, {}, line_at(parsed.offset),
                 std::string{"not well-formed XML: "} + parsed.description());
        if (root().name() != std::string_view{"EtherCATInfo"})
            fail(errc::not_esi, root(), "the root element, expected <EtherCATInfo>");
        return root();
    }
    pugi::xml_node root() const { return document_.document_element(); }

    [[noreturn]] void fail(errc code, pugi::xml_node node, const std::string& what) const {
        fail(code, node.name(), line_of(node), '<' + std::string{node.name()} + ">: " + what);
    }
    std::size_t line_at(std::ptrdiff_t offset) const {
        const auto before = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
        return 1 + static_cast<std::size_t>(std::ranges::lower_bound(line_ends_, before) - line_ends_.begin());
    }
    std::size_t line_of(pugi::xml_node node) const { return line_at(node.offset_debug()); }

    pugi::xml_node child(pugi::xml_node parent, const char* name) const {
        const auto found = parent.child(name);
        if (!found) fail(errc::missing, parent, "expected a <" + std::string{name} + "> in it");
        return found;
    }
    /// The text in an element, without white space at its ends; empty for no element.
    static std::string text(pugi::xml_node node) { return std::string{trimmed(node.text().get())}; }
    /// The name in an element: the English one, or the first that there is; empty for none.
    static std::string name_in(pugi::xml_node parent) {
        std::string first;
        for (const auto each : parent.children("Name")) {
            auto name = text(each);
            if (each.attribute("LcId").value() == std::string_view{"1033"} && !name.empty()) return name;
            if (first.empty()) first = std::move(name);
        }
        return first;
    }
    std::string needed_text(pugi::xml_node node) const {
        auto value = text(node);
        if (value.empty()) fail(errc::missing, node, "expected a text in it");
        return value;
    }
    std::uint32_t number_in(pugi::xml_node node, std::string_view where, std::string_view value,
                            std::uint32_t max) const {
        if (const auto parsed = parse_number_liberally(value, max)) return *parsed;
        fail(errc::invalid_value, node,
             std::string{where} + '"' + std::string{value} + "\", expected a number such as #x1A or 26, at most " +
                 std::to_string(max));
    }
    std::uint32_t number(pugi::xml_node node, std::uint32_t max = 0xFFFFFFFF) const {
        return number_in(node, "", node.text().get(), max);
    }
    /// The number in an attribute, or 0 without one.
    std::uint32_t number(pugi::xml_node node, const char* name, std::uint32_t max = 0xFFFFFFFF) const {
        const auto found = node.attribute(name);
        return found ? number_in(node, std::string{name} + '=', found.value(), max) : 0;
    }
    /// The number in a child, if it has one.
    std::optional<std::uint32_t> number_of(pugi::xml_node parent, const char* name,
                                           std::uint32_t max = 0xFFFFFFFF) const {
        const auto found = parent.child(name);
        if (text(found).empty()) return std::nullopt;
        return number(found, max);
    }
    template <class Integer>
    Integer integer_in(pugi::xml_node node, std::string_view where, std::string_view value) const {
        constexpr auto min = std::numeric_limits<Integer>::min(), max = std::numeric_limits<Integer>::max();
        if (const auto parsed = parse_integer(without_space(value), min, max)) return static_cast<Integer>(*parsed);
        fail(errc::invalid_value, node,
             std::string{where} + '"' + std::string{value} + "\", expected a number from " + std::to_string(min) +
                 " to " + std::to_string(max));
    }
    bool boolean(pugi::xml_node node, const char* name) const {
        const auto found = node.attribute(name);
        if (!found) return false;
        const auto value = parse_boolean(trimmed(found.value()));
        if (!value)
            fail(errc::invalid_value, node, std::string{name} + "=\"" + found.value() + "\", expected true or false");
        return *value;
    }
    std::vector<std::byte> bytes(pugi::xml_node node) const {
        auto value = parse_bytes(node.text().get());
        if (!value) fail(errc::invalid_value, node, "expected hexadecimal digits, two for each byte");
        return *value;
    }

  private:
    [[noreturn]] void fail(errc code, std::string element, std::size_t line, const std::string& what) const {
        throw esi_error{{.code = code,
                         .element = std::move(element),
                         .line = line,
                         .message = source_ + ':' + std::to_string(line) + ": " + what}};
    }

    bool is_wide_;
    std::string text_;
    std::string source_;
    std::vector<std::size_t> line_ends_{};
    pugi::xml_document document_{};
};

} // namespace jauscat::esi::detail
