// The functions of listed_objects.
#pragma once
#include <jauscat/bridge/listed_objects.hpp>

namespace jauscat::bridging {

JAUSCAT_FUNCTION ethercat::object_read listed_objects::read(std::uint16_t index, std::uint8_t subindex,
                                                            std::span<std::byte> out) noexcept {
    const auto* const object = find(index);
    if (object == nullptr) return {.error = ethercat::abort_code::no_object};
    if (subindex == 0) {
        if (out.empty()) return {.error = ethercat::abort_code::exceeds_mailbox};
        out.front() = static_cast<std::byte>(object->highest_subindex());
        return {.size = 1};
    }
    const auto* const entry = object->find(subindex);
    if (entry == nullptr) return {.error = ethercat::abort_code::no_subindex};
    if (!entry->readable) return {.error = ethercat::abort_code::write_only};
    const auto got = application_.read(index, subindex, out);
    if (got.error != ethercat::abort_code::none) return got;
    if (!allows(*object, *entry, got.size)) return {.error = ethercat::abort_code::length_mismatch};
    return got;
}

JAUSCAT_FUNCTION ethercat::abort_code listed_objects::write(std::uint16_t index, std::uint8_t subindex,
                                                            std::span<const std::byte> data) noexcept {
    const auto* const object = find(index);
    if (object == nullptr) return ethercat::abort_code::no_object;
    if (subindex == 0) return ethercat::abort_code::read_only;
    const auto* const entry = object->find(subindex);
    if (entry == nullptr) return ethercat::abort_code::no_subindex;
    if (!entry->writable) return ethercat::abort_code::read_only;
    if (!allows(*object, *entry, data.size()))
        return is_exact(*object) ? ethercat::abort_code::length_mismatch : ethercat::abort_code::length_too_high;
    return application_.write(index, subindex, data);
}

JAUSCAT_FUNCTION std::uint16_t listed_objects::next_index(std::uint16_t after) const noexcept {
    std::uint16_t next{};
    for (const auto& each : objects_)
        if (each.index > after && (next == 0 || each.index < next)) next = each.index;
    return next;
}

JAUSCAT_FUNCTION std::optional<ethercat::object_info> listed_objects::describe(std::uint16_t index) const noexcept {
    const auto* const object = find(index);
    if (object == nullptr) return {};
    // Subindices are ranks: most are missing, and the entries cannot be read together.
    const bool all = object->entries.size() == object->highest_subindex() && is_exact(*object);
    return ethercat::object_info{.highest_subindex = object->highest_subindex(),
                                 .code = ethercat::object_code::record,
                                 .name = object->name,
                                 .complete_access = all};
}

JAUSCAT_FUNCTION std::optional<ethercat::entry_info> listed_objects::describe(std::uint16_t index,
                                                                              std::uint8_t subindex) const noexcept {
    const auto* const object = find(index);
    if (object == nullptr) return {};
    if (subindex == 0) return ethercat::highest_subindex_info;
    const auto* const entry = object->find(subindex);
    if (entry == nullptr) return {};
    const auto bits = std::min<std::size_t>(entry->max_size * std::size_t{8}, 0xFFFF);
    const auto both = entry->readable && entry->writable;
    return ethercat::entry_info{.data_type = octet_string_type,
                                .bits = static_cast<std::uint16_t>(bits),
                                .access = both              ? ethercat::accessible_always
                                          : entry->readable ? ethercat::readable_always
                                          : entry->writable ? ethercat::writable_always
                                                            : ethercat::entry_access{},
                                .name = entry->name};
}

JAUSCAT_FUNCTION const object_description* listed_objects::find(std::uint16_t index) const noexcept {
    const auto found = std::ranges::find(objects_, index, &object_description::index);
    return found != objects_.end() ? &*found : nullptr;
}

JAUSCAT_FUNCTION bool listed_objects::is_exact(const object_description& object) const noexcept {
    return object.exact_size || sizes_ == size_rule::exact;
}

JAUSCAT_FUNCTION bool listed_objects::allows(const object_description& object, const sub_object& entry,
                                             std::size_t size) const noexcept {
    return is_exact(object) ? size == entry.max_size : size <= entry.max_size;
}

} // namespace jauscat::bridging
