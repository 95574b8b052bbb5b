// Objects for the slaves of these tests: sizes are exact, and any object can be given an abort code. And data for them.
#pragma once

#include <jauscat/ethercat/slave/object_dictionary.hpp>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace jauscat::test {

/// Bytes that count up from `first`.
inline std::vector<std::byte> counting(std::size_t size, unsigned first = 1) {
    std::vector<std::byte> data(size);
    for (std::size_t i = 0; i != size; ++i) data[i] = static_cast<std::byte>(first + i);
    return data;
}

struct object {
    std::vector<std::byte> value{};
    ethercat::abort_code read_abort{};
    ethercat::abort_code write_abort{};
};

class objects {
  public:
    std::map<std::pair<std::uint16_t, std::uint8_t>, object> entries{};
    std::size_t writes{};
    bool sub_0_rule{}; ///< entries of PDO mapping objects are writable only while their subindex 0 is 0

    void add(std::uint16_t index, std::uint8_t subindex, std::size_t size) {
        entries[{index, subindex}].value.resize(size);
    }

    ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        const auto found = entries.find({index, subindex});
        if (found == entries.end()) return {.error = ethercat::abort_code::no_object};
        const auto& [value, read_abort, write_abort] = found->second;
        if (read_abort != ethercat::abort_code::none) return {.error = read_abort};
        if (value.size() > out.size()) return {.error = ethercat::abort_code::exceeds_mailbox};
        std::ranges::copy(value, out.begin());
        return {.size = value.size()};
    }

    ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
        const auto found = entries.find({index, subindex});
        if (found == entries.end()) return ethercat::abort_code::no_object;
        auto& [value, read_abort, write_abort] = found->second;
        if (write_abort != ethercat::abort_code::none) return write_abort;
        if (sub_0_rule && index >= 0x1A00 && index < 0x1C00 && subindex != 0 &&
            entries.at({index, 0}).value.front() != std::byte{})
            return ethercat::abort_code::subindex_0_not_zero;
        if (value.size() != data.size()) return ethercat::abort_code::length_mismatch;
        std::ranges::copy(data, value.begin());
        ++writes;
        return ethercat::abort_code::none;
    }
};

} // namespace jauscat::test
