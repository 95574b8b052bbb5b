// The slaves of one link and the components in front of them: frames, messages and time in, frames and messages out. It
// never blocks: messages are accepted during a transfer, and stop orders overtake them.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/bridge/component.hpp>
#include <jauscat/bridge/message_lane.hpp>
#include <jauscat/bridge/ring_clocks.hpp>
#include <jauscat/bridge/ring_memory.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/schema/jaus/communications.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>

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

/// Times of the cycles. Each longest one is since the ring began.
struct cycle_times {
    duration round_trip{}; ///< from the beginning of the last complete cycle to the return of its last frame
    duration longest_round_trip{};
    duration late{}; ///< the beginning of the last cycle, after it was due
    duration longest_late{};
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
    JAUSCAT_FUNCTION ring(const bridge_options& options, const ring_memory& memory) noexcept;
    ring(const ring&) = delete;
    ring& operator=(const ring&) = delete;

    /// Adds a slave of this link, not from within a turn. It must outlive the ring, or be removed. False if the ring is
    /// full.
    [[nodiscard]] JAUSCAT_FUNCTION bool add(slave_front& front) noexcept;
    /// Removes a slave, not from within a turn: it is left as it is. Bring it to rest before, see `shut_down`.
    JAUSCAT_FUNCTION void remove(const slave_front& front, time_point now);
    /// The options have changed.
    JAUSCAT_FUNCTION void apply_options();

    /// Jobs of others. Those that reset slaves of this ring (scan, bring_up, change_state) end their work as a loss
    /// does.
    void share(const shared_jobs& others) noexcept { shared_ = others; }
    /// Cancels the job of others that runs, with the error `timeout`; it ends in the next turn. False: there is none.
    JAUSCAT_FUNCTION bool cancel_shared() noexcept;
    /// The slaves are cleared of what an earlier master has left in them: they are not scanned again.
    [[nodiscard]] bool is_cleared() const noexcept { return is_cleared_; }

    /// Takes a frame that arrived. False if it was not waited for: it may be another master's.
    JAUSCAT_FUNCTION bool on_frame(bytes frame, time_point now, jaus::message_sink out);
    /// After all frames that have arrived, so that none of them counts as lost.
    JAUSCAT_FUNCTION void on_time(time_point now, jaus::message_sink out);
    /// Writes the next frame to `frame`, which holds 1514 bytes, and returns its size; 0 when there is nothing to send
    /// now.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t next_frame(std::span<std::byte> frame, time_point now);
    /// The link has not sent the last frame.
    JAUSCAT_FUNCTION void not_sent() noexcept;

    /// When `on_time` or `next_frame` will next have something to do, if nothing arrives first.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<time_point> next_event() const;

    /// Every actuator has confirmed that it stops, also those of lost slaves.
    [[nodiscard]] JAUSCAT_FUNCTION bool at_rest() const noexcept;
    /// Shuts all components down, see component::shut_down. Keep driving the ring until `at_rest`.
    JAUSCAT_FUNCTION void shut_down(time_point now, jaus::message_sink out);

    /// While it `is_on`, `shared_jobs::cycle` is called each period also where no slave takes part.
    void keep_cycling(bool is_on, time_point now) noexcept {
        if (!cycles()) next_cycle_ = now;
        keeps_cycling_ = is_on;
    }
    /// When the last cycle has begun. Inputs that are older have not come with it.
    [[nodiscard]] std::optional<time_point> cycle_begun() const noexcept { return cycle_begun_; }
    [[nodiscard]] const cycle_times& times() const noexcept { return times_; }

    /// Whether what goes on now only keeps slaves from stopping: nothing that a log needs.
    [[nodiscard]] JAUSCAT_FUNCTION bool keeps_alive() const noexcept;
    [[nodiscard]] const ethercat::master& master() const noexcept { return master_; }
    /// Of all frames but those of the process data.
    [[nodiscard]] JAUSCAT_FUNCTION ethercat::master_statistics statistics() const noexcept;
    [[nodiscard]] const ethercat::process_data& process_data() const noexcept { return data_; }
    /// The distributed clocks' part of the cycles; none before a slave with SYNC signals has been set up.
    [[nodiscard]] const std::optional<ethercat::clock_cycle>& clocks() const noexcept { return clocks_.cycle(); }
    /// Why the last attempt to bring the slave up has failed; ok if it has not.
    [[nodiscard]] JAUSCAT_FUNCTION const ethercat::master_error&
    bring_up_error(const slave_front& front) const noexcept;

