// The functions of slave_setup.
#pragma once
#include <jauscat/ethercat/master/slave_setup.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION slave_setup::slave_setup(slave_record& slave, std::uint32_t& image_end,
                                          std::chrono::nanoseconds watchdog, std::uint32_t logical_base,
                                          std::span<process_object> objects) noexcept
    : slave_{&slave}, setup_{slave, image_end, watchdog, logical_base, objects} {
    slave.watchdog = {};
}

JAUSCAT_FUNCTION std::size_t slave_setup::request_size() const noexcept {
    return uploads_ ? upload_.request_size() : setup_.request_size();
}

JAUSCAT_FUNCTION void slave_setup::request(frame_builder& frame) noexcept {
    if (uploads_)
        upload_.request(frame);
    else
        setup_.request(frame);
}

JAUSCAT_FUNCTION progress slave_setup::reply(replies datagrams, time_point now, const master_config& config) noexcept {
    auto next = uploads_ ? upload_.reply(datagrams, now, config) : setup_.reply(datagrams, now, config);
    if (uploads_ && next == progress::done) {
        uploads_ = false;
        next = setup_.uploaded(upload_.result());
    }
    if (next != progress::done && !uploads_ && setup_.wants_upload()) {
        uploads_ = true;
        upload_ = {};
        upload_.begin(*slave_, setup_.upload());
    }
    if (next == progress::done && setup_.result()) {
        slave_->process_data = setup_.place();
        slave_->watchdog = setup_.watchdog();
    }
    return next;
}

JAUSCAT_FUNCTION void slave_setup::lost() noexcept {
    if (uploads_) upload_.lost();
}

} // namespace jauscat::ethercat
