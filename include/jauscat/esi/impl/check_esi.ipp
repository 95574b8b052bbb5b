// The checks of ESI files.
#pragma once
#include <jauscat/esi/check_esi.hpp>
#include <jauscat/esi/device.hpp>
#include <jauscat/esi/read_esi.hpp>
#include <jauscat/esi/requirements.hpp>
#include <jauscat/esi/text_values.hpp>
#include <jauscat/esi/xml_source.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>

#include <pugixml.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace jauscat::esi {

namespace detail {

class esi_checker : xml_source {
  public:
    esi_checker(std::string_view text, const std::string& source)
        : xml_source{text, source}, text_{text}, name_{source} {}

    std::vector<finding> check() {
        root_ = load();
        const auto device = root_.child("Descriptions").child("Devices").child("Device");
        has_mailbox_ = is_with_mailbox(device);
        for (const auto& each : requirements) look_for(each);
        if (has_mailbox_) check_mailbox(device);
        check_eeprom(device.child("Eeprom"));
        const auto objects = device.child("Profile").child("Dictionary").child("Objects");
        for (const auto& [index, name] : {std::pair{0x1000u, "device type"}, std::pair{0x1018u, "identity"}})
            if (has_mailbox_) check_object(objects, index, name);
        check_order();
        check_reading();
        return std::move(findings_);
    }

  private:
    std::string at(pugi::xml_node node) const {
        return "line " + std::to_string(line_of(node)) + ": <" + node.name() + ">: ";
    }
    std::string fault(pugi::xml_node node, const std::string& what) const {
        return node ? at(node) + what : std::string{parent_is_missing};
    }

    // A device that has SyncManagers for process data alone, and nothing else that needs a mailbox, has none.
    static bool is_with_mailbox(pugi::xml_node device) {
        if (!device || device.child("Mailbox") || device.child("Profile").child("Dictionary")) return true;
        const auto managers = device.children("Sm");
        return managers.empty() || std::ranges::any_of(managers, [](pugi::xml_node each) {
                   const std::string_view use = each.text().get();
                   return use != "Outputs" && use != "Inputs";
               });
    }

    void look_for(const requirement& wanted) {
        if (wanted.where == needed::with_mailbox && !has_mailbox_) return;
        std::vector<pugi::xml_node> parents{root_};
        auto rest = wanted.path;
        for (auto slash = rest.find('/'); slash != rest.npos; slash = rest.find('/')) {
            const std::string step{rest.substr(0, slash)};
            rest.remove_prefix(slash + 1);
            std::vector<pugi::xml_node> next;
            for (const auto parent : parents)
                std::ranges::copy(parent.children(step.c_str()), std::back_inserter(next));
            parents = std::move(next);
        }
        findings_.push_back({std::string{wanted.path}, std::string{wanted.reason},
                             parents.empty() && wanted.where != needed::in_parent
                                 ? std::string{parent_is_missing}
                                 : problem_in(parents, std::string{rest}, wanted.holds)});
    }

    std::string problem_in(const std::vector<pugi::xml_node>& parents, const std::string& name, content holds) const {
        for (const auto parent : parents) {
            if (name.front() == '@') {
                const auto attribute = parent.attribute(name.c_str() + 1);
                if (!attribute) return at(parent) + "has no attribute " + name.substr(1);
                if (!fits(attribute.value(), holds)) return at(parent) + wrong(attribute.value(), holds);
                continue;
            }
            if (!parent.child(name.c_str())) return at(parent) + "has no <" + name + '>';
            for (const auto child : parent.children(name.c_str()))
                if (!fits(child.text().get(), holds)) return at(child) + wrong(child.text().get(), holds);
        }
        return {};
    }

    static bool fits(std::string_view value, content holds) {
        switch (holds) {
        case content::element: return true;
        case content::text: return !value.empty();
        case content::number: return parse_number(value).has_value();
        case content::boolean: return parse_boolean(value).has_value();
        case content::bytes: return !value.empty() && parse_bytes(value).has_value();
        case content::access: return value == "ro" || value == "wo" || value == "rw";
        case content::sync_manager: return parse_sync_manager_use(value).has_value();
        }
        return false;
    }
    static std::string wrong(std::string_view value, content holds) {
        const auto expected = [holds]() -> std::string {
            switch (holds) {
            case content::element:
            case content::text: return "a text";
            case content::number: return "a number such as #x1A or 26";
            case content::boolean: return "true or false";
            case content::bytes: return "hexadecimal digits, two for each byte";
            case content::access: return "ro, wo or rw";
            case content::sync_manager: return "MBoxOut, MBoxIn, Outputs or Inputs";
            }
            return {};
        }();
        return '"' + std::string{value} + "\", expected " + expected;
    }

    void check_mailbox(pugi::xml_node device) {
        auto& result = add("SyncManagers 0 and 1 are the mailbox", "tools number the Sm elements from 0");
        const auto out = device.child("Sm"), in = out.next_sibling("Sm");
        if (out.text().get() != std::string_view{"MBoxOut"}) {
            result.problem = fault(out ? out : device, "expected the first <Sm> to be MBoxOut");
        } else if (in.text().get() != std::string_view{"MBoxIn"}) {
            result.problem = fault(in ? in : device, "expected the second <Sm> to be MBoxIn");
        }
        for (const auto sm : {out, in})
            if (const auto size = parse_number(sm.attribute("DefaultSize").value());
                result.met() && (!size || *size < ethercat::min_mailbox_size || *size > ethercat::max_mailbox_size))
                result.problem = at(sm) + "a mailbox has 24 to 1486 bytes";
    }

    void check_eeprom(pugi::xml_node node) {
        auto& config = add("ConfigData has the SII's words 0 to 6", "the slave controller's configuration");
        const auto bytes = parse_bytes(node.child("ConfigData").text().get());
        if (!bytes || bytes->size() < ethercat::sii_configuration_checked)
            config.problem = fault(node, "expected 14 bytes or more in <ConfigData>");
        auto& size = add("ByteSize holds the SII's fixed part", "its categories begin at byte 128");
        const auto value = parse_number(node.child("ByteSize").text().get());
        if (!value || *value < 2 * ethercat::sii_words::categories)
            size.problem = fault(node, "expected 128 or more in <ByteSize>");
    }

    void check_object(pugi::xml_node objects, std::uint32_t index, const std::string& name) {
        auto& result = add("object " + hex_number(index, 4) + ", " + name, "mandatory in every CoE device");
        for (const auto each : objects.children("Object"))
            if (parse_number(each.child("Index").text().get()) == index) return;
        result.problem = fault(objects, "has no object " + hex_number(index, 4));
    }

    void check_order() {
        auto& result = add("elements stand in the schema's order", "schema");
        for (const auto& found : root_.select_nodes("descendant-or-self::*")) {
            const auto node = found.node();
            const std::string name = node.name(), qualified = std::string{node.parent().name()} + '/' + name;
            for (const auto& [element, children] : element_orders)
                if (result.met() && (element == name || element == qualified))
                    result.problem = disorder_in(node, ' ' + std::string{children} + ' ');
        }
    }

    std::string disorder_in(pugi::xml_node node, const std::string& order) const {
        std::size_t last = 0;
        for (const auto child : node.children()) {
            if (child.type() != pugi::node_element) continue;
            const auto place = order.find(' ' + std::string{child.name()} + ' ');
            if (place == order.npos) return at(child) + "not known in <" + node.name() + '>';
            if (place < last)
                return at(child) + "stands too late in <" + node.name() + ">, expected the order" +
                       order.substr(0, order.size() - 1);
            last = place;
        }
        return {};
    }

    // Errors across elements, such as types that do not fit their objects, are found by reading the file.
    void check_reading() {
        auto& result = add("types, sizes and references agree", "tools and emulators build the dictionary from them");
        result.problem = parse_esi(text_, name_).error().message;
    }

    finding& add(std::string what, std::string reason) {
        return findings_.emplace_back(finding{std::move(what), std::move(reason), {}});
    }

    static constexpr std::string_view parent_is_missing = "its parent is missing";

    std::string_view text_;
    std::string name_;
    pugi::xml_node root_{};
    bool has_mailbox_{};
    std::vector<finding> findings_{};
};

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL result<std::vector<finding>, error> check_esi_text(std::string_view text, const std::string& source) {
    return detail::caught([&] { return detail::esi_checker{text, source}.check(); });
}

JAUSCAT_DECL result<std::vector<finding>, error> check_esi(const std::filesystem::path& path) {
    return detail::caught([&] { return detail::esi_checker{detail::text_of(path), path.string()}.check(); });
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi
