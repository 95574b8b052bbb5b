// The functions of process_setup.
#pragma once
#include <jauscat/ethercat/master/process_setup.hpp>

namespace jauscat::ethercat {

JAUSCAT_FUNCTION process_setup::process_setup(const slave_record& slave, std::uint32_t& image_end,
                                              std::chrono::nanoseconds watchdog, std::uint32_t logical_base,
                                              std::span<process_object> objects) noexcept
    : station_{slave.station},
      coe_{slave.mailbox.coe && slave.mailbox.receive_size != 0},
      before_{slave.process_data},
      image_end_{&image_end},
      watchdog_units_{watchdog_units(watchdog)},
      logical_base_{logical_base},
      objects_{objects} {
    process_object::forget(objects_);
}

JAUSCAT_FUNCTION std::chrono::nanoseconds process_setup::watchdog() const noexcept {
    return watchdog_time(default_watchdog_divider, watchdog_units_);
}

JAUSCAT_FUNCTION sdo_transfer process_setup::upload() noexcept {
    const auto object = about_object({});
    return sdo_transfer::upload(object.index, object.subindex, room(object.subindex));
}

JAUSCAT_FUNCTION master_error process_setup::about_object(master_error error) noexcept {
    const bool assigns = step_ == step::assignment;
    error.index = assigns ? static_cast<std::uint16_t>(0x1C10 + managed().number) : mapping_;
    error.subindex = static_cast<std::uint8_t>(assigns ? pdo_ : entry_);
    return error;
}

JAUSCAT_FUNCTION progress process_setup::uploaded(const master_result<std::size_t>& upload) noexcept {
    // Without its assignment object the SII counts for a SyncManager, and for all where there is no CoE after all.
    const auto& error = upload.error();
    const bool has_no_coe =
        error.code == master_errc::mailbox_error && (error.mailbox == mailbox_error_code::unsupported_protocol ||
                                                     error.mailbox == mailbox_error_code::service_not_supported);
    if ((error.code == master_errc::sdo_abort || has_no_coe) && step_ == step::assignment && pdo_ == 0) {
        by_sii_ |= 1U << manager_;
        if (has_no_coe) by_sii_ = ~0U, manager_ = survey_.managers().size() - 1;
        ++manager_;
        return next_manager();
    }
    if (!upload) return give_back(about_object(error));
    if (step_ == step::assignment) return assigned(number_of(*upload));
    return mapped(number_of(*upload));
}

JAUSCAT_FUNCTION std::size_t process_setup::request_size() const noexcept {
    const std::size_t managers = survey_.managers().size();
    constexpr std::size_t registers = 2 * (datagram_overhead + 16); // two reads or writes of registers
    if (step_ == step::set_up)
        return datagram_overhead + max_fmmus * esc_registers::fmmu.size +
               managers * (2 * sync_manager_size + datagram_overhead + esc_registers::fmmu.size);
    return step_ == step::check_watchdog ? registers + managers * sync_manager_size : registers;
}
JAUSCAT_FUNCTION std::size_t process_setup::request_datagrams() const noexcept {
    const std::size_t managers = survey_.managers().size();
    return step_ == step::set_up ? 1 + 3 * managers : step_ == step::check_watchdog ? 2 + managers : 2;
}

JAUSCAT_FUNCTION void process_setup::request(frame_builder& frame) noexcept {
    switch (step_) {
    case step::describe: frame.read(station_, esc_registers::description); break;
    case step::take_sii: ethercat::take_sii(frame, station_); break;
    case step::give_sii: ethercat::give_sii(frame, station_); break;
    case step::set_up: set_up(frame); break;
    case step::set_watchdog:
        frame.write(station_, esc_registers::watchdog_divider, {default_watchdog_divider});
        frame.write(station_, esc_registers::process_data_watchdog, {watchdog_units_});
        break;
    case step::check_watchdog: read_watchdog(frame); break;
    default: survey_.request(frame, station_);
    }
}

JAUSCAT_FUNCTION progress process_setup::reply(replies datagrams, time_point now,
                                               const master_config& config) noexcept {
    if (failure_ != master_error{}) return fail(failure_); // the SII is given back
    if (result_ = executed_by_one(datagrams); !result_) return progress::done;
    switch (step_) {
    case step::describe: {
        const auto controller = datagrams.front().value(esc_registers::description);
        fmmus_ = controller.fmmus;
        place_.no_lrw = controller.no_lrw;
        return go(step::take_sii);
    }
    case step::take_sii: return survey(!coe_);
    case step::give_sii: return lay_out();
    case step::set_up: return place_.output_size != 0 ? go(step::set_watchdog) : progress::done;
    case step::set_watchdog: return go(step::check_watchdog);
    case step::check_watchdog: return check_watchdog(datagrams);
    default: break;
    }
    const auto after = survey_.reply(datagrams.front(), now, config);
    if (after != progress::done) return after;
    if (!survey_.result()) return give_back(survey_.result().error());
    place_.no_lrw = place_.no_lrw || survey_.no_lrw();
    if (by_coe_) return next_manager();
    for (std::size_t i = 0; i != manager_; ++i) // what objects have said counts
        if ((by_sii_ >> i & 1U) == 0) survey_.managers()[i] = by_objects_[i];
    return go(step::give_sii);
}

JAUSCAT_FUNCTION progress process_setup::go(step next) noexcept {
    step_ = next;
    return progress::send;
}

JAUSCAT_FUNCTION progress process_setup::fail(const master_error& error) noexcept {
    result_ = error;
    return progress::done;
}

JAUSCAT_FUNCTION progress process_setup::give_back(const master_error& why) noexcept {
    failure_ = why;
    return go(step::give_sii);
}

JAUSCAT_FUNCTION progress process_setup::survey(bool sizes) noexcept {
    by_coe_ = !sizes;
    survey_ = sizes ? sii_survey{objects_, searched()} : sii_survey{false};
    survey_.begin();
    return go(step::survey);
}

// What objects have said counts.
JAUSCAT_FUNCTION std::uint32_t process_setup::searched() noexcept {
    std::uint32_t numbers = coe_ ? 0 : ~0U;
    for (std::size_t i = 0; i != survey_.managers().size(); ++i)
        if ((by_sii_ >> i & 1U) != 0) numbers |= 1U << survey_.managers()[i].number;
    return numbers;
}

JAUSCAT_FUNCTION progress process_setup::next_manager() noexcept {
    if (manager_ == survey_.managers().size()) {
        if (by_sii_ == 0) return go(step::give_sii);
        std::ranges::copy(survey_.managers(), by_objects_.begin());
        return survey(true);
    }
    managed().bits = 0;
    pdo_ = 0;
    return go(step::assignment);
}

JAUSCAT_FUNCTION progress process_setup::assigned(std::uint32_t value) noexcept {
    if (pdo_ == 0) {
        pdos_left_ = value;
        if (!takes_objects(value)) return give_back(about_object({.code = master_errc::too_many_entries}));
    } else {
        mapping_ = static_cast<std::uint16_t>(value);
        managed().carries_pdo(mapping_);
        entry_ = 0;
        if (mapping_ != 0) return go(step::mapping); // 0: a place that is not used
    }
    return next_pdo();
}

JAUSCAT_FUNCTION progress process_setup::next_pdo() noexcept {
    if (pdo_++ != pdos_left_) return go(step::assignment);
    ++manager_;
    return next_manager();
}

JAUSCAT_FUNCTION progress process_setup::mapped(std::uint32_t value) noexcept {
    if (entry_ != 0) {
        const pdo_mapping entry{.bits = static_cast<std::uint8_t>(value),
                                .subindex = static_cast<std::uint8_t>(value >> 8),
                                .index = static_cast<std::uint16_t>(value >> 16)};
        process_object::note(objects_, entry, managed().is_output(), managed().number, managed().bits);
        managed().bits += entry.bits;
    } else {
        entries_left_ = value;
        if (!takes_objects(value)) return give_back(about_object({.code = master_errc::too_many_entries}));
    }
    if (entry_++ != entries_left_) return go(step::mapping);
    return next_pdo();
}

JAUSCAT_FUNCTION bool process_setup::takes_objects(std::uint32_t more) noexcept {
    read_ += more;
    return read_ <= max_process_objects;
}

JAUSCAT_FUNCTION std::span<std::byte> process_setup::room(std::uint32_t subindex) noexcept {
    return std::span{value_}.first(subindex == 0 ? 1 : value_.size());
}

JAUSCAT_FUNCTION std::uint32_t process_setup::number_of(std::size_t size) const noexcept {
    std::uint32_t number = 0;
    for (std::size_t i = std::min(size, value_.size()); i-- != 0;)
        number = number << 8 | std::to_integer<std::uint32_t>(value_[i]);
    return number;
}

JAUSCAT_FUNCTION progress process_setup::lay_out() noexcept {
    std::uint32_t outputs = 0, inputs = 0;
    std::uint16_t used = 0;
    for (const auto& each : survey_.managers()) {
        if (each.bits == 0) continue;
        if (each.description.use == sii_sync_manager_use::none)
            return fail({.code = master_errc::no_direction, .sync_manager = each.number});
        (each.is_output() ? outputs : inputs) += each.bytes();
        ++(each.is_output() ? place_.output_managers : place_.input_managers);
        ++used;
    }
    if (used > fmmus_) return fail({.code = master_errc::no_fmmu, .fmmus = used});
    // A slave that comes back keeps its place.
    const bool same = outputs == before_.output_size && inputs == before_.input_size && before_.size() != 0;
    place_.output_address = same ? before_.output_address : *image_end_;
    if (std::size_t{outputs} + inputs > (place_.no_lrw ? max_slave_process_data_without_lrw : max_slave_process_data))
        return fail({.code = master_errc::image_full, .bytes = outputs + inputs});
    place_.input_address = place_.output_address + outputs;
    place_.output_size = static_cast<std::uint16_t>(outputs);
    place_.input_size = static_cast<std::uint16_t>(inputs);
    *image_end_ = std::max(*image_end_, place_.end());
    place_objects();
    return fmmus_ == 0 && survey_.managers().empty() ? progress::done : go(step::set_up);
}

JAUSCAT_FUNCTION void process_setup::place_objects() noexcept {
    for (auto& each : objects_) {
        for (const auto& before : survey_.managers()) {
            if (before.number == each.manager) break;
            if (before.is_output() == each.is_output) each.first_bit += before.bytes() * 8;
        }
    }
}

JAUSCAT_FUNCTION void process_setup::set_up(frame_builder& frame) const noexcept {
    auto output = place_.output_address, input = place_.input_address;
    std::size_t fmmus = 0;
    // None is left from before.
    if (fmmus_ != 0)
        frame.add(command::fpwr, station_, esc_registers::fmmu.address,
                  std::min<std::size_t>(fmmus_, max_fmmus) * esc_registers::fmmu.size);
    for (const auto& each : survey_.managers()) {
        // The SII has the register's control byte, which is its fifth.
        std::array<std::byte, wire::max_size<sync_manager>> bytes{};
        bytes[4] = static_cast<std::byte>(each.description.control);
        sync_manager settings{};
        static_cast<void>(wire::decode(settings, bytes));
        settings.start = each.description.start;
        settings.length = static_cast<std::uint16_t>(each.bytes()); // fits: see lay_out
        settings.watchdog = settings.watchdog || each.is_output();  // whatever the SII says
        if (!each.is_virtual()) {
            const auto at = nth(esc_registers::sync_manager, each.number);
            frame.write(station_, at, settings);
            settings.enable = each.bits != 0;
            if (settings.enable) frame.write(station_, at, settings);
        }
        if (each.bits == 0) continue;
        auto& address = each.is_output() ? output : input;
        frame.write(station_, nth(esc_registers::fmmu, fmmus++),
                    {.logical_start = logical_base_ + address,
                     .length = settings.length,
                     .last_bit = 7,
                     .physical_start = each.description.start,
                     .read = !each.is_output(),
                     .write = each.is_output(),
                     .enable = true});
        address += settings.length;
    }
}

JAUSCAT_FUNCTION void process_setup::read_watchdog(frame_builder& frame) const noexcept {
    frame.read(station_, esc_registers::watchdog_divider);
    frame.read(station_, esc_registers::process_data_watchdog);
    for (const auto& each : survey_.managers())
        if (each.is_output() && each.bits != 0 && !each.is_virtual())
            frame.read(station_, nth(esc_registers::sync_manager, each.number));
}

JAUSCAT_FUNCTION progress process_setup::check_watchdog(replies datagrams) noexcept {
    const auto divider = datagrams[0].value(esc_registers::watchdog_divider);
    const auto units = datagrams[1].value(esc_registers::process_data_watchdog);
    const bool triggered = std::ranges::all_of(datagrams.subspan(2), [](const datagram_view& datagram) {
        const auto settings = datagram.value(esc_registers::sync_manager);
        return settings.watchdog && settings.enable;
    });
    if (triggered && divider.value == default_watchdog_divider && units.value == watchdog_units_) return progress::done;
    return fail(
        {.code = master_errc::watchdog_not_kept, .watchdog_divider = divider.value, .watchdog_units = units.value});
}

} // namespace jauscat::ethercat
