// The functions of process_plan.
#pragma once
#include <jauscat/ethercat/master/process_plan.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION process_member* process_plan::find(std::uint16_t station, const process_place& place) const noexcept {
    const auto all = slots_.first(members_);
    const auto key = key_of(station, place);
    const auto at = std::ranges::lower_bound(all, key, {}, key_of_slot);
    return at != all.end() && key_of_slot(*at) == key ? &at->member : nullptr;
}

JAUSCAT_FUNCTION void process_plan::add(const slave_record& slave) noexcept {
    slots_[members_++].member = {
        .station = slave.station, .has_mailbox = slave.mailbox.send_size != 0, .place = slave.process_data};
}

JAUSCAT_FUNCTION bool process_plan::cut(bool watches, std::size_t reserved) noexcept {
    parts_ = frames_ = 0;
    reserved_ = reserved;
    sort();
    for (std::size_t i = 0; i != members_; ++i) {
        if (!place(i, watches)) {
            frames_ = 0;
            return false;
        }
    }
    return true;
}

JAUSCAT_FUNCTION process_plan::order process_plan::key_of(std::uint16_t station, const process_place& place) noexcept {
    const bool is_empty = place.size() == 0;
    return {is_empty, is_empty ? 0 : place.output_address, station};
}

JAUSCAT_FUNCTION process_plan::order process_plan::key_of_slot(const process_slot& slot) noexcept {
    return key_of(slot.member.station, slot.member.place);
}

JAUSCAT_FUNCTION void process_plan::sort() noexcept {
    for (std::size_t i = 1; i < members_; ++i) {
        const auto moved = slots_[i].member;
        const auto at = key_of(moved.station, moved.place);
        std::size_t to = i;
        for (; to != 0 && at < key_of_slot(slots_[to - 1]); --to) slots_[to].member = slots_[to - 1].member;
        slots_[to].member = moved;
    }
}

JAUSCAT_FUNCTION bool process_plan::place(std::size_t i, bool watches) noexcept {
    const auto& added = slots_[i].member;
    const std::size_t copies = added.place.no_lrw ? 2 : 1;
    const std::size_t data = added.place.size() * copies;
    if (!watches && data != 0 && joins(added.place, data)) {
        auto& last = part(parts_ - 1);
        last.size += added.place.size();
        last.counters.add(added.place);
        ++last.members;
        frame(frames_ - 1).size += data;
        ++frame(frames_ - 1).members;
        return true;
    }
    const std::size_t needed =
        (data != 0 ? data + copies * datagram_overhead : 0) + (watches ? watch_size(added.has_mailbox) : 0);
    if (needed == 0) return true; // nothing to exchange with it
    if (frames_ == 0 || frame(frames_ - 1).size + needed > max_datagrams_size) {
        const std::size_t filler = (data == 0 ? datagram_overhead + filler_size : 0) + (frames_ == 0 ? reserved_ : 0);
        if (filler + needed > max_datagrams_size) return false;
        frame(frames_++) = {.first_part = parts_, .first_member = i, .size = filler};
    }
    auto& last = frame(frames_ - 1);
    last.size += needed;
    ++last.members;
    if (data == 0) return true;
    ++last.parts;
    auto& made = part(parts_++);
    made = {.address = added.place.output_address, .size = added.place.size(), .members = 1};
    made.counters.add(added.place);
    return true;
}

JAUSCAT_FUNCTION bool process_plan::joins(const process_place& added, std::size_t data) const noexcept {
    if (frames_ == 0 || parts_ == 0) return false;
    const auto& last = part(parts_ - 1);
    return last.address + last.size == added.output_address && last.counters.no_lrw == added.no_lrw &&
           frame(frames_ - 1).size + data <= max_datagrams_size;
}

} // namespace jauscat::ethercat
