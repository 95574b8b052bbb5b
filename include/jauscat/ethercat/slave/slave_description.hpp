// Description of an emulated slave: identity, mailboxes, process data. SII, standard objects and checks are derived
// from it.
#pragma once

#include <jauscat/ethercat/slave/pdo_entry.hpp>
#include <jauscat/ethercat/slave/slave_clock.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace jauscat::ethercat {

/// A way to synchronize the slave by its distributed clock, as in the SII. The first one is the default.
struct clock_mode {
    std::string_view name{};
    std::string_view description{};
    std::uint16_t assign_activate{}; ///< value of registers 0980h and 0981h; 0: not synchronized by the clock
    std::uint32_t cycle_time_0{};    ///< ns, of SYNC0; 0: `cycle_factor_0` times the cycle of the bus
    std::int32_t shift_time_0{};     ///< ns, of SYNC0
    std::int32_t shift_time_1{};     ///< ns, of SYNC1
    std::int16_t cycle_factor_0{};   ///< of SYNC0
    std::int16_t cycle_factor_1{};   ///< of SYNC1, in cycles of SYNC0
};

/// A SyncManager of process data, of a slave that has others than usual.
struct data_area {
    std::uint8_t manager{}; ///< its number
    std::uint16_t start{};
    std::uint16_t size{}; ///< bytes
    bool is_output{};     ///< written by the master
};

struct slave_description {
    std::uint32_t vendor{};
    std::uint32_t product{};
    std::uint32_t revision{1};
    std::uint32_t serial{};
    std::uint16_t station_alias{};
    std::uint16_t mailbox_out_offset{0x1000}; ///< master to slave, SyncManager 0
    std::uint16_t mailbox_out_size{256};      ///< bytes, 24 to 1486; both 0: neither mailbox nor CoE
    std::uint16_t mailbox_in_offset{0x1600};  ///< slave to master, SyncManager 1
    std::uint16_t mailbox_in_size{256};       ///< bytes, 24 to 1486; both 0: neither mailbox nor CoE
    std::string_view name{"JausCat slave"};   ///< up to 64 characters are kept
    bool eight_byte_sii_reads{};              ///< a read of the SII gives 8 bytes, else 4
    /// Master to slave: in SyncManager 2, or 0 without a mailbox, at process_memory::outputs. What spans refer to must
    /// outlive the slave. A slave with more than process_memory allows refuses SAFE-OP.
    std::span<const pdo_entry> outputs{};
    std::span<const pdo_entry> inputs{};      ///< slave to master: in SyncManager 3, or 1, at process_memory::inputs
    std::span<const pdo_part> output_parts{}; ///< PDOs of the outputs, at most 16; none: RxPDO 1600h has all
    std::span<const pdo_part> input_parts{};  ///< PDOs of the inputs, at most 16; none: TxPDO 1A00h has all
    bool error_register{};                    ///< it has object 1001h, with the value 0: no error
    std::string_view hardware_version{};      ///< object 1009h; empty: it has none
    std::string_view software_version{};      ///< object 100Ah; empty: it has none
    std::optional<std::uint16_t> device_id{}; ///< explicit device identification, such as a selector switch
    /// With process data: it has objects 1C32h and 1C33h. They say free run, but for standard_objects::show.
    bool synchronization{};
    clock_width clock{}; ///< whether it has a distributed clock, which needs `slave::pass` with the time
    /// With outputs: after so many SYNC0 in a row that found no new outputs, it leaves OP (001Ah); 0: never.
    std::uint16_t sync_missed_limit{};
    /// SAFE-OP is refused unless SYNC0 is on (0030h), and OP until its first one has come (002Dh).
    bool needs_sync{};
    std::span<const clock_mode> clock_modes{}; ///< those of its distributed clock, at most 8
    /// Its SyncManagers of process data, up to 8, in place of those for `outputs` and `inputs`. The outputs are those
    /// of all areas one behind the other.
    std::span<const data_area> areas{};
    std::span<const std::byte> sii{}; ///< its whole SII; empty: made of this description

    /// Without one it has no CoE either.
    [[nodiscard]] constexpr bool has_mailbox() const noexcept { return mailbox_out_size != 0 || mailbox_in_size != 0; }
    /// Whether it has any.
    [[nodiscard]] constexpr bool has_process_data() const noexcept {
        return !outputs.empty() || !inputs.empty() || !areas.empty();
    }
    /// Bytes, 0 where there are more than fit.
    [[nodiscard]] constexpr std::size_t output_size() const noexcept {
        return areas.empty() ? size_within(outputs, process_memory::max_outputs)
                             : size_of_areas(true, process_memory::max_outputs);
    }
    /// Bytes that the master reads in each cycle.
    [[nodiscard]] constexpr std::size_t input_size() const noexcept {
        return areas.empty() ? size_within(inputs, process_memory::max_inputs)
                             : size_of_areas(false, process_memory::max_inputs);
    }
    [[nodiscard]] constexpr pdo_list output_pdos() const noexcept { return {outputs, output_parts, all_outputs}; }
    [[nodiscard]] constexpr pdo_list input_pdos() const noexcept { return {inputs, input_parts, all_inputs}; }
    /// Number of the SyncManager of the outputs; the inputs have the next one.
    [[nodiscard]] constexpr std::size_t output_manager() const noexcept {
        return has_mailbox() ? manager_numbers::outputs : 0;
    }
    [[nodiscard]] constexpr std::size_t input_manager() const noexcept { return output_manager() + 1; }

  private:
    static constexpr pdo_part all_outputs{.index = pdo_indices::outputs, .name = "Outputs"};
    static constexpr pdo_part all_inputs{.index = pdo_indices::inputs, .name = "Inputs"};

    static constexpr std::size_t size_within(std::span<const pdo_entry> entries, std::size_t most) noexcept {
        const auto size = process_data_size(entries);
        return size <= most && entries.size() <= process_memory::max_entries ? size : 0;
    }
    [[nodiscard]] constexpr std::size_t size_of_areas(bool of_outputs, std::size_t most) const noexcept {
        std::size_t size = 0;
        for (const auto& each : areas)
            if (each.is_output == of_outputs) size += each.size;
        return size <= most ? size : 0;
    }
};

} // namespace jauscat::ethercat
