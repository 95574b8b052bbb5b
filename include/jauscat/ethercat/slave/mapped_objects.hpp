// The objects that a slave's PDOs map: their values are those of its process data. Configuration tools look for each
// mapped object in the dictionary.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/slave/copy_bits.hpp>
#include <jauscat/ethercat/slave/object_dictionary.hpp>
#include <jauscat/ethercat/slave/slave_description.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// The mapped objects of a description, read only, in front of the objects of an application. A record, or a variable
/// where only its subindex 0 is mapped. Models object_source.
class mapped_objects {
  public:
    /// All objects that `description` and `application` refer to must outlive this object.
    constexpr mapped_objects(const slave_description& description, object_dictionary application) noexcept
        : outputs_{pdo_contents(description.outputs)},
          inputs_{pdo_contents(description.inputs)},
          application_{application} {}

    /// The memory of the slave's process data (`slave::outputs`, `slave::inputs`). Until it is given, values are 0.
    constexpr void show(std::span<const std::byte> outputs, std::span<const std::byte> inputs) noexcept {
        output_bytes_ = outputs;
        input_bytes_ = inputs;
    }

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
    struct place {
        const pdo_entry* entry{};
        std::span<const std::byte> memory{};
        std::size_t first_bit{};
    };

    [[nodiscard]] constexpr place find(std::uint16_t index, std::uint8_t subindex) const noexcept {
        for (const bool output : {true, false}) {
            std::size_t bit = 0;
            for (const auto& each : output ? outputs_ : inputs_) {
                if (each.index == index && each.subindex == subindex)
                    return {&each, output ? output_bytes_ : input_bytes_, bit};
                bit += each.bits;
            }
        }
        return {};
    }
    [[nodiscard]] constexpr bool is_output(std::uint16_t index) const noexcept {
        return std::ranges::find(outputs_, index, &pdo_entry::index) != outputs_.end();
    }
    // Index 0 is a gap.
    [[nodiscard]] constexpr bool has(std::uint16_t index) const noexcept {
        return index != 0 &&
               (is_output(index) || std::ranges::find(inputs_, index, &pdo_entry::index) != inputs_.end());
    }
    [[nodiscard]] constexpr std::uint8_t highest(std::uint16_t index) const noexcept {
        std::uint8_t most = 0;
        for (const auto entries : {outputs_, inputs_})
            for (const auto& each : entries)
                if (each.index == index) most = std::max(most, each.subindex);
        return most;
    }

    std::span<const pdo_entry> outputs_;
    std::span<const pdo_entry> inputs_;
    object_dictionary application_;
    std::span<const std::byte> output_bytes_{}, input_bytes_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/slave/impl/mapped_objects.ipp>
#endif
