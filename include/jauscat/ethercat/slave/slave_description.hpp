// Description of an emulated slave: identity, mailboxes, process data. SII, standard objects and checks are derived
// from it.
#pragma once

#include <jauscat/ethercat/slave/pdo_entry.hpp>
#include <jauscat/ethercat/slave/slave_clock.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace jauscat::ethercat {

struct slave_description {
    std::uint32_t vendor{};
    std::uint32_t product{};
    std::uint32_t revision{1};
    std::uint32_t serial{};
    std::uint16_t station_alias{};
    std::uint16_t mailbox_out_offset{0x1000}; ///< master to slave, SyncManager 0
    std::uint16_t mailbox_out_size{256};      ///< bytes, 24 to 1486
    std::uint16_t mailbox_in_offset{0x1600};  ///< slave to master, SyncManager 1
    std::uint16_t mailbox_in_size{256};       ///< bytes, 24 to 1486
    std::string_view name{"JausCat slave"};   ///< up to 64 characters are kept
    bool eight_byte_sii_reads{};              ///< a read of the SII gives 8 bytes, else 4
    /// Master to slave: RxPDO 1600h in SyncManager 2, at process_memory::outputs. What these and the next refer to must
    /// outlive the slave. A slave with more than process_memory allows refuses SAFE-OP.
    std::span<const pdo_entry> outputs{};
    std::span<const pdo_entry> inputs{}; ///< slave to master: TxPDO 1A00h in SyncManager 3, at process_memory::inputs
    bool error_register{};               ///< it has object 1001h, with the value 0: no error
    std::string_view hardware_version{}; ///< object 1009h; empty: it has none
    std::string_view software_version{}; ///< object 100Ah; empty: it has none
    bool synchronization{};              ///< with process data: it has objects 1C32h and 1C33h, which say free run
    clock_width clock{}; ///< whether it has a distributed clock, which needs `slave::pass` with the time
    /// With outputs: after so many SYNC0 in a row that found no new outputs, it leaves OP (001Ah); 0: never.
    std::uint16_t sync_missed_limit{};
    /// SAFE-OP is refused unless SYNC0 is on (0030h), and OP until its first one has come (002Dh).
    bool needs_sync{};

    /// Whether it has any.
    [[nodiscard]] constexpr bool has_process_data() const noexcept { return !outputs.empty() || !inputs.empty(); }
    /// Bytes, 0 where there are more than fit.
    [[nodiscard]] constexpr std::size_t output_size() const noexcept {
        return size_within(outputs, process_memory::max_outputs);
    }
    /// Bytes that the master reads in each cycle.
    [[nodiscard]] constexpr std::size_t input_size() const noexcept {
        return size_within(inputs, process_memory::max_inputs);
    }

  private:
    static constexpr std::size_t size_within(std::span<const pdo_entry> entries, std::size_t most) noexcept {
        const auto size = process_data_size(entries);
        return size <= most && entries.size() <= process_memory::max_entries ? size : 0;
    }
};

} // namespace jauscat::ethercat
