// The ESI description of an emulated slave: what its SII says, its standard objects, and the objects that JAUS messages
// are written to.
#pragma once

#include <jauscat/esi/device.hpp>
#include <jauscat/esi/text_values.hpp>
#include <jauscat/ethercat/sii_image.hpp>
#include <jauscat/ethercat/standard_objects.hpp>
#include <jauscat/translate/object_list.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::esi {

/// What people read of a device, and no slave says of itself.
struct device_texts {
    std::string vendor_name{};
    std::string group_type{};
    std::string group_name{};
    std::string type{}; ///< short name, such as an order number
};

/// Properties that make an object of the ESI a component's object again.
namespace property_names {
inline constexpr std::string_view component = "JausComponent";      ///< of an object: JAUS component ID
inline constexpr std::string_view command_code = "JausCommandCode"; ///< of an entry
inline constexpr std::string_view exact_size = "ExactSize";         ///< of an object: entries take and give one size
} // namespace property_names

namespace detail {

/// An application without objects: what is behind the standard objects when only these are asked for.
struct no_objects {
    static ethercat::object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept {
        return {.error = ethercat::abort_code::no_object};
    }
    static ethercat::abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept {
        return ethercat::abort_code::no_object;
    }
};

struct standard_entry {
    std::uint16_t index{};
    std::uint8_t subindex{};
    std::string_view type{}; ///< empty: a string of the value's length
    std::string_view name{};
};

// A line with subindex 0 begins an object, and has its name.
inline constexpr std::array<standard_entry, 10> standard_entries{{
    {ethercat::standard_indices::device_type, 0, "UDINT", "Device type"},
    {ethercat::standard_indices::device_name, 0, "", "Device name"},
    {ethercat::standard_indices::identity, 0, "USINT", "Identity"},
    {ethercat::standard_indices::identity, 1, "UDINT", "Vendor ID"},
    {ethercat::standard_indices::identity, 2, "UDINT", "Product code"},
    {ethercat::standard_indices::identity, 3, "UDINT", "Revision"},
    {ethercat::standard_indices::identity, 4, "UDINT", "Serial number"},
    {ethercat::standard_indices::sync_manager_types, 0, "USINT", "SyncManager types"},
    {ethercat::standard_indices::sync_manager_types, 1, "USINT", "SyncManager 0"},
    {ethercat::standard_indices::sync_manager_types, 2, "USINT", "SyncManager 1"},
}};

inline constexpr const char* subindex_0_name = "Highest subindex";

/// The standard objects as a slave of that description answers with them.
inline std::vector<object> describe_standard_objects(const ethercat::slave_description& slave) {
    no_objects none{};
    ethercat::standard_objects source{slave, none};
    std::vector<object> made;
    for (const auto& each : standard_entries) {
        std::vector<std::byte> value(64);
        value.resize(source.read(each.index, each.subindex, value).size);
        if (each.subindex == 0) {
            made.push_back({.index = each.index,
                            .name = std::string{each.name},
                            .code = object_code::variable,
                            .mandatory = each.index != ethercat::standard_indices::device_name});
        } else { // more entries than one
            made.back().code =
                each.index == ethercat::standard_indices::sync_manager_types ? object_code::array : object_code::record;
            made.back().entries.front().name = subindex_0_name;
        }
        const auto type = each.type.empty() ? string_type(value.size()) : std::string{each.type};
        made.back().entries.push_back({.subindex = each.subindex,
                                       .name = std::string{each.name},
                                       .type = type,
                                       .bit_size = static_cast<std::uint32_t>(value.size()) * 8,
                                       .readable = true,
                                       .default_data = value});
    }
    return made;
}

inline object describe_component(const translate::object_description& component) {
    object made{.index = component.index, .name = std::string{component.name}, .code = object_code::record};
    made.properties.push_back({std::string{property_names::component}, std::to_string(component.component)});
    if (component.exact_size) made.properties.push_back({std::string{property_names::exact_size}, "true"});
    made.entries.push_back({.name = subindex_0_name,
                            .type = "USINT",
                            .bit_size = 8,
                            .readable = true,
                            .default_data = {static_cast<std::byte>(component.highest_subindex())}});
    for (const auto& each : component.entries) {
        made.entries.push_back({.subindex = each.subindex,
                                .name = std::string{each.name},
                                .type = octet_string_type(each.max_size),
                                .bit_size = each.max_size * 8u,
                                .readable = each.readable,
                                .writable = each.writable});
        made.entries.back().properties.push_back(
            {std::string{property_names::command_code}, hex_number(each.command_code, 4)});
    }
    return made;
}

} // namespace detail

/// Describes the emulated slave of that description, with standard_objects in front of the objects in `components`.
/// `segmented_sdo`: it has memory for transfers in segments (`coe_options::transfer_memory`).
inline device make_device(const ethercat::slave_description& slave, const device_texts& texts,
                          std::span<const translate::object_description> components, bool segmented_sdo) {
    const auto image = ethercat::make_sii_image(slave);
    device made{.vendor_id = slave.vendor,
                .vendor_name = texts.vendor_name,
                .group_type = texts.group_type,
                .group_name = texts.group_name,
                .type = texts.type,
                .product_code = slave.product,
                .revision = slave.revision,
                .serial = slave.serial,
                .name = std::string{slave.name},
                .objects = detail::describe_standard_objects(slave)};
    for (const auto& each : components) made.objects.push_back(detail::describe_component(each));
    made.sync_managers = {{.use = ethercat::sii_sync_manager_use::mailbox_out,
                           .start = slave.mailbox_out_offset,
                           .default_size = slave.mailbox_out_size,
                           .control = 0x26,
                           .enabled = true},
                          {.use = ethercat::sii_sync_manager_use::mailbox_in,
                           .start = slave.mailbox_in_offset,
                           .default_size = slave.mailbox_in_size,
                           .control = 0x22,
                           .enabled = true}};
    made.coe.segmented_sdo = segmented_sdo;
    made.eeprom.byte_size = static_cast<std::uint32_t>(image.size());
    made.eeprom.config_data.assign(image.begin(), image.begin() + 14);
    return made;
}

} // namespace jauscat::esi
