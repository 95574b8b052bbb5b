// The objects of the communication area that every CoE slave has (ETG.1000.6): device type, name, identity, use of the
// SyncManagers. Configuration tools read them to identify the device.
#pragma once

#include <jauscat/ethercat/slave/object_dictionary.hpp>
#include <jauscat/ethercat/slave/slave_description.hpp>
#include <jauscat/ethercat/slave/sync_report.hpp>
#include <jauscat/schema/ethercat/dc_registers.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/pdo.hpp>
#include <jauscat/schema/ethercat/sii.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace jauscat::ethercat {

/// Indices of the standard objects.
namespace standard_indices {
inline constexpr std::uint16_t device_type = 0x1000;
inline constexpr std::uint16_t error_register = 0x1001; ///< one bit for each kind of error
inline constexpr std::uint16_t device_name = 0x1008;
inline constexpr std::uint16_t hardware_version = 0x1009; ///< text of the manufacturer
inline constexpr std::uint16_t software_version = 0x100A; ///< text of the manufacturer
inline constexpr std::uint16_t identity = 0x1018;
inline constexpr std::uint16_t sync_manager_types = 0x1C00;
inline constexpr std::uint16_t output_assignment = 0x1C12;
inline constexpr std::uint16_t input_assignment = 0x1C13;
inline constexpr std::uint16_t output_synchronization = 0x1C32; ///< how the outputs' SyncManager is synchronised
inline constexpr std::uint16_t input_synchronization = 0x1C33;  ///< the same of the inputs'
} // namespace standard_indices

/// The standard objects of an emulated slave, all read only, in front of the objects of its application: with process
/// data also their mapping (1600h and 1A00h, or those of its PDOs) and assignment (1C12h, 1C13h). The description
/// determines the others. Models object_source.
class standard_objects {
  public:
    /// What `description` and `application` refer to must outlive this.
    constexpr standard_objects(const slave_description& description, object_dictionary application) noexcept
        : description_{description}, application_{application} {}

    /// Objects 1C32h and 1C33h, where the description has them, say from now on what `slave::synchronization` gives,
    /// which outlives this: types, cycles, missed SYNC0 and error.
    constexpr void show(const sync_report& synchronization) noexcept { synchronization_ = &synchronization; }

    /// Aborts: no_subindex and exceeds_mailbox, those of the application.
    object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        value found{};
        const auto error = find(index, subindex, found);
        if (error == abort_code::no_object) return application_.read(index, subindex, out);
        if (error != abort_code::none) return {.error = error};
        if (found.size > out.size()) return {.error = abort_code::exceeds_mailbox};
        std::ranges::copy(std::span{found.bytes}.first(found.size), out.begin());
        return {.size = found.size};
    }

    /// Aborts: no_subindex, read_only, those of the application.
    [[nodiscard]] abort_code write(std::uint16_t index, std::uint8_t subindex,
                                   std::span<const std::byte> data) noexcept {
        value found{};
        const auto error = find(index, subindex, found);
        if (error == abort_code::no_object) return application_.write(index, subindex, data);
        return error == abort_code::none ? abort_code::read_only : error;
    }

    /// Whether the application describes its objects, too.
    [[nodiscard]] bool is_described() const noexcept { return application_.is_described(); }
    [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept {
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
    [[nodiscard]] std::optional<object_info> describe(std::uint16_t index) const noexcept {
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
    [[nodiscard]] std::optional<entry_info> describe(std::uint16_t index, std::uint8_t subindex) const noexcept {
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

  private:
    /// Constant part of a standard object.
    struct constant_part {
        std::uint16_t index{};
        object_code code{};
        std::uint16_t object_type{};
        std::uint16_t entry_type{};
        std::string_view name{};
    };
    static constexpr std::array kinds{
        constant_part{standard_indices::device_type, object_code::variable, data_types::unsigned32,
                      data_types::unsigned32, "Device type"},
        constant_part{standard_indices::error_register, object_code::variable, data_types::unsigned8,
                      data_types::unsigned8, "Error register"},
        constant_part{standard_indices::device_name, object_code::variable, data_types::visible_string,
                      data_types::visible_string, "Device name"},
        constant_part{standard_indices::hardware_version, object_code::variable, data_types::visible_string,
                      data_types::visible_string, "Hardware version"},
        constant_part{standard_indices::software_version, object_code::variable, data_types::visible_string,
                      data_types::visible_string, "Software version"},
        constant_part{standard_indices::identity, object_code::record, data_types::identity, data_types::unsigned32,
                      "Identity"},
        constant_part{standard_indices::sync_manager_types, object_code::array, data_types::unsigned8,
                      data_types::unsigned8, "SyncManager types"},
        constant_part{standard_indices::output_assignment, object_code::array, data_types::unsigned16,
                      data_types::unsigned16, "Output assignment"},
        constant_part{standard_indices::input_assignment, object_code::array, data_types::unsigned16,
                      data_types::unsigned16, "Input assignment"},
        constant_part{standard_indices::output_synchronization, object_code::record, data_types::synchronization,
                      data_types::unsigned32, "Output synchronization"},
        constant_part{standard_indices::input_synchronization, object_code::record, data_types::synchronization,
                      data_types::unsigned32, "Input synchronization"},
    };
    [[nodiscard]] std::optional<constant_part> kind_of(std::uint16_t index) const noexcept {
        if (const auto pdo = pdo_of(index))
            return constant_part{index, object_code::record, data_types::pdo_mapping, data_types::unsigned32,
                                 pdo->name};
        const auto found = std::ranges::find(kinds, index, &constant_part::index);
        return found != kinds.end() ? std::optional{*found} : std::nullopt;
    }
    // The PDO with this mapping object.
    [[nodiscard]] std::optional<described_pdo> pdo_of(std::uint16_t index) const noexcept {
        for (const auto& pdos : {description_.output_pdos(), description_.input_pdos()})
            for (std::size_t i = 0; i != pdos.size(); ++i)
                if (const auto pdo = pdos[i]; pdo.index == index) return pdo;
        return {};
    }
    static constexpr std::string_view name_of(const pdo_entry& each) noexcept {
        return each.index == 0 ? "Gap" : each.name;
    }
    [[nodiscard]] std::string_view entry_name(std::uint16_t index, std::size_t entry) const noexcept {
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

    struct value {
        std::array<std::byte, 64> bytes{};
        std::size_t size{};

        void put(std::size_t byte) noexcept { bytes[size++] = static_cast<std::byte>(byte); }
        void put_message(const auto& message) noexcept {
            size += wire::encode(message, std::span{bytes}.subspan(size))->size();
        }
    };

    static constexpr std::byte free_run_supported{0x01};
    static constexpr std::uint16_t by_clock_supported = 0x0D; // free run, SYNC0, SYNC1

    [[nodiscard]] static constexpr bool is_synchronization(std::uint16_t index) noexcept {
        return index == standard_indices::output_synchronization || index == standard_indices::input_synchronization;
    }
    // 1C32h or 1C33h of a slave that shows how it is synchronized. Times that it does not have are 0.
    [[nodiscard]] abort_code find_synchronization(std::uint8_t subindex, value& out) const noexcept {
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

    // Error no_object: it is none of the standard ones.
    [[nodiscard]] abort_code find(std::uint16_t index, std::uint8_t subindex, value& out) const noexcept {
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

    slave_description description_;
    object_dictionary application_;
    const sync_report* synchronization_{};
};

} // namespace jauscat::ethercat
