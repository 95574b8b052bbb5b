// The functions of job_machine.
#pragma once
#include <jauscat/ethercat/master/job_machine.hpp>

namespace jauscat::ethercat::detail {

JAUSCAT_FUNCTION master_error choose(slave_list& slaves, std::uint16_t station, slave_record*& chosen) noexcept {
    chosen = slaves.find(station);
    if (chosen == nullptr) return {.code = master_errc::wrong_station, .station = station};
    return {};
}

JAUSCAT_FUNCTION master_error choose_mailbox(slave_list& slaves, std::uint16_t station,
                                             slave_record*& chosen) noexcept {
    if (const auto wrong = choose(slaves, station, chosen); wrong != master_error{}) return wrong;
    if (chosen->mailbox.receive_size == 0) return {.code = master_errc::no_mailbox};
    if (!chosen->mailbox.coe) return {.code = master_errc::no_coe};
    return {};
}

} // namespace jauscat::ethercat::detail

namespace jauscat::ethercat {

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::scan>::begin(const scan&, ring_knowledge& ring,
                                                                          const master_config&) noexcept {
    ring.slaves.clear();
    return {};
}

} // namespace jauscat::ethercat

namespace jauscat::ethercat::detail {

JAUSCAT_FUNCTION slave_bring_up begin_bring_up(const bring_up& job, slave_list& slaves) noexcept {
    const auto* before = slaves.find(job.station);
    const bool is_ours = before != nullptr && before->position != job.position; // another slave is to have it
    if (before == nullptr) before = slaves.find_away(job.station);
    const auto known = before != nullptr ? *before : slave_record{};
    slaves.remove(job.position, job.station);
    if (before != nullptr) slaves.add_away(known);
    return {job.position, job.station, job.identity, !is_ours, known.timeouts};
}

JAUSCAT_FUNCTION slave_record complete_bring_up(slave_record slave, slave_list& slaves) noexcept {
    if (const auto* const before = slaves.find_away(slave.station)) {
        slave.process_data = before->process_data; // it keeps its place in the image
        slave.unfinished = before->unfinished;     // a change of state does not end it in every slave
        slave.timeouts = before->timeouts;
        slave.last_counter = before->last_counter; // some slaves keep it, and drop a message with the same one
    }
    slaves.remove(slave.position, slave.station);
    slaves.add(slave);
    return slave;
}

} // namespace jauscat::ethercat::detail

namespace jauscat::ethercat {

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::bring_up>::begin(const bring_up& job, ring_knowledge& ring,
                                                                              const master_config&) noexcept {
    steps_ = detail::begin_bring_up(job, ring.slaves);
    if (ring.slaves.full() && ring.slaves.find_away(job.station) == nullptr)
        return {.code = master_errc::too_many_slaves};
    return {};
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::bring_up>::complete(ring_knowledge& ring) noexcept {
    if (!steps_.result()) return steps_.result().error();
    slave_ = detail::complete_bring_up(steps_.slave(), ring.slaves);
    return {};
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::bring_up_all>::begin(const bring_up_all& job,
                                                                                  ring_knowledge& ring,
                                                                                  const master_config&) noexcept {
    slaves_ = &ring.slaves;
    places_ = job.places;
    steps_ = steps{job.places};
    for (std::size_t i = 0; i != places_.size(); ++i) {
        auto& each = places_[i];
        const auto is_same = [&](const bring_up_place& other) {
            return other.slave.station == each.slave.station || other.slave.position == each.slave.position;
        };
        if (std::ranges::any_of(places_.first(i), is_same))
            each.error = {.code = master_errc::duplicate_station};
        else
            steps_.begin(each, detail::begin_bring_up(each.slave, *slaves_));
    }
    return {};
}

JAUSCAT_FUNCTION progress job_machine<jauscat::ethercat::bring_up_all>::reply(replies datagrams, time_point now,
                                                                              const master_config& config) noexcept {
    return steps_.reply(datagrams, now, config, [&](bring_up_place& place, const slave_bring_up& work) {
        if (place.error != master_error{}) return;
        if (slaves_->full() && slaves_->find_away(place.slave.station) == nullptr)
            place.error = {.code = master_errc::too_many_slaves};
        else
            detail::complete_bring_up(work.slave(), *slaves_);
    });
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::identify>::begin(const identify& job, ring_knowledge& ring,
                                                                              const master_config&) noexcept {
    steps_ = slave_identification{job.station, job.device_id};
    slave_record* slave{};
    return detail::choose(ring.slaves, job.station, slave);
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::identify_all>::begin(const identify_all& job,
                                                                                  ring_knowledge& ring,
                                                                                  const master_config&) noexcept {
    places_ = job.places;
    steps_ = steps{job.places};
    for (auto& each : places_) {
        slave_record* slave{};
        each.error = detail::choose(ring.slaves, each.station, slave);
        if (slave != nullptr) steps_.begin(each, slave_identification{each.station, job.device_id});
    }
    return {};
}

JAUSCAT_FUNCTION progress job_machine<jauscat::ethercat::identify_all>::reply(replies datagrams, time_point now,
                                                                              const master_config& config) noexcept {
    return steps_.reply(datagrams, now, config,
                        [](identify_place& place, const slave_identification& work) { place.is = work.value(); });
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::read_names>::begin(const read_names& job,
                                                                                ring_knowledge& ring,
                                                                                const master_config&) noexcept {
    places_ = job.places;
    steps_ = steps{job.places};
    for (auto& each : places_) {
        slave_record* slave{};
        each.error = detail::choose(ring.slaves, each.station, slave);
        if (slave != nullptr) steps_.begin(each, sii_name{each.station});
    }
    return {};
}

JAUSCAT_FUNCTION progress job_machine<jauscat::ethercat::read_names>::reply(replies datagrams, time_point now,
                                                                            const master_config& config) noexcept {
    return steps_.reply(datagrams, now, config,
                        [](name_place& place, const sii_name& work) { place.name = work.value(); });
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::locate_slaves>::begin(const locate_slaves& job,
                                                                                   ring_knowledge& ring,
                                                                                   const master_config&) noexcept {
    slaves_ = &ring.slaves;
    into_ = job.into;
    return {};
}

JAUSCAT_FUNCTION progress job_machine<jauscat::ethercat::locate_slaves>::reply(replies datagrams, time_point,
                                                                               const master_config&) noexcept {
    if (steps_.slaves() == 0) // counted next
        for (auto& each : slaves_->all()) each.position = slave_record::no_position;
    return steps_.reply(datagrams, [&](std::uint16_t position, std::uint16_t station) {
        auto* const slave = station != 0 ? slaves_->find(station) : nullptr;
        if (slave != nullptr && slave->position == slave_record::no_position) {
            slave->position = position;
            ++known_;
        } else if (unknown_ != into_.size()) {
            into_[unknown_++] = position;
        }
    });
}

JAUSCAT_FUNCTION located_slaves job_machine<jauscat::ethercat::locate_slaves>::value() const noexcept {
    return {.slaves = steps_.slaves(), .known = known_, .unknown = into_.first(unknown_)};
}

} // namespace jauscat::ethercat

namespace jauscat::ethercat::detail {

JAUSCAT_FUNCTION master_error begin_setup(slave_list& slaves, std::uint16_t station, std::chrono::nanoseconds watchdog,
                                          slave_record*& slave) noexcept {
    if (const auto wrong = choose(slaves, station, slave); wrong != master_error{}) return wrong;
    if (watchdog_units(watchdog) == 0) return {.code = master_errc::watchdog_range};
    return {};
}

} // namespace jauscat::ethercat::detail

namespace jauscat::ethercat {

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::configure>::begin(const configure& job,
                                                                               ring_knowledge& ring,
                                                                               const master_config& config) noexcept {
    slave_record* slave{};
    const auto wrong = detail::begin_setup(ring.slaves, job.station, job.watchdog, slave);
    if (slave == nullptr) return wrong;
    image_end_ = ring.slaves.image_end(slave);
    steps_ = slave_setup{*slave, image_end_, job.watchdog, config.logical_base, job.objects};
    return wrong;
}

JAUSCAT_FUNCTION progress job_machine<jauscat::ethercat::configure>::reply(replies datagrams, time_point now,
                                                                           const master_config& config) noexcept {
    return steps_.reply(datagrams, now, config);
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::configure_all>::begin(
    const configure_all& job, ring_knowledge& ring, const master_config& config) noexcept {
    image_end_ = ring.slaves.image_end();
    places_ = job.places;
    steps_ = steps{job.places, config.frames_may_be_copied};
    for (auto& each : places_) {
        slave_record* slave{};
        each.error = detail::begin_setup(ring.slaves, each.station, job.watchdog, slave);
        if (each.error == master_error{})
            steps_.begin(each, slave_setup{*slave, image_end_, job.watchdog, config.logical_base, each.objects});
    }
    return {};
}

JAUSCAT_FUNCTION progress job_machine<jauscat::ethercat::configure_all>::reply(replies datagrams, time_point now,
                                                                               const master_config& config) noexcept {
    return steps_.reply(datagrams, now, config, [](const configure_place&, const slave_setup&) {});
}

} // namespace jauscat::ethercat

namespace jauscat::ethercat::detail {

JAUSCAT_FUNCTION master_error begin_change(slave_list& slaves, std::uint16_t station, al_state goal) noexcept {
    slave_record* slave{};
    if (const auto wrong = choose(slaves, station, slave); wrong != master_error{}) return wrong;
    slave->drained = false;
    if (!is_known(goal)) return {.code = master_errc::al_error, .al_status = al_status_code::unknown_state};
    if (goal == al_state::op && slave->watchdog == slave->watchdog.zero()) return {.code = master_errc::not_configured};
    return {};
}

} // namespace jauscat::ethercat::detail

namespace jauscat::ethercat {

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::change_state>::begin(const change_state& job,
                                                                                  ring_knowledge& ring,
                                                                                  const master_config&) noexcept {
    const auto refused = detail::begin_change(ring.slaves, job.station, job.goal);
    if (refused == master_error{}) steps_ = {job.station, job.goal, ring.slaves.find(job.station)->timeouts};
    return refused;
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::change_states>::begin(const change_states& job,
                                                                                   ring_knowledge& ring,
                                                                                   const master_config&) noexcept {
    places_ = job.places;
    steps_ = steps{job.places};
    for (auto& each : places_)
        if (each.error = detail::begin_change(ring.slaves, each.station, job.goal); each.error == master_error{})
            steps_.begin(each, state_change{each.station, job.goal, ring.slaves.find(each.station)->timeouts});
    return {};
}

JAUSCAT_FUNCTION progress job_machine<jauscat::ethercat::change_states>::reply(replies datagrams, time_point now,
                                                                               const master_config& config) noexcept {
    return steps_.reply(datagrams, now, config, [](const state_place&, const state_change&) {});
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::check_positions>::begin(const check_positions& job,
                                                                                     ring_knowledge& ring,
                                                                                     const master_config&) noexcept {
    places_ = job.places;
    steps_ = steps{job.places};
    for (auto& each : places_) {
        slave_record* slave{};
        each.error = detail::choose(ring.slaves, each.station, slave);
        if (each.error == master_error{}) steps_.begin(each, position_check{slave->position, each.station});
    }
    return {};
}

JAUSCAT_FUNCTION progress job_machine<jauscat::ethercat::check_positions>::reply(replies datagrams, time_point now,
                                                                                 const master_config& config) noexcept {
    return steps_.reply(datagrams, now, config, [](const position_place&, const position_check&) {});
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::check>::begin(const check& job, ring_knowledge& ring,
                                                                           const master_config&) noexcept {
    if (const auto wrong = detail::choose(ring.slaves, job.station, slave_); wrong != master_error{}) return wrong;
    slave_->al = {};
    slave_->reply_waiting = false;
    steps_ = slave_check{*slave_};
    return {};
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::check>::complete(ring_knowledge&) noexcept {
    slave_->al = steps_.al();
    slave_->reply_waiting = steps_.reply_waiting();
    return steps_.result().error();
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::download>::begin(const download& job, ring_knowledge& ring,
                                                                              const master_config&) noexcept {
    return begin_protocol(ring, job.station, sdo_transfer::download(job.index, job.subindex, job.data, job.options));
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::run_init_commands>::begin(const run_init_commands& job,
                                                                                       ring_knowledge& ring,
                                                                                       const master_config&) noexcept {
    job_ = job;
    find();
    return is_done() ? detail::choose(ring.slaves, job.station, slave_) : start(ring.slaves);
}

JAUSCAT_FUNCTION progress job_machine<jauscat::ethercat::run_init_commands>::reply(
    replies datagrams, time_point now, const master_config& config) noexcept {
    const auto next = session_.reply(datagrams, now, config);
    if (next != progress::done || !session_.result()) return next;
    ++written_;
    ++at_;
    find();
    if (is_done()) return progress::done;
    begin_session();
    return progress::send;
}

JAUSCAT_FUNCTION void job_machine<jauscat::ethercat::run_init_commands>::find() noexcept {
    while (!is_done() && job_.commands[at_].transition != job_.transition) ++at_;
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::run_init_commands>::start(slave_list& slaves) noexcept {
    const auto wrong = detail::choose_mailbox(slaves, job_.station, slave_);
    if (wrong == master_error{}) begin_session();
    return wrong;
}

JAUSCAT_FUNCTION void job_machine<jauscat::ethercat::run_init_commands>::begin_session() noexcept {
    const auto& command = job_.commands[at_];
    session_ = {};
    session_.begin(*slave_, sdo_transfer::download(command.index, command.subindex, command.data, command.options));
}

JAUSCAT_FUNCTION master_error
job_machine<jauscat::ethercat::run_init_commands>::of_command(master_error error) const noexcept {
    if (error == master_error{}) return error;
    error.command = static_cast<std::uint16_t>(at_);
    if (at_ < job_.commands.size()) {
        error.index = job_.commands[at_].index;
        error.subindex = job_.commands[at_].subindex;
    }
    return error;
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::upload>::begin(const upload& job, ring_knowledge& ring,
                                                                            const master_config&) noexcept {
    into_ = job.into;
    return begin_protocol(ring, job.station, sdo_transfer::upload(job.index, job.subindex, job.into, job.options));
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::upload_all>::begin(const upload_all& job,
                                                                                ring_knowledge& ring,
                                                                                const master_config& config) noexcept {
    places_ = job.places;
    steps_ = steps{job.places, config.frames_may_be_copied};
    for (std::size_t i = 0; i != places_.size(); ++i) {
        auto& each = places_[i];
        const auto& object = each.object;
        slave_record* slave{};
        each.size = 0;
        each.error = detail::choose_mailbox(ring.slaves, object.station, slave);
        const auto is_same = [&](const upload_place& other) { return other.object.station == object.station; };
        if (std::ranges::any_of(places_.first(i), is_same)) each.error = {.code = master_errc::busy};
        if (each.error != master_error{}) continue;
        mailbox_session<sdo_transfer> session{};
        session.begin(*slave, sdo_transfer::upload(object.index, object.subindex, object.into, object.options));
        steps_.begin(each, session);
    }
    return {};
}

JAUSCAT_FUNCTION progress job_machine<jauscat::ethercat::upload_all>::reply(replies datagrams, time_point now,
                                                                            const master_config& config) noexcept {
    return steps_.reply(datagrams, now, config, [](upload_place& each, const mailbox_session<sdo_transfer>& session) {
        each.size = std::min(each.object.into.size(), session.result().value_or(0));
    });
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::list_objects>::begin(const list_objects& job,
                                                                                  ring_knowledge& ring,
                                                                                  const master_config&) noexcept {
    into_ = job.into;
    return begin_protocol(ring, job.station, sdo_information::list(job.list, job.into));
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::describe_object>::begin(const describe_object& job,
                                                                                     ring_knowledge& ring,
                                                                                     const master_config&) noexcept {
    into_ = job.into;
    return begin_protocol(ring, job.station, sdo_information::object(job.index, job.into));
}

JAUSCAT_FUNCTION master_result<object_description>
job_machine<jauscat::ethercat::describe_object>::value() const noexcept {
    return decode_object_description(received(into_));
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::describe_entry>::begin(const describe_entry& job,
                                                                                    ring_knowledge& ring,
                                                                                    const master_config&) noexcept {
    into_ = job.into;
    return begin_protocol(ring, job.station,
                          sdo_information::entry({job.index, job.subindex, job.value_info}, job.into));
}

JAUSCAT_FUNCTION master_result<entry_description>
job_machine<jauscat::ethercat::describe_entry>::value() const noexcept {
    return decode_entry_description(received(into_));
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::collect_emergencies>::begin(
    const collect_emergencies& job, ring_knowledge& ring, const master_config&) noexcept {
    exchange_ = mailbox_exchange::collect();
    const auto wrong = detail::choose_mailbox(ring.slaves, job.station, slave_);
    if (wrong == master_error{} && slave_->is_lent) return {.code = master_errc::busy}; // the other one collects
    return wrong;
}

JAUSCAT_FUNCTION progress job_machine<jauscat::ethercat::collect_emergencies>::reply(
    replies datagrams, time_point now, const master_config& config) noexcept {
    return exchange_.reply(datagrams.front(), now, config, *slave_, nothing_);
}

JAUSCAT_FUNCTION master_error
job_machine<jauscat::ethercat::collect_emergencies>::cancel(const master_error& why) noexcept {
    exchange_.abandon(*slave_);
    return why;
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::exchange_datagram>::begin(const exchange_datagram& job,
                                                                                       ring_knowledge&,
                                                                                       const master_config&) noexcept {
    steps_ = datagram_exchange{job.cmd, job.adp, job.ado, job.data};
    return {};
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::set_up_clocks>::begin(const set_up_clocks& job,
                                                                                   ring_knowledge&,
                                                                                   const master_config&) noexcept {
    steps_ = clock_setup{job};
    if (job.slaves.empty()) return {.code = master_errc::no_clock};
    return {};
}

JAUSCAT_FUNCTION master_error job_machine<jauscat::ethercat::start_sync>::begin(const start_sync& job, ring_knowledge&,
                                                                                const master_config&) noexcept {
    steps_ = sync_setup{job};
    if (!steps_.has_reference()) return {.code = master_errc::no_clock};
    return {};
}

} // namespace jauscat::ethercat
