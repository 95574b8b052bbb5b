// An object dictionary for fuzzing: reads of many sizes, refusals of several kinds, and a record of what was written.
#pragma once
#include "target.hpp"
#include <jauscat/ethercat/slave/object_dictionary.hpp>
#include <jauscat/ethercat/slave/sii_image.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>

#include <array>
#include <functional>

namespace fuzz {

inline constexpr std::array process_entries{jauscat::ethercat::pdo_entry{0x7000, 1, 16, 6, "word"},
                                            jauscat::ethercat::pdo_entry{0x7000, 2, 3, 5, "bits"}};

/// A slave like the one of the captures, with process data and some things changed.
inline jauscat::ethercat::slave_description description(std::uint8_t options) {
    using namespace jauscat::ethercat;
    return {.vendor = 1,
            .product = 2,
            .station_alias = static_cast<std::uint16_t>((options & 1) * 7),
            .mailbox_out_size = 128,
            .mailbox_in_offset = 0x1400,
            .mailbox_in_size = static_cast<std::uint16_t>((options & 2) != 0 ? min_mailbox_size : 128),
            .eight_byte_sii_reads = (options & 4) != 0,
            .outputs = process_entries,
            .inputs = process_entries};
}

/// Object `index`:`subindex` has 4 * subindex bytes. Odd indices cannot be written, and none above 8000h exists.
class objects {
  public:
    std::size_t reads{}, writes{};
    byte_vector last_written{};
    std::function<void()> on_access{[] {}};

    jauscat::ethercat::object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        using jauscat::ethercat::abort_code;
        ++reads;
        on_access();
        const std::size_t size = std::size_t{subindex} * 4;
        if (index > 0x8000) return {.error = abort_code::no_object};
        if (index >= 0x1C10 && index < 0x1C30) return {.error = abort_code::no_object}; // the SII has the process data
        if (size > out.size()) return {.error = abort_code::exceeds_mailbox};
        std::ranges::fill(out.first(size), static_cast<std::byte>(index));
        return {.size = size};
    }
    jauscat::ethercat::abort_code write(std::uint16_t index, std::uint8_t, std::span<const std::byte> data) noexcept {
        using jauscat::ethercat::abort_code;
        on_access();
        if (index > 0x8000) return abort_code::no_object;
        if (index % 2 != 0) return abort_code::read_only;
        ++writes;
        last_written = copy_of(data);
        return abort_code::none;
    }
};

} // namespace fuzz