  private:
    static constexpr int looks_apart = 10;      // cycles, at a clock
    static constexpr unsigned window_bits = 16; // holds every image
    static constexpr std::size_t max_image = std::size_t{1} << window_bits;

    using place = ring_place;
    using phase = place::phase;
    // Purpose of the master's current job.
    enum class work : std::uint8_t {
        none,
        scan,
        bring_up,
        start_up,
        configure,
        clocks,
        clock_look,
        sync,
        safe_op,
        op,
        place,
        bring_up_all,
        configure_all,
        safe_op_all,
        op_all,
        place_all,
        shared
    };
    using purpose = message_lane::purpose;

    [[nodiscard]] std::span<place> places() noexcept { return memory_.first(place_count_); }
    [[nodiscard]] std::span<const place> places() const noexcept { return memory_.first(place_count_); }
    // Nullptr: the slave is none of this ring.
    [[nodiscard]] JAUSCAT_FUNCTION place* place_of(std::uint16_t station) const noexcept;
    [[nodiscard]] bool cycles() const noexcept { return exchanged_ != 0 || clocks_.runs() || keeps_cycling_; }
    [[nodiscard]] bool is_periodic() const noexcept { return has_process_data_ || clocks_.runs() || keeps_cycling_; }
    [[nodiscard]] JAUSCAT_FUNCTION duration interval() const noexcept;
    [[nodiscard]] duration reserve() const noexcept { return is_periodic() ? options_.period / 4 : duration{}; }

    // A slave that was not reached when all were cleared may still run with the place in the process image that an
    // earlier life of this program gave it: each life has an image elsewhere, in one of 2^16 windows.
    JAUSCAT_FUNCTION void begin(time_point now);

    JAUSCAT_FUNCTION void turn(time_point now, jaus::message_sink out);
    // All of them send frames to this link.
    JAUSCAT_FUNCTION bool take(bytes frame, time_point now);

    // ---- The master's next job, in the order of urgency.

    // True where something was done and there may be more.
    JAUSCAT_FUNCTION bool advance(time_point now, jaus::message_sink out);

    JAUSCAT_FUNCTION bool begin_shared();
    JAUSCAT_FUNCTION void end_shared();

    // The next step of a slave that is not up.
    JAUSCAT_FUNCTION bool begin_step(place& at, time_point now);
    // All jobs go to its station, which another master may have given to another slave.
    JAUSCAT_FUNCTION bool begin_place_check(place& at);

    // ---- Distributed clocks: of all slaves on the bus, as soon as one is to have SYNC signals.

    [[nodiscard]] JAUSCAT_FUNCTION static bool has_sync(const place& at) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION std::uint64_t system_time(time_point now) const noexcept;
    // The clocks that are in use go on, and so does their time.
    JAUSCAT_FUNCTION bool begin_clocks(place& at, time_point now);
    JAUSCAT_FUNCTION void clocks_set_up(place& at, const ethercat::master_error& error, time_point now,
                                        jaus::message_sink out);
    JAUSCAT_FUNCTION void follow_clock(place& at, time_point now);
    // Its speed must have been learnt, too: just set, any clock is right.
    [[nodiscard]] static bool is_in_time(const place& at) noexcept { return at.good_looks >= 20; }
    // A slave that was not there alone keeps the others from being set up: they are set up without it.
    [[nodiscard]] JAUSCAT_FUNCTION static bool is_of_other(const place& at,
                                                           const ethercat::master_error& error) noexcept;
    JAUSCAT_FUNCTION void leave_out(const ethercat::master_error& error, time_point now, jaus::message_sink out);
    JAUSCAT_FUNCTION bool begin_clock_look(place& at, time_point now);
    JAUSCAT_FUNCTION void clock_looked_at(place& at, const ethercat::master_error& error, time_point now,
                                          jaus::message_sink out);
    // All that follow the reference clock by now start together.
    JAUSCAT_FUNCTION bool begin_sync(place& at, time_point now);
    JAUSCAT_FUNCTION void sync_started(place& at, const ethercat::master_error& error, time_point now,
                                       jaus::message_sink out);
    // The cycles follow the reference clock, and its SYNC signals come.
    [[nodiscard]] JAUSCAT_FUNCTION bool is_synchronized(const place& at) const noexcept;
    // In SAFE-OP, until the cycles follow the reference clock.
    JAUSCAT_FUNCTION void watch_waiting(place& at, time_point now, jaus::message_sink out);
    JAUSCAT_FUNCTION void watch_clocks(time_point now, jaus::message_sink out);

