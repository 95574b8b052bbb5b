// The functions of emulated_device.
#pragma once
#include <jauscat/esi/emulated_device.hpp>
#include <jauscat/esi/text_values.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/schema/ethercat/sii.hpp>
#include <jauscat/wire/decode.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace jauscat::esi {
inline namespace JAUSCAT_WAY {

JAUSCAT_DECL emulated_device::emulated_device(device what) : device_{std::move(what)} {
    read_description();
    for (const auto& each : device_.objects)
        if (const auto* id = find(each.properties, property_names::component)) add_component(each, id->value);
    // If the description generated from the emulated slave differs, the device has a part that cannot be emulated.
    const auto emulated =
        make_device(description_, {device_.vendor_name, device_.group_type, device_.group_name, device_.type},
                    components_, device_.coe.segmented_sdo);
    const auto compare = [this](bool same, const char* element, const std::string& what_differs) {
        if (!same) fail(errc::cannot_be_emulated, element, what_differs + " cannot be emulated");
    };
    compare(emulated.physics == device_.physics, "Device", "its ports (Physics)");
    compare(emulated.profile == device_.profile, "ProfileNo", "a device profile");
    compare(emulated.rx_pdos == device_.rx_pdos, "RxPdo", "these outputs");
    compare(emulated.tx_pdos == device_.tx_pdos, "TxPdo", "these inputs");
    compare(emulated.fmmus == device_.fmmus, "Fmmu", "these FMMUs");
    compare(emulated.sync_managers == device_.sync_managers, "Sm", "these SyncManagers");
    compare(emulated.coe == device_.coe, "CoE", "these features");
    compare(emulated.clock_modes == device_.clock_modes, "Dc", "a cycle time of SYNC1");
    compare(emulated.eeprom == device_.eeprom, "Eeprom", "this memory");
    for (const auto& each : device_.objects)
        compare(std::ranges::find(emulated.objects, each) != emulated.objects.end(), "Object",
                hex_number(each.index, 4) + " is of a kind that");
    for (const auto& each : emulated.objects)
        compare(std::ranges::find(device_.objects, each) != device_.objects.end(), "Objects",
                "a device without " + hex_number(each.index, 4));
}

[[noreturn]] JAUSCAT_DECL void emulated_device::fail(errc code, const std::string& element,
                                                     const std::string& what) const {
    throw esi_error{
        {.code = code, .element = element, .message = '"' + device_.name + "\": <" + element + ">: " + what}};
}

JAUSCAT_DECL void emulated_device::read_description() {
    const auto count = device_.sync_managers.size();
    if (device_.has_coe && count != 2 && count != 4)
        fail(errc::cannot_be_emulated, "Sm", "expected two, the mailbox, or four, with outputs and inputs");
    if (!device_.has_coe && count != 0 && count != 2)
        fail(errc::cannot_be_emulated, "Sm", "expected two without a mailbox, outputs and inputs, or none");
    if (device_.eeprom.config_data.size() != ethercat::sii_configuration_checked)
        fail(errc::cannot_be_emulated, "ConfigData", "expected 14 bytes, words 0 to 6 of the SII");
    std::array<std::byte, wire::max_size<ethercat::sii_configuration>> words{};
    std::ranges::copy(device_.eeprom.config_data, words.begin());
    ethercat::sii_configuration configuration{};
    static_cast<void>(wire::decode(configuration, words));
    description_ = {.vendor = device_.vendor_id,
                    .product = device_.product_code,
                    .revision = device_.revision,
                    .serial = device_.serial,
                    .station_alias = configuration.station_alias,
                    .mailbox_out_size = 0,
                    .mailbox_in_size = 0,
                    .name = device_.name};
    if (device_.has_coe) {
        const auto &out = device_.sync_managers[0], &in = device_.sync_managers[1];
        description_.mailbox_out_offset = out.start;
        description_.mailbox_out_size = out.default_size;
        description_.mailbox_in_offset = in.start;
        description_.mailbox_in_size = in.default_size;
    }
    read_pdos(device_.rx_pdos, outputs_, output_parts_);
    read_pdos(device_.tx_pdos, inputs_, input_parts_);
    description_.outputs = outputs_;
    description_.inputs = inputs_;
    description_.output_parts = output_parts_;
    description_.input_parts = input_parts_;
    for (const auto& each : device_.clock_modes)
        clock_modes_.push_back({.name = each.name,
                                .description = each.description,
                                .assign_activate = each.assign_activate,
                                .cycle_time_0 = each.cycle_time_0,
                                .shift_time_0 = each.shift_time_0,
                                .shift_time_1 = each.shift_time_1,
                                .cycle_factor_0 = each.cycle_factor_0,
                                .cycle_factor_1 = each.cycle_factor_1});
    description_.clock_modes = clock_modes_;
    if (std::ranges::any_of(clock_modes_, [](const auto& each) { return each.assign_activate != 0; }))
        description_.clock = ethercat::clock_width::bits_64; // the file does not have the width
    using namespace ethercat::standard_indices;
    description_.error_register = find_object(error_register) != nullptr;
    description_.hardware_version = hardware_ = text_of(hardware_version);
    description_.software_version = software_ = text_of(software_version);
    description_.synchronization =
        find_object(output_synchronization) != nullptr || find_object(input_synchronization) != nullptr;
}

JAUSCAT_DECL void emulated_device::read_pdos(const std::vector<pdo>& pdos, std::vector<ethercat::pdo_entry>& into,
                                             std::vector<ethercat::pdo_part>& parts) {
    for (const auto& each : pdos) {
        parts.push_back({each.index, static_cast<std::uint16_t>(each.entries.size()), each.name});
        for (const auto& entry : each.entries)
            into.push_back({.index = entry.index,
                            .subindex = entry.subindex,
                            .bits = static_cast<std::uint8_t>(std::min<std::uint16_t>(entry.bits, 0xFF)),
                            .data_type = static_cast<std::uint8_t>(parse_data_type(entry.type)),
                            .name = entry.name});
    }
}

JAUSCAT_DECL const object* emulated_device::find_object(std::uint16_t index) const noexcept {
    const auto found = std::ranges::find(device_.objects, index, &object::index);
    return found == device_.objects.end() ? nullptr : &*found;
}

JAUSCAT_DECL std::string emulated_device::text_of(std::uint16_t index) const {
    std::string text;
    if (const auto* const what = find_object(index); what != nullptr && !what->entries.empty())
        for (const auto byte : what->entries.front().default_data)
            text += static_cast<char>(std::to_integer<unsigned char>(byte));
    return text;
}

JAUSCAT_DECL void emulated_device::add_component(const object& what, const std::string& id) {
    const auto where = hex_number(what.index, 4) + ": ";
    const auto component = parse_number(id, 0xFF);
    if (!component)
        fail(errc::invalid_value, "Object",
             where + "its property " + std::string{property_names::component} + " is no component ID");
    auto& entries = entries_.emplace_back();
    for (const auto& each : what.entries) {
        if (each.subindex == 0) continue;
        const auto* code = find(each.properties, property_names::command_code);
        const auto number = code == nullptr ? std::nullopt : parse_number(code->value, 0xFFFF);
        if (!number)
            fail(errc::missing, "Object",
                 where + "subindex " + std::to_string(each.subindex) + " has no property " +
                     std::string{property_names::command_code} + " with a command code");
        entries.push_back({.subindex = each.subindex,
                           .command_code = static_cast<std::uint16_t>(*number),
                           .name = each.name,
                           .max_size = static_cast<std::uint16_t>(each.bit_size / 8),
                           .readable = each.readable,
                           .writable = each.writable});
    }
    const auto* exact = find(what.properties, property_names::exact_size);
    components_.push_back({.index = what.index,
                           .component = static_cast<std::uint8_t>(*component),
                           .name = what.name,
                           .exact_size = exact != nullptr && exact->value == "true",
                           .entries = entries});
}

JAUSCAT_DECL const property* emulated_device::find(const std::vector<property>& properties,
                                                   std::string_view name) noexcept {
    const auto found = std::ranges::find(properties, name, &property::name);
    return found == properties.end() ? nullptr : &*found;
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi
