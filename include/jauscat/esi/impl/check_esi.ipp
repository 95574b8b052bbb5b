// The checks of ESI files.
#pragma once
#include <jauscat/esi/check_esi.hpp>
#include <jauscat/esi/device.hpp>
#include <jauscat/esi/emulated_device.hpp>
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
        load();
        for (const auto each : root().child("Descriptions").child("Devices").children("Device"))
            devices_.push_back(each);
        if (devices_.empty()) devices_.emplace_back(); // so that its elements are missing
        for (const auto& each : requirements) look_for(each);
        check_order();
        check_reading();
        for (const auto device : devices_) {
            check_eeprom(device.child("Eeprom"));
            if (is_with_mailbox(device)) check_mailbox(device);
            if (is_with_dictionary(device)) check_objects(device);
        }
        check_emulation();
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
        return std::ranges::any_of(device.children("Sm"), [](pugi::xml_node each) {
            return text(each) == "MBoxOut" || text(each) == "MBoxIn";
        });
    }
    // A device with a mailbox may have other protocols than CoE.
    static bool is_with_dictionary(pugi::xml_node device) {
        const auto mailbox = device.child("Mailbox");
        return is_with_mailbox(device) && (!mailbox.first_child() || mailbox.child("CoE"));
    }
    static bool is_concerned(pugi::xml_node device, needed where) {
        switch (where) {
        case needed::always:
        case needed::in_parent: return true;
        case needed::with_mailbox: return is_with_mailbox(device);
        case needed::with_coe: return is_with_dictionary(device);
        }
        return true;
    }

    void look_for(const requirement& wanted) {
        constexpr std::string_view below = "Descriptions/Devices/Device/";
        if (!wanted.path.starts_with(below)) {
            add(wanted.by, wanted.path, wanted.reason, problem_below(root(), wanted.path, wanted));
            return;
        }
        for (const auto device : devices_)
            if (is_concerned(device, wanted.where))
                add(wanted.by, wanted.path, wanted.reason,
                    problem_below(device, wanted.path.substr(below.size()), wanted));
    }

    std::string problem_below(pugi::xml_node from, std::string_view rest, const requirement& wanted) const {
        std::vector<pugi::xml_node> parents;
        if (from) parents.push_back(from);
        for (auto slash = rest.find('/'); slash != rest.npos; slash = rest.find('/')) {
            const std::string step{rest.substr(0, slash)};
            rest.remove_prefix(slash + 1);
            std::vector<pugi::xml_node> next;
            for (const auto parent : parents)
                std::ranges::copy(parent.children(step.c_str()), std::back_inserter(next));
            parents = std::move(next);
        }
        if (parents.empty()) return wanted.where == needed::in_parent ? std::string{} : std::string{parent_is_missing};
        return problem_in(parents, std::string{rest}, wanted.holds);
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
        const auto out = device.child("Sm"), in = out.next_sibling("Sm");
        std::string problem;
        if (text(out) != "MBoxOut") {
            problem = fault(out ? out : device, "expected the first <Sm> to be MBoxOut");
        } else if (text(in) != "MBoxIn") {
            problem = fault(in ? in : device, "expected the second <Sm> to be MBoxIn");
        }
        for (const auto sm : {out, in})
            if (const auto size = parse_number(sm.attribute("DefaultSize").value());
                problem.empty() && (!size || *size < ethercat::min_mailbox_size || *size > ethercat::max_mailbox_size))
                problem = at(sm) + "a mailbox has 24 to 1486 bytes";
        add(demand::standard, "SyncManagers 0 and 1 are the mailbox", "tools number the Sm elements from 0", problem);
    }

    void check_eeprom(pugi::xml_node node) {
        if (node.child("Data")) return; // the SII as a whole
        const auto bytes = parse_bytes(node.child("ConfigData").text().get());
        add(demand::standard, "ConfigData has the SII's words 0 to 6", "the slave controller's configuration",
            !bytes || bytes->size() < ethercat::sii_configuration_checked
                ? fault(node, "expected 14 bytes or more in <ConfigData>")
                : "");
        const auto value = parse_number(node.child("ByteSize").text().get());
        add(demand::standard, "ByteSize holds the SII's fixed part", "its categories begin at byte 128",
            !value || *value < 2 * ethercat::sii_words::categories ? fault(node, "expected 128 or more in <ByteSize>")
                                                                   : "");
    }

    void check_objects(pugi::xml_node device) {
        const auto objects = device.child("Profile").child("Dictionary").child("Objects");
        for (const auto& [index, name] : {std::pair{0x1000u, "device type"}, std::pair{0x1018u, "identity"}}) {
            const auto is_there =
                std::ranges::any_of(objects.children("Object"), [wanted = index](pugi::xml_node each) {
                    return parse_number_liberally(each.child("Index").text().get()) == wanted;
                });
            add(demand::emulation, "object " + hex_number(index, 4) + ", " + name, "mandatory in every CoE device",
                is_there ? "" : fault(objects, "has no object " + hex_number(index, 4)));
        }
    }

    void check_order() {
        add(demand::schema, "elements stand in the schema's order", "tools read them in it",
            disorder_below(root(), "EtherCATInfo"));
    }

    // The first element below `node` that stands in a wrong place. What `node` may hold depends on its own place.
    std::string disorder_below(pugi::xml_node node, std::string_view kind) const {
        const auto* const order = std::ranges::find(element_orders, kind, &element_order::kind);
        if (order == element_orders.end()) return {};
        std::size_t last = 0;
        for (const auto child : node.children()) {
            if (child.type() != pugi::node_element) continue;
            const auto place = place_in(order->children, child.name());
            if (place == std::string_view::npos) return at(child) + "not known in <" + node.name() + '>';
            if (place < last)
                return at(child) + "stands too late in <" + node.name() + ">, expected the order " +
                       names_in(order->children);
            last = place;
            const auto rest = order->children.substr(place + std::string_view{child.name()}.size());
            if (!rest.starts_with(':')) continue;
            auto problem = disorder_below(child, rest.substr(1, rest.find(' ') - 1));
            if (!problem.empty()) return problem;
        }
        return {};
    }
    static std::size_t place_in(std::string_view children, std::string_view name) {
        for (std::size_t at = children.find(name); at != children.npos; at = children.find(name, at + 1)) {
            const auto end = at + name.size();
            if ((at == 0 || children[at - 1] == ' ') &&
                (end == children.size() || children[end] == ' ' || children[end] == ':'))
                return at;
        }
        return children.npos;
    }
    static std::string names_in(std::string_view children) {
        std::string made;
        for (bool is_name = true; const char c : children) {
            is_name = c == ' ' || (is_name && c != ':');
            if (is_name) made += c;
        }
        return made;
    }

    // Errors across elements, such as types that do not fit their objects, are found by reading the file.
    void check_reading() {
        std::string problem;
        const auto file = esi_file::parse(text_, name_);
        if (!file) problem = file.error().message;
        for (std::size_t i = 0; i != file->devices().size(); ++i) {
            auto device = file->read({.number = i});
            if (problem.empty() && !device) problem = device.error().message;
            if (problem.empty() && !device->slips.empty()) problem = device->slips.front().message;
            if (device) read_.push_back(*std::move(device));
        }
        add(demand::schema, "types, sizes and references agree", "tools build the dictionary from them", problem);
    }

    void check_emulation() {
        std::string problem;
        for (const auto& each : read_) {
            const auto made = caught([&] {
                const emulated_device device{each};
                return true;
            });
            if (!made && problem.empty()) problem = made.error().message;
        }
        if (read_.empty()) problem = "no device could be read";
        add(demand::emulation, "the emulated device takes it", "emulated_bus --esi", problem);
    }

    // One finding for a requirement, with the first problem.
    void add(demand by, std::string_view what, std::string_view reason, std::string problem) {
        const auto found = std::ranges::find(findings_, what, &finding::what);
        if (found == findings_.end())
            findings_.push_back({by, std::string{what}, std::string{reason}, std::move(problem)});
        else if (found->met())
            found->problem = std::move(problem);
    }

    static constexpr std::string_view parent_is_missing = "its parent is missing";

    std::string_view text_;
    std::string name_;
    std::vector<pugi::xml_node> devices_{};
    std::vector<device> read_{};
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
