// The functions of mapped_objects.
#pragma once
#include <jauscat/ethercat/slave/mapped_objects.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION object_read mapped_objects::read(std::uint16_t index, std::uint8_t subindex,
                                                  std::span<std::byte> out) noexcept {
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

JAUSCAT_FUNCTION abort_code mapped_objects::write(std::uint16_t index, std::uint8_t subindex,
                                                  std::span<const std::byte> data) noexcept {
    if (!has(index)) return application_.write(index, subindex, data);
    return subindex == 0 || find(index, subindex).entry != nullptr ? abort_code::read_only : abort_code::no_subindex;
}

JAUSCAT_FUNCTION std::uint16_t mapped_objects::next_index(std::uint16_t after) const noexcept {
    auto next = application_.next_index(after);
    for (const auto entries : {outputs_, inputs_})
        for (const auto& each : entries)
            if (each.index > after && (next == 0 || each.index < next)) next = each.index;
    return next;
}

JAUSCAT_FUNCTION std::optional<object_info> mapped_objects::describe(std::uint16_t index) const noexcept {
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

JAUSCAT_FUNCTION std::optional<entry_info> mapped_objects::describe(std::uint16_t index,
                                                                    std::uint8_t subindex) const noexcept {
    if (!has(index)) return application_.describe(index, subindex);
    const auto at = find(index, subindex);
    if (at.entry == nullptr) return subindex == 0 ? std::optional{highest_subindex_info} : std::nullopt;
    auto access = readable_always;
    (is_output(index) ? access.rx_pdo : access.tx_pdo) = true;
    return entry_info{
        .data_type = at.entry->data_type, .bits = at.entry->bits, .access = access, .name = at.entry->name};
}

} // namespace jauscat::ethercat
