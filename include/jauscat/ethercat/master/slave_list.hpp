// The slaves that a master has brought up, in no particular order, in memory lent by the user.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Memory for the records of up to `Slaves` slaves.
template <std::size_t Slaves> struct slave_memory {
    std::array<slave_record, Slaves> records{};

    constexpr operator std::span<slave_record>() noexcept { return records; }
};

/// Records found by station address. A slave that is `away` could not be brought up again: it may still use its place
/// in the process image, so its record stays.
class slave_list {
  public:
    /// `memory` outlives the list.
    explicit slave_list(std::span<slave_record> memory) noexcept : memory_{memory} {}
    slave_list(const slave_list&) = delete;
    slave_list& operator=(const slave_list&) = delete;

    /// Those that were brought up, in no particular order.
    [[nodiscard]] std::span<const slave_record> all() const noexcept { return memory_.first(count_); }
    [[nodiscard]] std::span<slave_record> all() noexcept { return memory_.first(count_); }
    [[nodiscard]] std::span<const slave_record> away() const noexcept { return memory_.last(away_); }
    [[nodiscard]] std::size_t capacity() const noexcept { return memory_.size(); }
    /// Whether there is no memory for another record.
    [[nodiscard]] bool full() const noexcept { return count_ + away_ == memory_.size(); }

    /// By its station address; nullptr where there is none.
    [[nodiscard]] slave_record* find(std::uint16_t station) noexcept { return find(memory_.first(count_), station); }
    /// By its station address; nullptr where there is none.
    [[nodiscard]] JAUSCAT_FUNCTION const slave_record* find(std::uint16_t station) const noexcept;
    /// The same among those that are away.
    [[nodiscard]] JAUSCAT_FUNCTION const slave_record* find_away(std::uint16_t station) const noexcept;

    void clear() noexcept { count_ = away_ = 0; }
    /// Removes the slaves with this position or this station address, also those that are away.
    JAUSCAT_FUNCTION void remove(std::uint16_t position, std::uint16_t station) noexcept;
    /// Only while it is not full.
    void add(const slave_record& record) noexcept { memory_[count_++] = record; }
    /// Only while it is not full.
    void add_away(const slave_record& record) noexcept { memory_[memory_.size() - ++away_] = record; }

    /// Where the process image ends: that of all slaves but `one`, those that are away included.
    [[nodiscard]] JAUSCAT_FUNCTION std::uint32_t image_end(const slave_record* one = nullptr) const noexcept;

  private:
    JAUSCAT_FUNCTION static slave_record* find(std::span<slave_record> records, std::uint16_t station) noexcept;

    std::span<slave_record> memory_;
    std::size_t count_{}; // at the front
    std::size_t away_{};  // at the back
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/slave_list.ipp>
#endif
