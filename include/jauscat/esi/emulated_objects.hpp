// The objects of an emulated slave that an ESI file describes.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/bridge/listed_objects.hpp>
#include <jauscat/esi/emulated_device.hpp>
#include <jauscat/ethercat/slave/mapped_objects.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace jauscat::esi {
inline namespace JAUSCAT_WAY {

/// The dictionary of the file, in front of an application that takes the messages of JAUS components. Its values are
/// the file's defaults, or 0, and what a master writes where it may. Identity, the uses of the SyncManagers, assignment
/// and mapping of the PDOs are there in any case, with the values of the device; a write of another assignment or
/// mapping is refused. Mapped objects have the values of the process data. Models described_object_source.
class emulated_objects {
  public:
    /// `of` and what `application` refers to must outlive this.
    JAUSCAT_DECL emulated_objects(const emulated_device& of, ethercat::object_dictionary application);
    emulated_objects(const emulated_objects&) = delete;
    emulated_objects& operator=(const emulated_objects&) = delete;

    /// The slave of these objects: values of mapped objects are those of its process data from now on.
    JAUSCAT_DECL void show(ethercat::slave& of) noexcept;

    /// Aborts: no_object, no_subindex, write_only, exceeds_mailbox, those of the application.
    JAUSCAT_DECL ethercat::object_read read(std::uint16_t index, std::uint8_t subindex,
                                            std::span<std::byte> out) noexcept;
    /// Aborts: no_object, no_subindex, read_only, length_too_low, length_too_high, value_range, those of the
    /// application.
    [[nodiscard]] JAUSCAT_DECL ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex,
                                                          std::span<const std::byte> data) noexcept;

    /// Whether the device has SDO information.
    [[nodiscard]] JAUSCAT_DECL bool is_described() const noexcept;
    [[nodiscard]] JAUSCAT_DECL std::uint16_t next_index(std::uint16_t after) const noexcept;
    [[nodiscard]] JAUSCAT_DECL std::optional<ethercat::object_info> describe(std::uint16_t index) const noexcept;
    [[nodiscard]] JAUSCAT_DECL std::optional<ethercat::entry_info> describe(std::uint16_t index,
                                                                            std::uint8_t subindex) const noexcept;

  private:
    // Where an entry is in the process data.
    struct place {
        bool is_output{};
        std::size_t area{}; // of the inputs
        std::size_t first_bit{};
        std::size_t bits{};
    };
    struct stored_entry {
        entry what{};
        std::vector<std::byte> value{};
        bool is_fixed{}; // may be written, with its own value alone
        std::optional<place> mapped{};
    };
    struct stored_object {
        object_code code{};
        std::string name{};
        std::map<std::uint8_t, stored_entry> entries{};
    };

    JAUSCAT_DECL void add_file_objects();
    JAUSCAT_DECL void add_values_of_device();
    JAUSCAT_DECL void add_places();
    // Values of subindices 1 to n, each of `bytes` bytes, and their number in subindex 0.
    JAUSCAT_DECL void set_list(std::uint16_t index, const std::string& name, const char* type, std::size_t bytes,
                               const std::vector<std::uint32_t>& values, bool is_configuration);
    // The entry that a PDO maps; made where the file does not have it.
    JAUSCAT_DECL stored_entry& mapped_entry(const pdo_entry& of, bool is_output);
    // The entry in `objects`, or nullptr.
    static auto* find_in(auto& objects, std::uint16_t index, std::uint8_t subindex) noexcept {
        const auto object = objects.find(index);
        decltype(&object->second.entries.begin()->second) found{};
        if (object == objects.end()) return found;
        const auto at = object->second.entries.find(subindex);
        return at == object->second.entries.end() ? found : &at->second;
    }

    const emulated_device& device_;
    bridging::listed_objects listed_;
    ethercat::mapped_objects mapped_;
    ethercat::standard_objects standard_;
    std::map<std::uint16_t, stored_object> objects_{}; // of a device that is not plain
    ethercat::slave* slave_{};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat::esi

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/esi/impl/emulated_objects.ipp>
#endif
