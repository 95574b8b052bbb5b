// Reads from the categories of a slave's SII which SyncManagers carry process data, and how many bits.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/process_object.hpp>
#include <jauscat/ethercat/master/sii_read.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// A SyncManager that carries process data, or may do so.
struct process_manager {
    std::uint8_t number{};
    sii_sync_manager description{}; ///< use none: neither its use nor its control byte says the direction
    std::uint32_t bits{};

    /// Whether the master writes them.
    [[nodiscard]] bool is_output() const noexcept { return description.use == sii_sync_manager_use::outputs; }
    /// Not switched on: an FMMU alone maps its place.
    [[nodiscard]] bool is_virtual() const noexcept { return (description.enable & sii_enable::virtual_manager) != 0; }
    /// It carries a PDO of outputs, or of inputs. Counts where nothing else says the direction.
    constexpr void carries(bool outputs) noexcept {
        if (description.use == sii_sync_manager_use::none)
            description.use = outputs ? sii_sync_manager_use::outputs : sii_sync_manager_use::inputs;
    }
    /// The same by the PDO's object: outputs are mapped by 1600h to 17FFh, inputs by 1A00h to 1BFFh.
    constexpr void carries_pdo(std::uint16_t index) {
        if (index >= 0x1600 && index <= 0x17FF) carries(true);
        if (index >= 0x1A00 && index <= 0x1BFF) carries(false);
    }
    [[nodiscard]] std::uint32_t bytes() const noexcept { return bits / 8 + (bits % 8 != 0 ? 1 : 0); }
};

/// Whether a SyncManager of the SII may carry process data. Where its use is not given, it becomes the direction that
/// the control byte says: bits 0 and 1 are 0 (buffered), bits 2 and 3 are 1 where the master writes. It remains none
/// where the control byte is 0. An entry of zeros is a place that is not used.
[[nodiscard]] inline bool may_carry_process_data(sii_sync_manager& manager) noexcept {
    using enum sii_sync_manager_use;
    if (manager.use == outputs || manager.use == inputs) return true;
    if (manager.use != none || manager.start == 0) return false;
    if ((manager.enable & (sii_enable::enabled | sii_enable::virtual_manager)) == 0) manager.length = 0;
    const unsigned mode = manager.control & 3U, direction = manager.control >> 2U & 3U;
    if (mode != 0) return false; // a mailbox
    if (direction == 1) manager.use = outputs;
    if (direction == 0 && manager.control != 0) manager.use = inputs;
    return true;
}

/// PDOs and entries of one slave that the master reads at most: a faulty slave may state 65,025 for each SyncManager.
inline constexpr std::uint32_t max_process_objects = 4096;

/// State machine: `request` adds the datagram of the present step, `reply` takes its return. Stays in place while it
/// runs. Errors: those of sii_read, sii_malformed, too_many_managers, too_many_entries.
class sii_survey {
  public:
    static constexpr std::size_t capacity = 14; ///< SyncManagers with process data: a controller has 16

    sii_survey() noexcept = default;
    /// With `sizes` the PDOs are read, too: a datagram pair for each entry, so only where nothing else tells the sizes.
    explicit sii_survey(bool sizes) noexcept : sizes_{sizes} {}
    /// The same; `objects` are looked for in the PDOs of these SyncManagers, a bit each, and get their places in them.
    sii_survey(std::span<process_object> objects, std::uint32_t managers) noexcept
        : sizes_{true}, wanted_{objects}, searched_{managers} {}

    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }
    /// The SyncManagers that carry process data.
    [[nodiscard]] std::span<process_manager> managers() noexcept { return std::span{managers_}.first(count_); }
    /// The SyncManagers that carry process data.
    [[nodiscard]] JAUSCAT_FUNCTION std::span<const process_manager> managers() const noexcept;

    /// The slave does not execute LRW.
    [[nodiscard]] bool no_lrw() const noexcept { return no_lrw_; }

    /// Starts with the first category.
    void begin() noexcept { read(step::category, sii_words::categories, wire::max_size<sii_category_header>); }

    void request(frame_builder& frame, std::uint16_t station) const noexcept { sii_.request(frame, station); }

    JAUSCAT_FUNCTION progress reply(const datagram_view& datagram, time_point now,
                                    const master_config& config) noexcept;

  private:
    enum class step : std::uint8_t { category, general, sync_manager, pdo, pdo_entry };

    static constexpr std::uint8_t max_managers = 32; // for which there are registers, and assignment objects
    static constexpr std::uint32_t sii_end = 0x8000; // words of the largest memory
    static constexpr unsigned max_categories = 100;  // an erased memory would have thousands
    static constexpr std::uint32_t manager_words = wire::max_size<sii_sync_manager> / 2;
    static constexpr std::uint32_t pdo_words = wire::max_size<sii_pdo> / 2;
    static constexpr std::uint32_t entry_words = wire::max_size<sii_pdo_entry> / 2;

    JAUSCAT_FUNCTION progress read(step next, std::uint32_t word, std::size_t bytes) noexcept;
    JAUSCAT_FUNCTION progress fail(const master_error& error) noexcept;

    JAUSCAT_FUNCTION progress category_read() noexcept;
    JAUSCAT_FUNCTION progress flags_read() noexcept;
    JAUSCAT_FUNCTION progress next_category() noexcept;

    JAUSCAT_FUNCTION progress next_sync_manager(std::uint32_t word) noexcept;
    JAUSCAT_FUNCTION progress sync_manager_read() noexcept;

    // A PDO counts for the SyncManager that carries it from the start.
    JAUSCAT_FUNCTION progress next_pdo(std::uint32_t word) noexcept;
    JAUSCAT_FUNCTION progress pdo_read() noexcept;
    JAUSCAT_FUNCTION progress next_pdo_entry(std::uint32_t word) noexcept;
    JAUSCAT_FUNCTION progress pdo_entry_read() noexcept;

    JAUSCAT_FUNCTION progress finish() noexcept;

    bool sizes_{};
    std::span<process_object> wanted_{};
    std::uint32_t searched_{};
    step step_{};
    sii_read sii_{};
    std::array<std::byte, 8> buffer_{}; // the largest piece
    std::uint32_t word_{};              // where it stands
    std::uint32_t end_{};               // of the category
    unsigned categories_{};
    std::array<process_manager, capacity> managers_{};
    std::size_t count_{};
    std::uint8_t number_{}; // of the next SyncManager
    bool described_{};      // there are PDOs
    bool no_lrw_{};
    std::uint8_t carrier_{};
    std::uint32_t entries_left_{};
    std::uint32_t objects_{};              // PDOs and entries so far
    std::array<std::uint32_t, 16> bits_{}; // of each SyncManager
    bool is_output_{};                     // the PDOs of this category
    std::uint16_t outputs_{}, inputs_{};   // SyncManagers with such PDOs, a bit each
    master_result<> result_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/sii_survey.ipp>
#endif
