// The writer of ESI files.
#pragma once
#include <jauscat/esi/text_values.hpp>
#include <jauscat/esi/write_esi.hpp>

#include <pugixml.hpp>

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

namespace jauscat::esi {

namespace detail {

inline pugi::xml_node add(pugi::xml_node parent, const char* name) { return parent.append_child(name); }
inline pugi::xml_node add(pugi::xml_node parent, const char* name, const std::string& text) {
    auto node = parent.append_child(name);
    node.text().set(text.c_str());
    return node;
}
/// A name in English, the schema's NameType.
inline void add_name(pugi::xml_node parent, const std::string& text) {
    add(parent, "Name", text).append_attribute("LcId").set_value("1033");
}
inline void set(pugi::xml_node node, const char* name, const std::string& text) {
    node.append_attribute(name).set_value(text.c_str());
}
inline std::string number(std::uint64_t value) { return std::to_string(value); }

/// Adds one device to a document.
class esi_writer {
  public:
    explicit esi_writer(const device& what) : device_{what} {}

    void write(pugi::xml_document& document) {
        auto declaration = document.append_child(pugi::node_declaration);
        set(declaration, "version", "1.0");
        set(declaration, "encoding", "UTF-8");
        const auto root = add(document, "EtherCATInfo");
        set(root, "xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance");
        set(root, "xsi:noNamespaceSchemaLocation", "EtherCATInfo.xsd");
        set(root, "Version", "1.6");
        const auto vendor = add(root, "Vendor");
        add(vendor, "Id", hex_number(device_.vendor_id, 8));
        add_name(vendor, device_.vendor_name);
        const auto descriptions = add(root, "Descriptions");
        const auto group = add(add(descriptions, "Groups"), "Group");
        add(group, "Type", device_.group_type);
        add_name(group, device_.group_name);
        put_device(add(add(descriptions, "Devices"), "Device"));
    }

  private:
    void put_device(pugi::xml_node node) {
        set(node, "Physics", device_.physics);
        const auto type = add(node, "Type", device_.type);
        set(type, "ProductCode", hex_number(device_.product_code, 8));
        set(type, "RevisionNo", hex_number(device_.revision, 8));
        if (device_.serial != 0) set(type, "SerialNo", hex_number(device_.serial, 8));
        add_name(node, device_.name);
        put_timeouts(node);
        add(node, "GroupType", device_.group_type);
        if (device_.has_coe || device_.profile != 0) {
            const auto profile = add(node, "Profile");
            add(profile, "ProfileNo", number(device_.profile));
            if (device_.has_coe) put_dictionary(add(profile, "Dictionary"));
        }
        for (const auto& use : device_.fmmus) add(node, "Fmmu", use);
        for (const auto& manager : device_.sync_managers) put_sync_manager(node, manager);
        for (const auto& each : device_.rx_pdos) put_pdo(add(node, "RxPdo"), each);
        for (const auto& each : device_.tx_pdos) put_pdo(add(node, "TxPdo"), each);
        if (device_.has_coe || !device_.protocols.empty()) put_mailbox(add(node, "Mailbox"));
        if (!device_.clock_modes.empty()) {
            const auto clock = add(node, "Dc");
            for (const auto& each : device_.clock_modes) put_clock_mode(add(clock, "OpMode"), each);
        }
        put_slots(node);
        if (device_.eeprom != eeprom{}) put_eeprom(add(node, "Eeprom"));
    }

    void put_eeprom(pugi::xml_node node) const {
        if (!device_.eeprom.image.empty()) {
            add(node, "Data", hex_bytes(device_.eeprom.image));
            return;
        }
        add(node, "ByteSize", number(device_.eeprom.byte_size));
        add(node, "ConfigData", hex_bytes(device_.eeprom.config_data));
        if (!device_.eeprom.bootstrap.empty()) add(node, "BootStrap", hex_bytes(device_.eeprom.bootstrap));
    }

    void put_timeouts(pugi::xml_node device) const {
        const auto& times = device_.timeouts;
        if (times == esi::timeouts{}) return;
        const auto info = add(device, "Info");
        const auto put = [](pugi::xml_node parent, const char* name, std::optional<std::chrono::milliseconds> time) {
            if (time) add(parent, name, std::to_string(time->count()));
        };
        if (times.pre_op || times.safe_op_op || times.back_to_init || times.back_to_safe_op) {
            const auto states = add(add(info, "StateMachine"), "Timeout");
            put(states, "PreopTimeout", times.pre_op);
            put(states, "SafeopOpTimeout", times.safe_op_op);
            put(states, "BackToInitTimeout", times.back_to_init);
            put(states, "BackToSafeopTimeout", times.back_to_safe_op);
        }
        if (times.request || times.response) {
            const auto mailbox = add(add(info, "Mailbox"), "Timeout");
            put(mailbox, "RequestTimeout", times.request);
            put(mailbox, "ResponseTimeout", times.response);
        }
    }

    void put_slots(pugi::xml_node device) const {
        if (device_.slots.empty()) return;
        const auto slots = add(device, "Slots");
        for (const auto& each : device_.slots) {
            const auto node = add(slots, "Slot");
            set(node, "MinInstances", number(each.min_instances));
            set(node, "MaxInstances", number(each.max_instances));
            if (!each.name.empty()) add_name(node, each.name);
            for (const auto& name : each.module_classes) add(add(node, "ModuleClass"), "Class", name);
            for (const auto ident : each.module_idents) add(node, "ModuleIdent", hex_number(ident, 8));
        }
    }

    void put_dictionary(pugi::xml_node dictionary) {
        const auto types = add(dictionary, "DataTypes");
        const auto objects = add(dictionary, "Objects");
        for (const auto& what : device_.objects) put_object(types, objects, what);
    }

    static void put_sync_manager(pugi::xml_node device, const sync_manager& manager) {
        const auto* const use =
            std::ranges::find(sync_manager_uses, manager.use, [](const auto& u) { return u.first; });
        const auto node = add(device, "Sm", use == sync_manager_uses.end() ? "" : std::string{use->second});
        if (manager.min_size != 0) set(node, "MinSize", number(manager.min_size));
        if (manager.max_size != 0) set(node, "MaxSize", number(manager.max_size));
        set(node, "DefaultSize", number(manager.default_size));
        set(node, "StartAddress", hex_number(manager.start, 4));
        set(node, "ControlByte", hex_number(manager.control, 2));
        set(node, "Enable", manager.enabled ? "1" : "0");
        if (manager.is_virtual) set(node, "Virtual", "true");
    }

    static void put_pdo(pugi::xml_node node, const pdo& what) {
        if (what.sync_manager != not_assigned) set(node, "Sm", number(what.sync_manager));
        if (what.fixed) set(node, "Fixed", "1");
        if (what.mandatory) set(node, "Mandatory", "1");
        add(node, "Index", hex_number(what.index, 4));
        add_name(node, what.name);
        for (const auto& each : what.entries) {
            const auto entry = add(node, "Entry");
            add(entry, "Index", hex_number(each.index, each.index == 0 ? 1 : 4));
            if (each.index != 0) add(entry, "SubIndex", number(each.subindex));
            add(entry, "BitLen", number(each.bits));
            if (each.index == 0) continue;
            if (!each.name.empty()) add_name(entry, each.name);
            if (!each.type.empty()) add(entry, "DataType", each.type);
        }
    }

    void put_mailbox(pugi::xml_node node) const {
        set(node, "DataLinkLayer", "true"); // a lost reply can be requested again
        const auto put_protocols = [&](bool behind) {
            for (const auto& each : device_.protocols)
                if ((each > "CoE" && each != "EoE") == behind) add(node, each.c_str());
        };
        put_protocols(false); // AoE, EoE, CoE, FoE, SoE, VoE is the schema's order
        if (device_.has_coe) put_coe(add(node, "CoE"));
        put_protocols(true);
    }

    void put_coe(pugi::xml_node coe) const {
        const auto put = [&](const char* name, bool value) { set(coe, name, value ? "true" : "false"); };
        put("SdoInfo", device_.coe.sdo_information);
        put("PdoAssign", device_.coe.pdo_assign);
        put("PdoConfig", device_.coe.pdo_configuration);
        put("CompleteAccess", device_.coe.complete_access);
        put("SegmentedSdo", device_.coe.segmented_sdo);
        for (const auto& each : device_.start_up) {
            const auto node = add(coe, "InitCmd");
            if (each.complete_access) set(node, "CompleteAccess", "true");
            for (const auto& transition : each.transitions) add(node, "Transition", transition);
            add(node, "Index", hex_number(each.index, 4));
            add(node, "SubIndex", number(each.subindex));
            add(node, "Data", hex_bytes(each.data));
            if (!each.comment.empty()) add(node, "Comment", each.comment);
        }
    }

    static void put_clock_mode(pugi::xml_node node, const clock_mode& mode) {
        const auto put_cycle = [node](const char* name, std::uint32_t time, std::int16_t factor) {
            set(add(node, name, number(time)), "Factor", std::to_string(factor));
        };
        add(node, "Name", mode.name);
        if (!mode.description.empty()) add(node, "Desc", mode.description);
        add(node, "AssignActivate", hex_number(mode.assign_activate, 3));
        put_cycle("CycleTimeSync0", mode.cycle_time_0, mode.cycle_factor_0);
        add(node, "ShiftTimeSync0", std::to_string(mode.shift_time_0));
        put_cycle("CycleTimeSync1", mode.cycle_time_1, mode.cycle_factor_1);
        add(node, "ShiftTimeSync1", std::to_string(mode.shift_time_1));
    }

    void put_object(pugi::xml_node types, pugi::xml_node objects, const object& what) {
        const auto bits = what.code == object_code::variable ? what.entries.at(0).bit_size : record_bits(what);
        const auto type = what.code == object_code::variable ? what.entries.at(0).type : type_name(what);
        if (what.code == object_code::variable) {
            put_base_type(types, what.entries.at(0));
        } else {
            put_record_type(types, what, bits);
        }

        const auto node = add(objects, "Object");
        add(node, "Index", hex_number(what.index, 4));
        add_name(node, what.name);
        add(node, "Type", type);
        add(node, "BitSize", number(bits));
        const auto info = add(node, "Info");
        for (const auto& each : what.entries) {
            auto to = info;
            if (what.code != object_code::variable) {
                const auto item = add(info, "SubItem");
                add(item, "Name", each.name);
                to = add(item, "Info"); // also if empty: some readers stop without it
            }
            if (!each.default_data.empty()) add(to, "DefaultData", hex_bytes(each.default_data));
        }
        const auto flags = add(node, "Flags");
        const auto any = [&](bool entry::* can) {
            return std::ranges::any_of(what.entries, [&](const entry& e) { return e.*can; });
        };
        add(flags, "Access", access(any(&entry::readable), any(&entry::writable)));
        add(flags, "Category", what.mandatory ? "m" : "o");
        if (what.properties.empty()) return;
        const auto properties = add(node, "Properties");
        for (const auto& each : what.properties) put_property(properties, each);
    }

    static void put_property(pugi::xml_node parent, const property& what) {
        const auto node = add(parent, "Property");
        add(node, "Name", what.name);
        add(node, "Value", what.value);
    }

    void put_base_type(pugi::xml_node types, const entry& of) {
        if (!known_types_.insert(of.type).second) return;
        const auto node = add(types, "DataType");
        add(node, "Name", of.type);
        add(node, "BitSize", number(of.bit_size));
    }

    void put_record_type(pugi::xml_node types, const object& what, std::uint32_t bits) {
        for (const auto& each : what.entries) put_base_type(types, each);
        const bool array = what.code == object_code::array;
        if (array && what.entries.size() > 1) {
            const auto& element = what.entries[1];
            const auto node = add(types, "DataType");
            add(node, "Name", type_name(what) + "ARR");
            add(node, "BaseType", element.type);
            add(node, "BitSize", number(bits - 16));
            const auto info = add(node, "ArrayInfo");
            add(info, "LBound", "1");
            add(info, "Elements", number(what.entries.size() - 1));
        }
        const auto node = add(types, "DataType");
        add(node, "Name", type_name(what));
        add(node, "BitSize", number(bits));
        std::uint32_t offset = 0;
        for (const auto& each : what.entries) {
            const auto item = add(node, "SubItem");
            const bool elements = array && each.subindex != 0;
            const auto size = elements ? bits - 16 : each.bit_size;
            if (!elements) add(item, "SubIdx", number(each.subindex));
            add(item, "Name", elements ? "Elements" : each.name);
            add(item, "Type", elements ? type_name(what) + "ARR" : each.type);
            add(item, "BitSize", number(size));
            add(item, "BitOffs", number(offset));
            add(add(item, "Flags"), "Access", access(each.readable, each.writable));
            for (const auto& extra : each.properties) put_property(item, extra);
            if (elements) break; // one item for all elements
            offset = each.subindex == 0 ? 16 : offset + size;
        }
    }

    // Subindex 0 has 16 bits before the others, as in a complete access.
    static std::uint32_t record_bits(const object& what) {
        std::uint32_t bits = 16;
        for (const auto& each : what.entries)
            if (each.subindex != 0) bits += each.bit_size;
        return bits;
    }
    static std::string type_name(const object& what) { return "DT" + hex_number(what.index, 4).substr(2); }
    static std::string access(bool readable, bool writable) { return !writable ? "ro" : readable ? "rw" : "wo"; }

    const device& device_;
    std::set<std::string> known_types_{};
};

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL std::string write_esi(const device& what) {
    pugi::xml_document document;
    detail::esi_writer{what}.write(document);
    std::ostringstream text;
    document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
    return text.str();
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi
