// A bus: its queue of jobs, its link and its slaves.
#pragma once
#include <jauscat/app/detail/explained.hpp>
#include <jauscat/app/impl/bus_jobs.hpp>
#include <jauscat/app/impl/named_slaves.ipp>
#include <jauscat/base/stable_sort.hpp>
#include <jauscat/ethercat/code_texts.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/text/master_error_text.hpp>

#include <boost/asio/post.hpp>

#include <algorithm>
#include <iostream>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

JAUSCAT_DECL error_code error_of(const ethercat::master_error& error) noexcept {
    using enum ethercat::master_errc;
    switch (error.code) {
    case ok: return {};
    case not_sent:
    case no_space: return bus_errc::not_sent;
    case no_reply: return bus_errc::no_reply;
    case timeout: return bus_errc::stopped;
    case no_slave:
    case wrong_station:
    case duplicate_station:
    case working_counter: return bus_errc::slave_lost;
    case wrong_identity: return bus_errc::wrong_slave;
    case no_mailbox:
    case no_coe: return bus_errc::no_objects;
    case al_error:
        if (error.al_status != ethercat::al_status_code::none) return error.al_status;
        return error.state == ethercat::al_state{} ? bus_errc::refused : bus_errc::left_state;
    case state_timeout: return bus_errc::state_not_reached;
    case too_many_slaves: return bus_errc::too_many_slaves;
    case sii_busy:
    case sii_error:
    case sii_malformed:
    case no_fmmu:
    case too_many_managers:
    case wrong_mapping:
    case no_direction:
    case too_many_entries:
    case image_full:
    case watchdog_range:
    case object_not_kept:
    case watchdog_not_kept: return bus_errc::not_configurable;
    case no_clock:
    case clock_topology:
    case clock_delay:
    case clock_unsettled:
    case sync_late: return bus_errc::not_synchronized;
    case not_configured: return bus_errc::needs_cycles;
    case mailbox_full: return bus_errc::not_taken;
    case mailbox_timeout: return bus_errc::no_answer;
    case busy:
    case mailbox_error: return bus_errc::refused;
    case unexpected_reply:
    case toggle_bit:
    case fragment_missing:
    case too_many_fragments: return bus_errc::malformed_answer;
    case sdo_abort:
    case clear_refused:
        if (error.abort == ethercat::abort_code::none) return bus_errc::refused;
        return error.abort;
    case size_mismatch: return bus_errc::wrong_size;
    case data_too_long: return bus_errc::too_large;
    }
    return bus_errc::refused;
}

JAUSCAT_DECL std::string name_of(const slave_info& slave) {
    if (!slave.configured_name.empty())
        return "slave \"" + slave.configured_name + "\" at position " + std::to_string(slave.position);
    auto name = "slave " + std::to_string(slave.position);
    if (!slave.name.empty()) name += " (" + slave.name + ")";
    return name;
}

JAUSCAT_DECL error_code error_of(const slave_info& slave, const ethercat::master_error& error,
                                 const std::optional<object>& about, std::string_view type) {
    const auto plain = error_of(error);
    auto line = name_of(slave);
    if (about) line += ", object " + text::hex_number(about->index, 4);
    if (about && about->subindex) line += ":" + std::to_string(*about->subindex);
    if (plain != bus_errc::wrong_size && plain != bus_errc::not_configurable)
        line += ": " + plain.message();
    else if (plain == bus_errc::not_configurable || type.empty()) // not as large as the slave has announced
        line += ": " + text::explain(error);
    else
        line += " has " + std::to_string(error.found_bytes) + " bytes, and " + std::string{type} + " has " +
                std::to_string(error.bytes);
    return explained(plain, line);
}
JAUSCAT_DECL error_code error_of_loss(ethercat::al_state goal, const ethercat::master_error& why) {
    auto plain = error_of(why);
    if (!plain || plain == bus_errc::stopped) plain = bus_errc::slave_lost;
    if (plain == bus_errc::not_configurable) return explained(plain, text::explain(why));
    if (why.state == ethercat::al_state{}) return plain;
    auto line = "left " + std::string{describe(goal)} + ": " + std::string{describe(why.state)};
    if (why.al_status != ethercat::al_status_code::none) line += ", " + plain.message();
    return explained(plain, line);
}

JAUSCAT_DECL void bus_slave::identify(const ethercat::slave_record& record) noexcept {
    info.station = record.station;
    info.alias = record.alias;
    info.vendor = record.identity.vendor;
    info.product = record.identity.product;
    info.revision = record.identity.revision;
    info.serial = record.identity.serial;
    info.has_objects = record.mailbox.coe && record.mailbox.receive_size != 0;
    is_identified = true;
}

/// Shows the frames that it passes on.
class shown_link final : public net::any_link {
  public:
    shown_link(std::unique_ptr<net::any_link> link, const bus_state& to) : link_{std::move(link)}, to_{to} {}

    bool send(std::span<const std::byte> frame) override {
        to_.show_frame(frame, true);
        return link_->send(frame);
    }
    std::size_t receive(std::span<std::byte> buffer, duration timeout) override {
        const auto size = link_->receive(buffer, timeout);
        if (size != 0) to_.show_frame(buffer.first(size), false);
        return size;
    }
    int native_handle() override { return link_->native_handle(); }
    [[nodiscard]] const std::string& problem() const override { return link_->problem(); }

  private:
    std::unique_ptr<net::any_link> link_;
    const bus_state& to_;
};

// System time of distributed clocks, ns since 2000-01-01, when net::now() was 0; the same for all of this program.
inline std::uint64_t system_time_at_zero() {
    using std::chrono::system_clock, std::chrono::nanoseconds;
    static const std::uint64_t time = [] {
        constexpr std::chrono::sys_days epoch{std::chrono::year{2000} / std::chrono::January / 1};
        const nanoseconds since = system_clock::now() - epoch;
        return static_cast<std::uint64_t>((since - net::now().time_since_epoch()).count());
    }();
    return time;
}

JAUSCAT_DECL bridging::bridge_options timing_of(const bus_options& options) {
    bridging::bridge_options timing{};
    timing.master = {.frame_timeout = options.frame_timeout,
                     .frames_may_be_copied = options.frames_may_be_copied,
                     .retries = options.frame_retries};
    timing.download = {.clear_subindex_0 = options.clear_subindex_0};
    timing.system_time = system_time_at_zero();
    return timing;
}

JAUSCAT_DECL bus_state::bus_state(boost::asio::io_context& context, std::string_view where, bus_options options)
    : context_{context},
      where_{options.name.empty() ? std::string{where} : options.name},
      options_{std::move(options)},
      link_{net::open_link(where)},
      timing_{timing_of(options_)},
      memory_(max_object_size),
      named_{options_.slaves} {
    if (options_.on_frame) link_ = std::make_unique<shown_link>(std::move(link_), *this);
}
JAUSCAT_DECL bus_state::~bus_state() { close(); }

JAUSCAT_DECL void bus_state::log(std::string_view line) const {
    auto whole = where_ + ": " + std::string{line};
    if (!is_own_thread()) return write_line(whole);
    boost::asio::post(context_, [weak = weak_from_this(), text = std::move(whole)] {
        if (const auto self = weak.lock()) self->write_line(text);
    });
}
JAUSCAT_DECL void bus_state::write_line(const std::string& line) const {
    try {
        if (options_.log)
            options_.log(line);
        else
            std::cerr << line + "\n";
    } catch (...) { // of the application's log: frames are under way
    }
}

template <class F, class... Arguments> void bus_state::call_later(F bus_state::* function, Arguments... arguments) {
    if (!(this->*function)) return;
    boost::asio::post(context_, [weak = weak_from_this(), function, arguments...] {
        const auto self = weak.lock();
        if (!self) return;
        auto lock = self->lock();
        if (self->is_closed_) return;
        const auto call = (*self).*function; // it may end the bus
        lock.unlock();
        if (call) call(arguments...);
    });
}

// ---- The queue.

JAUSCAT_DECL void bus_state::open() {
    if (ring_) return;
    ring_ = std::make_unique<ring_type>(timing_);
    late_cycles_ = {};
    ring_->share({.begin = jaus::bound<&bus_state::begin_job>(*this),
                  .done = jaus::bound<&bus_state::end_job>(*this),
                  .cycle = jaus::bound<&bus_state::run_cycle>(*this)});
    if (options_.thread) {
        try {
            thread_ = std::make_unique<ring_thread>(*link_, *ring_, output_, mutex_, [this] {
                look_at_link();
                return look_at_time();
            });
        } catch (...) {
            ring_.reset(); // opened anew by the next operation
            throw;
        }
        work_.emplace(context_.get_executor());
        if (options_.priority == 0) return;
        if (const auto problem = thread_->set_priority(options_.priority); !problem.empty())
            log("the bus works without the priority " + std::to_string(options_.priority) + ": " + problem);
        return;
    }
    runner_.emplace(context_, *link_, *ring_, output_);
    const auto look = [this] {
        if (const auto next = look_at_time(); next != time_point::max()) timer_->arm(next);
    };
    runner_->after_turn = [this, look] {
        look_at_link();
        look();
    };
    timer_.emplace(context_, [this, look] {
        look();
        wake();
    });
    runner_->start();
}
JAUSCAT_DECL void bus_state::wake() {
    if (thread_) thread_->wake()();
    if (runner_) runner_->wake()();
}

JAUSCAT_DECL void bus_state::add(std::unique_ptr<bus_job> job, duration limit) {
    const auto locked = lock();
    if (is_closed_) return job->fail(boost::asio::error::operation_aborted);
    open();
    job->limit = limit;
    queue_.push_back(std::move(job));
    wake();
}

JAUSCAT_DECL bool bus_state::begin_job(ethercat::master& master) {
    const auto now = net::now();
    for (;;) {
        if (!current_) current_ = next_job(now);
        if (!current_) return false;
        if (!current_->is_over() && current_->begin(*this, master)) return true;
        current_.reset();
    }
}
JAUSCAT_DECL void bus_state::end_job(ethercat::master& master) {
    if (current_) current_->end(*this, master);
}

/// Operations and looks at slaves alternate where both wait.
JAUSCAT_DECL std::unique_ptr<bus_job> bus_state::next_job(time_point now) {
    std::erase_if(queue_, [](const auto& each) { return each->is_over(); });
    if (finds_changes() && next_find_ <= now && (queue_.empty() || !looked_last_)) {
        looked_last_ = true;
        next_find_ = saturating_add(now, options_.check_interval);
        return make_find_job(find_scope::changes, nullptr);
    }
    bus_slave* seen_last{};
    if (options_.check_interval > duration{} && is_started_)
        for (auto& each : slaves_)
            if (is_watched(each) && each.next_look <= now && (!seen_last || each.next_look < seen_last->next_look))
                seen_last = &each;
    const bool looks = seen_last != nullptr && (queue_.empty() || !looked_last_);
    looked_last_ = looks;
    if (looks) {
        seen_last->next_look = saturating_add(now, options_.check_interval);
        return make_look_job(seen_last->info.station);
    }
    if (queue_.empty()) return nullptr;
    auto next = std::move(queue_.front());
    queue_.pop_front();
    while (!queue_.empty() && (queue_.front()->is_over() || next->takes_along(*queue_.front()))) queue_.pop_front();
    next->due = deadline{now, next->limit}.at();
    return next;
}

JAUSCAT_DECL time_point bus_state::look_at_time() {
    const auto now = net::now();
    auto next = time_point::max();
    std::erase_if(queue_, [](const auto& each) { return each->is_over(); });
    if (current_ && current_->due <= now) current_->fail(bus_errc::timed_out);
    if (current_ && current_->is_over()) {
        if (!ring_->cancel_shared()) current_.reset();
        wake(); // it ends, or the next one begins
    }
    look_at_operated(now);
    if (current_) next = current_->due;
    if (options_.check_interval > duration{} && is_started_ && !current_)
        for (const auto& each : slaves_)
            if (is_watched(each)) next = std::min(next, std::max(each.next_look, now + std::chrono::milliseconds{1}));
    if (finds_changes() && !current_) next = std::min(next, std::max(next_find_, now + std::chrono::milliseconds{1}));
    return next;
}

JAUSCAT_DECL void bus_state::look_at_link() {
    if (const auto& now = link_->problem(); !now.empty() && now != problem_) {
        problem_ = now;
        tell_fault(link_fault::no_frames, problem_);
    }
    const auto seen = ring_->statistics();
    if (seen.foreign != 0 && !std::exchange(has_seen_master_, true))
        tell_fault(link_fault::second_master, "frames of another master are on this link; only one may use it");
    if (seen.circulated != 0 && !std::exchange(has_seen_gap_, true))
        tell_fault(link_fault::broken_ring, "frames return marked as circulating: a cable between two slaves is out");
}
JAUSCAT_DECL void bus_state::tell_fault(link_fault what, std::string_view line) const {
    log(line);
    if (!options_.on_fault) return;
    boost::asio::post(context_, [weak = weak_from_this(), what, text = std::string{line}] {
        const auto self = weak.lock();
        if (!self) return;
        auto lock = self->lock();
        if (self->is_closed_) return;
        lock.unlock();
        self->options_.on_fault(what, text);
    });
}
JAUSCAT_DECL void bus_state::show_frame(std::span<const std::byte> frame, bool is_sent) const {
    options_.on_frame({.bytes = frame, .is_sent = is_sent, .is_keep_alive = ring_ && ring_->keeps_alive()});
}

JAUSCAT_DECL void bus_state::abort_all(error_code why) {
    auto all = std::exchange(queue_, {});
    for (const auto& each : all) each->fail(why);
    if (current_) current_->fail(why);
}
JAUSCAT_DECL void bus_state::cancel() {
    const auto locked = lock();
    abort_all(boost::asio::error::operation_aborted);
    if (ring_) static_cast<void>(look_at_time());
}
JAUSCAT_DECL void bus_state::stop() noexcept {
    const auto attempt = [](auto&& work) {
        try {
            work();
        } catch (...) { // no memory to tell of it: the rest must be done
        }
    };
    {
        const auto locked = lock();
        attempt([&] { abort_all(boost::asio::error::operation_aborted); });
        attempt([&] {
            for (const auto& each : std::exchange(prepared_, {}))
                each.done->complete(boost::asio::error::operation_aborted);
        });
        for (auto* const user : users_) user->was_up = user->front().up();
        auto kept = std::exchange(on_cycle, nullptr); // what it refers to may be gone; nothing moves from now on
        const auto begun = net::now();
        attempt([&] {
            if (ring_) bring_cycle_users_to_rest(longest_rest * 4 / 7);
        });
        attempt([&] {
            if (ring_) bring_to_rest(users_, longest_rest - std::min(net::now() - begun, longest_rest * 4 / 7));
        });
        attempt([&] {
            for (const auto& each : std::exchange(cycle_users_, {})) each->bus_ends();
        });
        on_cycle.swap(kept);
        end_operations();
        for (auto* const user : std::exchange(users_, {})) user->bus_ends();
        is_started_ = false;
        attempt([&] {
            if (runner_) runner_->stop();
        });
    }
    if (thread_) thread_->stop(); // without the lock, which it waits for
    thread_.reset();
    current_.reset(); // the master uses its data until then
    work_.reset();
    runner_.reset();
    timer_.reset();
    ring_.reset();
    slaves_.clear();
    operate_period_ = {};
}
JAUSCAT_DECL void bus_state::close() noexcept {
    {
        const auto locked = lock();
        if (std::exchange(is_closed_, true)) return;
    }
    stop();
    link_.reset();
    on_cycle = nullptr;
    on_lost = nullptr;
    on_found = nullptr;
    on_changed = nullptr;
    on_emergency = nullptr;
}

// ---- The slaves.

JAUSCAT_DECL std::vector<slave_info> bus_state::infos() const {
    const auto locked = lock();
    std::vector<slave_info> all;
    for (const auto& each : slaves_) all.push_back(each.info);
    return all;
}
JAUSCAT_DECL bus_slave* bus_state::at(std::uint16_t station) {
    const auto found =
        std::ranges::find_if(slaves_, [=](const bus_slave& each) { return each.info.station == station; });
    return found == slaves_.end() ? nullptr : &*found;
}
JAUSCAT_DECL bus_slave* bus_state::at_position(std::uint16_t position) {
    const auto found = std::ranges::find_if(
        slaves_, [=](const bus_slave& each) { return each.info.position == position && !each.is_absent; });
    return found == slaves_.end() ? nullptr : &*found;
}
JAUSCAT_DECL bus_slave* bus_state::find(const slave_choice& which, error_code& error) {
    const auto is_same = [](const auto& required, auto value) { return !required || *required == value; };
    const auto& id = which.identity;
    const auto* const name = named(which);
    error = is_started_ ? bus_errc::no_such_slave : bus_errc::not_started;
    if (is_started_ && name != nullptr && name->why) {
        error = name->why;
        return nullptr;
    }
    bus_slave* found{};
    for (auto& each : slaves_) {
        const auto& info = each.info;
        if (name != nullptr && each.named != name) continue;
        if (which.position && (each.is_absent || !is_same(which.position, info.position))) {
            if (name != nullptr) error = bus_errc::wrong_slave;
            continue;
        }
        const bool is_as_required = is_same(which.alias, info.alias) &&
                                    (which.name.empty() || name != nullptr || which.name.view() == info.name) &&
                                    is_same(id.vendor, info.vendor) && is_same(id.product, info.product) &&
                                    is_same(id.revision, info.revision) && is_same(id.serial, info.serial);
        if (!is_as_required) {
            if (which.position) error = bus_errc::wrong_slave;
            continue;
        }
        if (found != nullptr) {
            error = bus_errc::ambiguous;
            return nullptr;
        }
        found = &each;
    }
    if (found != nullptr) error = {};
    return found;
}

JAUSCAT_DECL duration bus_state::timeout_of(const slave_choice& which) {
    const auto locked = lock();
    error_code error;
    const auto* const slave = find(which, error);
    if (slave == nullptr || slave->named == nullptr) return options_.timeout;
    const auto& times = slave->named->entry.timeouts;
    const auto time = [](const auto& given) { return duration{given.value_or(net::timeout_entry::milliseconds{})}; };
    return options_.timeout + std::max({time(times.pre_op) + 2 * time(times.safe_op_op), time(times.back_to_init),
                                        2 * time(times.mailbox)}); // a request, and its abort
}

