// Objects of an emulated slave that hold what a master writes to them.
#pragma once
#include <jauscat/ethercat/slave/object_dictionary.hpp>
#include <jauscat/ethercat/slave/pdo_entry.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace example {

namespace ethercat = jauscat::ethercat;

/// Models ethercat::described_object_source. Entries take and give their own size only. An object with a subindex above
/// 0 is a record, and its subindex 0 the highest one; any other is a variable.
class stored_objects {
  public:
    /// Called after each write.
    std::function<void(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data)> on_write{};

    /// An entry that can be read and written.
    void add(std::uint16_t index, std::uint8_t subindex, std::size_t size) {
        auto& made = entries_[{index, subindex}];
        made.value.resize(size);
        made.type = size == 1   ? ethercat::data_types::unsigned8
                    : size == 2 ? ethercat::data_types::unsigned16
                    : size == 4 ? ethercat::data_types::unsigned32
                                : octet_string;
        made.bits = static_cast<std::uint16_t>(std::min<std::size_t>(size * 8, 0xFFFF));
        made.access = ethercat::accessible_always;
        made.name = "value of " + std::to_string(size) + " bytes";
    }
    /// The objects that are mapped into process data, which stand in `memory`: they can be read.
    void add_mapped(std::span<const ethercat::pdo_entry> pdo, std::span<const std::byte> memory, bool outputs) {
        for (const auto& each : pdo) {
            auto& made = entries_[{each.index, each.subindex}];
            made.mapped = memory.first(each.bits / 8u);
            memory = memory.subspan(each.bits / 8u);
            made.type = each.data_type;
            made.bits = each.bits;
            made.access = ethercat::readable_always;
            (outputs ? made.access.rx_pdo : made.access.tx_pdo) = true;
            made.name = each.name;
        }
    }
    /// Bytes of the largest object with all its entries.
    [[nodiscard]] std::size_t largest() const {
        std::map<std::uint16_t, std::size_t> sizes;
        for (const auto& [place, each] : entries_) sizes[place.first] += each.value.size() + 2;
        std::size_t most = 0;
        for (const auto& [index, size] : sizes) most = std::max(most, size);
        return most;
    }

    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) const noexcept {
        const auto* const found = find(index, subindex);
        if (found == nullptr && subindex == 0 && exists(index)) {
            if (out.empty()) return {.error = ethercat::abort_code::exceeds_mailbox};
            out.front() = static_cast<std::byte>(highest(index));
            return {.size = 1};
        }
        if (found == nullptr) return {.error = missing(index)};
        const auto value = found->mapped.empty() ? std::span<const std::byte>{found->value} : found->mapped;
        if (value.size() > out.size()) return {.error = ethercat::abort_code::exceeds_mailbox};
        std::ranges::copy(value, out.begin());
        return {.size = value.size()};
    }
    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        const auto found = entries_.find({index, subindex});
        if (found == entries_.end())
            return subindex == 0 && exists(index) ? ethercat::abort_code::read_only : missing(index);
        if (!is_writable(found->second.access)) return ethercat::abort_code::read_only;
        if (found->second.value.size() != data.size()) return ethercat::abort_code::length_mismatch;
        std::ranges::copy(data, found->second.value.begin());
        if (on_write) on_write(index, subindex, data);
        return ethercat::abort_code::none;
    }

    [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept {
        const auto next = entries_.upper_bound({after, std::uint8_t{0xFF}});
        return next == entries_.end() ? std::uint16_t{} : next->first.first;
    }
    [[nodiscard]] std::optional<ethercat::object_info> describe(std::uint16_t index) const noexcept {
        if (!exists(index)) return {};
        const auto* const variable = find(index, 0);
        if (variable != nullptr)
            return ethercat::object_info{
                .data_type = variable->type, .code = ethercat::object_code::variable, .name = variable->name};
        const auto last = highest(index);
        std::size_t count = 0;
        for (auto at = entries_.lower_bound({index, std::uint8_t{}}); at != entries_.end() && at->first.first == index;
             ++at)
            ++count;
        return ethercat::object_info{.highest_subindex = last,
                                     .code = ethercat::object_code::record,
                                     .name = "record",
                                     .complete_access = count == last};
    }
    [[nodiscard]] std::optional<ethercat::entry_info> describe(std::uint16_t index,
                                                               std::uint8_t subindex) const noexcept {
        const auto* const found = find(index, subindex);
        if (found == nullptr)
            return subindex == 0 && exists(index) ? std::optional{ethercat::highest_subindex_info} : std::nullopt;
        return ethercat::entry_info{
            .data_type = found->type, .bits = found->bits, .access = found->access, .name = found->name};
    }

  private:
    static constexpr std::uint16_t octet_string = 0x000A;

    struct entry {
        std::vector<std::byte> value{};
        std::span<const std::byte> mapped{}; // in place of a value
        std::uint16_t type{};
        std::uint16_t bits{};
        ethercat::entry_access access{};
        std::string name{};
    };

    [[nodiscard]] const entry* find(std::uint16_t index, std::uint8_t subindex) const noexcept {
        const auto found = entries_.find({index, subindex});
        return found == entries_.end() ? nullptr : &found->second;
    }
    [[nodiscard]] bool exists(std::uint16_t index) const noexcept {
        const auto found = entries_.lower_bound({index, std::uint8_t{}});
        return found != entries_.end() && found->first.first == index;
    }
    [[nodiscard]] std::uint8_t highest(std::uint16_t index) const noexcept {
        return std::prev(entries_.upper_bound({index, std::uint8_t{0xFF}}))->first.second;
    }
    [[nodiscard]] ethercat::abort_code missing(std::uint16_t index) const noexcept {
        return exists(index) ? ethercat::abort_code::no_subindex : ethercat::abort_code::no_object;
    }

    std::map<std::pair<std::uint16_t, std::uint8_t>, entry> entries_{};
};

} // namespace example
