// The slaves that a master has brought up, in no particular order; memory for all of them.
#pragma once

#include <jauscat/ethercat/master/process_image.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Up to slave_capacity records, found by station address.
class slave_list {
  public:
    /// All of them, in no particular order.
    [[nodiscard]] std::span<const slave_record> all() const noexcept { return std::span{records_}.first(count_); }
    /// Whether the list is full.
    [[nodiscard]] bool full() const noexcept { return count_ == records_.size(); }

    /// By its station address; nullptr where there is none.
    [[nodiscard]] slave_record* find(std::uint16_t station) noexcept {
        const auto known = std::span{records_}.first(count_);
        const auto found = std::ranges::find(known, station, &slave_record::station);
        return found == known.end() ? nullptr : &*found;
    }
    /// By its station address; nullptr where there is none.
    [[nodiscard]] const slave_record* find(std::uint16_t station) const noexcept {
        const auto found = std::ranges::find(all(), station, &slave_record::station);
        return found == all().end() ? nullptr : &*found;
    }

    void clear() noexcept { count_ = 0; }
    /// Removes the slave with this position or this station address.
    void remove(std::uint16_t position, std::uint16_t station) noexcept {
        const auto known = std::span{records_}.first(count_);
        const auto gone = [&](const slave_record& s) { return s.position == position || s.station == station; };
        count_ = static_cast<std::size_t>(std::remove_if(known.begin(), known.end(), gone) - known.begin());
    }
    /// Only while it is not full.
    void add(const slave_record& record) noexcept { records_[count_++] = record; }

    /// The process image of all slaves but one.
    [[nodiscard]] process_image image_without(const slave_record& slave) const noexcept {
        auto others = *this;
        others.remove(slave.position, slave.station);
        return process_image::of(others.all());
    }

  private:
    std::array<slave_record, slave_capacity> records_{};
    std::size_t count_{};
};

} // namespace jauscat::ethercat
