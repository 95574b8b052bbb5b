// The functions of sii_name.
#pragma once
#include <jauscat/ethercat/master/sii_name.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION void sii_name::request(frame_builder& frame) const noexcept {
    switch (step_) {
    case step::take_sii: return ethercat::take_sii(frame, station_);
    case step::give_sii: return ethercat::give_sii(frame, station_);
    case step::category:
    case step::general:
    case step::strings: sii_.request(frame, station_);
    }
}

JAUSCAT_FUNCTION progress sii_name::reply(replies datagrams, time_point now, const master_config& config) noexcept {
    if (result_ = executed_by_one(datagrams); !result_) return progress::done;
    if (step_ == step::take_sii) return read(step::category, sii_words::categories);
    if (step_ == step::give_sii) {
        if (failure_ != master_error{}) result_ = failure_;
        return progress::done;
    }
    const auto after = sii_.reply(datagrams.front(), now, config);
    if (after != progress::done) return after;
    if (!sii_.result()) return end(sii_.result().error());
    switch (step_) {
    case step::category: return category_read();
    case step::general: {
        constexpr std::size_t name = 3;
        wanted_ = std::to_integer<unsigned>(buffer_[name]);
        if (wanted_ == 0) return end();
        return strings_ != 0 ? find_string() : next_category();
    }
    default: return strings_read();
    }
}

JAUSCAT_FUNCTION progress sii_name::read(step next, std::uint32_t word) noexcept {
    step_ = next;
    word_ = word;
    sii_ = sii_read{word, buffer_};
    return progress::send;
}

JAUSCAT_FUNCTION progress sii_name::category_read() noexcept {
    sii_category_header header{};
    static_cast<void>(wire::decode_prefix(header, buffer_));
    const std::uint32_t content = word_ + wire::max_size<sii_category_header> / 2;
    end_ = content + header.words;
    if (header.category == sii_category::end) return end();
    if (header.category == sii_category::strings) {
        strings_ = content;
        strings_end_ = end_;
        if (wanted_ != 0) return find_string();
    }
    constexpr std::uint32_t words_to_name = 2;
    if (header.category == sii_category::general && header.words >= words_to_name) return read(step::general, content);
    return next_category();
}

JAUSCAT_FUNCTION progress sii_name::next_category() noexcept {
    if (++categories_ > max_categories || end_ >= sii_end)
        return end({.code = master_errc::sii_malformed, .sii_word = end_});
    return read(step::category, end_);
}

JAUSCAT_FUNCTION progress sii_name::find_string() noexcept { return read(step::strings, strings_); }

JAUSCAT_FUNCTION progress sii_name::strings_read() noexcept {
    for (const auto each : buffer_) {
        if (left_ != 0) {
            --left_;
            if (passed_ == wanted_ && name_.size != name_.characters.size())
                name_.characters[name_.size++] = static_cast<char>(each);
        } else if (!is_counted_) {
            is_counted_ = true;
            if (std::to_integer<unsigned>(each) < wanted_) return end();
        } else {
            ++passed_;
            left_ = std::to_integer<unsigned>(each);
        }
        if (passed_ == wanted_ && left_ == 0) return end();
    }
    const auto next = word_ + static_cast<std::uint32_t>(buffer_.size() / 2);
    if (next >= strings_end_) return end({.code = master_errc::sii_malformed, .sii_word = next});
    return read(step::strings, next);
}

JAUSCAT_FUNCTION progress sii_name::end(const master_error& why) noexcept {
    failure_ = why;
    step_ = step::give_sii;
    return progress::send;
}

} // namespace jauscat::ethercat
