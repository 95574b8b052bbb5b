// The reader of ESI files.
#pragma once
#include <jauscat/esi/read_esi.hpp>
#include <jauscat/esi/text_values.hpp>
#include <jauscat/esi/xml_source.hpp>

#include <pugixml.hpp>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace jauscat::esi {

namespace detail {

class esi_reader : xml_source {
  public:
    using xml_source::xml_source;

    device read(const device_choice& choice) {
        const auto root = load();
        const auto vendor = child(root, "Vendor");
        const auto descriptions = child(root, "Descriptions");
        const auto devices = child(descriptions, "Devices");
        const auto node = find_device(devices, choice);

        device made{};
        made.vendor_id = number(child(vendor, "Id"));
        made.vendor_name = text(child(vendor, "Name"));
        made.group_type = text(child(node, "GroupType"));
        for (const auto group : child(descriptions, "Groups").children("Group"))
            if (text(child(group, "Type")) == made.group_type) made.group_name = text(child(group, "Name"));
        if (made.group_name.empty())
            fail(errc::unknown_reference, child(node, "GroupType"),
                 "no <Group> has the type \"" + made.group_type + '"');
        made.physics = attribute(node, "Physics").value();
        const auto type = child(node, "Type");
        made.type = text(type);
        made.product_code = number(type, "ProductCode");
        made.revision = number(type, "RevisionNo");
        if (type.attribute("SerialNo")) made.serial = number(type, "SerialNo");
        made.name = text(child(node, "Name"));
        const auto profile = node.child("Profile");
        if (const auto no = profile.child("ProfileNo")) made.profile = static_cast<std::uint16_t>(number(no, 0xFFFF));
        if (const auto dictionary = profile.child("Dictionary")) read_objects(made, dictionary);
        made.has_coe = node.child("Mailbox").child("CoE") || !made.objects.empty();
        for (const auto each : node.children("Fmmu")) made.fmmus.emplace_back(each.text().get());
        for (const auto each : node.children("Sm")) {
            if (made.sync_managers.size() == max_sync_managers)
                fail(errc::unexpected, each,
                     "expected at most " + std::to_string(max_sync_managers) + " <Sm>: a slave has no more");
            made.sync_managers.push_back(read_sync_manager(each));
        }
        for (const auto each : node.children("RxPdo")) made.rx_pdos.push_back(read_pdo(each));
        for (const auto each : node.children("TxPdo")) made.tx_pdos.push_back(read_pdo(each));
        if (made.has_coe) made.coe = read_coe(child(child(node, "Mailbox"), "CoE"));
        for (const auto each : node.child("Dc").children("OpMode")) made.clock_modes.push_back(read_clock_mode(each));
        made.eeprom = read_eeprom(child(node, "Eeprom"));
        return made;
    }

  private:
    static constexpr std::size_t max_sync_managers = 16; // registers 0800h to 087Fh
    static constexpr std::size_t max_pdo_entries = 255;  // subindices of its mapping object

    pugi::xml_node find_device(pugi::xml_node devices, const device_choice& choice) const {
        const bool is_chosen = choice.product || choice.revision;
        pugi::xml_node found = is_chosen ? pugi::xml_node{} : child(devices, "Device");
        for (const auto each : devices.children("Device")) {
            if (each == found || (is_chosen && !is_choice(each.child("Type"), choice))) continue;
            if (found)
                fail(errc::unexpected, each,
                     is_chosen ? "a second device of this choice, expected one"
                               : "a second device, expected one in a file");
            found = each;
        }
        if (!found) fail(errc::missing, devices, "no <Device> has the product code and the revision that were chosen");
        return found;
    }
    bool is_choice(pugi::xml_node type, const device_choice& choice) const {
        const auto is_value = [&](const auto& wanted, const char* name) {
            return !wanted || (type.attribute(name) && number(type, name) == *wanted);
        };
        return is_value(choice.product, "ProductCode") && is_value(choice.revision, "RevisionNo");
    }

    void read_objects(device& made, pugi::xml_node dictionary) {
        types_ = child(dictionary, "DataTypes");
        for (const auto each : child(dictionary, "Objects").children("Object"))
            made.objects.push_back(read_object(each));
        check_indices(dictionary, made.objects);
    }

    clock_mode read_clock_mode(pugi::xml_node node) const {
        clock_mode made{.name = text(child(node, "Name")),
                        .description = node.child("Desc").text().get(),
                        .assign_activate = static_cast<std::uint16_t>(number(child(node, "AssignActivate"), 0xFFFF))};
        const auto read_sync = [&](const char* cycle_name, const char* shift_name, std::uint32_t& cycle,
                                   std::int16_t& factor, std::int32_t& shift) {
            if (const auto found = node.child(cycle_name)) {
                cycle = number(found);
                if (const auto by = found.attribute("Factor"))
                    factor = integer_in<std::int16_t>(found, "Factor=", by.value());
            }
            if (const auto found = node.child(shift_name))
                shift = integer_in<std::int32_t>(found, "", found.text().get());
        };
        read_sync("CycleTimeSync0", "ShiftTimeSync0", made.cycle_time_0, made.cycle_factor_0, made.shift_time_0);
        read_sync("CycleTimeSync1", "ShiftTimeSync1", made.cycle_time_1, made.cycle_factor_1, made.shift_time_1);
        return made;
    }

    sync_manager read_sync_manager(pugi::xml_node node) const {
        const auto use = parse_sync_manager_use(node.text().get());
        if (!use)
            fail(errc::invalid_value, node,
                 '"' + std::string{node.text().get()} + "\", expected MBoxOut, MBoxIn, Outputs or Inputs");
        const auto size = [&](const char* name) {
            return static_cast<std::uint16_t>(node.attribute(name) ? number(node, name, 0xFFFF) : 0);
        };
        return {.use = *use,
                .start = static_cast<std::uint16_t>(number(node, "StartAddress", 0xFFFF)),
                .default_size = size("DefaultSize"),
                .min_size = size("MinSize"),
                .max_size = size("MaxSize"),
                .control = static_cast<std::uint8_t>(number(node, "ControlByte", 0xFF)),
                .enabled = (number(node, "Enable", 0xFF) & 1) != 0};
    }

    pdo read_pdo(pugi::xml_node node) const {
        const auto is_set = [&](const char* name) { return node.attribute(name) && boolean(node, name); };
        pdo made{.index = static_cast<std::uint16_t>(number(child(node, "Index"), 0xFFFF)),
                 .name = text(child(node, "Name")),
                 .sync_manager = node.attribute("Sm")
                                     ? static_cast<std::uint8_t>(number(node, "Sm", max_sync_managers - 1))
                                     : not_assigned,
                 .fixed = is_set("Fixed"),
                 .mandatory = is_set("Mandatory")};
        for (const auto each : node.children("Entry")) {
            if (made.entries.size() == max_pdo_entries)
                fail(errc::unexpected, each,
                     "expected at most " + std::to_string(max_pdo_entries) + " <Entry>: a PDO has no more");
            pdo_entry entry{.index = static_cast<std::uint16_t>(number(child(each, "Index"), 0xFFFF)),
                            .bits = static_cast<std::uint8_t>(number(child(each, "BitLen"), 0xFF))};
            if (entry.index != 0) {
                entry.subindex = static_cast<std::uint8_t>(number(child(each, "SubIndex"), 0xFF));
                entry.name = each.child("Name").text().get();
                entry.type = each.child("DataType").text().get();
            }
            made.entries.push_back(std::move(entry));
        }
        return made;
    }

    coe_features read_coe(pugi::xml_node node) const {
        return {.sdo_information = boolean(node, "SdoInfo"),
                .pdo_assign = boolean(node, "PdoAssign"),
                .pdo_configuration = boolean(node, "PdoConfig"),
                .complete_access = boolean(node, "CompleteAccess"),
                .segmented_sdo = boolean(node, "SegmentedSdo")};
    }

    esi::eeprom read_eeprom(pugi::xml_node node) const {
        esi::eeprom made{.byte_size = number(child(node, "ByteSize")), .config_data = bytes(child(node, "ConfigData"))};
        if (const auto bootstrap = node.child("BootStrap")) made.bootstrap = bytes(bootstrap);
        return made;
    }

    object read_object(pugi::xml_node node) const {
        object made{.index = static_cast<std::uint16_t>(number(child(node, "Index"), 0xFFFF)),
                    .name = text(child(node, "Name")),
                    .mandatory = node.child("Flags").child("Category").text().get() == std::string_view{"m"}};
        made.properties = read_properties(node.child("Properties"));
        const auto type = base_of(text(child(node, "Type")));
        const auto info = node.child("Info");
        if (const auto bits = bits_of(type)) {
            made.code = object_code::variable;
            made.entries.push_back({.name = made.name, .type = type, .bit_size = *bits});
            set_access(made.entries.front(), node);
            set_default(made.entries.front(), info);
        } else {
            read_items(made, named_type(node, type));
            name_items(made, info);
        }
        std::uint32_t bits = made.code == object_code::variable ? 0 : 16;
        for (const auto& each : made.entries)
            if (made.code == object_code::variable || each.subindex != 0) bits += each.bit_size;
        // The entries of a record may be aligned.
        const auto said = child(node, "BitSize");
        if (made.code == object_code::record ? number(said) < bits : number(said) != bits)
            fail(errc::inconsistent, said, "expected " + std::to_string(bits) + ", the size of " + type);
        return made;
    }

    std::vector<property> read_properties(pugi::xml_node parent) const {
        std::vector<property> made;
        for (const auto each : parent.children("Property"))
            made.push_back({text(child(each, "Name")), each.child("Value").text().get()});
        return made;
    }

    pugi::xml_node named_type(pugi::xml_node user, const std::string& name) const {
        for (const auto each : types_.children("DataType"))
            if (each.child("Name").text().get() == name) return each;
        fail(errc::unknown_reference, user,
             "its type \"" + name + "\" is no base type; expected a <DataType> of that name in <DataTypes>");
    }

    // The base type of an enumeration, or of another name of a base type; other types as they are.
    std::string base_of(std::string name) const {
        for (int depth = 0; depth != 8 && !bits_of(name); ++depth) {
            const auto type =
                types_.find_child([&](pugi::xml_node each) { return each.child("Name").text().get() == name; });
            if (!type.child("BaseType") || type.child("ArrayInfo") || type.child("SubItem")) break;
            name = type.child("BaseType").text().get();
        }
        return name;
    }

    void read_items(object& made, pugi::xml_node type) const {
        made.code = object_code::record;
        for (const auto item : type.children("SubItem")) {
            if (made.code == object_code::array)
                fail(errc::unexpected, item, "an item behind the elements of an array, expected none there");
            entry each{.name = text(child(item, "Name")), .type = text(child(item, "Type"))};
            each.properties = read_properties(item);
            set_access(each, item);
            if (item.child("SubIdx")) {
                each.subindex = static_cast<std::uint8_t>(number(item.child("SubIdx"), 0xFF));
                if (!made.entries.empty() && each.subindex <= made.entries.back().subindex)
                    fail(errc::inconsistent, item.child("SubIdx"), "expected ascending subindices");
                append(made, each, item);
                continue;
            }
            if (made.entries.size() > 1)
                fail(errc::unexpected, item,
                     "the elements of an array behind a record's items, expected them behind subindex 0 alone");
            made.code = object_code::array;
            const auto array = named_type(item, each.type);
            const auto bounds = child(array, "ArrayInfo");
            each.type = text(child(array, "BaseType"));
            const auto first = number(child(bounds, "LBound"), 1), count = number(child(bounds, "Elements"), 254);
            if (first != 1) fail(errc::invalid_value, child(bounds, "LBound"), "expected 1, the first subindex");
            for (std::uint32_t i = 0; i != count; ++i) {
                each.subindex = static_cast<std::uint8_t>(i + 1);
                append(made, each, item);
            }
        }
        if (made.entries.empty() || made.entries.front().subindex != 0 || made.entries.front().type != "USINT")
            fail(errc::missing, type, "expected a <SubItem> with <SubIdx> 0 of type USINT first");
    }

    void append(object& made, entry each, pugi::xml_node item) const {
        each.type = base_of(std::move(each.type));
        const auto bits = bits_of(each.type);
        if (!bits)
            fail(errc::unknown_reference, item,
                 "its type \"" + each.type + "\" is unknown; expected a base type such as OCTET_STRING(28)");
        each.bit_size = *bits;
        made.entries.push_back(std::move(each));
    }

    // The object has the names and the default values of its entries, in the order of its type.
    void name_items(object& made, pugi::xml_node info) const {
        auto each = made.entries.begin();
        for (const auto item : info.children("SubItem")) {
            if (each == made.entries.end()) fail(errc::unexpected, item, "more items than the object's type has");
            each->name = text(child(item, "Name"));
            set_default(*each++, item.child("Info"));
        }
        if (each != made.entries.begin() && each != made.entries.end())
            fail(errc::inconsistent, info,
                 "expected " + std::to_string(made.entries.size()) + " <SubItem>, one for each of the object's type");
    }

    void set_access(entry& made, pugi::xml_node node) const {
        const std::string_view access = node.child("Flags").child("Access").text().get();
        if (access != "ro" && access != "wo" && access != "rw" && !access.empty())
            fail(errc::invalid_value, node, "access \"" + std::string{access} + "\", expected ro, wo or rw");
        made.readable = access != "wo"; // ro by default
        made.writable = access == "wo" || access == "rw";
    }

    void set_default(entry& made, pugi::xml_node info) const {
        if (const auto value = info.child("DefaultValue")) {
            auto read = parse_value(value.text().get(), made.type);
            if (!read)
                fail(errc::invalid_value, value,
                     '"' + std::string{value.text().get()} + "\", expected a number that " + made.type +
                         " holds, or <DefaultData> in its place");
            made.default_data = std::move(*read);
            return;
        }
        auto data = info.child("DefaultData");
        if (data) {
            made.default_data = bytes(data);
        } else if ((data = info.child("DefaultString"))) {
            for (const char c : std::string_view{data.text().get()})
                made.default_data.push_back(static_cast<std::byte>(c));
        }
        if (made.default_data.size() > (made.bit_size + 7) / 8)
            fail(errc::inconsistent, data,
                 std::to_string(made.default_data.size()) + " bytes, expected at most " +
                     std::to_string((made.bit_size + 7) / 8));
    }

    void check_indices(pugi::xml_node dictionary, const std::vector<object>& objects) const {
        std::set<std::uint16_t> seen;
        for (const auto& each : objects)
            if (!seen.insert(each.index).second)
                fail(errc::duplicate, dictionary,
                     "object " + hex_number(each.index, 4) + " is there twice, expected each once");
    }

    pugi::xml_node types_{};
};

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL result<device, error> parse_esi(std::string_view text, std::string source, const device_choice& choice) {
    return detail::caught([&] { return detail::esi_reader{text, std::move(source)}.read(choice); });
}

JAUSCAT_DECL result<device, error> read_esi(const std::filesystem::path& path, const device_choice& choice) {
    return detail::caught([&] { return detail::esi_reader{detail::text_of(path), path.string()}.read(choice); });
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi
