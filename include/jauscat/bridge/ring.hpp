// The slaves of one link and the components in front of them: frames, messages and time in, frames and messages out. It
// never blocks: messages are accepted during a transfer, and stop orders overtake them.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/bridge/component.hpp>
#include <jauscat/ethercat/hilscher/packet_job.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/schema/jaus/communications.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::bridging {

/// Jobs of others than a ring for its master. One that keeps a stop order waiting is cancelled: its error is then
/// `timeout`.
struct shared_jobs {
    /// May start a job of the idle master, and says whether it has.
    jaus::hook<bool(ethercat::master& idle)> begin{};
    /// That job has ended. Its result is the master's until this has returned.
    jaus::hook<void(ethercat::master& idle)> done{};
    /// Each cycle of the process data, after the steps of process parts: for slaves without components.
    jaus::hook<void()> cycle{};
};

/// A slave of a ring; the ring's own.
struct ring_place {
    enum class phase : std::uint8_t {
        absent,     // next: bring_up
        pre_op,     // cyclic: next is configure
        configured, // next: SAFE-OP
        safe_op,    // next: OP; its process data are exchanged from here on
        settling,   // in OP; until its inputs are there
        up,
    };

    slave_front* front{};
    phase at{};
    ethercat::master_error bring_up{};
    time_point next_try = time_point::min();
    time_point next_keep_alive{};
    time_point last_seen{}; // in a state in which it can be commanded
    time_point settling_until{};
    bool takes_keep_alive{true};
    bool has_reply{};
    std::span<std::byte> outputs{}; // in data_, if it is exchanged
    std::span<const std::byte> inputs{};
    const ethercat::slave_status* status{};
};

/// What a ring keeps in memory of the user, for as many slaves as each span has elements.
struct ring_memory {
    std::span<ring_place> places{};
    std::span<ethercat::slave_record> records{};
    std::span<ethercat::slave_record> exchanged{}; ///< those in the process data
    std::span<ethercat::process_slot> slots{};
    std::span<std::byte> image{}; ///< all outputs and inputs, up to 64 KiB
};

/// Memory for up to `Slaves` slaves and `Bytes` of process data.
template <std::size_t Slaves, std::size_t Bytes> struct ring_memory_for {
    std::array<ring_place, Slaves> places{};
    std::array<ethercat::slave_record, Slaves> records{}, exchanged{};
    std::array<ethercat::process_slot, Slaves> slots{};
    std::array<std::byte, Bytes> image{};

    [[nodiscard]] ring_memory spans() noexcept { return {places, records, exchanged, slots, image}; }
};

/// Other work on the same link goes by the same master, in turn with the slaves' jobs: see `share`.
///
/// Call `on_time` at `next_event()` and after the components have received messages, and `on_frame` for each received
/// frame; after either, send the frames from `next_frame` until it returns none. JAUS messages (acknowledgements and
/// reports) are passed to `out`.
class ring {
  public:
    using bytes = std::span<const std::byte>;

    /// Options and memory must outlive it: see ring_for. The watchdog, the times of loss and the keep-alive of each
    /// slave are those of its front; the period is the shortest of all.
    ring(const bridge_options& options, const ring_memory& memory) noexcept
        : options_{options},
          master_{memory.records},
          data_{memory.slots, memory.image.first(std::min(memory.image.size(), max_image))},
          memory_{memory.places},
          records_{memory.exchanged} {}
    ring(const ring&) = delete;
    ring& operator=(const ring&) = delete;

    /// Adds a slave of this link, not from within a turn. It must outlive the ring, or be removed. False if the ring is
    /// full.
    [[nodiscard]] bool add(slave_front& front) noexcept {
        if (place_count_ == memory_.size()) return false;
        memory_[place_count_] = {};
        memory_[place_count_].at = front.options().is_taken_over ? phase::pre_op : phase::absent;
        memory_[place_count_++].front = &front;
        return true;
    }
    /// Removes a slave, not from within a turn: it is left as it is. Bring it to rest before, see `shut_down`.
    void remove(const slave_front& front, time_point now) {
        const auto found = std::ranges::find(places(), &front, &place::front);
        if (found == places().end()) return;
        place* const gone = &*found;
        if (work_ != work::none && work_ != work::shared && served_ == gone) {
            master_.cancel(ethercat::master_errc::timeout);
            work_ = work::none;
            job_.reset();
        } else if (served_ > gone) {
            --served_;
        }
        std::move(found + 1, places().end(), found);
        --place_count_;
        last_served_ = 0;
        rebuild_process_data(now);
    }
    /// The options have changed.
    void apply_options() {
        auto config = options_.master;
        config.logical_base = logical_base_;
        master_.set_config(config);
    }

    /// Jobs of others. Those that reset slaves of this ring (scan, bring_up, change_state) end their work as a loss
    /// does.
    void share(const shared_jobs& others) noexcept { shared_ = others; }
    /// Cancels the job of others that runs, with the error `timeout`; it ends in the next turn. False: there is none.
    bool cancel_shared() noexcept {
        if (work_ != work::shared) return false;
        master_.cancel(ethercat::master_errc::timeout);
        return true;
    }
    /// The slaves are cleared of what an earlier master has left in them: they are not scanned again.
    [[nodiscard]] bool is_cleared() const noexcept { return is_cleared_; }

    /// Takes a frame that arrived. False if it was not waited for: it may be another master's.
    bool on_frame(bytes frame, time_point now, jaus::message_sink out) {
        const bool waited = data_.waits();
        const bool was_taken = data_.on_frame(frame) || master_.on_frame(frame, now);
        is_step_due_ = is_step_due_ || (waited && !data_.waits());
        on_time(now, out);
        return was_taken;
    }
    void on_time(time_point now, jaus::message_sink out) {
        last_turn_ = now;
        if (!has_begun_) begin(now);
        master_.on_time(now);
        watch_cycles(now, out);
        refuse_expired(now, out);
        use_process_data(now, out);
        stop_what_hinders(now);
        while (master_.idle() && advance(now, out)) {}
    }
    /// Writes the next frame to `frame`, which holds 1514 bytes, and returns its size; 0 when there is nothing to send
    /// now.
    [[nodiscard]] std::size_t next_frame(std::span<std::byte> frame, time_point now) {
        if (cycles() && now >= next_cycle_) {
            // Missed cycles are skipped.
            next_cycle_ = std::max(next_cycle_ + interval(), now + interval() / 2);
            is_step_due_ = is_step_due_ || data_.waits(); // a frame of the last cycle is lost
            data_.begin_cycle();
        }
        if (const auto size = data_.next_frame(frame, now)) return size;
        if (cycles() && next_cycle_ - now <= reserve()) return 0; // the process data must not wait behind it
        return master_.next_frame(frame, now);
    }
    /// The link has not sent the last frame.
    void not_sent() noexcept { master_.cancel(ethercat::master_errc::not_sent); }

    /// When `on_time` or `next_frame` will next have something to do, if nothing arrives first.
    [[nodiscard]] std::optional<time_point> next_event() const {
        std::optional<time_point> next;
        const auto consider = [&](std::optional<time_point> other) {
            if (other && (!next || *other < *next)) next = other;
        };
        if (!master_.idle()) {
            // A frame may be overdue and still delayed in favour of the process data.
            if (const auto frame = master_.next_event()) {
                const auto at = std::max(*frame, last_turn_);
                consider(cycles() && next_cycle_ - at <= reserve() ? std::max(at, next_cycle_) : at);
            }
            if (const auto hindered = hindered_until()) consider(*hindered);
        }
        if (cycles()) consider(next_cycle_);
        for (const place& each : places()) {
            consider(each.front->orders().next_expiry());
            if (each.at == phase::up) consider(saturating_add(each.last_seen, longest_silence(each)));
            if (master_.idle()) consider(next_work_of(each));
        }
        return next;
    }

    /// Every actuator has confirmed that it stops, also those of lost slaves.
    [[nodiscard]] bool at_rest() const noexcept {
        return std::ranges::all_of(places(), [](const place& each) {
            return std::ranges::none_of(each.front->components(),
                                        [](const component* unit) { return unit->stops().stop_is_pending(); });
        });
    }
    /// Shuts all components down, see component::shut_down. Keep driving the ring until `at_rest`.
    void shut_down(time_point now, jaus::message_sink out) {
        for (place& each : places())
            for (component* unit : each.front->components()) unit->shut_down(now, out);
    }

    /// Whether what the master does now only keeps a slave from stopping: nothing that a log needs.
    [[nodiscard]] bool keeps_alive() const noexcept {
        return work_ == work::message && purpose_ == purpose::keep_alive;
    }
    [[nodiscard]] const ethercat::master& master() const noexcept { return master_; }
    [[nodiscard]] const ethercat::process_data& process_data() const noexcept { return data_; }
    /// Why the last attempt to bring the slave up has failed; ok if it has not.
    [[nodiscard]] const ethercat::master_error& bring_up_error(const slave_front& front) const noexcept {
        const auto found = std::ranges::find(places(), &front, &place::front);
        static constexpr ethercat::master_error none{};
        return found == places().end() ? none : found->bring_up;
    }

  private:
    static constexpr unsigned window_bits = 16; // holds every image
    static constexpr std::size_t max_image = std::size_t{1} << window_bits;
    static constexpr std::size_t message_size = jaus::header_size + jaus::max_body_size;

    using place = ring_place;
    using phase = place::phase;
    // Purpose of the master's current job.
    enum class work : std::uint8_t { none, scan, bring_up, configure, safe_op, op, collect, message, shared };
    enum class purpose : std::uint8_t { order, stop, keep_alive };

    [[nodiscard]] std::span<place> places() noexcept { return memory_.first(place_count_); }
    [[nodiscard]] std::span<const place> places() const noexcept { return memory_.first(place_count_); }
    [[nodiscard]] bool cycles() const noexcept { return exchanged_ != 0; }
    [[nodiscard]] duration interval() const noexcept {
        return has_process_data_ ? options_.period : options_.check_interval;
    }
    [[nodiscard]] static duration longest_silence(const place& at) noexcept {
        return at.front->timing().longest_silence;
    }
    [[nodiscard]] duration reserve() const noexcept { return has_process_data_ ? options_.period / 4 : duration{}; }

    // A slave that was not reached when all were cleared may still run with the place in the process image that an
    // earlier life of this program gave it: each life has an image elsewhere, in one of 2^16 windows.
    void begin(time_point now) {
        const auto start = static_cast<std::uint64_t>(now.time_since_epoch() / std::chrono::microseconds{1});
        const auto window = start * 0x9E37'79B9'7F4A'7C15U >> (32 + window_bits); // spreads starts that are close
        logical_base_ = static_cast<std::uint32_t>(window << window_bits);
        auto config = options_.master;
        config.logical_base = logical_base_;
        master_.reset(config);
        has_begun_ = true;
    }

    // ---- The master's next job, in the order of urgency.

    // True where something was done and there may be more.
    bool advance(time_point now, jaus::message_sink out) {
        if (work_ != work::none) {
            complete(now, out);
            return true;
        }
        for (place& each : places())
            if (begin_stop(each, now, out)) return true;
        // Round robin: no slave waits for more than one job of each of the others. The last turn is the shared jobs'.
        const std::size_t turns = place_count_ + 1;
        for (std::size_t i = 0; i != turns; ++i) {
            const auto turn = (last_served_ + 1 + i) % turns;
            if (turn == place_count_ ? !begin_shared() : !begin_other(memory_[turn], now, out)) continue;
            last_served_ = turn;
            return true;
        }
        return false;
    }

    bool begin_shared() {
        if (!shared_.begin || !shared_.begin(master_)) return false;
        work_ = work::shared;
        return true;
    }
    void end_shared() {
        if (master_.result<ethercat::scan>().value_or(0) != 0) is_cleared_ = true;
        shared_.done(master_);
    }

    bool begin_stop(place& at, time_point now, jaus::message_sink out) {
        if (!at.front->up()) return false;
        for (component* unit : at.front->components()) {
            const auto what = unit->stops().next();
            if (!what || unit->stops().next_attempt() > now || stops_by_process_data(*unit, *what)) continue;
            unit_ = unit;
            stop_ = *what;
            const auto size = unit->stop_message(*what, message_);
            begin_message(at, purpose::stop, size, now, out);
            return true;
        }
        return false;
    }

    bool begin_other(place& at, time_point now, jaus::message_sink out) {
        switch (at.at) {
        case phase::absent: return now >= at.next_try && !at.front->options().is_taken_over && begin_bring_up(at);
        case phase::pre_op:
            return begin_job(at, work::configure,
                             ethercat::configure{at.front->station(), at.front->timing().watchdog});
        case phase::configured:
            return begin_job(at, work::safe_op,
                             ethercat::change_state{at.front->station(), ethercat::al_state::safe_op});
        case phase::safe_op:
            return begin_job(at, work::op, ethercat::change_state{at.front->station(), ethercat::al_state::op});
        case phase::settling: return false;
        case phase::up: break;
        }
        if (at.has_reply) return begin_job(at, work::collect, ethercat::collect_emergencies{at.front->station()});
        if (begin_order(at, now, out)) return true;
        return begin_keep_alive(at, now, out);
    }

    template <ethercat::master_job Job> bool begin_job(place& at, work what, const Job& job) {
        const bool started = static_cast<bool>(master_.start(job));
        served_ = &at;
        work_ = started ? what : work::none;
        return started;
    }
    // Slaves may still be as an earlier master, or an earlier life of this program, has left them.
    bool begin_bring_up(place& at) {
        if (!is_cleared_) return begin_job(at, work::scan, ethercat::scan{});
        const auto& slave = at.front->options();
        return begin_job(at, work::bring_up,
                         ethercat::bring_up{slave.position, slave.identity.station, slave.expected});
    }
    // Nothing that moves the actuator goes before a stop order that it has not confirmed.
    [[nodiscard]] static bool is_held_back(const order& each) noexcept {
        return each.unit->stops().next() && !is_query(each.header);
    }
    [[nodiscard]] static bool may_go_by_mailbox(const order& each) {
        return !is_held_back(each) && !goes_by_process_data(each);
    }
    bool begin_order(place& at, time_point now, jaus::message_sink out) {
        auto& orders = at.front->orders();
        const order* const next = orders.first(may_go_by_mailbox);
        if (next == nullptr) return false;
        unit_ = next->unit;
        order_ = *next;
        jaus::header head = order_.header;
        head.destination = unit_->self(); // also where all of a level are meant
        const auto made = jaus::join(head, orders.body(*next), message_);
        orders.remove(*next);
        begin_message(at, purpose::order, made ? made->size() : 0, now, out);
        return true;
    }
    bool begin_keep_alive(place& at, time_point now, jaus::message_sink out) {
        if (at.front->options().cyclic || at.front->timing().keep_alive == duration{} || !at.takes_keep_alive ||
            now < at.next_keep_alive || at.front->components().empty())
            return false;
        unit_ = at.front->components().front();
        const auto message_bytes = jaus::make_message({.destination = unit_->self(), .source = unit_->self()},
                                                      jaus::report_heartbeat_pulse{}, message_);
        begin_message(at, purpose::keep_alive, message_bytes->size(), now, out);
        return true;
    }

    void begin_message(place& at, purpose what, std::size_t size, time_point now, jaus::message_sink out) {
        served_ = &at;
        work_ = work::message;
        purpose_ = what;
        take_step(exchange().begin(std::span{message_}.first(size), packet_), now, out);
    }
    [[nodiscard]] any_exchange& exchange() const noexcept { return served_->front->exchange(); }
    // A request packet is executed by the master; any other step ends the exchange.
    void take_step(const exchange_step& step, time_point now, jaus::message_sink out) {
        if (step.what != exchange_progress::request) return end_message(step, now, out);
        const auto packet = std::span{packet_}.first(step.size);
        tell_packet(packet);
        job_.emplace(packet, confirmation_, ethercat::packet_options{.download = options_.download});
        if (!job_->start(master_)) confirm(now, out);
    }
    void confirm(time_point now, jaus::message_sink out) {
        const auto size = job_->finish(master_);
        take_step(exchange().on_confirmation(std::span{confirmation_}.first(size), packet_), now, out);
    }
    void tell_packet(bytes packet) const {
        if (purpose_ == purpose::keep_alive) return;
        const auto& watcher = served_->front->watcher();
        hilscher::packet_header head{};
        static_cast<void>(wire::decode_prefix(head, packet));
        if (head.ul_cmd == hilscher::packet_command::sdo_upload_req)
            watcher.asks_report(*served_->front, packet);
        else
            watcher.translated(*served_->front, packet);
    }

    // ---- What its end means.

    void complete(time_point now, jaus::message_sink out) {
        if (work_ == work::message) {
            if (job_->next(master_)) return;
            return confirm(now, out);
        }
        if (work_ == work::shared) {
            work_ = work::none;
            return end_shared();
        }
        place& at = *served_;
        const auto result = master_.error();
        switch (std::exchange(work_, work::none)) {
        case work::scan: return cleared(at, master_.result<ethercat::scan>().value_or(0));
        case work::bring_up: return brought_up(at, result, now);
        case work::configure: return set_up(at, result, phase::configured, now, out);
        case work::safe_op: return set_up(at, result, phase::safe_op, now, out);
        case work::op: return set_up(at, result, phase::settling, now, out);
        case work::collect: at.has_reply = false; return tell_emergencies(at);
        default: return;
        }
    }

    // A failed job is repeated, unless a slave is up that it would reset.
    void cleared(place& at, std::size_t slaves) {
        is_cleared_ = true;
        static_cast<void>(begin_bring_up(at));
        is_cleared_ = slaves != 0;
    }
    void brought_up(place& at, const ethercat::master_error& error, time_point now) {
        at.bring_up = error;
        at.next_try = saturating_add(now, at.front->timing().bring_up_interval);
        if (error != ethercat::master_error{}) return at.front->watcher().bring_up_failed(*at.front, error);
        is_cleared_ = true;
        at.takes_keep_alive = true;
        at.has_reply = false;
        at.at = at.front->options().cyclic ? phase::pre_op : phase::up;
        at.front->watcher().slave_up(*at.front, *master_.find(at.front->station()), at.at == phase::up);
        if (at.at == phase::up) ready(at, now);
    }
    void set_up(place& at, const ethercat::master_error& error, phase next, time_point now, jaus::message_sink out) {
        if (error != ethercat::master_error{}) {
            at.bring_up = error;
            return lose(at, loss::no_process_data, error, now, out);
        }
        at.at = next;
        if (next == phase::safe_op) rebuild_process_data(now);
        if (next == phase::settling) at.settling_until = saturating_add(now, options_.master.state_timeout);
    }
    void ready(place& at, time_point now) {
        at.at = phase::up;
        at.last_seen = now;
        if (!at.front->options().cyclic) rebuild_process_data(now);
        at.front->set_up(true);
        for (component* unit : at.front->components())
            if (unit->is_up()) unit->on_slave_up();
    }
    void tell_emergencies(place& at) {
        const auto* const record = master_.find(at.front->station());
        if (record == nullptr) return;
        for (const auto& each : record->emergencies.kept()) at.front->watcher().slave_emergency(*at.front, each);
        master_.clear_emergencies(at.front->station());
    }

    void end_message(const exchange_step& step, time_point now, jaus::message_sink out) {
        work_ = work::none;
        place& at = *served_;
        const bool was_executed = step.what == exchange_progress::done;
        const auto error = job_ ? job_->error() : ethercat::master_error{};
        const refusal_reason why{.why = exchange().error() != translate::errc::ok ? refusal::not_translated
                                                                                  : refusal::by_slave,
                                 .error = exchange().error(),
                                 .status = exchange().status(),
                                 .of_master = error};
        const bool answers = was_executed || is_of_slave(error);
        if (answers) at.next_keep_alive = saturating_add(now, at.front->timing().keep_alive);
        const auto report = std::span{packet_}.first(was_executed ? step.size : 0);
        job_.reset();
        switch (purpose_) {
        case purpose::order: end_order(was_executed, report, why, now, out); break;
        case purpose::stop: end_stop(was_executed, why, now, out); break;
        case purpose::keep_alive:
            if (was_executed || !answers) break;
            at.takes_keep_alive = false;
            at.front->watcher().no_keep_alive(*at.front, why);
            break;
        }
        tell_emergencies(at);
        if (!answers) lose(at, loss::no_answer, error, now, out);
    }
    // The slave has refused, and so is present.
    static bool is_of_slave(const ethercat::master_error& error) noexcept {
        using enum ethercat::master_errc;
        return error.code == ok || error.code == sdo_abort || error.code == clear_refused ||
               error.code == mailbox_error || error.code == data_too_long;
    }
    void end_order(bool was_executed, bytes report, const refusal_reason& why, time_point now, jaus::message_sink out) {
        if (!was_executed) return unit_->on_not_executed(order_.header, why, now, out);
        if (!report.empty()) out(report);
        unit_->on_executed(order_.header, now, out);
    }
    void end_stop(bool was_executed, const refusal_reason& why, time_point now, jaus::message_sink out) {
        // A confirmation from before the slave's loss does not count: the order is sent again when the slave is back.
        if (was_executed && !served_->front->up()) return;
        if (was_executed) return unit_->on_confirmed(stop_, now, out);
        using enum ethercat::abort_code;
        const auto code = why.of_master.abort;
        const bool is_unknown =
            (why.of_master.code == ethercat::master_errc::sdo_abort && (code == no_object || code == no_subindex)) ||
            why.error == translate::errc::unknown_index;
        unit_->on_refused(stop_, is_unknown, why, now, out);
    }

    // ---- What ends by time.

    // A job that delays a stop order is cancelled; one that is itself a stop order is not.
    [[nodiscard]] std::optional<time_point> hindered_until() const {
        if (!hindered_since_) return std::nullopt;
        return saturating_add(*hindered_since_, options_.stop_timeout);
    }
    void stop_what_hinders(time_point now) {
        if (!is_hindered(now)) return hindered_since_.reset();
        if (!hindered_since_) hindered_since_ = now;
        if (now - *hindered_since_ < options_.stop_timeout) return;
        hindered_since_.reset();
        // A late reply could be mistaken for the next one's, so a slave whose transfer is cancelled counts as lost and
        // is brought up again.
        master_.cancel(ethercat::master_errc::timeout);
    }
    // A slave waits for a stop order, and the master is busy with something else than a transfer to that slave.
    [[nodiscard]] bool is_hindered(time_point now) const {
        if (master_.idle() || (work_ == work::message && purpose_ == purpose::stop)) return false;
        return std::ranges::any_of(places(), [&](const place& each) {
            if (!each.front->up() || (work_ == work::message && &each == served_)) return false;
            return std::ranges::any_of(each.front->components(), [&](const component* unit) {
                const auto what = unit->stops().next();
                return unit->stops().stop_is_pending() && unit->stops().next_attempt() <= now &&
                       !stops_by_process_data(*unit, *what);
            });
        });
    }
    void refuse_expired(time_point now, jaus::message_sink out) {
        for (place& each : places())
            each.front->orders().remove_if([&](const order& waiting) { return waiting.expires.is_reached(now); },
                                           [&](const order& late) {
                                               late.unit->on_not_executed(late.header, {.why = refusal::expired}, now,
                                                                          out);
                                           });
    }
    [[nodiscard]] std::optional<time_point> next_work_of(const place& at) const {
        switch (at.at) {
        case phase::absent: return at.front->options().is_taken_over ? std::nullopt : std::optional{at.next_try};
        case phase::pre_op:
        case phase::configured:
        case phase::safe_op: return time_point::min();
        case phase::settling: return at.settling_until;
        case phase::up: break;
        }
        if (at.has_reply || at.front->orders().first(may_go_by_mailbox) != nullptr) return time_point::min();
        std::optional<time_point> next;
        const auto consider = [&](time_point other) { next = next ? std::min(*next, other) : other; };
        for (const component* unit : at.front->components())
            if (const auto what = unit->stops().next(); what && !stops_by_process_data(*unit, *what))
                consider(unit->stops().next_attempt());
        if (!at.front->options().cyclic && at.takes_keep_alive && at.front->timing().keep_alive != duration{})
            consider(at.next_keep_alive);
        return next;
    }

    void lose(place& at, loss what, const ethercat::master_error& why, time_point now, jaus::message_sink out) {
        if (at.at == phase::absent) return; // its last job has ended only now
        const bool was_up = at.front->up();
        at.at = phase::absent;
        at.next_try = was_up ? now : saturating_add(now, at.front->timing().bring_up_interval);
        std::array<bool, component_capacity> were_up{};
        std::ranges::transform(at.front->components(), were_up.begin(), [](auto* unit) { return unit->is_up(); });
        at.front->set_up(false);
        at.front->set_data({});
        at.front->watcher().slave_lost(*at.front, what, why);
        for (std::size_t i = 0; i != at.front->components().size(); ++i) {
            component& unit = *at.front->components()[i];
            unit.front().orders().remove_if(
                [&](const order& each) { return each.unit == &unit; },
                [&](const order& each) { unit.on_not_executed(each.header, {.why = refusal::slave_down}, now, out); });
            if (were_up[i]) unit.on_slave_lost(now, out);
        }
        // A pending command would be requested again, and reach a slave that returns.
        if (work_ == work::message && purpose_ == purpose::order && served_ == &at)
            master_.cancel(ethercat::master_errc::timeout);
        rebuild_process_data(now);
    }

    // ---- Cycles: process data, and the state of every slave.

    [[nodiscard]] static bool is_exchanged(const place& at) noexcept {
        return at.at >= (at.front->options().cyclic ? phase::safe_op : phase::up);
    }
    // Rebuilds the process image from the present slaves; keeps their outputs.
    void rebuild_process_data(time_point now) {
        std::size_t count = 0;
        for (place& each : places()) {
            const auto* const record = master_.find(each.front->station());
            if (is_exchanged(each) && record != nullptr) records_[count++] = *record;
        }
        data_.set_slaves(records_.first(count), {.watch_slaves = true, .logical_base = logical_base_});
        has_process_data_ = data_.image().size != 0;
        if (exchanged_ == 0 || next_cycle_ > saturating_add(now, interval())) next_cycle_ = now;
        exchanged_ = count;
        for (place& each : places()) {
            const auto* const record = is_exchanged(each) ? master_.find(each.front->station()) : nullptr;
            each.outputs = record == nullptr ? std::span<std::byte>{} : data_.outputs(*record);
            each.inputs = record == nullptr ? bytes{} : data_.inputs(*record);
            each.status = record == nullptr ? nullptr : &data_.status(*record);
            show_data(each);
        }
    }
    // What parts see of a slave. Until it is up its outputs remain zeros.
    static void show_data(place& at) {
        if (at.at != phase::up || at.status == nullptr || !at.front->options().cyclic) return at.front->set_data({});
        at.front->set_data({at.outputs, at.inputs, *at.status});
    }
    // Whether a stop order goes to the outputs alone.
    [[nodiscard]] static bool stops_by_process_data(const component& unit, stop_order what) {
        const auto* const process = unit.process();
        return process != nullptr && (what == stop_order::rest || !process->part().uses_mailbox());
    }
    [[nodiscard]] static bool goes_by_process_data(const order& each) {
        const auto* const process = each.unit->process();
        return process != nullptr && process->takes(each.header);
    }

    // Evaluates the status of each slave after a cycle.
    void watch_cycles(time_point now, jaus::message_sink out) {
        for (place& each : places()) {
            if (!is_exchanged(each) || each.status == nullptr) continue;
            const auto& seen = *each.status;
            using enum ethercat::slave_condition;
            if (each.at == phase::settling) {
                if (seen.condition == running)
                    start_process_data(each, now, out);
                else if (now >= each.settling_until)
                    lose(each, loss::no_process_data, {.code = ethercat::master_errc::working_counter}, now, out);
                continue;
            }
            if (each.at != phase::up) continue;
            if (const auto last = last_working(each, seen)) each.last_seen = std::max(each.last_seen, *last);
            each.has_reply = seen.reply_waiting;
            show_data(each);
            const ethercat::master_error state{.code = ethercat::master_errc::al_error, .al_status = seen.al.code};
            if (seen.condition == absent)
                lose(each, loss::no_station, {.code = ethercat::master_errc::working_counter}, now, out);
            else if (seen.condition == duplicate)
                lose(each, loss::no_station, {.code = ethercat::master_errc::duplicate_station}, now, out);
            else if (seen.condition != silent && !works_in(each, seen.al.state))
                lose(each, loss::left_state, state, now, out);
            else if (now - each.last_seen >= longest_silence(each))
                lose(each, loss::no_answer, {.code = ethercat::master_errc::no_reply}, now, out);
        }
    }
    // A slave by mailbox need not be in OP.
    [[nodiscard]] static bool works_in(const place& at, ethercat::al_state state) noexcept {
        using enum ethercat::al_state;
        return state == op || (!at.front->options().cyclic && (state == pre_op || state == safe_op));
    }
    [[nodiscard]] static std::optional<time_point> last_working(const place& at,
                                                                const ethercat::slave_status& seen) noexcept {
        if (at.front->options().cyclic) return seen.last_running;
        return works_in(at, seen.al.state) ? seen.last_frame : std::nullopt;
    }
    // The last slave of a component starts its part.
    void start_process_data(place& at, time_point now, jaus::message_sink out) {
        at.front->set_data({at.outputs, at.inputs, *at.status});
        for (component* unit : at.front->components()) {
            auto* const process = unit->process();
            if (process == nullptr || std::ranges::any_of(process->fronts(), [&](const slave_front* each) {
                    return each != at.front && !each->up();
                }))
                continue;
            if (!process->start(options_.period))
                return lose(at, loss::no_process_data, {.code = ethercat::master_errc::size_mismatch}, now, out);
        }
        at.front->watcher().slave_up(*at.front, *master_.find(at.front->station()), true);
        ready(at, now);
    }

    // Messages that go by process data, and the slaves' confirmations of those that went.
    void use_process_data(time_point now, jaus::message_sink out) {
        const bool steps = std::exchange(is_step_due_, false);
        for (place& each : places()) {
            if (!each.front->options().cyclic) continue;
            for (component* unit : each.front->components()) {
                auto* const process = unit->process();
                if (process == nullptr || process->fronts().front() != each.front || !process->has_begun()) continue;
                if (steps) unit->on_step(process->step(now), now, out);
                take_confirmations(*unit, *process, now, out);
                put_stop(*unit, *process, now, out);
                if (process->is_started()) put_orders(*unit, *process, now, out);
            }
        }
        if (steps) shared_.cycle();
    }
    // Also where the slave gets an emergency by mailbox, and where others of the group are lost.
    void put_stop(component& unit, process_channel& process, time_point now, jaus::message_sink out) {
        const auto& stops = unit.stops();
        const auto next = stops.next();
        if (next == stop_order::clear_emergency && !process.part().uses_mailbox())
            return unit.on_confirmed(stop_order::clear_emergency, now, out);
        if (!stops.stop_is_pending() || !process.has_slaves()) return;
        const bool is_awaited =
            process.is_started() && stops_by_process_data(unit, *next) && stops.next_attempt() <= now;
        const auto what = is_awaited ? *next : stop_order::rest;
        const auto waiting = process.waiting_stop();
        if (waiting == what || waiting == stop_order::emergency || (process.has_rest_outputs() && !is_awaited)) return;
        const auto limit = is_awaited ? std::optional{unit.front().timing().longest_silence} : std::nullopt;
        const auto number = process.stop(what, limit, now, [&](const jaus::header& head) {
            unit.on_not_executed(head, {.why = refusal::stopped}, now, out);
        });
        unit.front().watcher().into_image(unit.front(), number, unit.front().data().outputs);
    }
    void put_orders(component& unit, process_channel& process, time_point now, jaus::message_sink out) {
        auto& orders = unit.front().orders();
        while (const order* const next = orders.first([&](const order& each) {
            return each.unit == &unit && goes_by_process_data(each) && !is_held_back(each);
        })) {
            jaus::header head = next->header;
            const auto body = orders.body(*next);
            orders.remove(*next);
            if (is_query(head))
                answer(unit, process, head, body, now, out);
            else if (const auto why = put_command(unit, process, head, body, now))
                unit.on_not_executed(head, *why, now, out);
        }
    }

    // Nothing where it is in the outputs; else why not.
    std::optional<refusal_reason> put_command(component& unit, process_channel& process, const jaus::header& head,
                                              bytes body, time_point now) {
        if (process.is_full()) return refusal_reason{.why = refusal::queue_full};
        const auto number = process.command(head, body, unit.front().timing().longest_silence, now);
        if (!number) return refusal_reason{.why = refusal::not_translated, .error = number.error()};
        unit.front().watcher().into_image(unit.front(), *number, unit.front().data().outputs);
        return std::nullopt;
    }
    void answer(component& unit, process_channel& process, const jaus::header& query, bytes body, time_point now,
                jaus::message_sink out) {
        if (!process.has_inputs_within(unit.front().timing().longest_silence, now))
            return unit.on_not_executed(query, {.why = refusal::stale}, now, out);
        jaus::header head = query;
        head.destination = unit.self();                          // also where all of a level are meant
        std::array<std::byte, any_exchange::buffer_size> report; // not packet_, which a running transfer may use
        const auto made = process.answer(head, body, report);
        if (!made)
            return unit.on_not_executed(query, {.why = refusal::not_translated, .error = made.error()}, now, out);
        unit.front().watcher().from_image(unit.front(), unit.front().data().inputs);
        out(*made);
        unit.on_executed(query, now, out);
    }
    void take_confirmations(component& unit, process_channel& process, time_point now, jaus::message_sink out) {
        using enum process_channel::outcome;
        bool takes_stops = true;
        while (const auto over = process.next_ended(now)) {
            if (over->stop && over->how == executed) {
                unit.on_confirmed(*over->stop, now, out);
            } else if (over->stop) {
                unit.on_refused(*over->stop, false, {.why = refusal::not_accepted}, now, out);
                takes_stops = false;
            } else if (over->how == executed) {
                unit.on_executed(over->header, now, out);
            } else if (over->how == superseded) {
                unit.on_not_executed(over->header, {.why = refusal::superseded}, now, out);
            } else {
                unit.on_not_accepted(over->header, now, out);
            }
        }
        if (takes_stops) return;
        for (place& each : places())
            if (std::ranges::count(process.fronts(), each.front) != 0)
                lose(each, loss::no_process_data, {.code = ethercat::master_errc::timeout}, now, out);
    }

    const bridge_options& options_;
    ethercat::master master_;
    ethercat::process_data data_;
    std::span<place> memory_;
    std::span<ethercat::slave_record> records_;
    std::size_t place_count_{};
    std::size_t last_served_{};
    std::size_t exchanged_{}; // slaves in the cyclic exchange
    bool has_process_data_{}; // some of them; else it only reads their states
    bool is_cleared_{};       // the slaves, of what an earlier master has left in them
    bool has_begun_{};
    bool is_step_due_{}; // a cycle has ended
    std::uint32_t logical_base_{};
    time_point last_turn_{};
    time_point next_cycle_{};

    work work_{};
    place* served_{};
    purpose purpose_{};
    component* unit_{};
    stop_order stop_{};
    order order_{};
    std::optional<time_point> hindered_since_{};
    shared_jobs shared_{};
    std::optional<ethercat::packet_job> job_{};
    std::array<std::byte, message_size> message_{};
    std::array<std::byte, std::max(any_exchange::buffer_size, message_size)> packet_{};
    std::array<std::byte, ethercat::packet_job::confirmation_size> confirmation_{};
};

/// A ring with its memory: `ring_for<16, 4096> ring{options}`.
template <std::size_t Slaves, std::size_t Bytes> class ring_for : private ring_memory_for<Slaves, Bytes>, public ring {
  public:
    explicit ring_for(const bridge_options& options) noexcept
        : ring{options, ring_memory_for<Slaves, Bytes>::spans()} {}
};

} // namespace jauscat::bridging
