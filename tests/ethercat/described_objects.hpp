// Objects that describe themselves, for the slaves of these tests.
#pragma once

#include <jauscat/ethercat/slave/object_dictionary.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace jauscat::test {

/// Variables of 4 bytes at 2000h (can be mapped into outputs), 2001h (into inputs), 2002h (stored) and 2003h (a
/// setting, written in PRE-OP only), and a record of 3, 5, 16 and 1 bits at 3000h.
class described_objects {
  public:
    std::map<std::pair<std::uint16_t, std::uint8_t>, std::vector<std::byte>> values{
        {{0x2000, 0}, bytes(4)},      {{0x2001, 0}, bytes(4)},
        {{0x2002, 0}, bytes(4)},      {{0x2003, 0}, bytes(4)},
        {{0x3000, 0}, {bytes(1, 4)}}, {{0x3000, 1}, bytes(1, 5)},
        {{0x3000, 2}, bytes(1, 5)},   {{0x3000, 3}, {std::byte{0x34}, std::byte{0x12}}},
        {{0x3000, 4}, bytes(1, 1)},
    };

    bool are_entries_named{true}; ///< also of 2000h to 2003h, which have a name themselves

    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) const noexcept {
        const auto found = values.find({index, subindex});
        if (found == values.end()) return {.error = missing(index)};
        if (found->second.size() > out.size()) return {.error = ethercat::abort_code::exceeds_mailbox};
        std::ranges::copy(found->second, out.begin());
        return {.size = found->second.size()};
    }
    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        const auto found = values.find({index, subindex});
        if (found == values.end()) return missing(index);
        if (index == 0x3000 && subindex == 0) return ethercat::abort_code::read_only;
        if (found->second.size() != data.size()) return ethercat::abort_code::length_mismatch;
        std::ranges::copy(data, found->second.begin());
        return ethercat::abort_code::none;
    }

    [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept {
        const auto next = values.upper_bound({after, std::uint8_t{0xFF}});
        return next == values.end() ? std::uint16_t{} : next->first.first;
    }
    [[nodiscard]] std::optional<ethercat::object_info> describe(std::uint16_t index) const noexcept {
        if (missing(index) == ethercat::abort_code::no_object) return {};
        if (index != 0x3000)
            return ethercat::object_info{.data_type = 7, .code = ethercat::object_code::variable, .name = "gain"};
        return ethercat::object_info{
            .highest_subindex = 4, .code = ethercat::object_code::record, .name = "mixture", .complete_access = true};
    }
    [[nodiscard]] std::optional<ethercat::entry_info> describe(std::uint16_t index,
                                                               std::uint8_t subindex) const noexcept {
        if (!values.contains({index, subindex})) return {};
        if (index == 0x3000) {
            constexpr std::array<std::uint16_t, 5> bits{8, 3, 5, 16, 1};
            if (subindex == 0) return ethercat::highest_subindex_info;
            return ethercat::entry_info{
                .data_type = 5, .bits = bits[subindex], .access = ethercat::accessible_always, .name = "part"};
        }
        ethercat::entry_info entry{
            .data_type = 7, .bits = 32, .access = ethercat::accessible_always, .name = are_entries_named ? "gain" : ""};
        entry.access.rx_pdo = index == 0x2000;
        entry.access.tx_pdo = index == 0x2001;
        entry.access.backup = index == 0x2002;
        entry.access.setting = index == 0x2003;
        if (index == 0x2003) entry.access.write_safe_op = entry.access.write_op = false;
        return entry;
    }

  private:
    static std::vector<std::byte> bytes(std::size_t size, unsigned value = 0) {
        return std::vector<std::byte>(size, static_cast<std::byte>(value));
    }
    [[nodiscard]] ethercat::abort_code missing(std::uint16_t index) const noexcept {
        return values.contains({index, std::uint8_t{}}) ? ethercat::abort_code::no_subindex
                                                        : ethercat::abort_code::no_object;
    }
};

} // namespace jauscat::test
