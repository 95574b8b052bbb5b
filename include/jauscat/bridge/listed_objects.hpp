// Object dictionary of a slave, generated from object lists: objects, sizes, access rights. The application handles
// reads and writes.
#pragma once
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/ethercat/slave/object_dictionary.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::bridging {

/// Which sizes an object takes and gives.
enum class size_rule : std::uint8_t {
    up_to_largest, ///< any up to the largest, unless its table has fixed_length
    exact,         ///< the largest only: a strict slave, which needs a table with fixed_length
};

/// The objects of a list, in front of an application that holds what is in them. Models described_object_source: an
/// access that the list does not allow is aborted, all others reach the application. Subindex 0 is the highest
/// subindex, read only.
class listed_objects {
  public:
    /// `objects` and what `application` refers to must outlive this. The application sees indices and subindices of the
    /// list only, other than 0, with data of the sizes that `sizes` allows.
    constexpr listed_objects(std::span<const object_description> objects, ethercat::object_dictionary application,
                             size_rule sizes = size_rule::up_to_largest) noexcept
        : objects_{objects}, application_{application}, sizes_{sizes} {}

    /// Aborts: no_object, no_subindex, write_only, length_mismatch, those of the application.
    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
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

    /// Aborts: no_object, no_subindex, read_only, length_mismatch (exact sizes), length_too_high, those of the
    /// application.
    [[nodiscard]] ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex,
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

    [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept {
        std::uint16_t next{};
        for (const auto& each : objects_)
            if (each.index > after && (next == 0 || each.index < next)) next = each.index;
        return next;
    }
    /// A record of octet strings.
    [[nodiscard]] std::optional<ethercat::object_info> describe(std::uint16_t index) const noexcept {
        const auto* const object = find(index);
        if (object == nullptr) return {};
        // Subindices are ranks: most are missing, and the entries cannot be read together.
        const bool all = object->entries.size() == object->highest_subindex() && is_exact(*object);
        return ethercat::object_info{.highest_subindex = object->highest_subindex(),
                                     .code = ethercat::object_code::record,
                                     .name = object->name,
                                     .complete_access = all};
    }
    [[nodiscard]] std::optional<ethercat::entry_info> describe(std::uint16_t index,
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

  private:
    [[nodiscard]] const object_description* find(std::uint16_t index) const noexcept {
        const auto found = std::ranges::find(objects_, index, &object_description::index);
        return found != objects_.end() ? &*found : nullptr;
    }
    [[nodiscard]] bool is_exact(const object_description& object) const noexcept {
        return object.exact_size || sizes_ == size_rule::exact;
    }
    [[nodiscard]] bool allows(const object_description& object, const sub_object& entry,
                              std::size_t size) const noexcept {
        return is_exact(object) ? size == entry.max_size : size <= entry.max_size;
    }

    std::span<const object_description> objects_;
    ethercat::object_dictionary application_;
    size_rule sizes_;
};

} // namespace jauscat::bridging
