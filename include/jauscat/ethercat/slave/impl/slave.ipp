// The functions of slave.
#pragma once
#include <jauscat/ethercat/slave/slave.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION slave::slave(const slave_description& description, object_dictionary objects,
                              const coe_options& options) noexcept
    : description_{description},
      mailbox_{description, objects, options},
      sii_{make_sii_image(description,
                          {.sdo_information = objects.is_described(), .complete_access = objects.is_described()})},
      process_data_{description} {
    if (!description.sii.empty()) {
        const auto kept = description.sii.first(std::min(description.sii.size(), sii_image::max_size));
        sii_ = {};
        std::ranges::fill(sii_.whole(), std::byte{0xFF});
        std::ranges::copy(kept, sii_.whole().begin());
        sii_.fit(kept.size());
    }
    set_clock_error({});
}

JAUSCAT_FUNCTION void slave::power_on() noexcept {
    esc_.reset();
    esc_.store(esc_registers::pdi_control, {sii_pdi_control});
    sii_request sii{.eight_byte_reads = description_.eight_byte_sii_reads,
                    .two_address_bytes = std::max(sii_.size(), description_.sii.size()) > 2048};
    load_configuration(sii);
    esc_.store(esc_registers::sii_request, sii);
    mailbox_.power_on(esc_);
    process_data_.power_on(esc_);
    sync0_count_ = 0;
    report_ = {};
}

JAUSCAT_FUNCTION void slave::set_clock_error(const clock_error& error) noexcept {
    esc_.set_clock(description_.clock, error);
    power_on();
}

JAUSCAT_FUNCTION void slave::process(std::span<std::byte> frame) noexcept {
    pass(frame);
    work();
}

JAUSCAT_FUNCTION void slave::process(std::span<std::byte> frame, time_point now) noexcept {
    pass(frame, now);
    work();
}

JAUSCAT_FUNCTION void slave::pass(std::span<std::byte> frame, time_point now) noexcept {
    pass_time(now);
    esc_.pass(frame, now);
}

JAUSCAT_FUNCTION void slave::pass_time(time_point now) noexcept {
    if (!esc_.has_clock()) return;
    esc_.clock().advance(now);
    const auto count = esc_.clock().take_sync0();
    sync0_count_ += count;
    const auto& activation = esc_.clock().activation();
    report_.type = !activation.on || !activation.sync0 ? sync_type::free_run
                   : activation.sync1                  ? sync_type::sync1
                                                       : sync_type::sync0;
    report_.sync0_cycle = report_.type == sync_type::free_run ? 0 : esc_.load(esc_registers::dc_sync0_cycle).value;
    if (state() != al_state::op) return;
    process_data_.on_sync0(count);
    report_.missed = static_cast<std::uint16_t>(std::min<std::uint64_t>(process_data_.sync_missed(), 0xFFFF));
    report_.error = process_data_.missed_in_row() != 0;
    const auto limit = description_.sync_missed_limit;
    if (limit != 0 && process_data_.missed_in_row() >= limit) leave_op(al_status_code::synchronization);
}

JAUSCAT_FUNCTION void slave::work() noexcept {
    if (esc_.take_al_control()) change_state();
    if (esc_.take_sii_command()) access_sii();
    process_data_.work(esc_, state());
    if (state() != al_state::init) mailbox_.work(esc_);
}

JAUSCAT_FUNCTION void slave::on_time(time_point now) noexcept {
    if (state() != al_state::op || !process_data_.expired(esc_, now)) return;
    leave_op(al_status_code::sync_manager_watchdog);
}

JAUSCAT_FUNCTION std::uint16_t slave::station_address() const noexcept {
    return esc_.load(esc_registers::station_address).value;
}

JAUSCAT_FUNCTION void slave::leave_op(al_status_code why) noexcept {
    const al_status lost{.state = al_state::safe_op, .error = true, .code = why};
    esc_.store(esc_registers::al_status, lost);
    mailbox_.set_state(lost.state);
}

JAUSCAT_FUNCTION void slave::change_state() noexcept {
    const auto control = esc_.load(esc_registers::al_control);
    auto changed = status();
    const auto before = changed.state;
    if (changed.error && !control.acknowledge && control.state > changed.state) return;
    const bool from_init = changed.state == al_state::init;
    changed.error = false;
    changed.code = refusal(changed.state, control.state);
    if (changed.code == al_status_code::none) {
        changed.state = control.state;
    } else {
        changed.error = true;
    }
    changed.device_id_loaded = control.request_device_id && description_.device_id && !changed.error;
    if (changed.device_id_loaded) changed.code = static_cast<al_status_code>(*description_.device_id);
    if (from_init || changed.state == al_state::init) mailbox_.forget(esc_);
    esc_.store(esc_registers::al_status, changed);
    if (changed.state != before) enter(changed.state); // a request that changes nothing does not feed the watchdog
}

JAUSCAT_FUNCTION void slave::enter(al_state state) noexcept {
    process_data_.enter(esc_, state);
    mailbox_.set_state(state);
}

JAUSCAT_FUNCTION al_status_code slave::refusal(al_state from, al_state to) noexcept {
    switch (to) {
    case al_state::init: return al_status_code::none;
    case al_state::boot: return al_status_code::boot_not_supported;
    case al_state::pre_op:
        if (from != al_state::init) return al_status_code::none;
        return mailbox_.is_configured(esc_) ? al_status_code::none : al_status_code::mailbox_pre_op;
    case al_state::safe_op:
        if (from == al_state::init) return al_status_code::invalid_state_change;
        if (from == al_state::op) return al_status_code::none;
        if (needs_sync() && !makes_sync0()) return al_status_code::dc_sync_configuration;
        return process_data_.refusal(esc_);
    case al_state::op:
        if (from != al_state::safe_op && from != al_state::op) return al_status_code::invalid_state_change;
        if (needs_sync() && (!makes_sync0() || esc_.clock().activation_status().sync0_pending))
            return al_status_code::no_sync;
        return process_data_.refusal(esc_);
    }
    return al_status_code::unknown_state;
}

JAUSCAT_FUNCTION bool slave::makes_sync0() const noexcept {
    return esc_.clock().activation().on && esc_.clock().activation().sync0;
}

JAUSCAT_FUNCTION void slave::access_sii() noexcept {
    auto access = esc_.load(esc_registers::sii_access);
    auto& request = access.request;
    const std::size_t at = std::size_t{request.address} * 2;
    switch (request.cmd) {
    case sii_command::read:
        for (std::size_t i = 0; i != (description_.eight_byte_sii_reads ? 8 : 4); ++i)
            access.data[i] = sii_byte(at + i);
        break;
    case sii_command::write:
        request.write_enable_error = !request.write_enable;
        request.command_error = at >= sii_.size();
        if (!request.write_enable_error && !request.command_error)
            std::ranges::copy_n(access.data.begin(), 2, sii_.whole().begin() + static_cast<std::ptrdiff_t>(at));
        break;
    case sii_command::reload: load_configuration(request); break;
    default: request.command_error = true;
    }
    request.busy = request.write_enable = false;
    request.cmd = sii_command::clear;
    esc_.store(esc_registers::sii_access, access);
}

JAUSCAT_FUNCTION std::byte slave::sii_byte(std::size_t at) const noexcept {
    if (at < sii_.size()) return sii_[at];
    return at < description_.sii.size() ? description_.sii[at] : std::byte{0xFF};
}

JAUSCAT_FUNCTION void slave::load_configuration(sii_request& status) noexcept {
    const std::span words{sii_.data(), sii_configuration_checked + 2};
    sii_configuration loaded{};
    static_cast<void>(wire::decode(loaded, words));
    status.checksum_error = (loaded.checksum & 0xFF) != sii_checksum(words.first(sii_configuration_checked));
    esc_.store(esc_registers::station_alias, {status.checksum_error ? std::uint16_t{} : loaded.station_alias});
}

} // namespace jauscat::ethercat
