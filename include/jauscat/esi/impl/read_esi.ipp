// The reader of ESI files.
#pragma once
#include <jauscat/esi/read_esi.hpp>
#include <jauscat/esi/text_values.hpp>
#include <jauscat/esi/xml_source.hpp>
#include <jauscat/ethercat/slave/pdo_entry.hpp>

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <set>
#include <utility>

namespace jauscat::esi {

namespace detail {

/// Reads a part of a file, or tells in `slips` why it is left out.
template <class Read> void read_or_slip(std::vector<error>& slips, Read&& read) {
    try {
        read();
    } catch (const esi_error& thrown) {
        slips.push_back(thrown.error());
    }
}

/// The dictionary of a device: each object with the entries of its type.
class dictionary_reader {
  public:
    dictionary_reader(const xml_source& source, pugi::xml_node dictionary) : source_{source} {
        for (const auto each : dictionary.child("DataTypes").children("DataType"))
            types_.emplace(xml_source::text(each.child("Name")), each);
    }

    object read(pugi::xml_node node) const {
        object made{.index = static_cast<std::uint16_t>(source_.number(source_.child(node, "Index"), 0xFFFF)),
                    .name = xml_source::name_in(node),
                    .mandatory = xml_source::text(node.child("Flags").child("Category")) == "m"};
        made.properties = properties_in(node.child("Properties"));
        const auto type = base_of(source_.needed_text(source_.child(node, "Type")));
        const auto info = node.child("Info");
        if (const auto bits = size_of(type)) {
            made.code = object_code::variable;
            made.entries.push_back({.name = made.name, .type = type, .bit_size = *bits});
            set_access(made.entries.front(), node);
            set_default(made.entries.front(), info);
        } else {
            read_items(made, type_of(node, type));
            name_items(made, info);
        }
        check_size(made, node.child("BitSize"), type);
        return made;
    }

  private:
    void check_size(const object& made, pugi::xml_node said, const std::string& type) const {
        if (!said) return;
        std::uint32_t bits = made.code == object_code::variable ? 0 : 16;
        for (const auto& each : made.entries)
            if (made.code == object_code::variable || each.subindex != 0) bits += each.bit_size;
        // The entries of an array and of a record may be aligned.
        const auto size = source_.number(said);
        if (made.code == object_code::variable ? size != bits : size < bits)
            source_.fail(errc::inconsistent, said, "expected " + std::to_string(bits) + ", the size of " + type);
    }

    std::vector<property> properties_in(pugi::xml_node parent) const {
        std::vector<property> made;
        for (const auto each : parent.children("Property"))
            made.push_back({xml_source::text(each.child("Name")), each.child("Value").text().get()});
        return made;
    }

    pugi::xml_node type_of(pugi::xml_node user, const std::string& name) const {
        if (const auto found = types_.find(name); found != types_.end()) return found->second;
        source_.fail(errc::unknown_reference, user,
                     "its type \"" + name + "\" is no base type; expected a <DataType> of that name in <DataTypes>");
    }

    // The base type of an enumeration, or of another name of a base type; other types as they are.
    std::string base_of(std::string name) const {
        for (int depth = 0; depth != 8 && !bits_of(name); ++depth) {
            const auto found = types_.find(name);
            if (found == types_.end()) break;
            const auto type = found->second;
            if (!type.child("BaseType") || type.child("ArrayInfo") || type.child("SubItem")) break;
            name = xml_source::text(type.child("BaseType"));
        }
        return name;
    }

    // Of a base type, or of another one that the file declares with its size alone.
    std::optional<std::uint32_t> size_of(const std::string& type) const {
        if (const auto bits = bits_of(type)) return bits;
        const auto found = types_.find(type);
        if (found == types_.end()) return std::nullopt;
        const auto declared = found->second;
        if (declared.child("SubItem") || declared.child("ArrayInfo") || declared.child("BaseType")) return std::nullopt;
        return source_.number_of(declared, "BitSize");
    }
    // The same; an array in one entry has the size of all of it.
    std::uint32_t entry_size(pugi::xml_node item, const std::string& type) const {
        if (const auto bits = size_of(type)) return *bits;
        if (const auto found = types_.find(type); found != types_.end() && found->second.child("ArrayInfo"))
            if (const auto bits = source_.number_of(found->second, "BitSize")) return *bits;
        source_.fail(errc::unknown_reference, item,
                     "its type \"" + type + "\" is unknown; expected a base type such as OCTET_STRING(28)");
    }

    void read_items(object& made, pugi::xml_node type) const {
        made.code = object_code::record;
        for (const auto item : type.children("SubItem")) {
            if (made.code == object_code::array)
                source_.fail(errc::unexpected, item, "an item behind the elements of an array, expected none there");
            entry each{.name = xml_source::name_in(item), .type = source_.needed_text(source_.child(item, "Type"))};
            each.properties = properties_in(item);
            set_access(each, item);
            if (!xml_source::text(item.child("SubIdx")).empty()) {
                each.subindex = static_cast<std::uint8_t>(source_.number(item.child("SubIdx"), 0xFF));
                if (!made.entries.empty() && each.subindex <= made.entries.back().subindex)
                    source_.fail(errc::inconsistent, item.child("SubIdx"), "expected ascending subindices");
                append(made, each, item);
                continue;
            }
            if (made.entries.size() > 1)
                source_.fail(errc::unexpected, item,
                             "the elements of an array behind a record's items, expected them behind subindex 0 alone");
            made.code = object_code::array;
            read_elements(made, each, item);
        }
        if (made.entries.empty() || made.entries.front().subindex != 0 || made.entries.front().bit_size > 16)
            source_.fail(errc::missing, type, "expected a <SubItem> with <SubIdx> 0 of type USINT first");
    }

    void read_elements(object& made, entry each, pugi::xml_node item) const {
        const auto array = type_of(item, each.type);
        const auto bounds = source_.child(array, "ArrayInfo");
        each.type = source_.needed_text(source_.child(array, "BaseType"));
        const auto first = source_.number(source_.child(bounds, "LBound"), 1);
        const auto count = source_.number(source_.child(bounds, "Elements"), 254);
        if (first != 1) source_.fail(errc::invalid_value, bounds.child("LBound"), "expected 1, the first subindex");
        for (std::uint32_t i = 0; i != count; ++i) {
            each.subindex = static_cast<std::uint8_t>(i + 1);
            append(made, each, item);
        }
    }

    void append(object& made, entry each, pugi::xml_node item) const {
        each.type = base_of(std::move(each.type));
        each.bit_size = entry_size(item, each.type);
        made.entries.push_back(std::move(each));
    }

    // Items of an object belong to those of its type by name. An array's elements have one name in the type, and each
    // their own in the object: these are taken in order. So are all where the object has an item for each of the type.
    void name_items(object& made, pugi::xml_node info) const {
        const auto items = info.children("SubItem");
        const bool are_all = std::distance(items.begin(), items.end()) == std::ssize(made.entries);
        std::vector<bool> is_taken(made.entries.size());
        std::size_t next = 0;
        for (const auto item : items) {
            auto name = xml_source::name_in(item);
            std::size_t at = next;
            for (std::size_t i = 0; i != made.entries.size(); ++i)
                if (!is_taken[i] && made.entries[i].name == name) {
                    at = i;
                    break;
                }
            const bool is_named = at < made.entries.size() && made.entries[at].name == name;
            if (!is_named && !are_all && made.code == object_code::array) at = std::max<std::size_t>(at, 1);
            if (at >= made.entries.size() || is_taken[at])
                source_.fail(errc::unexpected, item, "more items than the object's type has");
            if (!is_named && !are_all && made.code != object_code::array)
                source_.fail(errc::unknown_reference, item, "the object's type has no item \"" + name + '"');
            is_taken[at] = true;
            next = at + 1;
            if (!name.empty()) made.entries[at].name = std::move(name);
            set_default(made.entries[at], item.child("Info"));
        }
    }

