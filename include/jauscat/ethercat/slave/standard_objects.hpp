// The objects of the communication area that every CoE slave has (ETG.1000.6): device type, name, identity, use of the
// SyncManagers. Configuration tools read them to identify the device.
#pragma once

#include <jauscat/base/compilation.hpp>
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
    JAUSCAT_FUNCTION object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept;

    /// Aborts: no_subindex, read_only, those of the application.
    [[nodiscard]] JAUSCAT_FUNCTION abort_code write(std::uint16_t index, std::uint8_t subindex,
                                                    std::span<const std::byte> data) noexcept;

    /// Whether the application describes its objects, too.
    [[nodiscard]] bool is_described() const noexcept { return application_.is_described(); }
    [[nodiscard]] JAUSCAT_FUNCTION std::uint16_t next_index(std::uint16_t after) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<object_info> describe(std::uint16_t index) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<entry_info> describe(std::uint16_t index,
                                                                      std::uint8_t subindex) const noexcept;

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
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<constant_part> kind_of(std::uint16_t index) const noexcept;
    // The PDO with this mapping object.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<described_pdo> pdo_of(std::uint16_t index) const noexcept;
    static constexpr std::string_view name_of(const pdo_entry& each) noexcept {
        return each.index == 0 ? "Gap" : each.name;
    }
    [[nodiscard]] JAUSCAT_FUNCTION std::string_view entry_name(std::uint16_t index, std::size_t entry) const noexcept;

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
    [[nodiscard]] JAUSCAT_FUNCTION abort_code find_synchronization(std::uint8_t subindex, value& out) const noexcept;

    // Error no_object: it is none of the standard ones.
    [[nodiscard]] JAUSCAT_FUNCTION abort_code find(std::uint16_t index, std::uint8_t subindex,
                                                   value& out) const noexcept;

    slave_description description_;
    object_dictionary application_;
    const sync_report* synchronization_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/standard_objects.ipp>
#endif
