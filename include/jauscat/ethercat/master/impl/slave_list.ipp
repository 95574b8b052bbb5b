// The functions of slave_list.
#pragma once
#include <jauscat/ethercat/master/slave_list.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION const slave_record* slave_list::find(std::uint16_t station) const noexcept {
    return find(memory_.first(count_), station);
}

JAUSCAT_FUNCTION const slave_record* slave_list::find_away(std::uint16_t station) const noexcept {
    return find(memory_.last(away_), station);
}

JAUSCAT_FUNCTION void slave_list::remove(std::uint16_t position, std::uint16_t station) noexcept {
    const auto gone = [&](const slave_record& s) { return s.position == position || s.station == station; };
    const auto known = memory_.first(count_);
    count_ = static_cast<std::size_t>(std::remove_if(known.begin(), known.end(), gone) - known.begin());
    for (std::size_t i = memory_.size() - away_; i != memory_.size(); ++i)
        if (gone(memory_[i])) memory_[i] = memory_[memory_.size() - away_--];
}

JAUSCAT_FUNCTION std::uint32_t slave_list::image_end(const slave_record* one) const noexcept {
    std::uint32_t end = 0;
    const auto add = [&](const slave_record& each) {
        if (&each != one) end = std::max(end, each.process_data.end());
    };
    std::ranges::for_each(all(), add);
    std::ranges::for_each(away(), add);
    return end;
}

JAUSCAT_FUNCTION slave_record* slave_list::find(std::span<slave_record> records, std::uint16_t station) noexcept {
    const auto found = std::ranges::find(records, station, &slave_record::station);
    return found == records.end() ? nullptr : &*found;
}

} // namespace jauscat::ethercat