    template <ethercat::master_job Job> bool begin_job(place& at, work what, const Job& job) {
        const bool started = static_cast<bool>(master_.start(job));
        served_ = &at;
        work_ = started ? what : work::none;
        return started;
    }
    // Slaves may still be as an earlier master, or an earlier life of this program, has left them.
    JAUSCAT_FUNCTION bool begin_bring_up(place& at, time_point now);
    JAUSCAT_FUNCTION bool begin_configure(place& at);
    [[nodiscard]] JAUSCAT_FUNCTION static bool goes_to_safe_op(const place& at) noexcept;
    bool begin_state(place& at, work one, work many, ethercat::al_state goal, auto&& joins) {
        if (const auto all = gather(at, state_changes_, joins,
                                    [](const place& each) { return ethercat::state_place{each.front->station()}; });
            !all.empty())
            return begin_job(at, many, ethercat::change_states{all, goal});
        return begin_job(at, one, ethercat::change_state{at.front->station(), goal});
    }

    // ---- Steps of many slaves at once. The job ends with the slowest of them, so that one which was slow is on its
    // own until it is up: it holds the others up once.

    // Empty where it is on its own, and where the frames, which are longer then, could delay the process data.
    template <class Step>
    [[nodiscard]] std::span<Step> gather(const place& at, std::span<Step> memory, auto&& joins, auto&& made) {
        together_ = 0;
        if (at.is_slow || (is_periodic() && options_.period < std::chrono::milliseconds{1})) return {};
        for (const place& each : places()) {
            if (together_ == memory.size()) break;
            if (joins(each) && !each.is_slow && !is_carried(each)) memory[together_++] = made(each);
        }
        return memory.first(together_ > 1 ? together_ : 0);
    }
    // Errors that take the slave's time, not the link's.
    [[nodiscard]] JAUSCAT_FUNCTION static bool is_slow(const ethercat::master_error& error) noexcept;
    // Calls `ended(place, error)` for each slave that is still where it was.
    void complete_all(auto steps, auto&& station_of, auto&& is_expected, auto&& ended, time_point now) {
        holds_rebuild_ = true;
        for (const auto& each : steps.first(together_)) {
            place* const found = place_of(station_of(each));
            if (found != nullptr && is_expected(*found)) ended(*found, each.error);
        }
        holds_rebuild_ = false;
        if (std::exchange(is_rebuild_due_, false)) rebuild_process_data(now);
    }
    JAUSCAT_FUNCTION void brought_up_all(time_point now);
    void set_up_all(auto steps, phase next, auto&& is_expected, time_point now, jaus::message_sink out) {
        complete_all(
            steps, [](const auto& each) { return each.station; }, is_expected,
            [&](place& at, const ethercat::master_error& error) { set_up(at, error, next, now, out); }, now);
    }
    // The slave in the group of a part that has process data of it. The part is nullptr behind the last one.
    struct part_place {
        process_part* part{};
        std::size_t slave{};
    };
    [[nodiscard]] JAUSCAT_FUNCTION static part_place part_of(const place& at, std::size_t which);
    [[nodiscard]] JAUSCAT_FUNCTION static std::span<ethercat::process_object> objects_of(const place& at);
    // Whether one part after the other can work with the process data; each has them set up for its objects.
    JAUSCAT_FUNCTION void configured(place& at, ethercat::master_error error, time_point now, jaus::message_sink out);
    // One list after the other: those of all parts that have process data of the slave.
    [[nodiscard]] JAUSCAT_FUNCTION const ethercat::init_command* next_start_up_object(const place& at) const;
    JAUSCAT_FUNCTION bool begin_start_up(place& at, const ethercat::init_command& object);
    JAUSCAT_FUNCTION void started_up(place& at, const ethercat::master_error& error, time_point now,
                                     jaus::message_sink out);
    // ---- What its end means.

    JAUSCAT_FUNCTION void complete(time_point now, jaus::message_sink out);

    // A failed job is repeated, unless a slave is up that it would reset.
    JAUSCAT_FUNCTION void cleared(place& at, std::size_t slaves, time_point now);
    JAUSCAT_FUNCTION void brought_up(place& at, const ethercat::master_error& error, time_point now);
    JAUSCAT_FUNCTION void reach_pre_op(place& at);
    JAUSCAT_FUNCTION void placed(place& at, const ethercat::master_error& error, time_point now,
                                 jaus::message_sink out);
    JAUSCAT_FUNCTION void set_up(place& at, const ethercat::master_error& error, phase next, time_point now,
                                 jaus::message_sink out);
    JAUSCAT_FUNCTION void ready(place& at, time_point now);
    // ---- Messages by mailbox: a lane for each slave that gets one. The longest transfer, and a slave that does not
    // answer, occupy their own lane only.

