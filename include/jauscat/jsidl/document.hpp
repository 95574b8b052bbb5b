// JSIDL documents and the definitions in them that others refer to.
#pragma once
#include <jauscat/jsidl/expression.hpp>
#include <jauscat/jsidl/source.hpp>
#include <jauscat/text/quoted.hpp>

#include <pugixml.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace jauscat::jsidl::detail {

/// An element's name without the prefix of its namespace.
inline std::string_view local_name(pugi::xml_node node) {
    const std::string_view name{node.name()};
    return name.substr(name.find(':') + 1);
}

/// `record` for `record` and `declared_record`.
inline std::string_view kind_name(pugi::xml_node node) {
    auto name = local_name(node);
    if (name.starts_with("declared_")) name.remove_prefix(std::string_view{"declared_"}.size());
    return name;
}

class document {
  public:
    /// `source` is the file's name in messages.
    document(std::string_view text, std::string source) : text_{text::as_utf8(text)}, source_{std::move(source)} {
        for (std::size_t at = 0; (at = text_.find('\n', at)) != text_.npos; ++at) line_ends_.push_back(at);
        const auto parsed = document_.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
        if (!parsed)
            detail::fail(errc::not_xml, source_, line_at(parsed.offset), "",
                         std::string{"not well-formed XML: "} + parsed.description());
        const auto name = local_name(root());
        if (name != "service_def" && name != "declared_type_set" && name != "declared_const_set")
            fail(errc::not_jsidl, root(),
                 "the root element, expected <service_def>, <declared_type_set> or <declared_const_set>");
        const std::string space = name_space();
        if (space != "urn:jaus:jsidl:1.0" && space != "urn:jaus:jsidl:1.1")
            fail(errc::not_jsidl, root(),
                 "the namespace is " + text::quoted(space) + ", expected urn:jaus:jsidl:1.0 or urn:jaus:jsidl:1.1");
    }

    [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }
    [[nodiscard]] const std::string& source() const noexcept { return source_; }
    [[nodiscard]] std::size_t line_of(pugi::xml_node node) const { return line_at(node.offset_debug()); }

    [[noreturn]] void fail(errc code, pugi::xml_node node, const std::string& what) const {
        detail::fail(code, source_, line_of(node), node.name(), what);
    }
    [[nodiscard]] std::string attribute(pugi::xml_node node, const char* name) const {
        const auto found = node.attribute(name);
        if (!found) fail(errc::missing, node, "has no attribute " + std::string{name});
        auto value = with_single_spaces(found.value());
        if (value.empty()) fail(errc::missing, node, std::string{name} + " is empty");
        return value;
    }
    [[nodiscard]] bool boolean(pugi::xml_node node, const char* name) const {
        const auto value = with_single_spaces(node.attribute(name).value());
        if (value.empty() || value == "false" || value == "0") return false;
        if (value == "true" || value == "1") return true;
        fail(errc::invalid_value, node, std::string{name} + "=" + text::quoted(value) + ", expected true or false");
    }
    [[nodiscard]] std::optional<pugi::xml_node> child(pugi::xml_node parent, std::string_view name) const {
        std::optional<pugi::xml_node> found;
        for (const auto each : parent.children()) {
            if (kind_name(each) != name) continue;
            if (found) fail(errc::unexpected, each, "the second one here, expected one");
            found = each;
        }
        return found;
    }
    [[nodiscard]] pugi::xml_node needed_child(pugi::xml_node parent, std::string_view name) const {
        const auto found = child(parent, name);
        if (!found) fail(errc::missing, parent, "expected a <" + std::string{name} + "> in it");
        return *found;
    }

  private:
    [[nodiscard]] std::size_t line_at(std::ptrdiff_t offset) const {
        const auto before = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
        return 1 + static_cast<std::size_t>(std::ranges::lower_bound(line_ends_, before) - line_ends_.begin());
    }
    [[nodiscard]] std::string name_space() const {
        const std::string_view name{root().name()};
        const auto colon = name.find(':');
        const auto attribute =
            colon == name.npos ? std::string{"xmlns"} : "xmlns:" + std::string{name.substr(0, colon)};
        return with_single_spaces(root().attribute(attribute.c_str()).value());
    }

    std::string text_;
    std::string source_;
    std::vector<std::size_t> line_ends_{};
    pugi::xml_document document_{};
};

/// An element, and the file that it stands in.
struct located {
    const document* file{};
    pugi::xml_node node{};
};

/// Sets of types and constants by URI and version.
class definitions {
  public:
    void add(const document& file) {
        const auto root = file.root();
        const auto key = key_of({&file, root});
        const auto [known, is_new] = sets_.emplace(key, located{&file, root});
        if (!is_new)
            file.fail(errc::duplicate, root,
                      "defines " + key.first + " version " + key.second + " again; " + known->second.file->source() +
                          " defines it");
    }

