// The functions of assignable_pdos.
#pragma once
#include <jauscat/ethercat/slave/assignable_pdos.hpp>
#include <jauscat/ethercat/slave/copy_bits.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <utility>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION assignable_pdos::assignable_pdos(const slave_description& description,
                                                  object_dictionary objects) noexcept
    : objects_{objects},
      directions_{made_of(true, description.output_pdos()), made_of(false, description.input_pdos())} {}

JAUSCAT_FUNCTION assignable_pdos::direction assignable_pdos::made_of(bool is_output, const pdo_list& pdos) noexcept {
    direction made{.is_output = is_output,
                   .assignment = is_output ? standard_indices::output_assignment : standard_indices::input_assignment};
    for (std::size_t i = 0; i != pdos.size(); ++i) {
        const auto from = pdos[i];
        auto& to = made.pdos[i];
        to.index = made.assigned[made.count++] = from.index;
        for (const auto& each : from.entries.first(std::min(from.entries.size(), max_entries)))
            to.entries[to.count++] = {each.bits, each.subindex, each.index};
    }
    auto next = is_output ? pdo_indices::outputs : pdo_indices::inputs;
    for (std::size_t i = made.count; i < max_pdos; ++i) {
        while (made.find(next) != place::none) ++next;
        made.pdos[i].index = next;
    }
    return made;
}

JAUSCAT_FUNCTION std::size_t assignable_pdos::direction::find(std::uint16_t index) const noexcept {
    if (index == 0) return place::none;
    return static_cast<std::size_t>(std::ranges::find(pdos, index, &mapping::index) - pdos.begin());
}
inline void assignable_pdos::direction::for_entries(auto&& f) const noexcept {
    std::size_t bit = 0;
    for (const auto each : std::span{assigned}.first(count))
        for (const auto& entry : pdos[find(each)].mapped()) {
            f(entry, bit);
            bit += entry.bits;
        }
}
JAUSCAT_FUNCTION std::size_t assignable_pdos::direction::bits() const noexcept {
    std::size_t all = 0;
    for_entries([&](const pdo_mapping& entry, std::size_t) { all += entry.bits; });
    return all;
}

JAUSCAT_FUNCTION void assignable_pdos::follow(slave& of) noexcept {
    is_open_ = of.state() == al_state::init || of.state() == al_state::pre_op;
    if (is_open_) of.set_process_data_sizes((directions_[0].bits() + 7) / 8, (directions_[1].bits() + 7) / 8);
}

JAUSCAT_FUNCTION void assignable_pdos::take(std::span<const std::byte> outputs) noexcept {
    directions_[0].for_entries([&](const pdo_mapping& entry, std::size_t first_bit) {
        if (entry.index == 0 || first_bit + entry.bits > outputs.size() * 8) return;
        std::array<std::byte, 32> value{};
        copy_bits(outputs, first_bit, value, 0, entry.bits);
        static_cast<void>(objects_.write(entry.index, entry.subindex, std::span{value}.first((entry.bits + 7u) / 8u)));
    });
}

JAUSCAT_FUNCTION void assignable_pdos::give(std::span<std::byte> inputs) noexcept {
    directions_[1].for_entries([&](const pdo_mapping& entry, std::size_t first_bit) {
        std::array<std::byte, 32> value{};
        if (entry.index == 0 || first_bit + entry.bits > inputs.size() * 8) return;
        if (objects_.read(entry.index, entry.subindex, value).error == abort_code::none)
            copy_bits(value, 0, inputs, first_bit, entry.bits);
    });
}

JAUSCAT_FUNCTION assignable_pdos::place assignable_pdos::find(std::uint16_t index) const noexcept {
    for (std::size_t i = 0; i != directions_.size(); ++i) {
        if (directions_[i].assignment == index) return {.direction = i};
        if (const auto pdo = directions_[i].find(index); pdo != place::none) return {.direction = i, .pdo = pdo};
    }
    return {};
}

JAUSCAT_FUNCTION object_read assignable_pdos::read(std::uint16_t index, std::uint8_t subindex,
                                                   std::span<std::byte> out) noexcept {
    const auto at = find(index);
    if (at.direction == place::none) return objects_.read(index, subindex, out);
    const auto& of = directions_[at.direction];
    const auto put = [&](const auto& value) -> object_read {
        const auto done = wire::encode(value, out);
        if (!done) return {.error = abort_code::exceeds_mailbox};
        return {.size = done->size()};
    };
    const bool is_assignment = at.pdo == place::none;
    const std::size_t count = is_assignment ? of.count : of.pdos[at.pdo].count;
    if (subindex > count) return {.error = abort_code::no_subindex};
    if (subindex != 0 && is_assignment) return put(esc_word{of.assigned[subindex - 1u]});
    if (subindex != 0) return put(of.pdos[at.pdo].entries[subindex - 1u]);
    if (out.empty()) return {.error = abort_code::exceeds_mailbox};
    out.front() = static_cast<std::byte>(count);
    return {.size = 1};
}

JAUSCAT_FUNCTION abort_code assignable_pdos::write(std::uint16_t index, std::uint8_t subindex,
                                                   std::span<const std::byte> data) noexcept {
    const auto at = find(index);
    if (at.direction == place::none) return objects_.write(index, subindex, data);
    if (!is_open_) return abort_code::device_state;
    auto& of = directions_[at.direction];
    const bool is_assignment = at.pdo == place::none;
    const std::size_t most = is_assignment ? of.assigned.size() : max_entries;
    auto& count = is_assignment ? of.count : of.pdos[at.pdo].count;
    if (subindex > most) return abort_code::no_subindex;
    if (subindex != 0) {
        if (count != 0) return abort_code::subindex_0_not_zero;
        return write_entry(of, at, subindex - 1u, data);
    }
    if (data.size() != 1) return abort_code::length_mismatch;
    const auto wanted = std::to_integer<std::uint8_t>(data.front());
    if (wanted > most) return abort_code::value_too_high;
    const auto before = std::exchange(count, wanted);
    const auto error = check(of);
    if (error != abort_code::none) count = before;
    return error;
}

JAUSCAT_FUNCTION abort_code assignable_pdos::write_entry(direction& of, const place& at, std::size_t entry,
                                                         std::span<const std::byte> data) noexcept {
    if (at.pdo != place::none) {
        if (!wire::decode(of.pdos[at.pdo].entries[entry], data)) return abort_code::length_mismatch;
        return abort_code::none;
    }
    esc_word word{};
    if (!wire::decode(word, data)) return abort_code::length_mismatch;
    if (of.find(word.value) == place::none) return abort_code::not_mappable;
    of.assigned[entry] = word.value;
    return abort_code::none;
}

/// Entries are looked at when subindex 0 says how many there are.
JAUSCAT_FUNCTION abort_code assignable_pdos::check(const direction& of) const noexcept {
    for (const auto each : std::span{of.assigned}.first(of.count))
        if (of.find(each) == place::none) return abort_code::not_mappable;
    for (const auto& each : of.pdos)
        for (const auto& entry : each.mapped())
            if (!is_mappable(entry, of.is_output)) return abort_code::not_mappable;
    const auto most = of.is_output ? process_memory::max_outputs : process_memory::max_inputs;
    return of.bits() > most * 8 ? abort_code::pdo_length : abort_code::none;
}

JAUSCAT_FUNCTION bool assignable_pdos::is_mappable(const pdo_mapping& entry, bool as_output) const noexcept {
    if (entry.index == 0) return entry.bits != 0; // a gap
    const auto info = objects_.describe(entry.index, entry.subindex);
    return info && info->bits == entry.bits && (as_output ? info->access.rx_pdo : info->access.tx_pdo);
}

JAUSCAT_FUNCTION std::uint16_t assignable_pdos::next_index(std::uint16_t after) const noexcept {
    auto next = objects_.next_index(after);
    const auto offer = [&](std::uint16_t index) {
        if (index > after && (next == 0 || index < next)) next = index;
    };
    for (const auto& each : directions_) {
        offer(each.assignment);
        for (const auto& of : each.pdos) offer(of.index);
    }
    return next;
}

JAUSCAT_FUNCTION std::optional<object_info> assignable_pdos::describe(std::uint16_t index) const noexcept {
    const auto at = find(index);
    if (at.direction == place::none) return objects_.describe(index);
    const auto& of = directions_[at.direction];
    if (at.pdo == place::none)
        return object_info{.data_type = data_types::unsigned16,
                           .highest_subindex = of.count,
                           .code = object_code::array,
                           .name = of.is_output ? "Output assignment" : "Input assignment"};
    return object_info{.data_type = data_types::pdo_mapping,
                       .highest_subindex = of.pdos[at.pdo].count,
                       .code = object_code::record,
                       .name = of.is_output ? "Output mapping" : "Input mapping"};
}

JAUSCAT_FUNCTION std::optional<entry_info> assignable_pdos::describe(std::uint16_t index,
                                                                     std::uint8_t subindex) const noexcept {
    const auto at = find(index);
    if (at.direction == place::none) return objects_.describe(index, subindex);
    auto access = readable_always;
    access.write_pre_op = true;
    const bool is_assignment = at.pdo == place::none;
    if (subindex == 0)
        return entry_info{.data_type = data_types::unsigned8, .bits = 8, .access = access, .name = "Highest subindex"};
    if (subindex > (is_assignment ? pdo_list::max_size : max_entries)) return {};
    if (is_assignment)
        return entry_info{.data_type = data_types::unsigned16, .bits = 16, .access = access, .name = "PDO"};
    return entry_info{.data_type = data_types::unsigned32, .bits = 32, .access = access, .name = "Mapped object"};
}

} // namespace jauscat::ethercat