    [[nodiscard]] JAUSCAT_FUNCTION message_lane* lane_of(const place& at) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION bool is_carried(const place& at) const noexcept;
    // A lane for a slave: the one it had, or one in which no frame of another slave is left.
    [[nodiscard]] JAUSCAT_FUNCTION message_lane* free_lane(const place& at, time_point now) const noexcept;
    // When it has one, if that can be said.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<time_point> lane_from(const place& at) const noexcept;

    // True where something was done and there may be more.
    JAUSCAT_FUNCTION bool carry(time_point now, jaus::message_sink out);
    JAUSCAT_FUNCTION bool begin_stop(place& at, time_point now);
    JAUSCAT_FUNCTION bool begin_other(place& at, time_point now);
    // Nothing that moves the actuator goes before a stop order that it has not confirmed.
    [[nodiscard]] JAUSCAT_FUNCTION static bool is_held_back(const order& each) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION static bool may_go_by_mailbox(const order& each);
    // Round robin: no component waits for more than one message of each of the others.
    [[nodiscard]] JAUSCAT_FUNCTION static const order* next_order(place& at);
    JAUSCAT_FUNCTION bool begin_order(place& at, message_lane& lane);
    JAUSCAT_FUNCTION bool begin_keep_alive(place& at, message_lane& lane, time_point now);
    JAUSCAT_FUNCTION bool begin_message(message_lane& lane, const message_lane::task& what, std::size_t size);

    JAUSCAT_FUNCTION void end_message(message_lane& lane, time_point now, jaus::message_sink out);
    // The slave has refused, and so is present.
    JAUSCAT_FUNCTION static bool is_of_slave(const ethercat::master_error& error) noexcept;
    JAUSCAT_FUNCTION static void end_order(const message_lane::task& task, const message_lane::outcome& ended,
                                           const refusal_reason& why, time_point now, jaus::message_sink out);
    JAUSCAT_FUNCTION static void end_stop(const message_lane::task& task, bool was_executed, const refusal_reason& why,
                                          time_point now, jaus::message_sink out);
    JAUSCAT_FUNCTION void tell_emergencies(place& at);

    // ---- What ends by time.

    // A job for this slave, or transfers to others in all lanes, that delay a stop order are cancelled; a stop order is
    // not, nor is a transfer to the same slave.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<time_point> hindered_until() const;
    JAUSCAT_FUNCTION void stop_what_hinders(time_point now);
    [[nodiscard]] JAUSCAT_FUNCTION const place* hindered(time_point now) const;
    // After a pause of this program a command would be requested again, and reach the slave too late.
    JAUSCAT_FUNCTION void drop_after_pause(time_point now);
    JAUSCAT_FUNCTION void refuse_expired(time_point now, jaus::message_sink out);
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<time_point> next_work_of(const place& at) const;

    JAUSCAT_FUNCTION void lose(place& at, loss what, const ethercat::master_error& why, time_point now,
                               jaus::message_sink out);

    // ---- Cycles: process data, and the state of every slave.

    [[nodiscard]] JAUSCAT_FUNCTION static bool is_exchanged(const place& at) noexcept;
    // Rebuilds the process image from the present slaves; keeps their outputs.
    JAUSCAT_FUNCTION void rebuild_process_data(time_point now);
    // What parts see of a slave. Until it is up its outputs remain zeros.
    JAUSCAT_FUNCTION static void show_data(place& at);
    // Whether a stop order goes to the outputs alone.
    [[nodiscard]] JAUSCAT_FUNCTION static bool stops_by_process_data(const component& unit, stop_order what);
    [[nodiscard]] JAUSCAT_FUNCTION static bool goes_by_process_data(const order& each);