    /// The definition that a declared_ element refers to, behind any number of references, and the set it stands in.
    struct target {
        located definition{};
        located set{};
    };
    [[nodiscard]] target resolve(located reference, located set) const {
        for (int steps = 0; local_name(reference.node).starts_with("declared_"); ++steps) {
            const auto path = reference.file->attribute(reference.node, "declared_type_ref");
            if (steps > 64)
                reference.file->fail(errc::cycle, reference.node,
                                     "declared_type_ref=" + text::quoted(path) + " refers to itself");
            const auto [from, name] = follow(reference, set, path, "type");
            const auto kind = kind_name(reference.node);
            auto found = definition(from, name);
            if (!found.node)
                reference.file->fail(errc::unknown_reference, reference.node,
                                     "declared_type_ref=" + text::quoted(path) + ": there is no \"" + name + "\" in " +
                                         describe(from));
            if (kind_name(found.node) != kind)
                reference.file->fail(errc::unknown_reference, reference.node,
                                     "declared_type_ref=" + text::quoted(path) + " is a <" + found.node.name() +
                                         ">, expected a <" + std::string{kind} + ">");
            reference = found;
            set = from;
        }
        return {reference, set};
    }

    /// The number in an attribute, which may name constants.
    [[nodiscard]] double real(located at, located set, const char* attribute) const {
        std::vector<std::pair<const document*, std::ptrdiff_t>> open;
        return evaluate(at, set, attribute, open);
    }

  private:
    using key_type = std::pair<std::string, std::string>;

    static key_type key_of(located at) {
        return {at.file->attribute(at.node, "id"), at.file->attribute(at.node, "version")};
    }
    static std::string describe(located set) {
        const std::string_view name{set.node.attribute("name").value()};
        return name.empty() ? set.file->source() : text::quoted(name) + " of " + set.file->source();
    }

    /// The set in which the last name of `path` is defined, and this name.
    [[nodiscard]] std::pair<located, std::string> follow(located at, located set, std::string_view path,
                                                         const std::string& what) const {
        // The first name may also stand in what is around the set.
        const auto first = path.substr(0, path.find('.'));
        while (!knows(set, first) && set.node.parent().type() == pugi::node_element) set.node = set.node.parent();
        for (auto dot = path.find('.'); dot != path.npos; dot = path.find('.')) {
            const auto alias = path.substr(0, dot);
            path.remove_prefix(dot + 1);
            set = entered(at, set, alias, what);
        }
        return {set, std::string{path}};
    }
    static bool knows(located set, std::string_view name) {
        return std::ranges::any_of(
            scope(set), [&](const auto& each) { return with_single_spaces(each.attribute("name").value()) == name; });
    }
    /// The set that is called `alias` in `set`.
    [[nodiscard]] located entered(located at, located set, std::string_view alias, const std::string& what) const {
        for (const auto each : scope(set)) {
            if (with_single_spaces(each.attribute("name").value()) != alias) continue;
            const auto name = local_name(each);
            if (name == "declared_type_set" || name == "declared_const_set") return {set.file, each};
            if (name != "declared_type_set_ref" && name != "declared_const_set_ref") continue;
            const auto key = key_of({set.file, each});
            const auto found = sets_.find(key);
            if (found == sets_.end())
                set.file->fail(errc::unknown_reference, each,
                               "no file that is given defines " + key.first + " version " + key.second);
            return found->second;
        }
        at.file->fail(errc::unknown_reference, at.node,
                      "there is no set of " + what + "s called " + text::quoted(alias) + " in " + describe(set));
    }
    /// What stands in a set and in the sets inside it: a service has its types in a <declared_type_set>.
    static std::vector<pugi::xml_node> scope(located set) {
        std::vector<pugi::xml_node> found;
        for (const auto each : set.node.children()) {
            found.push_back(each);
            const auto name = local_name(each);
            if (name == "declared_type_set" || name == "declared_const_set")
                for (const auto inner : each.children()) found.push_back(inner);
        }
        return found;
    }
    static located definition(located set, std::string_view wanted) {
        for (const auto each : scope(set)) {
            const auto name = local_name(each);
            if (name.ends_with("_ref") || name.ends_with("_set")) continue;
            if (with_single_spaces(each.attribute("name").value()) == wanted) return {set.file, each};
        }
        return {};
    }

    double evaluate(located at, located set, const char* attribute,
                    std::vector<std::pair<const document*, std::ptrdiff_t>>& open) const {
        const auto written = at.file->attribute(at.node, attribute);
        const auto constant = [&](std::string_view path) {
            const auto [from, name] = follow(at, set, path, "constant");
            const auto found = definition(from, name);
            if (!found.node || local_name(found.node) != "const_def")
                at.file->fail(errc::unknown_reference, at.node,
                              std::string{attribute} + "=" + text::quoted(written) + ": there is no constant \"" +
                                  name + "\" in " + describe(from));
            const std::pair<const document*, std::ptrdiff_t> key{found.file, found.node.offset_debug()};
            if (std::ranges::find(open, key) != open.end())
                found.file->fail(errc::cycle, found.node, "the constant refers to itself");
            open.push_back(key);
            const double value = evaluate(found, from, "const_value", open);
            open.pop_back();
            return value;
        };
        const auto value = expression{written, constant}.value();
        if (!value)
            at.file->fail(errc::invalid_value, at.node,
                          std::string{attribute} + "=" + text::quoted(written) +
                              ", expected a number such as 1000, 1,000 or -20*consts.PI");
        return *value;
    }

    std::map<key_type, located> sets_{};
};

} // namespace jauscat::jsidl::detail
