// The objects that a slave's PDOs map: their values are those of its process data. Configuration tools look for each
// mapped object in the dictionary.
#pragma once

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
    object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        if (!has(index)) return application_.read(index, subindex, out);
        const auto at = find(index, subindex);
        if (at.entry == nullptr && subindex != 0) return {.error = abort_code::no_subindex};
        const std::size_t size = at.entry == nullptr ? 1 : (at.entry->bits + 7u) / 8u;
        if (size > out.size()) return {.error = abort_code::exceeds_mailbox};
        std::ranges::fill(out.first(size), std::byte{});
        if (at.entry == nullptr)
            out.front() = static_cast<std::byte>(highest(index));
        else if (at.first_bit + at.entry->bits <= at.memory.size() * 8)
            copy_bits(at.memory, at.first_bit, out, 0, at.entry->bits);
        return {.size = size};
    }
    /// Aborts: no_subindex, read_only, those of the application.
    [[nodiscard]] abort_code write(std::uint16_t index, std::uint8_t subindex,
                                   std::span<const std::byte> data) noexcept {
        if (!has(index)) return application_.write(index, subindex, data);
        return subindex == 0 || find(index, subindex).entry != nullptr ? abort_code::read_only
                                                                       : abort_code::no_subindex;
    }

    /// Whether the application describes its objects, too.
    [[nodiscard]] bool is_described() const noexcept { return application_.is_described(); }
    [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept {
        auto next = application_.next_index(after);
        for (const auto entries : {outputs_, inputs_})
            for (const auto& each : entries)
                if (each.index > after && (next == 0 || each.index < next)) next = each.index;
        return next;
    }
    [[nodiscard]] std::optional<object_info> describe(std::uint16_t index) const noexcept {
        if (!has(index)) return application_.describe(index);
        const auto variable = find(index, 0);
        if (variable.entry != nullptr)
            return object_info{
                .data_type = variable.entry->data_type, .code = object_code::variable, .name = variable.entry->name};
        unsigned there = 0;
        for (unsigned i = 1; i <= highest(index); ++i)
            there += find(index, static_cast<std::uint8_t>(i)).entry != nullptr ? 1 : 0;
        return object_info{.highest_subindex = highest(index),
                           .code = object_code::record,
                           .name = is_output(index) ? "Mapped outputs" : "Mapped inputs",
                           .complete_access = there == highest(index)};
    }
    [[nodiscard]] std::optional<entry_info> describe(std::uint16_t index, std::uint8_t subindex) const noexcept {
        if (!has(index)) return application_.describe(index, subindex);
        const auto at = find(index, subindex);
        if (at.entry == nullptr) return subindex == 0 ? std::optional{highest_subindex_info} : std::nullopt;
        auto access = readable_always;
        (is_output(index) ? access.rx_pdo : access.tx_pdo) = true;
        return entry_info{
            .data_type = at.entry->data_type, .bits = at.entry->bits, .access = access, .name = at.entry->name};
    }

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