    // Evaluates the status of each slave after a cycle.
    JAUSCAT_FUNCTION void watch_cycles(time_point now, jaus::message_sink out);
    // Missed cycles are skipped; those that follow a reference clock keep their phase.
    JAUSCAT_FUNCTION void skip_to_next_cycle(time_point now) noexcept;
    // To the parts, if it has changed.
    JAUSCAT_FUNCTION void tell_period();
    [[nodiscard]] bool is_cycle_due(time_point now) const noexcept { return cycles() && now >= next_cycle_; }
    // Silence is counted in cycles, each at most as long as it is to be: the time in which this program did not run is
    // none of the slave's. A cycle whose frames were forgotten, because another slave came or went, counts as well.
    JAUSCAT_FUNCTION void end_cycle(time_point now);
    [[nodiscard]] JAUSCAT_FUNCTION bool has_lost_station(const place& at) const noexcept;
    JAUSCAT_FUNCTION void give_up_settling(place& at, time_point now, jaus::message_sink out);
    // A slave by mailbox need not be in OP.
    [[nodiscard]] JAUSCAT_FUNCTION static bool is_seen(const ethercat::slave_status& seen) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION static bool works_in(const place& at, const ethercat::al_status& al) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION static std::optional<time_point>
    last_working(const place& at, const ethercat::slave_status& seen) noexcept;
    // The last slave of a component starts its part.
    JAUSCAT_FUNCTION void start_process_data(place& at, time_point now, jaus::message_sink out);

    // Messages that go by process data, and the slaves' confirmations of those that went.
    JAUSCAT_FUNCTION void use_process_data(time_point now, jaus::message_sink out);
    // Also where the slave gets an emergency by mailbox, and where others of the group are lost.
    JAUSCAT_FUNCTION void put_stop(component& unit, process_channel& process, time_point now, jaus::message_sink out);
    JAUSCAT_FUNCTION void put_orders(component& unit, process_channel& process, time_point now, jaus::message_sink out);

    // Nothing where it is in the outputs; else why not.
    JAUSCAT_FUNCTION std::optional<refusal_reason> put_command(component& unit, process_channel& process,
                                                               const jaus::header& head, bytes body, time_point now,
                                                               jaus::message_sink out);
    JAUSCAT_FUNCTION void answer(component& unit, process_channel& process, const jaus::header& query, bytes body,
                                 time_point now, jaus::message_sink out);
    JAUSCAT_FUNCTION void take_confirmations(component& unit, process_channel& process, time_point now,
                                             jaus::message_sink out);

    const bridge_options& options_;
    ethercat::master master_;
    ethercat::process_data data_;
    std::span<place> memory_;
    std::span<message_lane> lanes_;
    std::span<ethercat::slave_record> records_;
    std::span<ethercat::bring_up_place> bring_ups_;
    std::span<ethercat::configure_place> configurations_;
    std::span<ethercat::state_place> state_changes_;
    std::span<ethercat::position_place> positions_;
    std::size_t together_{}; // slaves of the master's current job, if it is one for many
    std::size_t place_count_{};
    std::size_t last_served_{};  // by the master
    std::size_t last_carried_{}; // by a lane
    ethercat::master* sender_{}; // of the last frame; none for process data
    std::size_t exchanged_{};    // slaves in the cyclic exchange
    bool has_process_data_{};    // some of them; else it only reads their states
    bool is_cleared_{};          // the slaves, of what an earlier master has left in them
    bool has_begun_{};
    bool is_step_due_{}; // a cycle has ended
    bool holds_rebuild_{}, is_rebuild_due_{};
    std::uint32_t logical_base_{};
    time_point last_turn_{};
    time_point next_cycle_{};
    duration told_period_{};                  // to the parts
    std::optional<time_point> cycle_begun_{}; // the last one; none where its slaves were others
    bool is_cycle_ended_{};                   // ... and what it has found counts
    cycle_times times_{};
    bool keeps_cycling_{};
    ring_clocks clocks_;
    ethercat::clock_agreement agreement_{};
    std::array<std::byte, wire::max_size<ethercat::dc_difference>> difference_{}; // of the clock that is looked at

    work work_{};
    place* served_{};
    std::array<std::byte, 64> start_up_value_{}; // of the object that is read back
    ethercat::position_place one_position_{};    // of a slave that is looked at alone
    std::optional<time_point> hindered_since_{};
    shared_jobs shared_{};
};

/// A ring with its memory: `ring_for<16, 4096> ring{options}`; see ring_memory_for.
template <std::size_t Slaves, std::size_t Bytes, std::size_t Lanes = std::min<std::size_t>(Slaves, 16),
          std::size_t Clocks = 0>
class ring_for : private ring_memory_for<Slaves, Bytes, Lanes, Clocks>, public ring {
    using memory = ring_memory_for<Slaves, Bytes, Lanes, Clocks>;

  public:
    explicit ring_for(const bridge_options& options) noexcept : ring{options, memory::spans()} {}
};

} // namespace jauscat::bridging

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/bridge/impl/ring.ipp>
#endif