JAUSCAT_DECL void bus_state::note_lost(bus_slave& slave, error_code why) {
    const bool is_known = std::exchange(slave.info.is_lost, true);
    if (is_known && slave.why == why) return;
    slave.why = why;
    slave.is_configured = false;
    log(name_of(slave.info) + (is_known ? " is still lost: " : " is lost: ") + why.message());
    if (!is_known) call_later(&bus_state::on_lost, slave.info, why);
}
JAUSCAT_DECL void bus_state::note_all_lost(error_code why) {
    for (auto& each : slaves_)
        if (!each.info.is_served && !each.info.is_lost) note_lost(each, why);
}
JAUSCAT_DECL void bus_state::note_found(bus_slave& slave) {
    if (!is_trusted(slave)) return;
    if (!std::exchange(slave.info.is_lost, false)) return;
    slave.why = {};
    problem_.clear();
    log(name_of(slave.info) + " answers again");
    call_later(&bus_state::on_found, slave.info);
}
JAUSCAT_DECL void bus_state::note_outcome(bus_slave& slave, error_code error) {
    if (slave.info.is_served || error == bus_errc::stopped) return;
    if (error == bus_errc::no_reply || error == bus_errc::not_sent) return note_all_lost(error);
    if (error == bus_errc::slave_lost)
        note_lost(slave, error);
    else if (error != bus_errc::no_objects)
        note_found(slave);
}
JAUSCAT_DECL void bus_state::note_state(bus_slave& slave, const ethercat::al_status& al) {
    const auto before = std::exchange(slave.al, al);
    if (before.state == al.state && before.error == al.error && (!al.error || before.code == al.code)) return;
    if (al.state == ethercat::al_state::init) slave.is_configured = false;
    if (al.error) log(name_of(slave.info) + " has an error: " + make_error_code(al.code).message());
    call_later(&bus_state::on_changed, slave.info, al);
}
JAUSCAT_DECL void bus_state::note_emergencies(bus_slave& slave, ethercat::master& master) {
    const auto* const record = master.find(slave.info.station);
    if (record == nullptr || slave.info.is_served) return;
    for (const auto& each : record->emergencies.kept()) note_emergency(slave, each);
    if (record->emergencies.overflow()) log(name_of(slave.info) + " has reported more emergencies than are kept");
    master.clear_emergencies(slave.info.station);
}
JAUSCAT_DECL void bus_state::note_emergency(const bus_slave& slave, const ethercat::coe_emergency& emergency) {
    log(name_of(slave.info) + " reports an emergency: " + numbered("%04Xh", emergency.error_code) +
        numbered(", error register %02Xh", emergency.error_register));
    call_later(&bus_state::on_emergency, slave.info, emergency);
}

// ---- Named slaves.

JAUSCAT_DECL bool bus_state::finds_changes() const noexcept {
    return is_started_ && !named_.empty() && options_.check_interval > duration{};
}
JAUSCAT_DECL bool bus_state::is_trusted(const bus_slave& slave) const noexcept {
    const bool is_refused = slave.named == nullptr && slave.last_name != nullptr;
    return named_.empty() || (slave.is_prepared && !slave.is_absent && !is_refused);
}
JAUSCAT_DECL bool bus_state::is_watched(const bus_slave& slave) const noexcept {
    return !slave.info.is_served && is_trusted(slave);
}
JAUSCAT_DECL void bus_state::sort_slaves() {
    jauscat::stable_sort(slaves_, [](const bus_slave& each) { return each.info.position; });
}
JAUSCAT_DECL bus_slave* bus_state::slave_of(const named_slave& which) noexcept {
    const auto found = std::ranges::find(slaves_, &which, &bus_slave::named);
    return found == slaves_.end() ? nullptr : &*found;
}
JAUSCAT_DECL bool bus_state::await(named_slave& which, bus_user& user, std::uint16_t station) {
    if (which.user != nullptr && which.user != &user) return false;
    which.user = &user;
    auto* const slave = slave_of(which);
    if (std::exchange(which.station, station) != station && slave != nullptr) slave->is_prepared = false;
    if (slave != nullptr && is_watched(*slave) && !slave->info.is_lost) user.slave_ready();
    next_find_ = {};
    wake();
    return true;
}
JAUSCAT_DECL void bus_state::forget(const bus_user& user) noexcept {
    for (auto& each : named_.all())
        if (each.user == &user) each.user = nullptr;
}
JAUSCAT_DECL void bus_state::forget_found() {
    std::erase_if(slaves_, [](const bus_slave& each) { return !each.info.is_served; });
}
/// Returns the positions of slaves that are to be brought up, and the station addresses for it.
JAUSCAT_DECL std::vector<std::pair<std::uint16_t, std::uint16_t>>
bus_state::note_positions(const ethercat::master& master, std::span<const std::uint16_t> unknown) {
    const auto now = net::now();
    const auto is_unknown = [&](std::uint16_t position) { return std::ranges::count(unknown, position) != 0; };
    std::erase_if(slaves_, [&](const bus_slave& each) {
        return !each.is_identified && !each.info.is_served && !is_unknown(each.info.position);
    });
    for (auto& each : slaves_) {
        const auto* const record = master.find(each.info.station);
        const bool is_absent = record == nullptr || record->position == ethercat::slave_record::no_position;
        if (!each.is_identified) continue;
        if (std::exchange(each.is_absent, is_absent) != is_absent) is_match_due_ = true;
        if (is_absent && !each.info.is_served) note_lost(each, bus_errc::slave_lost);
        if (is_absent || record->position == each.info.position) continue;
        is_match_due_ = true;
        const auto before = std::exchange(each.info.position, record->position);
        log(name_of(each.info) + " was at position " + std::to_string(before));
    }
    std::vector<std::pair<std::uint16_t, std::uint16_t>> made;
    for (const auto position : unknown) {
        const auto failed = std::ranges::find_if(slaves_, [=](const bus_slave& each) {
            return each.info.position == position && !each.is_identified && !each.info.is_served;
        });
        if (failed == slaves_.end())
            made.emplace_back(position, next_station_++);
        else if (failed->next_try <= now)
            made.emplace_back(position, failed->info.station);
    }
    for (const auto& each : master.slaves()) // those that were not identified
        if (each.position != ethercat::slave_record::no_position && at(each.station) == nullptr)
            made.emplace_back(each.position, each.station);
    sort_slaves();
    return made;
}
JAUSCAT_DECL bool bus_state::note_brought_up(const bus_slave& made, error_code why) {
    auto* slave = at(made.info.station);
    if (slave == nullptr) slave = &slaves_.emplace_back();
    const auto before = std::exchange(slave->why, why);
    slave->info = made.info;
    slave->al = made.al;
    slave->is_identified = made.is_identified && !why;
    slave->is_brought_up = true;
    slave->info.is_lost = why.failed();
    slave->next_try = net::now() + timing_.bring_up_interval;
    is_match_due_ = true;
    if (why && why != before) log(name_of(slave->info) + " is not brought up: " + why.message());
    sort_slaves();
    return !why;
}
JAUSCAT_DECL void bus_state::refuse(named_slave& which, error_code why, const bus_slave* by) {
    if (std::exchange(which.why, why) == why) return;
    auto* const slave = slave_of(which);
    if (slave != nullptr) {
        note_lost(*slave, why);
        slave->named = nullptr;
        slave->info.configured_name.clear();
    }
    if (which.entry.is_optional && why == bus_errc::missing_slave) return;
    auto line = "slave \"" + which.entry.name + "\" is refused: " + why.message();
    if (by != nullptr)
        line += " (position " + std::to_string(by->info.position) + ": vendor " + numbered("%Xh", by->info.vendor) +
                ", product " + numbered("%Xh", by->info.product) + ", revision " + numbered("%Xh", by->info.revision) +
                ", serial " + std::to_string(by->info.serial) + ")";
    log(line);
}
JAUSCAT_DECL void bus_state::match_names() {
    if (!std::exchange(is_match_due_, false)) return;
    std::vector<ethercat::found_slave> found;
    std::vector<std::uint16_t> stations;
    for (const auto& each : slaves_) {
        if (each.is_absent || !each.is_identified) continue;
        const auto& info = each.info;
        ethercat::slave_identity is{.identity = {info.vendor, info.product, info.revision, info.serial},
                                    .alias = info.alias != 0 ? info.alias : each.identity.stored_alias,
                                    .device_id = each.identity.device_id};
        found.push_back({.position = each.info.position, .is = is});
        stations.push_back(each.info.station);
    }
    const auto matches = named_.match(std::move(found));
    for (std::size_t i = 0; i != matches.size(); ++i) {
        auto& which = named_.all()[i];
        auto* const known = slave_of(which);
        if (known != nullptr && known->info.is_served) {
            is_match_due_ = is_match_due_ || known->is_absent; // its user is about to lose it
            continue;
        }
        const bool is_there = known != nullptr && !known->is_absent;
        using enum ethercat::slave_match;
        const auto match = matches[i].match;
        auto* const by = match == missing || match == doubled ? nullptr : at(stations[matches[i].at]);
        if (match == missing && known != nullptr && known->is_absent)
            continue; // it is lost
        else if (match == missing)
            refuse(which, bus_errc::missing_slave, nullptr);
        else if (match == doubled)
            refuse(which, bus_errc::doubled_slave, nullptr);
        else if (match == foreign)
            refuse(which, bus_errc::foreign_slave, by);
        else if (match == swapped || (is_there && known != by) || (by->last_name != nullptr && by->last_name != &which))
            refuse(which, bus_errc::swapped_slave, by); // its station address says that it is another one
        else if (known != by && may_be(*by, which, known))
            give_name(*by, which, known);
    }
    std::erase_if(slaves_, [](const bus_slave& each) { return each.info.station == 0; });
    for (auto& each : slaves_) {
        if (each.named != nullptr || each.is_absent || !each.is_identified || is_match_due_) continue;
        if (std::exchange(each.is_prepared, true)) continue;
        log(name_of(each.info) + " is none of the named slaves: it is left as it is");
    }
}
JAUSCAT_DECL bool bus_state::may_be(const bus_slave& slave, const named_slave& which, const bus_slave* before) {
    const auto& entry = which.entry;
    if (before == nullptr || entry.alias || entry.identification || entry.serial) return true;
    const bool is_stranger = slave.is_prepared && slave.last_name == nullptr; // it was beside that one
    return !is_stranger && slave.info.vendor == before->info.vendor && slave.info.product == before->info.product;
}
JAUSCAT_DECL void bus_state::give_name(bus_slave& slave, named_slave& which, bus_slave* before) {
    slave.named = &which;
    slave.last_name = &which;
    slave.info.configured_name = which.entry.name;
    slave.is_prepared = slave.info.is_served;
    which.why = {};
    if (before == nullptr) return;
    slave.info.is_lost = before->info.is_lost;
    slave.why = before->why;
    slave.next_look = before->next_look;
    before->named = nullptr;
    before->info.station = 0; // erased
}
JAUSCAT_DECL bus_slave* bus_state::next_to_prepare() {
    const auto now = net::now();
    const auto found = std::ranges::find_if(slaves_, [=](const bus_slave& each) {
        return each.named != nullptr && !each.is_prepared && !each.is_absent && !each.info.is_served &&
               (each.is_brought_up || each.next_try <= now);
    });
    return found == slaves_.end() ? nullptr : &*found;
}
JAUSCAT_DECL void bus_state::note_prepared(bus_slave& slave, bool is_start) {
    auto& which = *slave.named;
    which.why = {};
    which.station = slave.info.station;
    slave.is_prepared = true;
    slave.is_brought_up = false; // is done at the next time
    slave.is_configured = false;
    slave.info.is_lost = false;
    slave.why = {};
    slave.next_try = net::now() + timing_.bring_up_interval;
    problem_.clear();
    log(name_of(slave.info) + " is there");
    if (!is_start) call_later(&bus_state::on_found, slave.info);
    note_state(slave, {.state = ethercat::al_state::pre_op});
    if (which.user != nullptr) which.user->slave_ready();
}
JAUSCAT_DECL void bus_state::note_unprepared(bus_slave& slave, error_code why) {
    slave.is_brought_up = false;
    slave.next_try = net::now() + timing_.bring_up_interval;
    note_lost(slave, why);
}
JAUSCAT_DECL error_code bus_state::first_refusal() {
    for (const auto& each : named_.all()) {
        const auto* const slave = slave_of(each);
        if (each.why && !(each.entry.is_optional && each.why == bus_errc::missing_slave)) return each.why;
        if (slave != nullptr && !slave->info.is_served && slave->info.is_lost && !slave->is_absent) return slave->why;
    }
    return {};
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
