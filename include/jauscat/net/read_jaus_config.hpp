// The reader of JausConfig.xml.
//
//   <jausconfig>
//     <thissystem>a</thissystem>
//     <system><name>a</name><jausip>1.0.0.0</jausip><ip>127.0.0.1</ip><port>39777</port></system>
//     ...
//   </jausconfig>
//
// Each value may be an attribute instead: <system name="a" jausip="1.0.0.0" ip="127.0.0.1" port="39777"/>.
#pragma once

#include <jauscat/net/jaus_config.hpp>

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace jauscat::net {

namespace detail {

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

class config_reader {
  public:
    config_reader(std::string_view text, std::string source) : text_{text}, source_{std::move(source)} {}

    jaus_config read() {
        const auto parsed = document_.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
        if (!parsed) fail(line_at(parsed.offset), std::string{"not well-formed XML: "} + parsed.description());

        const auto root = document_.document_element();
        if (!is_root_name(root.name()))
            fail(line_of(root), "the root element is <" + std::string{root.name()} + ">; it must be <jausconfig>");
        if (root.next_sibling()) fail(line_of(root.next_sibling()), "something follows </jausconfig>; remove it");

        std::array values{config_value{"thissystem"}};
        collect(root, values, "system");
        jaus_config config{.source = source_};
        for (const auto node : root.children("system")) config.systems.push_back(system(node, config));
        if (config.systems.empty())
            fail(line_of(root), "no <system>; give at least one, with <name>, <jausip>, <ip> and <port>");

        const auto& this_system = values[0];
        if (!this_system.given) fail(line_of(root), "no <thissystem>; name there the <system> that this program is");
        if (!config.find(this_system.text)) fail(this_system.line, no_such_system(config, this_system.text));
        config.this_system = this_system.text;
        return config;
    }

  private:
    [[noreturn]] void fail(std::size_t line, const std::string& text) const {
        throw config_error{source_ + ':' + std::to_string(line) + ": " + text, line};
    }

    std::size_t line_at(std::ptrdiff_t offset) const {
        const auto before = std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
        return 1 + static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + before, '\n'));
    }
    std::size_t line_of(pugi::xml_node node) const { return line_at(node.offset_debug()); }

    static bool is_root_name(std::string_view name) {
        const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
        return std::ranges::equal(name, std::string_view{"jausconfig"}, {}, lower);
    }

    /// Fills `values` from the attributes and children of `node`. Children called `other` are the caller's.
    void collect(pugi::xml_node node, std::span<config_value> values, std::string_view other = {}) const {
        const std::string inside = " in <" + std::string{node.name()} + '>';
        const auto set = [&](std::string_view name, const char* text, std::size_t line) {
            const auto value = std::ranges::find(values, name, &config_value::name);
            if (value == values.end())
                fail(line, "unknown " + quoted(name) + inside + "; remove it or correct its name");
            if (value->given) fail(line, quoted(name) + " is given twice" + inside + "; keep one");
            *value = {value->name, trimmed(text), line, true};
        };
        for (const auto attribute : node.attributes()) set(attribute.name(), attribute.value(), line_of(node));
        for (const auto child : node.children()) {
            const auto line = line_of(child);
            if (child.type() != pugi::node_element) fail(line, "stray text" + inside + "; remove it");
            if (child.name() == other) continue;
            set(child.name(), child.text().get(), line);
            if (child.first_attribute() || child.first_child() != child.last_child() ||
                child.first_child().type() == pugi::node_element)
                fail(line, '<' + std::string{child.name()} + "> takes a plain text and nothing else");
        }
    }

    system_entry system(pugi::xml_node node, const jaus_config& before) const {
        std::array values{config_value{"name"}, config_value{"jausip"}, config_value{"ip"}, config_value{"port"},
                          config_value{"framing"}};
        collect(node, values);
        const auto& [name, jausip, ip, port, framing] = values;
        const auto line = line_of(node);
        for (const auto& value : {name, jausip, ip, port})
            if (value.text.empty())
                fail(value.given ? value.line : line, "this <system> needs <" + std::string{value.name} + '>');
        return {.name = unique_name(name, before),
                .jausip = unique_jausip(jausip, before),
                .ip = ip_address(ip),
                .port = udp_port(port),
                .framing = framing_named(framing),
                .line = line};
    }

    std::string unique_name(const config_value& value, const jaus_config& before) const {
        if (const auto* taken = before.find(value.text))
            fail(value.line, "the name " + quoted(value.text) + " is taken by the <system> in line " +
                                 std::to_string(taken->line) + "; give each its own");
        return std::string{value.text};
    }

    jaus::address unique_jausip(const config_value& value, const jaus_config& before) const {
        const auto id = parse_jausip(value.text);
        if (!id || std::max({id->subsystem, id->node, id->component, id->instance}) > 254)
            fail(value.line, "jausip " + quoted(value.text) +
                                 " is not subsystem.node.component.instance, each 0 (all) to 254, such as 1.0.0.0");
        const auto taken = std::ranges::find(before.systems, *id, &system_entry::jausip);
        if (taken != before.systems.end())
            fail(value.line, "the jausip " + to_jausip(*id) + " is taken by the <system> in line " +
                                 std::to_string(taken->line) + "; give each its own");
        return *id;
    }

    boost::asio::ip::address ip_address(const config_value& value) const {
        boost::system::error_code wrong;
        auto address = boost::asio::ip::make_address(std::string{value.text}, wrong);
        if (wrong) fail(value.line, "ip " + quoted(value.text) + " is not an IP address, such as 127.0.0.1");
        return address;
    }

    std::uint16_t udp_port(const config_value& value) const {
        std::uint16_t port{};
        const auto* const end = value.text.data() + value.text.size();
        const auto [stop, error] = std::from_chars(value.text.data(), end, port);
        if (error != std::errc{} || stop != end || port == 0)
            fail(value.line, "port " + quoted(value.text) + " is not a UDP port, 1 to 65535");
        return port;
    }

    jaus::framing framing_named(const config_value& value) const {
        for (const auto framing : {jaus::framing::bare, jaus::framing::jaus01})
            if (value.text == jaus::name(framing)) return framing;
        if (value.given) fail(value.line, "framing " + quoted(value.text) + " is unknown; use bare or JAUS01.0");
        return jaus::framing::bare;
    }

    std::string_view text_;
    std::string source_;
    pugi::xml_document document_{};
};

} // namespace detail

/// Reads a configuration from text; `source` is the file's name in messages. Throws `config_error`.
inline jaus_config parse_jaus_config(std::string_view text, std::string source) {
    return detail::config_reader{text, std::move(source)}.read();
}

/// Reads a configuration file. Throws `config_error`.
inline jaus_config read_jaus_config(const std::filesystem::path& path) {
    std::ifstream file{path, std::ios::binary};
    file.peek(); // a directory opens, and fails here
    if (!file && !file.eof())
        throw config_error{path.string() + ": cannot be read: " + std::generic_category().message(errno) +
                               "; give the path of a JausConfig.xml, such as examples/JausConfig.xml",
                           0};
    std::ostringstream text;
    text << file.rdbuf();
    return parse_jaus_config(text.str(), path.string());
}

} // namespace jauscat::net
