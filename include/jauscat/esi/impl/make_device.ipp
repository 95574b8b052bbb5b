// The description of an emulated slave.
#pragma once
#include <jauscat/esi/make_device.hpp>
#include <jauscat/esi/text_values.hpp>
#include <jauscat/ethercat/slave/mapped_objects.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace jauscat::esi {

namespace detail {

/// An application without objects.
struct no_objects {
    static ethercat::object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept {
        return {.error = ethercat::abort_code::no_object};
    }
    static ethercat::abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept {
        return ethercat::abort_code::no_object;
    }
};

/// The ESI name of a standard object's data type.
inline std::string type_name(const ethercat::entry_info& entry) {
    const auto name = data_type_name(entry.data_type);
    return name.empty() ? string_type(entry.bits / 8u) : std::string{name};
}

inline bool is_mandatory(std::uint16_t index) {
    using namespace ethercat::standard_indices;
    const bool mapping = index >= 0x1600 && index < 0x1C00;
    return index == device_type || index == identity || index == sync_manager_types || index == output_assignment ||
           index == input_assignment || mapping;
}

/// The standard objects and the mapped objects of a slave with this description.
inline std::vector<object> describe_standard_objects(const ethercat::slave_description& slave) {
    no_objects none{};
    ethercat::mapped_objects mapped{slave, none};
    ethercat::standard_objects source{slave, mapped};
    std::vector<object> made;
    for (auto index = source.next_index(0); index != 0; index = source.next_index(index)) {
        auto info = *source.describe(index);
        // An ESI has no type for the elements of an empty array.
        if (info.code == ethercat::object_code::array && info.highest_subindex == 0)
            info.code = ethercat::object_code::record;
        made.push_back({.index = index,
                        .name = std::string{info.name},
                        .code = static_cast<object_code>(info.code),
                        .mandatory = is_mandatory(index)});
        for (unsigned i = 0; i <= info.highest_subindex; ++i) {
            const auto subindex = static_cast<std::uint8_t>(i);
            const auto entry = *source.describe(index, subindex);
            std::vector<std::byte> value((entry.bits + 7u) / 8u);
            static_cast<void>(source.read(index, subindex, value));
            if (entry.access.rx_pdo || entry.access.tx_pdo) value.clear(); // process data have no default
            made.back().entries.push_back({.subindex = subindex,
                                           .name = std::string{entry.name},
                                           .type = type_name(entry),
                                           .bit_size = entry.bits,
                                           .readable = true,
                                           .default_data = value});
        }
    }
    return made;
}

/// The PDOs of a direction.
inline std::vector<pdo> describe_pdos(const ethercat::pdo_list& pdos, std::size_t manager) {
    std::vector<pdo> all;
    for (std::size_t i = 0; i != pdos.size(); ++i) {
        const auto described = pdos[i];
        all.push_back({.index = described.index,
                       .name = std::string{described.name},
                       .sync_manager = static_cast<std::uint8_t>(manager),
                       .fixed = true,
                       .mandatory = true});
        for (const auto& each : described.entries)
            all.back().entries.push_back({.index = each.index,
                                          .subindex = each.subindex,
                                          .bits = each.bits,
                                          .name = std::string{each.name},
                                          .type = std::string{each.index == 0 ? "" : data_type_name(each.data_type)}});
    }
    return all;
}

inline std::vector<clock_mode> describe_clock_modes(const ethercat::slave_description& slave) {
    std::vector<clock_mode> all;
    for (const auto& each : slave.clock_modes)
        all.push_back({.name = std::string{each.name},
                       .description = std::string{each.description},
                       .assign_activate = each.assign_activate,
                       .cycle_time_0 = each.cycle_time_0,
                       .shift_time_0 = each.shift_time_0,
                       .shift_time_1 = each.shift_time_1,
                       .cycle_factor_0 = each.cycle_factor_0,
                       .cycle_factor_1 = each.cycle_factor_1});
    return all;
}

inline object describe_component(const bridging::object_description& component) {
    object made{.index = component.index, .name = std::string{component.name}, .code = object_code::record};
    made.properties.push_back({std::string{property_names::component}, std::to_string(component.component)});
    if (component.exact_size) made.properties.push_back({std::string{property_names::exact_size}, "true"});
    made.entries.push_back({.name = std::string{ethercat::highest_subindex_info.name},
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

/// SyncManagers of the process data, FMMUs and PDOs.
inline void describe_process_data(device& made, const ethercat::slave_description& slave) {
    const auto add = [&](ethercat::sii_sync_manager_use use, std::uint16_t start, std::size_t size,
                         std::uint8_t control, const char* fmmu) {
        made.sync_managers.push_back({.use = use,
                                      .start = start,
                                      .default_size = static_cast<std::uint16_t>(size),
                                      .control = control,
                                      .enabled = size != 0});
        if (size != 0) made.fmmus.emplace_back(fmmu);
    };
    add(ethercat::sii_sync_manager_use::outputs, ethercat::process_memory::outputs, slave.output_size(),
        ethercat::manager_controls::outputs, "Outputs");
    add(ethercat::sii_sync_manager_use::inputs, ethercat::process_memory::inputs, slave.input_size(),
        ethercat::manager_controls::inputs, "Inputs");
    made.rx_pdos = describe_pdos(slave.output_pdos(), slave.output_manager());
    made.tx_pdos = describe_pdos(slave.input_pdos(), slave.input_manager());
}

} // namespace detail

inline namespace JAUSCAT_WAY {

JAUSCAT_DECL device make_device(const ethercat::slave_description& slave, const device_texts& texts,
                                std::span<const bridging::object_description> components, bool segmented_sdo) {
    const auto image = make_sii(slave);
    device made{.vendor_id = slave.vendor,
                .vendor_name = texts.vendor_name,
                .group_type = texts.group_type,
                .group_name = texts.group_name,
                .type = texts.type,
                .product_code = slave.product,
                .revision = slave.revision,
                .serial = slave.serial,
                .name = std::string{slave.name},
                .has_coe = slave.has_mailbox(),
                .clock_modes = detail::describe_clock_modes(slave)};
    if (made.has_coe) {
        made.objects = detail::describe_standard_objects(slave);
        for (const auto& each : components) made.objects.push_back(detail::describe_component(each));
        made.sync_managers = {{.use = ethercat::sii_sync_manager_use::mailbox_out,
                               .start = slave.mailbox_out_offset,
                               .default_size = slave.mailbox_out_size,
                               .control = ethercat::manager_controls::mailbox_out,
                               .enabled = true},
                              {.use = ethercat::sii_sync_manager_use::mailbox_in,
                               .start = slave.mailbox_in_offset,
                               .default_size = slave.mailbox_in_size,
                               .control = ethercat::manager_controls::mailbox_in,
                               .enabled = true}};
        made.coe = {.sdo_information = true, .complete_access = true, .segmented_sdo = segmented_sdo};
    }
    if (slave.has_process_data()) detail::describe_process_data(made, slave);
    made.eeprom.byte_size = static_cast<std::uint32_t>(image.size());
    made.eeprom.config_data.assign(image.begin(), image.begin() + ethercat::sii_configuration_checked);
    return made;
}

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi
