// All entries of an object at once, as complete access carries them: one behind the other, entries of whole bytes on
// byte borders, others packed bit by bit, subindex 0 with 16 bits. ETG.1000.6, clause 5.6.2.
#pragma once

#include <jauscat/ethercat/slave/copy_bits.hpp>
#include <jauscat/ethercat/slave/object_dictionary.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// An object from subindex 0 or 1 on. `Objects` models described_object_source.
template <class Objects> class complete_object {
  public:
    /// The object from subindex `first` (0 or 1) on.
    complete_object(Objects& objects, std::uint16_t index, std::uint8_t first) noexcept
        : objects_{objects}, index_{index}, first_{first}, info_{objects.describe(index).value_or(object_info{})} {}

    /// Whether it can be accessed as a whole: only then the other functions may be called.
    [[nodiscard]] bool is_possible() const noexcept {
        if (!info_.complete_access || info_.code == object_code::variable || first_ > 1) return false;
        return for_entries([](const place& at) {
                   const bool fits = at.subindex == 0 ? at.bits == 8 // has 16 in the transfer
                                                      : is_whole(at.bits) || at.bits <= max_bit_entry * 8;
                   return fits ? abort_code::none : abort_code::complete_access;
               }).error == abort_code::none;
    }

    /// Bytes of all entries.
    [[nodiscard]] std::size_t size() const noexcept {
        return for_entries([](const place&) { return abort_code::none; }).size;
    }

    /// Errors: exceeds_mailbox, and those of the entries.
    object_read read(std::span<std::byte> out) noexcept {
        const auto all = size();
        if (all > out.size()) return {.error = abort_code::exceeds_mailbox};
        std::ranges::fill(out.first(all), std::byte{});
        return for_entries([&](const place& at) {
            std::array<std::byte, max_bit_entry> bits{};
            const auto room = is_whole(at.bits) ? out.subspan(at.bit / 8, at.bits / 8) : std::span{bits};
            const auto got = objects_.read(index_, at.subindex, room);
            if (got.error != abort_code::none) return got.error;
            if (got.size != (at.bits + 7) / 8) return abort_code::device_incompatible;
            if (!is_whole(at.bits)) copy_bits(bits, 0, out, at.bit, at.bits);
            return abort_code::none;
        });
    }

    /// `data` are of `size()` bytes. Entries are written one by one: those before one that refuses stay written.
    /// A subindex 0 that can be written is 0 meanwhile, as mapping objects need it; any other has to be what it is.
    [[nodiscard]] abort_code write(std::span<const std::byte> data) noexcept {
        const auto count = data.empty() ? std::byte{} : data.front();
        const auto entry = objects_.describe(index_, 0);
        const bool sets_count = first_ == 0 && entry && is_writable(entry->access);
        if (first_ == 0 && !sets_count && std::to_integer<std::uint8_t>(count) != info_.highest_subindex)
            return abort_code::read_only;
        const auto error = for_entries([&](const place& at) {
                               if (at.subindex == 0) return sets_count ? write_count({}) : abort_code::none;
                               return write_entry(at, data);
                           }).error;
        return error == abort_code::none && sets_count ? write_count(count) : error;
    }

    /// Calls f(subindex) for each entry until one returns an error, and returns that.
    [[nodiscard]] abort_code for_subindices(auto&& f) const noexcept {
        return for_entries([&](const place& at) { return f(at.subindex); }).error;
    }

  private:
    static constexpr std::size_t max_bit_entry = 8; // bytes of an entry that is not of whole bytes

    struct place {
        std::uint8_t subindex{};
        std::size_t bit{}, bits{};
    };
    static constexpr bool is_whole(std::size_t bits) noexcept { return bits % 8 == 0; }

    [[nodiscard]] abort_code write_count(std::byte count) noexcept {
        return objects_.write(index_, 0, std::array{count});
    }
    [[nodiscard]] abort_code write_entry(const place& at, std::span<const std::byte> data) noexcept {
        if (is_whole(at.bits)) return objects_.write(index_, at.subindex, data.subspan(at.bit / 8, at.bits / 8));
        std::array<std::byte, max_bit_entry> bits{};
        copy_bits(data, at.bit, bits, 0, at.bits);
        return objects_.write(index_, at.subindex, std::span{bits}.first((at.bits + 7) / 8));
    }

    // Calls f(place) for each entry; `size` are the bytes of all.
    object_read for_entries(auto&& f) const noexcept {
        std::size_t bit = 0;
        for (unsigned i = first_; i <= info_.highest_subindex; ++i) {
            const auto subindex = static_cast<std::uint8_t>(i);
            const auto entry = objects_.describe(index_, subindex);
            if (!entry) return {.error = abort_code::device_incompatible};
            if (is_whole(entry->bits)) bit = (bit + 7) / 8 * 8;
            const auto error = f(place{subindex, bit, entry->bits});
            if (error != abort_code::none) return {.error = error};
            bit += subindex == 0 ? 16 : entry->bits;
        }
        return {.size = (bit + 7) / 8};
    }

    Objects& objects_;
    std::uint16_t index_;
    std::uint8_t first_;
    object_info info_; // of an object that is not there: no complete access
};

} // namespace jauscat::ethercat