    // As the standard writes it, in any case, and as CANopen does.
    void set_access(entry& made, pugi::xml_node node) const {
        auto access = xml_source::text(node.child("Flags").child("Access"));
        std::ranges::transform(access, access.begin(),
                               [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
        static constexpr std::array<std::pair<std::string_view, std::pair<bool, bool>>, 7> known{
            {{"", {true, false}},
             {"ro", {true, false}},
             {"wo", {false, true}},
             {"rw", {true, true}},
             {"rwr", {true, true}},
             {"rww", {true, true}},
             {"const", {true, false}}}};
        const auto* const found = std::ranges::find(known, access, [](const auto& each) { return each.first; });
        if (found == known.end())
            source_.fail(errc::invalid_value, node, "access \"" + access + "\", expected ro, wo or rw");
        made.readable = found->second.first;
        made.writable = found->second.second;
    }

    void set_default(entry& made, pugi::xml_node info) const {
        if (const auto value = info.child("DefaultValue"); value && !is_string_type(made.type)) {
            if (xml_source::text(value).empty()) return;
            auto read = parse_value(value.text().get(), made.type);
            if (!read)
                source_.fail(errc::invalid_value, value,
                             '"' + std::string{value.text().get()} + "\", expected a number that " + made.type +
                                 " holds, or <DefaultData> in its place");
            made.default_data = std::move(*read);
            return;
        }
        auto data = info.child("DefaultData");
        if (data) {
            made.default_data = source_.bytes(data);
        } else {
            for (const auto* const name : {"DefaultString", "DefaultValue"})
                if (!data) data = info.child(name);
            for (const char c : std::string_view{data.text().get()})
                made.default_data.push_back(static_cast<std::byte>(c));
        }
        if (made.default_data.size() > (made.bit_size + 7) / 8)
            source_.fail(errc::inconsistent, data,
                         std::to_string(made.default_data.size()) + " bytes, expected at most " +
                             std::to_string((made.bit_size + 7) / 8));
    }

    const xml_source& source_;
    std::map<std::string, pugi::xml_node, std::less<>> types_{};
};

class esi_reader : xml_source {
  public:
    esi_reader(std::string_view text, std::string source) : xml_source{text, std::move(source)} {
        load();
        for (const auto each : devices()) nodes_.push_back(each);
    }

    // A number that cannot be read is 0 here, and an error of its device alone.
    std::vector<device_summary> list() const {
        std::vector<device_summary> made;
        for (const auto each : nodes_) {
            const auto type = each.child("Type");
            const auto number = [&](const char* name) {
                return parse_number_liberally(type.attribute(name).value()).value_or(0);
            };
            made.push_back({.product_code = number("ProductCode"),
                            .revision = number("RevisionNo"),
                            .type = text(type),
                            .name = name_in(each),
                            .line = line_of(each)});
        }
        return made;
    }

    device read(const std::vector<device_summary>& all, const device_choice& choice) const {
        const auto node = nodes_[chosen(all, choice)];
        const auto vendor = child(root(), "Vendor");
        device made{};
        made.vendor_id = number(child(vendor, "Id"));
        made.vendor_name = name_in(vendor);
        read_group(made, node.child("GroupType"));
        made.physics = node.attribute("Physics").value();
        const auto type = node.child("Type");
        made.type = text(type);
        made.product_code = number(type, "ProductCode");
        made.revision = number(type, "RevisionNo");
        made.serial = number(type, "SerialNo");
        made.name = name_in(node);
        read_profiles(made, node);
        const auto mailbox = node.child("Mailbox");
        const auto coe = mailbox.child("CoE");
        made.has_coe = coe || !made.objects.empty();
        if (made.has_coe) made.coe = read_coe(coe);
        for (const auto* const name : {"AoE", "EoE", "FoE", "SoE", "VoE"})
            if (mailbox.child(name)) made.protocols.emplace_back(name);
        for (const auto each : coe.children("InitCmd"))
            read_or_slip(made.slips, [&] { made.start_up.push_back(read_start_up(each)); });
        for (const auto each : node.children("Fmmu")) made.fmmus.push_back(text(each));
        read_sync_managers(made, node);
        read_pdos(made.rx_pdos, made.slips, node, "RxPdo");
        read_pdos(made.tx_pdos, made.slips, node, "TxPdo");
        for (const auto each : node.child("Dc").children("OpMode"))
            read_or_slip(made.slips, [&] { made.clock_modes.push_back(read_clock_mode(each)); });
        for (const auto each : node.child("Slots").children("Slot"))
            read_or_slip(made.slips, [&] { made.slots.push_back(read_slot(each)); });
        read_or_slip(made.slips, [&] { made.timeouts = read_timeouts(node.child("Info")); });
        made.eeprom = read_eeprom(node.child("Eeprom"));
        return made;
    }

    std::vector<module_description> modules() const {
        std::vector<module_description> made;
        for (const auto node : root().child("Descriptions").child("Modules").children("Module")) {
            const auto type = node.child("Type");
            auto& each = made.emplace_back(module_description{
                .module_class = type.attribute("ModuleClass").value(), .type = text(type), .name = name_in(node)});
            read_or_slip(each.slips, [&] { each.ident = number(type, "ModuleIdent"); });
            read_pdos(each.rx_pdos, each.slips, node, "RxPdo");
            read_pdos(each.tx_pdos, each.slips, node, "TxPdo");
        }
        return made;
    }

  private:
    static constexpr std::size_t max_sync_managers = 16; // registers 0800h to 087Fh
    static constexpr std::size_t max_pdo_entries = 255;  // subindices of its mapping object

    pugi::xml_object_range<pugi::xml_named_node_iterator> devices() const {
        return root().child("Descriptions").child("Devices").children("Device");
    }

    // The place of the device in the file.
    std::size_t chosen(const std::vector<device_summary>& all, const device_choice& choice) const {
        std::vector<std::size_t> fitting;
        for (std::size_t i = 0; i != all.size(); ++i)
            if ((!choice.number || *choice.number == i) && (!choice.product || *choice.product == all[i].product_code))
                fitting.push_back(i);
        const auto product = [&](std::size_t i) { return all[i].product_code; };
        const auto revision = [&](std::size_t i) { return all[i].revision; };
        auto left = fitting;
        if (choice.revision) {
            std::erase_if(left, [&](std::size_t i) { return revision(i) != *choice.revision; });
            // An older description holds for newer revisions of the same product.
            if (left.empty() && !fitting.empty() &&
                std::ranges::count(fitting, product(fitting[0]), product) == std::ssize(fitting)) {
                std::ranges::copy_if(fitting, std::back_inserter(left),
                                     [&](std::size_t i) { return revision(i) < *choice.revision; });
                if (!left.empty()) {
                    const auto newest = revision(*std::ranges::max_element(left, {}, revision));
                    std::erase_if(left, [&](std::size_t i) { return revision(i) != newest; });
                }
            }
        }
        const auto where = root().child("Descriptions").child("Devices");
        if (all.empty()) fail(errc::missing, where ? where : root(), "expected a <Device> in it");
        if (left.empty())
            fail(errc::missing, where,
                 "no <Device> is " + text_of(choice) +
                     (fitting.empty() || !choice.revision ? "" : " or older; there are" + list_of(all, fitting)));
        if (left.size() != 1)
            fail(errc::unexpected, nodes_[left[1]],
                 "a second device" +
                     (choice.number || choice.product || choice.revision ? " that is " + text_of(choice)
                                                                         : std::string{" where none is chosen"}) +
                     ", expected one; there are" + list_of(all, left));
        return left.front();
    }
    static std::string text_of(const device_choice& choice) {
        std::string made;
        const auto add = [&](const std::string& part) { made += (made.empty() ? "" : ", ") + part; };
        if (choice.number) add("number " + std::to_string(*choice.number));
        if (choice.product) add("product " + hex_number(*choice.product, 8));
        if (choice.revision) add("revision " + hex_number(*choice.revision, 8));
        return made;
    }
    static std::string list_of(const std::vector<device_summary>& all, const std::vector<std::size_t>& which) {
        constexpr std::size_t most = 8;
        std::string made;
        for (std::size_t i = 0; i != std::min(which.size(), most); ++i) {
            const auto& each = all[which[i]];
            made += (i != 0              ? ", "
                     : which.size() == 1 ? " number "
                                         : " numbers ") +
                    std::to_string(which[i]) + " (" + each.type + ", product " + hex_number(each.product_code, 8) +
                    ", revision " + hex_number(each.revision, 8) + ')';
        }
        return made + (which.size() > most ? " and " + std::to_string(which.size() - most) + " more" : "");
    }

    void read_group(device& made, pugi::xml_node type) const {
        made.group_type = made.group_name = text(type);
        if (!type) return;
        for (const auto group : root().child("Descriptions").child("Groups").children("Group"))
            if (text(group.child("Type")) == made.group_type) {
                if (auto name = name_in(group); !name.empty()) made.group_name = std::move(name);
                return;
            }
        read_or_slip(made.slips, [&] {
            fail(errc::unknown_reference, type, "no <Group> has the type \"" + made.group_type + '"');
        });
    }

    void read_profiles(device& made, pugi::xml_node node) const {
        for (const auto profile : node.children("Profile")) {
            for (const auto parent : {profile, profile.child("ChannelInfo")})
                if (made.profile == 0)
                    made.profile = static_cast<std::uint16_t>(number_of(parent, "ProfileNo", 0xFFFF).value_or(0));
            if (const auto other = profile.child("DictionaryFile"))
                read_or_slip(made.slips, [&] {
                    fail(errc::unknown_reference, other, "the objects are in the file " + text(other));
                });
            const auto dictionary = profile.child("Dictionary");
            const dictionary_reader reader{*this, dictionary};
            std::set<std::uint16_t> seen;
            for (const auto each : dictionary.child("Objects").children("Object"))
                read_or_slip(made.slips, [&] {
                    auto read = reader.read(each);
                    if (!seen.insert(read.index).second)
                        fail(errc::duplicate, each,
                             "object " + hex_number(read.index, 4) + " is there twice, expected each once");
                    made.objects.push_back(std::move(read));
                });
        }
    }

    void read_sync_managers(device& made, pugi::xml_node node) const {
        for (const auto each : node.children("Sm")) {
            if (made.sync_managers.size() == max_sync_managers)
                fail(errc::unexpected, each,
                     "expected at most " + std::to_string(max_sync_managers) + " <Sm>: a slave has no more");
            made.sync_managers.push_back(read_sync_manager(each, made.slips));
        }
    }
    sync_manager read_sync_manager(pugi::xml_node node, std::vector<error>& slips) const {
        using use = ethercat::sii_sync_manager_use;
        const auto size = [&](const char* name) { return static_cast<std::uint16_t>(number(node, name, 0xFFFF)); };
        sync_manager made{.start = size("StartAddress"),
                          .default_size = size("DefaultSize"),
                          .min_size = size("MinSize"),
                          .max_size = size("MaxSize"),
                          .control = static_cast<std::uint8_t>(number(node, "ControlByte", 0xFF)),
                          .enabled = !node.attribute("Enable") || is_enabled(node),
                          .is_virtual = boolean(node, "Virtual")};
        const auto name = text(node);
        if (const auto found = parse_sync_manager_use(name))
            made.use = *found;
        else if (!name.empty())
            read_or_slip(slips, [&] {
                fail(errc::invalid_value, node, '"' + name + "\", expected MBoxOut, MBoxIn, Outputs or Inputs");
            });
        if (!node.attribute("ControlByte"))
            made.control = made.use == use::mailbox_out  ? ethercat::manager_controls::mailbox_out
                           : made.use == use::mailbox_in ? ethercat::manager_controls::mailbox_in
                           : made.use == use::outputs    ? ethercat::manager_controls::outputs
                           : made.use == use::inputs     ? ethercat::manager_controls::inputs
                                                         : std::uint8_t{0};
        return made;
    }
    bool is_enabled(pugi::xml_node node) const {
        if (const auto said = parse_boolean(trimmed(node.attribute("Enable").value()))) return *said;
        return (number(node, "Enable", 0xFF) & 1) != 0;
    }

    void read_pdos(std::vector<pdo>& into, std::vector<error>& slips, pugi::xml_node parent, const char* name) const {
        for (const auto each : parent.children(name)) read_or_slip(slips, [&] { into.push_back(read_pdo(each)); });
    }
    pdo read_pdo(pugi::xml_node node) const {
        pdo made{.index = static_cast<std::uint16_t>(number(child(node, "Index"), 0xFFFF)),
                 .name = name_in(node),
                 .sync_manager = trimmed(node.attribute("Sm").value()).empty()
                                     ? not_assigned
                                     : static_cast<std::uint8_t>(number(node, "Sm", max_sync_managers - 1)),
                 .fixed = boolean(node, "Fixed"),
                 .mandatory = boolean(node, "Mandatory")};
        for (const auto each : node.children("Entry")) {
            if (made.entries.size() == max_pdo_entries)
                fail(errc::unexpected, each,
                     "expected at most " + std::to_string(max_pdo_entries) + " <Entry>: a PDO has no more");
            pdo_entry entry{.index = static_cast<std::uint16_t>(number(child(each, "Index"), 0xFFFF)),
                            .bits = static_cast<std::uint16_t>(number(child(each, "BitLen"), 0xFFFF))};
            if (entry.index != 0) {
                entry.subindex = static_cast<std::uint8_t>(number_of(each, "SubIndex", 0xFF).value_or(0));
                entry.name = name_in(each);
                entry.type = text(each.child("DataType"));
            }
            made.entries.push_back(std::move(entry));
        }
        return made;
    }

    clock_mode read_clock_mode(pugi::xml_node node) const {
        clock_mode made{.name = text(node.child("Name")),
                        .description = text(node.child("Desc")),
                        .assign_activate = static_cast<std::uint16_t>(number(child(node, "AssignActivate"), 0xFFFF))};
        const auto read_sync = [&](const char* cycle_name, const char* shift_name, std::uint32_t& cycle,
                                   std::int16_t& factor, std::int32_t& shift) {
            cycle = number_of(node, cycle_name).value_or(0);
            if (const auto by = node.child(cycle_name).attribute("Factor"))
                factor = integer_in<std::int16_t>(node.child(cycle_name), "Factor=", by.value());
            if (const auto found = node.child(shift_name); !text(found).empty())
                shift = integer_in<std::int32_t>(found, "", found.text().get());
        };
        read_sync("CycleTimeSync0", "ShiftTimeSync0", made.cycle_time_0, made.cycle_factor_0, made.shift_time_0);
        read_sync("CycleTimeSync1", "ShiftTimeSync1", made.cycle_time_1, made.cycle_factor_1, made.shift_time_1);
        return made;
    }

    coe_features read_coe(pugi::xml_node node) const {
        return {.sdo_information = boolean(node, "SdoInfo"),
                .pdo_assign = boolean(node, "PdoAssign"),
                .pdo_configuration = boolean(node, "PdoConfig"),
                .complete_access = boolean(node, "CompleteAccess"),
                .segmented_sdo = boolean(node, "SegmentedSdo")};
    }

    start_up_object read_start_up(pugi::xml_node node) const {
        start_up_object made{.index = static_cast<std::uint16_t>(number(child(node, "Index"), 0xFFFF)),
                             .subindex = static_cast<std::uint8_t>(number_of(node, "SubIndex", 0xFF).value_or(0)),
                             .data = bytes(child(node, "Data")),
                             .complete_access = boolean(node, "CompleteAccess"),
                             .comment = text(node.child("Comment"))};
        for (const auto each : node.children("Transition")) made.transitions.push_back(text(each));
        return made;
    }

    slot read_slot(pugi::xml_node node) const {
        slot made{.name = name_in(node),
                  .min_instances = number(node, "MinInstances"),
                  .max_instances = number(node, "MaxInstances")};
        for (const auto each : node.children("ModuleIdent"))
            if (!text(each).empty()) made.module_idents.push_back(number(each));
        for (const auto each : node.children("ModuleClass"))
            made.module_classes.push_back(text(each.child("Class") ? each.child("Class") : each));
        return made;
    }

    esi::timeouts read_timeouts(pugi::xml_node info) const {
        const auto states = info.child("StateMachine").child("Timeout"),
                   mailbox = info.child("Mailbox").child("Timeout");
        const auto time = [&](pugi::xml_node parent, const char* name) -> std::optional<std::chrono::milliseconds> {
            const auto value = number_of(parent, name);
            if (!value) return std::nullopt;
            return std::chrono::milliseconds{*value};
        };
        return {.pre_op = time(states, "PreopTimeout"),
                .safe_op_op = time(states, "SafeopOpTimeout"),
                .back_to_init = time(states, "BackToInitTimeout"),
                .back_to_safe_op = time(states, "BackToSafeopTimeout"),
                .request = time(mailbox, "RequestTimeout"),
                .response = time(mailbox, "ResponseTimeout")};
    }

    esi::eeprom read_eeprom(pugi::xml_node node) const {
        return {.byte_size = number_of(node, "ByteSize").value_or(0),
                .config_data = bytes(node.child("ConfigData")),
                .bootstrap = bytes(node.child("BootStrap")),
                .image = bytes(node.child("Data"))};
    }

    std::vector<pugi::xml_node> nodes_{};
};

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL esi_file::esi_file(std::shared_ptr<const detail::esi_reader> reader)
    : reader_{std::move(reader)}, devices_{reader_->list()} {}

JAUSCAT_DECL result<esi_file, error> esi_file::parse(std::string_view text, std::string source) {
    return detail::caught([&] { return esi_file{std::make_shared<detail::esi_reader>(text, std::move(source))}; });
}

JAUSCAT_DECL result<esi_file, error> esi_file::open(const std::filesystem::path& path) {
    return detail::caught(
        [&] { return esi_file{std::make_shared<detail::esi_reader>(detail::text_of(path), path.string())}; });
}

JAUSCAT_DECL result<device, error> esi_file::read(const device_choice& choice) const {
    if (reader_ == nullptr) return error{.code = errc::missing, .message = "no file"};
    return detail::caught([&] { return reader_->read(devices_, choice); });
}

JAUSCAT_DECL std::vector<module_description> esi_file::modules() const {
    return reader_ == nullptr ? std::vector<module_description>{} : reader_->modules();
}

JAUSCAT_DECL result<device, error> parse_esi(std::string_view text, std::string source, const device_choice& choice) {
    const auto file = esi_file::parse(text, std::move(source));
    if (!file) return file.error();
    return file->read(choice);
}

JAUSCAT_DECL result<device, error> read_esi(const std::filesystem::path& path, const device_choice& choice) {
    const auto file = esi_file::open(path);
    if (!file) return file.error();
    return file->read(choice);
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi
