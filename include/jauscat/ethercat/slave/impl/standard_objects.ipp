// The functions of standard_objects.
#pragma once
#include <jauscat/ethercat/slave/standard_objects.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION object_read standard_objects::read(std::uint16_t index, std::uint8_t subindex,
                                                    std::span<std::byte> out) noexcept {
    value found{};
    const auto error = find(index, subindex, found);
    if (error == abort_code::no_object) return application_.read(index, subindex, out);
    if (error != abort_code::none) return {.error = error};
    if (found.size > out.size()) return {.error = abort_code::exceeds_mailbox};
    std::ranges::copy(std::span{found.bytes}.first(found.size), out.begin());
    return {.size = found.size};
}

JAUSCAT_FUNCTION abort_code standard_objects::write(std::uint16_t index, std::uint8_t subindex,
                                                    std::span<const std::byte> data) noexcept {
    value found{};
    const auto error = find(index, subindex, found);
    if (error == abort_code::no_object) return application_.write(index, subindex, data);
    return error == abort_code::none ? abort_code::read_only : error;
}

JAUSCAT_FUNCTION std::uint16_t standard_objects::next_index(std::uint16_t after) const noexcept {
    auto next = application_.next_index(after);
    const auto offer = [&](std::uint16_t index) {
        if (index > after && (next == 0 || index < next)) next = index;
    };
    for (const auto& pdos : {description_.output_pdos(), description_.input_pdos()})
        for (std::size_t i = 0; i != pdos.size(); ++i) offer(pdos[i].index);
    for (const auto& each : kinds)
        if (each.index > after && describe(each.index)) {
            offer(each.index);
            break;
        }
    return next;
}

JAUSCAT_FUNCTION std::optional<object_info> standard_objects::describe(std::uint16_t index) const noexcept {
    value first{};
    const auto kind = kind_of(index);
    if (!kind || find(index, 0, first) != abort_code::none) return application_.describe(index);
    const bool variable = kind->code == object_code::variable;
    return object_info{.data_type = kind->object_type,
                       .highest_subindex =
                           variable ? std::uint8_t{} : std::to_integer<std::uint8_t>(first.bytes.front()),
                       .code = kind->code,
                       .name = kind->name,
                       .complete_access = !variable && (synchronization_ == nullptr || !is_synchronization(index))};
}

JAUSCAT_FUNCTION std::optional<entry_info> standard_objects::describe(std::uint16_t index,
                                                                      std::uint8_t subindex) const noexcept {
    value found{};
    const auto kind = kind_of(index);
    const auto error = !kind ? abort_code::no_object : find(index, subindex, found);
    if (error == abort_code::no_object) return application_.describe(index, subindex);
    if (error != abort_code::none) return {};
    const bool variable = kind->code == object_code::variable;
    if (!variable && subindex == 0) return highest_subindex_info;
    const bool synchronizes = is_synchronization(index);
    const bool is_flag = synchronizes && found.size == 1, is_word = synchronizes && found.size == 2;
    return entry_info{.data_type = is_flag   ? data_types::boolean
                                   : is_word ? data_types::unsigned16
                                             : kind->entry_type,
                      .bits = static_cast<std::uint16_t>(is_flag ? 1 : found.size * 8),
                      .access = readable_always,
                      .name = variable ? kind->name : entry_name(index, subindex - 1u)};
}

JAUSCAT_FUNCTION std::optional<standard_objects::constant_part>
standard_objects::kind_of(std::uint16_t index) const noexcept {
    if (const auto pdo = pdo_of(index))
        return constant_part{index, object_code::record, data_types::pdo_mapping, data_types::unsigned32, pdo->name};
    const auto found = std::ranges::find(kinds, index, &constant_part::index);
    return found != kinds.end() ? std::optional{*found} : std::nullopt;
}

JAUSCAT_FUNCTION std::optional<described_pdo> standard_objects::pdo_of(std::uint16_t index) const noexcept {
    for (const auto& pdos : {description_.output_pdos(), description_.input_pdos()})
        for (std::size_t i = 0; i != pdos.size(); ++i)
            if (const auto pdo = pdos[i]; pdo.index == index) return pdo;
    return {};
}

JAUSCAT_FUNCTION std::string_view standard_objects::entry_name(std::uint16_t index, std::size_t entry) const noexcept {
    constexpr std::array<std::string_view, 4> identity{"Vendor ID", "Product code", "Revision", "Serial number"};
    constexpr std::array<std::string_view, 4> managers{"SyncManager 0", "SyncManager 1", "SyncManager 2",
                                                       "SyncManager 3"};
    constexpr std::array<std::string_view, 13> synchronization{
        "Synchronization type", "Cycle time",         "Shift time",         "Synchronization types supported",
        "Minimum cycle time",   "Calc and copy time", "Minimum delay time", "Get cycle time",
        "Delay time",           "SYNC0 cycle time",   "SM event missed",    "Cycle time too small",
        "Shift time too short"};
    if (const auto pdo = pdo_of(index)) return name_of(pdo->entries[entry]);
    switch (index) {
    case standard_indices::output_synchronization:
    case standard_indices::input_synchronization:
        return entry < synchronization.size() ? synchronization[entry] : "Sync error";
    case standard_indices::identity: return identity[entry];
    case standard_indices::sync_manager_types: return managers[entry];
    default: return "PDO";
    }
}

JAUSCAT_FUNCTION abort_code standard_objects::find_synchronization(std::uint8_t subindex, value& out) const noexcept {
    constexpr std::uint8_t last_time = 13, error = 32;
    const auto& now = *synchronization_;
    switch (subindex) {
    case 0: out.put(error); break;
    case 1: out.put_message(esc_word{static_cast<std::uint16_t>(now.type)}); break;
    case 4: out.put_message(esc_word{by_clock_supported}); break;
    case 2:
    case 10: out.put_message(dc_time_32{now.sync0_cycle}); break;
    case 11: out.put_message(esc_word{now.missed}); break;
    case 8:
    case 12:
    case last_time: out.size = 2; break;
    case error: out.put(now.error ? 1 : 0); break;
    default:
        if (subindex > last_time) return abort_code::no_subindex;
        out.size = 4;
    }
    return abort_code::none;
}

JAUSCAT_FUNCTION abort_code standard_objects::find(std::uint16_t index, std::uint8_t subindex,
                                                   value& out) const noexcept {
    const bool process_data = description_.has_process_data();
    // An object with subindices 1 to `count` written by `put_entry`.
    const auto entries = [&](std::size_t count, auto&& put_entry) {
        if (subindex > count) return abort_code::no_subindex;
        if (subindex == 0) {
            out.put(count);
        } else {
            put_entry(subindex - 1u);
        }
        return abort_code::none;
    };
    if (const auto pdo = pdo_of(index)) {
        const auto mapped = pdo->entries;
        return entries(mapped.size(), [&](std::size_t i) {
            out.put_message(pdo_mapping{mapped[i].bits, mapped[i].subindex, mapped[i].index});
        });
    }
    const auto assignment = [&](const pdo_list& pdos) {
        if (!process_data) return abort_code::no_object;
        return entries(pdos.size(), [&](std::size_t i) { out.put_message(esc_word{pdos[i].index}); });
    };
    const auto text = [&](std::string_view characters) {
        if (characters.empty()) return abort_code::no_object;
        if (subindex != 0) return abort_code::no_subindex;
        for (const char c : characters.substr(0, out.bytes.size())) out.put(static_cast<unsigned char>(c));
        return abort_code::none;
    };
    const auto synchronization = [&](std::span<const pdo_entry> all) {
        if (!description_.synchronization || all.empty()) return abort_code::no_object;
        if (synchronization_ != nullptr) return find_synchronization(subindex, out);
        return entries(6, [&](std::size_t i) {
            out.size = i == 0 || i == 3 ? 2 : 4;                // type and types supported: words
            if (i == 3) out.bytes.front() = free_run_supported; // all others 0: free run, and no times
        });
    };
    switch (index) {
    case standard_indices::error_register:
        if (!description_.error_register) return abort_code::no_object;
        if (subindex != 0) return abort_code::no_subindex;
        out.put(0);
        return abort_code::none;
    case standard_indices::hardware_version: return text(description_.hardware_version);
    case standard_indices::software_version: return text(description_.software_version);
    case standard_indices::output_synchronization: return synchronization(description_.outputs);
    case standard_indices::input_synchronization: return synchronization(description_.inputs);
    case standard_indices::device_type: // 4 bytes of 0: no device profile
        if (subindex != 0) return abort_code::no_subindex;
        out.size = 4;
        return abort_code::none;
    case standard_indices::device_name:
        if (subindex != 0) return abort_code::no_subindex;
        for (const char c : description_.name.substr(0, out.bytes.size())) out.put(static_cast<unsigned char>(c));
        return abort_code::none;
    case standard_indices::identity: // subindices 1 to 4: as in the SII
        return entries(4, [&](std::size_t i) {
            std::array<std::byte, wire::max_size<sii_identity>> words{};
            static_cast<void>(wire::encode(
                sii_identity{description_.vendor, description_.product, description_.revision, description_.serial},
                words));
            std::ranges::copy(std::span{words}.subspan(i * 4, 4), out.bytes.begin());
            out.size = 4;
        });
    case standard_indices::sync_manager_types: {
        using enum sii_sync_manager_use;
        constexpr std::array uses{mailbox_out, mailbox_in, outputs, inputs};
        return entries(process_data ? 4 : 2, [&](std::size_t i) { out.put(static_cast<std::size_t>(uses[i])); });
    }
    case standard_indices::output_assignment: return assignment(description_.output_pdos());
    case standard_indices::input_assignment: return assignment(description_.input_pdos());
    default: return abort_code::no_object;
    }
}

} // namespace jauscat::ethercat
