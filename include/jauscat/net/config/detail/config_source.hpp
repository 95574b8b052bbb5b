// The text of a configuration file: elements with values in attributes or children, and errors with their line.
#pragma once

#include <jauscat/base/stable_sort.hpp>
#include <jauscat/net/config_error.hpp>
#include <jauscat/net/detail/quoted.hpp>

#include <pugixml.hpp>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace jauscat::net::detail {

inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n";
    const auto first = text.find_first_not_of(blank);
    return first == text.npos ? std::string_view{} : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

/// A value of an element, given as a child element or as an attribute of that name.
struct config_value {
    std::string_view name{};
    std::string_view text{};
    std::size_t line{};
    bool given{};
};

class config_source {
  public:
    /// Throws `config_error` when it is not well-formed XML.
    config_source(std::string_view text, std::string source) : source_{std::move(source)} {
        for (auto end = text.find('\n'); end != text.npos; end = text.find('\n', end + 1)) line_ends_.push_back(end);
        const auto parsed = document_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
        if (!parsed)
            fail(config_errc::not_xml, {}, line_at(parsed.offset),
                 std::string{"not well-formed XML: "} + parsed.description());
    }

    [[noreturn]] void fail(config_errc code, std::string_view name, std::size_t line, const std::string& text) const {
        throw config_error{code, std::string{name}, line, source_ + ':' + std::to_string(line) + ": " + text};
    }
    [[noreturn]] void fail(config_errc code, const config_value& value, const std::string& text) const {
        fail(code, value.name, value.line, text);
    }
    [[noreturn]] void fail(config_errc code, pugi::xml_node node, const std::string& text) const {
        fail(code, node.name(), line_of(node), text);
    }

    /// A mistake that does not hinder from reading on: `finish` throws it with all others. Of one value the first
    /// counts.
    void note(config_errc code, std::string_view name, std::size_t line, const std::string& text) const {
        note({code, std::string{name}, line, source_ + ':' + std::to_string(line) + ": " + text});
    }
    void note(config_errc code, const config_value& value, const std::string& text) const {
        note(code, value.name, value.line, text);
    }
    void note(config_errc code, pugi::xml_node node, const std::string& text) const {
        note(code, node.name(), line_of(node), text);
    }
    /// What `f` fails with is noted. Returns whether it has not failed.
    bool attempt(auto&& f) const {
        try {
            f();
            return true;
        } catch (const config_error& error) {
            note(error);
            return false;
        }
    }
    [[nodiscard]] bool has_problems() const noexcept { return !problems_.empty(); }
    /// Throws `config_error` where something was noted: that of the first line, with the text of all, a line each.
    void finish() const {
        if (problems_.empty()) return;
        jauscat::stable_sort(problems_, &config_error::line);
        std::string text;
        for (const auto& one : problems_) text.append(text.empty() ? "" : "\n").append(one.what());
        const auto& first = problems_.front();
        throw config_error{first.code(), first.name(), first.line(), text};
    }

    [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }
    [[nodiscard]] const std::string& name() const noexcept { return source_; }
    [[nodiscard]] std::size_t line_of(pugi::xml_node node) const { return line_at(node.offset_debug()); }

    /// Fills `values` from the attributes and children of `node`. Children called as in `others` are the caller's. All
    /// values called `repeated` are collected there instead.
    void collect(pugi::xml_node node, std::span<config_value> values,
                 std::initializer_list<std::string_view> others = {}, std::string_view repeated = {},
                 std::vector<config_value>* all = nullptr) const {
        const std::string inside = " in <" + std::string{node.name()} + '>';
        const auto set = [&](std::string_view name, const char* text, std::size_t line) {
            if (all && name == repeated) return void(all->push_back({repeated, trimmed(text), line, true}));
            const auto value = std::ranges::find(values, name, &config_value::name);
            if (value == values.end())
                return note(config_errc::unknown_name, name, line,
                            "unknown " + quoted(name) + inside + "; remove it or correct its name");
            if (value->given)
                return note(config_errc::duplicate, name, line,
                            quoted(name) + " is given twice" + inside + "; keep one");
            *value = {value->name, trimmed(text), line, true};
        };
        for (const auto attribute : node.attributes()) {
            const std::string_view name = attribute.name();
            // What editors need to find the schema.
            if (node == root() && (name.starts_with("xmlns") || name.starts_with("xsi:"))) continue;
            set(name, attribute.value(), line_of(node));
        }
        for (const auto child : node.children()) {
            const auto line = line_of(child);
            if (child.type() != pugi::node_element) {
                note(config_errc::unexpected, node.name(), line, "stray text" + inside + "; remove it");
                continue;
            }
            if (std::ranges::find(others, child.name()) != others.end()) continue;
            set(child.name(), child.text().get(), line);
            if (child.first_attribute() || child.first_child() != child.last_child() ||
                child.first_child().type() == pugi::node_element)
                note(config_errc::unexpected, child,
                     '<' + std::string{child.name()} + "> takes a plain text and nothing else");
        }
    }

    /// Notes which of the values have no text.
    void need(pugi::xml_node node, std::initializer_list<config_value> values) const {
        for (const auto& value : values)
            if (value.text.empty())
                note(config_errc::missing, value.name, value.given ? value.line : line_of(node),
                     "this <" + std::string{node.name()} + "> needs <" + std::string{value.name} + '>');
    }

    /// The only child of that name, or an empty node.
    [[nodiscard]] pugi::xml_node only_child(pugi::xml_node node, const char* name) const {
        const auto child = node.child(name);
        if (const auto second = child.next_sibling(name))
            fail(config_errc::duplicate, second,
                 quoted(name) + " is given twice in <" + std::string{node.name()} + ">; keep one");
        return child;
    }

  private:
    void note(const config_error& error) const {
        const bool is_of_absent = error.line() == 0; // which is noted as missing
        const auto is_same = [&](const config_error& one) {
            return one.line() == error.line() && one.name() == error.name() && !one.name().empty();
        };
        if (!is_of_absent && std::ranges::none_of(problems_, is_same)) problems_.push_back(error);
    }
    [[nodiscard]] std::size_t line_at(std::ptrdiff_t offset) const {
        const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
        return 1 + static_cast<std::size_t>(std::ranges::lower_bound(line_ends_, at) - line_ends_.begin());
    }

    std::vector<std::size_t> line_ends_{}; ///< where the line feeds are
    std::string source_;
    pugi::xml_document document_{};
    mutable std::vector<config_error> problems_{};
};

} // namespace jauscat::net::detail
