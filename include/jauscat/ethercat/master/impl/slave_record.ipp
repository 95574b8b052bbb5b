// The functions of slave_record.
#pragma once
#include <jauscat/ethercat/master/slave_record.hpp>

namespace jauscat::ethercat {

JAUSCAT_CONSTEXPR void emergency_log::note(const coe_emergency& emergency) noexcept {
    if (count_ == capacity) {
        std::ranges::copy(std::span{kept_}.subspan(1), kept_.begin());
        --count_;
        overflow_ = true;
    }
    kept_[count_++] = emergency;
}

JAUSCAT_CONSTEXPR std::span<const coe_emergency> emergency_log::kept() const noexcept {
    return std::span{kept_}.first(count_);
}

JAUSCAT_CONSTEXPR bool identity_check::accepts(const sii_identity& found) const noexcept {
    const auto same = [](const auto& wanted, std::uint32_t value) { return !wanted || *wanted == value; };
    return same(vendor, found.vendor) && same(product, found.product) && same(revision, found.revision) &&
           same(serial, found.serial);
}

JAUSCAT_CONSTEXPR std::uint32_t process_place::end() const noexcept {
    return size() != 0 ? output_address + output_size + input_size : 0;
}

JAUSCAT_CONSTEXPR void slave_record::return_mailbox(const slave_record& from) noexcept {
    last_counter = from.last_counter;
    last_reply_mark = from.last_reply_mark;
    awaits_late_answer = from.awaits_late_answer;
    drained = from.drained;
    unfinished = from.unfinished;
    emergencies = from.emergencies;
    is_lent = false;
}

} // namespace jauscat::ethercat
