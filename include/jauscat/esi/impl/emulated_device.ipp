// The functions of emulated_device.
#pragma once
#include <jauscat/esi/device_sii.hpp>
#include <jauscat/esi/emulated_device.hpp>
#include <jauscat/esi/text_values.hpp>
#include <jauscat/ethercat/slave/esc_memory.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <algorithm>
#include <utility>

namespace jauscat::esi {

namespace detail {

/// The property of that name, or nullptr.
inline const property* find_property(const std::vector<property>& properties, std::string_view name) noexcept {
    const auto found = std::ranges::find(properties, name, &property::name);
    return found == properties.end() ? nullptr : &*found;
}

/// What the emulation makes of a device, without what is for tools alone.
inline device emulated_part(device of) {
    of.slips.clear();
    of.start_up.clear();
    of.slots.clear();
    of.timeouts = {};
    return of;
}

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL emulated_device::emulated_device(device what) : device_{std::move(what)} {
    for (const auto& each : device_.objects)
        if (const auto* id = detail::find_property(each.properties, property_names::component))
            add_component(each, id->value);
    read_identity();
    read_areas();
    const auto of_file = description_;
    is_plain_ = read_as_plain();
    if (is_plain_) {
        const auto image = make_sii(description_);
        sii_.assign(image.begin(), image.end());
        return;
    }
    description_ = of_file;
    sii_ = device_sii(device_);
    if (sii_.size() < std::size_t{2} * ethercat::sii_words::categories)
        fail(errc::cannot_be_emulated, "Data", "expected 128 bytes of SII or more");
    description_.sii = sii_;
}

[[noreturn]] JAUSCAT_DECL void emulated_device::fail(errc code, const std::string& element,
                                                     const std::string& what) const {
    throw esi_error{
        {.code = code, .element = element, .message = '"' + device_.name + "\": <" + element + ">: " + what}};
}

JAUSCAT_DECL std::size_t emulated_device::transfer_size() const noexcept {
    if (!device_.coe.segmented_sdo && is_plain_) return 0;
    auto most = bridging::largest_subobject(components_);
    if (!is_plain_)
        for (const auto& each : device_.objects)
            for (const auto& entry : each.entries) most = std::max<std::size_t>(most, (entry.bit_size + 7) / 8);
    return most;
}

JAUSCAT_DECL void emulated_device::read_identity() {
    description_ = {.vendor = device_.vendor_id,
                    .product = device_.product_code,
                    .revision = device_.revision,
                    .serial = device_.serial,
                    .station_alias = configuration_of(device_.eeprom).station_alias,
                    .mailbox_out_size = 0,
                    .mailbox_in_size = 0,
                    .name = device_.name};
    if (std::ranges::any_of(device_.clock_modes, [](const auto& each) { return each.assign_activate != 0; }))
        description_.clock = ethercat::clock_width::bits_64; // the file does not have the width
}

JAUSCAT_DECL void emulated_device::read_areas() {
    using use = ethercat::sii_sync_manager_use;
    const auto& all = device_.sync_managers;
    if (all.size() > ethercat::esc_memory::sync_manager_count)
        fail(errc::cannot_be_emulated, "Sm",
             "expected at most " + std::to_string(ethercat::esc_memory::sync_manager_count) + " SyncManagers");
    const auto check_place = [&](std::size_t i, std::size_t size) {
        const auto name = "SyncManager " + std::to_string(i);
        const auto registers = ethercat::esc_registers::digital_outputs;
        if (all[i].start >= registers.address && all[i].start + size <= registers.address + registers.size) return;
        if (all[i].start < ethercat::esc_registers::process_ram.address ||
            all[i].start + size > ethercat::esc_memory::memory_size)
            fail(errc::cannot_be_emulated, "Sm", name + " is outside of the memory, 1000h to 2FFFh");
    };
    const auto is_mailbox = [&](const sync_manager& each) {
        return each.use == use::mailbox_out || each.use == use::mailbox_in;
    };
    const bool has_mailbox = device_.has_coe || !device_.protocols.empty() || std::ranges::any_of(all, is_mailbox);
    if (has_mailbox) {
        if (all.size() < 2 || all[0].use != use::mailbox_out || all[1].use != use::mailbox_in ||
            std::ranges::count_if(all, is_mailbox) != 2)
            fail(errc::cannot_be_emulated, "Sm", "expected MBoxOut first, then MBoxIn, and no other");
        for (std::size_t i = 0; i != 2; ++i) {
            check_place(i, all[i].default_size);
            if (all[i].default_size < ethercat::min_mailbox_size || all[i].default_size > ethercat::max_mailbox_size)
                fail(errc::cannot_be_emulated, "Sm", "expected a mailbox of 24 to 1486 bytes");
        }
        description_.mailbox_out_offset = all[0].start;
        description_.mailbox_out_size = all[0].default_size;
        description_.mailbox_in_offset = all[1].start;
        description_.mailbox_in_size = all[1].default_size;
    }
    for (const auto* const direction : {&device_.rx_pdos, &device_.tx_pdos})
        for (const auto& each : *direction)
            for (const auto& entry : each.entries)
                if (entry.bits > 0xFF)
                    fail(errc::cannot_be_emulated, direction == &device_.rx_pdos ? "RxPdo" : "TxPdo",
                         hex_number(each.index, 4) + " has an entry of " + std::to_string(entry.bits) +
                             " bits, expected at most 255");
    for (std::size_t i = has_mailbox ? 2 : 0; i != all.size(); ++i) {
        const auto size = data_size(device_, i);
        if (all[i].is_virtual || size == 0) continue;
        check_place(i, size);
        constexpr std::uint8_t mode_bits = 0x03, one_buffer = 0x02;
        if ((all[i].control & mode_bits) == one_buffer)
            fail(errc::cannot_be_emulated, "Sm",
                 "SyncManager " + std::to_string(i) + " has process data in one buffer (ControlByte " +
                     hex_number(all[i].control, 2) + "), expected three");
        const bool has_outputs = std::ranges::find(device_.rx_pdos, i, &pdo::sync_manager) != device_.rx_pdos.end();
        areas_.push_back({.manager = static_cast<std::uint8_t>(i),
                          .start = all[i].start,
                          .size = static_cast<std::uint16_t>(size),
                          .is_output = all[i].use == use::outputs || (all[i].use == use::none && has_outputs)});
    }
    description_.areas = areas_;
    const auto has = [&](bool outputs) {
        return std::ranges::find(areas_, outputs, &ethercat::data_area::is_output) != areas_.end();
    };
    if ((has(true) && description_.output_size() == 0) || (has(false) && description_.input_size() == 0))
        fail(errc::cannot_be_emulated, "Sm",
             "expected at most " + std::to_string(ethercat::process_memory::max_outputs) + " bytes of outputs and " +
                 std::to_string(ethercat::process_memory::max_inputs) + " of inputs");
}

JAUSCAT_DECL bool emulated_device::read_as_plain() {
    const auto count = device_.sync_managers.size();
    if (count != (device_.has_coe ? 2u : 0u) && count != (device_.has_coe ? 4u : 2u)) return false;
    if (device_.eeprom.config_data.size() != ethercat::sii_configuration_checked) return false;
    read_identity();
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
    using namespace ethercat::standard_indices;
    description_.error_register = find_object(error_register) != nullptr;
    description_.hardware_version = hardware_ = text_of(hardware_version);
    description_.software_version = software_ = text_of(software_version);
    description_.synchronization =
        find_object(output_synchronization) != nullptr || find_object(input_synchronization) != nullptr;
    const auto made =
        make_device(description_, {device_.vendor_name, device_.group_type, device_.group_name, device_.type},
                    components_, device_.coe.segmented_sdo);
    return made == detail::emulated_part(device_);
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
        const auto* code = detail::find_property(each.properties, property_names::command_code);
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
    const auto* exact = detail::find_property(what.properties, property_names::exact_size);
    components_.push_back({.index = what.index,
                           .component = static_cast<std::uint8_t>(*component),
                           .name = what.name,
                           .exact_size = exact != nullptr && exact->value == "true",
                           .entries = entries});
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi
