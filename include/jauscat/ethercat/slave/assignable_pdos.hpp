// PDOs that a master maps and assigns, for emulated slaves that leave both to their master.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/slave/object_dictionary.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/slave_description.hpp>
#include <jauscat/schema/ethercat/pdo.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace jauscat::ethercat {

/// The mapping objects (1600h ..., 1A00h ...) and assignments (1C12h, 1C13h) of a slave, in front of its other objects,
/// which say by their descriptions what can be mapped. A master writes them in PRE-OP, subindex 0 as 0 first; at first
/// they are those of the description, and further PDOs are empty. Models object_source.
class assignable_pdos {
  public:
    static constexpr std::size_t max_pdos = 4;     ///< of each direction, or as many as the description has
    static constexpr std::size_t max_entries = 64; ///< of a PDO

    /// What `description` and `objects` refer to must outlive this.
    JAUSCAT_FUNCTION assignable_pdos(const slave_description& description, object_dictionary objects) noexcept;

    /// To be called after each frame that the slave has processed: it expects process data of these sizes from now on.
    JAUSCAT_FUNCTION void follow(slave& of) noexcept;
    /// Writes each mapped object.
    JAUSCAT_FUNCTION void take(std::span<const std::byte> outputs) noexcept;
    /// Reads each mapped object.
    JAUSCAT_FUNCTION void give(std::span<std::byte> inputs) noexcept;

    /// Aborts: no_subindex and exceeds_mailbox, those of the other objects.
    JAUSCAT_FUNCTION object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept;
    /// Aborts: device_state (not in PRE-OP), subindex_0_not_zero, not_mappable (no object of this size, or no PDO),
    /// pdo_length (more than process_memory has), length_mismatch, no_subindex, those of the other objects.
    [[nodiscard]] JAUSCAT_FUNCTION abort_code write(std::uint16_t index, std::uint8_t subindex,
                                                    std::span<const std::byte> data) noexcept;
    /// Whether the other objects are described, too.
    [[nodiscard]] bool is_described() const noexcept { return objects_.is_described(); }
    [[nodiscard]] JAUSCAT_FUNCTION std::uint16_t next_index(std::uint16_t after) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<object_info> describe(std::uint16_t index) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<entry_info> describe(std::uint16_t index,
                                                                      std::uint8_t subindex) const noexcept;

  private:
    struct mapping {
        std::uint16_t index{}; // 0: there is none
        std::uint8_t count{};  // of the entries in force
        std::array<pdo_mapping, max_entries> entries{};

        [[nodiscard]] std::span<const pdo_mapping> mapped() const noexcept { return std::span{entries}.first(count); }
    };
    struct direction {
        bool is_output{};
        std::uint16_t assignment{}; // its index
        std::array<mapping, pdo_list::max_size> pdos{};
        std::uint8_t count{}; // of the assigned PDOs
        std::array<std::uint16_t, pdo_list::max_size> assigned{};

        /// Its place; pdo_list::max_size: there is none.
        [[nodiscard]] JAUSCAT_FUNCTION std::size_t find(std::uint16_t index) const noexcept;
        [[nodiscard]] JAUSCAT_FUNCTION std::size_t bits() const noexcept;
        /// Calls f(entry, first bit) for each assigned entry.
        void for_entries(auto&& f) const noexcept;
    };
    /// Whose subindices a transfer is about.
    struct place {
        static constexpr std::size_t none = pdo_list::max_size;
        std::size_t direction{none};
        std::size_t pdo{none}; ///< none: the assignment
    };

    JAUSCAT_FUNCTION static direction made_of(bool is_output, const pdo_list& pdos) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION place find(std::uint16_t index) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION bool is_mappable(const pdo_mapping& entry, bool as_output) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION abort_code check(const direction& of) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION static abort_code write_entry(direction& of, const place& at, std::size_t entry,
                                                                 std::span<const std::byte> data) noexcept;

    object_dictionary objects_;
    std::array<direction, 2> directions_; // outputs, inputs
    bool is_open_{true};                  // the slave is in INIT or PRE-OP
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/assignable_pdos.ipp>
#endif
