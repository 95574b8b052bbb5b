// ESI document with its text, for errors with file, line and element.
#pragma once

#include <jauscat/esi/error.hpp>
#include <jauscat/esi/text_values.hpp>

#include <pugixml.hpp>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
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
    /// `text` must outlive the source. `source` is the file's name in messages.
    xml_source(std::string_view text, std::string source) : text_{text}, source_{std::move(source)} {}

    /// Parses the text and returns the root element.
    pugi::xml_node load() {
        const auto parsed = document_.load_buffer(text_.data(), text_.size());
        if (!parsed)
            fail(errc::not_xml, {}, line_at(parsed.offset),
                 std::string{"not well-formed XML: "} + parsed.description());
        const auto root = document_.document_element();
        if (root.name() != std::string_view{"EtherCATInfo"})
            fail(errc::not_esi, root, "the root element, expected <EtherCATInfo>");
        return root;
    }

    [[noreturn]] void fail(errc code, pugi::xml_node node, const std::string& what) const {
        fail(code, node.name(), line_of(node), '<' + std::string{node.name()} + ">: " + what);
    }
    std::size_t line_at(std::ptrdiff_t offset) const {
        const auto before = std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
        return 1 + static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + before, '\n'));
    }

    std::size_t line_of(pugi::xml_node node) const { return line_at(node.offset_debug()); }

    pugi::xml_node child(pugi::xml_node parent, const char* name) const {
        const auto found = parent.child(name);
        if (!found) fail(errc::missing, parent, "expected a <" + std::string{name} + "> in it");
        return found;
    }
    pugi::xml_attribute attribute(pugi::xml_node node, const char* name) const {
        const auto found = node.attribute(name);
        if (!found) fail(errc::missing, node, "expected an attribute " + std::string{name});
        return found;
    }
    std::string text(pugi::xml_node node) const {
        std::string value = node.text().get();
        if (value.empty()) fail(errc::missing, node, "expected a text in it");
        return value;
    }
    std::uint32_t number_in(pugi::xml_node node, std::string_view where, std::string_view value,
                            std::uint32_t max) const {
        if (const auto parsed = parse_number(value, max)) return *parsed;
        fail(errc::invalid_value, node,
             std::string{where} + '"' + std::string{value} + "\", expected a number such as #x1A or 26, at most " +
                 std::to_string(max));
    }
    std::uint32_t number(pugi::xml_node node, std::uint32_t max = 0xFFFFFFFF) const {
        return number_in(node, "", node.text().get(), max);
    }
    std::uint32_t number(pugi::xml_node node, const char* name, std::uint32_t max = 0xFFFFFFFF) const {
        return number_in(node, std::string{name} + '=', attribute(node, name).value(), max);
    }
    template <class Integer>
    Integer integer_in(pugi::xml_node node, std::string_view where, std::string_view value) const {
        constexpr auto min = std::numeric_limits<Integer>::min(), max = std::numeric_limits<Integer>::max();
        if (const auto parsed = parse_integer(value, min, max)) return static_cast<Integer>(*parsed);
        fail(errc::invalid_value, node,
             std::string{where} + '"' + std::string{value} + "\", expected a number from " + std::to_string(min) +
                 " to " + std::to_string(max));
    }
    bool boolean(pugi::xml_node node, const char* name) const {
        const auto found = node.attribute(name);
        if (!found) return false;
        const auto value = parse_boolean(found.value());
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

    std::string_view text_;
    std::string source_;
    pugi::xml_document document_{};
};

} // namespace jauscat::esi::detail
