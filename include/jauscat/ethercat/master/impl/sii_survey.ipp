// The functions of sii_survey.
#pragma once
#include <jauscat/ethercat/master/sii_survey.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION std::span<const process_manager> sii_survey::managers() const noexcept {
    return std::span{managers_}.first(count_);
}

JAUSCAT_FUNCTION progress sii_survey::reply(const datagram_view& datagram, time_point now,
                                            const master_config& config) noexcept {
    const auto after = sii_.reply(datagram, now, config);
    if (after != progress::done) return after;
    if (result_ = sii_.result(); !result_) return progress::done;
    switch (step_) {
    case step::category: return category_read();
    case step::general: return flags_read();
    case step::sync_manager: return sync_manager_read();
    case step::pdo: return pdo_read();
    default: return pdo_entry_read();
    }
}

JAUSCAT_FUNCTION progress sii_survey::read(step next, std::uint32_t word, std::size_t bytes) noexcept {
    step_ = next;
    word_ = word;
    sii_ = sii_read{word, std::span{buffer_}.first(bytes)};
    return progress::send;
}

JAUSCAT_FUNCTION progress sii_survey::fail(const master_error& error) noexcept {
    result_ = error;
    return progress::done;
}

JAUSCAT_FUNCTION progress sii_survey::category_read() noexcept {
    sii_category_header header{};
    static_cast<void>(wire::decode_prefix(header, buffer_));
    const std::uint32_t content = word_ + wire::max_size<sii_category_header> / 2;
    end_ = content + header.words;
    switch (header.category) {
    case sii_category::end: return finish();
    case sii_category::general: {
        constexpr std::uint32_t words_before_flags = 5;
        if (header.words <= words_before_flags) return next_category();
        return read(step::general, content + words_before_flags, 2);
    }
    case sii_category::sync_manager: return next_sync_manager(content);
    case sii_category::rx_pdo:
    case sii_category::tx_pdo:
        described_ = true;
        is_output_ = header.category == sii_category::rx_pdo;
        return sizes_ ? next_pdo(content) : next_category();
    default: return next_category();
    }
}

JAUSCAT_FUNCTION progress sii_survey::flags_read() noexcept {
    no_lrw_ = (std::to_integer<std::uint8_t>(buffer_[1]) & sii_no_lrw) != 0; // the upper byte of the word
    return next_category();
}

JAUSCAT_FUNCTION progress sii_survey::next_category() noexcept {
    if (++categories_ > max_categories || end_ >= sii_end)
        return fail({.code = master_errc::sii_malformed, .sii_word = end_});
    return read(step::category, end_, wire::max_size<sii_category_header>);
}

JAUSCAT_FUNCTION progress sii_survey::next_sync_manager(std::uint32_t word) noexcept {
    if (word + manager_words > end_) return next_category();
    return read(step::sync_manager, word, wire::max_size<sii_sync_manager>);
}

JAUSCAT_FUNCTION progress sii_survey::sync_manager_read() noexcept {
    if (number_ == max_managers) return fail({.code = master_errc::sii_malformed, .sii_word = word_});
    process_manager found{.number = number_++};
    static_cast<void>(wire::decode_prefix(found.description, buffer_));
    if (may_carry_process_data(found.description)) {
        if (count_ == capacity) return fail({.code = master_errc::too_many_managers});
        managers_[count_++] = found;
    }
    return next_sync_manager(word_ + manager_words);
}

JAUSCAT_FUNCTION progress sii_survey::next_pdo(std::uint32_t word) noexcept {
    return word + pdo_words <= end_ ? read(step::pdo, word, wire::max_size<sii_pdo>) : next_category();
}

JAUSCAT_FUNCTION progress sii_survey::pdo_read() noexcept {
    sii_pdo pdo{};
    static_cast<void>(wire::decode_prefix(pdo, buffer_));
    entries_left_ = pdo.entries;
    objects_ += 1 + entries_left_;
    if (objects_ > max_process_objects) return fail({.code = master_errc::too_many_entries});
    carrier_ = pdo.sync_manager;
    if (carrier_ < bits_.size()) (is_output_ ? outputs_ : inputs_) |= static_cast<std::uint16_t>(1U << carrier_);
    return next_pdo_entry(word_ + pdo_words);
}

JAUSCAT_FUNCTION progress sii_survey::next_pdo_entry(std::uint32_t word) noexcept {
    if (entries_left_ == 0) return next_pdo(word);
    if (word + entry_words > end_) return fail({.code = master_errc::sii_malformed, .sii_word = word});
    return read(step::pdo_entry, word, wire::max_size<sii_pdo_entry>);
}

JAUSCAT_FUNCTION progress sii_survey::pdo_entry_read() noexcept {
    sii_pdo_entry entry{};
    static_cast<void>(wire::decode_prefix(entry, buffer_));
    // The category of SyncManagers may come later: bits are kept by number.
    if (carrier_ < bits_.size()) {
        if ((searched_ >> carrier_ & 1U) != 0)
            process_object::note(wanted_, {entry.bits, entry.subindex, entry.index}, is_output_, carrier_,
                                 bits_[carrier_]);
        bits_[carrier_] += entry.bits;
    }
    --entries_left_;
    return next_pdo_entry(word_ + entry_words);
}

JAUSCAT_FUNCTION progress sii_survey::finish() noexcept {
    for (auto& each : managers()) {
        // Without a PDO the size is the SyncManager's default length.
        if (!described_) {
            each.bits = each.description.length * 8u;
        } else if (each.number < bits_.size()) {
            each.bits = bits_[each.number];
            const bool out = (outputs_ >> each.number & 1U) != 0, in = (inputs_ >> each.number & 1U) != 0;
            if (out != in) each.carries(out);
        }
    }
    return progress::done;
}

} // namespace jauscat::ethercat
