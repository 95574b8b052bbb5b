// Process data with every slave on the wire, and what became of the cycles: how late they began, how long they took,
// what was lost, whether each slave stayed in OP, and that mailbox traffic does not disturb them.
#include "support/explain.hpp"
#include "support/link_options.hpp"
#include "support/say.hpp"
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/net/link/cycle_runner.hpp>
#include <jauscat/net/link/latency_histogram.hpp>
#include <jauscat/net/link/run_master.hpp>
#include <jauscat/net/now.hpp>
#include <jauscat/text/hex.hpp>
#include <jauscat/text/value.hpp>

#include <algorithm>
#include <iomanip>
#include <optional>
#include <sched.h>
#include <set>
#include <sstream>
#include <sys/mman.h>
#include <time.h>

namespace {

namespace ethercat = jauscat::ethercat;
using std::chrono::microseconds, std::chrono::milliseconds, std::chrono::seconds;

constexpr const char* help = R"(cyclic: exchanges process data with all slaves in every period, and measures the times.

It brings each slave from INIT to OP, runs for --seconds or until Ctrl-C, and meanwhile uploads an object of each slave
in turn. All outputs are 0. It reports when a slave leaves OP or is lost. The exit code is 1 if a slave is not in OP at
the end.

With --clocks it also sets the slaves' distributed clocks up and starts SYNC0, each period. The cycles follow the reference
clock; the slaves go to OP when they do. It measures how far from their phase the frames pass the reference clock, and the
largest difference of any slave's clock from it.

Examples:
  cyclic                                     EtherCAT in UDP to 127.0.0.1, port 34980: robot_arm
  cyclic --link raw --interface eth0 --period 250 --priority 80
  cyclic --link raw --interface eth0 --clocks
)";

struct measurement {
    jauscat::net::latency_histogram late{}, round_trip{};
    jauscat::net::latency_histogram clock_error{}, difference{}; // of each cycle with the reference clock's time
    std::uint64_t uploads{}, failed_uploads{};

    void add(const jauscat::net::cycle_report& cycle) {
        late.add(cycle.late);
        if (cycle.round_trip != jauscat::duration{}) round_trip.add(cycle.round_trip);
    }
    void add(const ethercat::clock_cycle& clocks) {
        if (!clocks.is_complete()) return;
        clock_error.add(std::chrono::abs(clocks.control().error()));
        difference.add(std::chrono::nanoseconds{clocks.difference()});
    }
};

/// Real-time priority, and no page is fetched from a disk while a cycle waits.
void become_real_time(int priority) {
    const sched_param parameters{.sched_priority = priority};
    if (::sched_setscheduler(0, SCHED_FIFO, &parameters) != 0)
        throw std::runtime_error{"--priority needs CAP_SYS_NICE: sudo setcap cap_sys_nice,cap_net_raw+ep cyclic"};
    if (::mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
        example::write_event(example::events::memory_not_locked, {}, "cyclic: memory is not locked (CAP_IPC_LOCK)\n");
}

constexpr auto longest_silence = milliseconds{100}; // then a slave counts as stopped

constexpr const char *wake_up = "wake-up after the instant it was due", *round_trip = "round trip of the process data",
                     *clock_error = "frame at the reference clock, off phase", *difference = "clocks, upper bound";

void print_distribution(std::ostream& out, const char* name, const jauscat::net::latency_histogram& times) {
    out << "\n" << example::bold(name) << " (from, cycles, their logarithm as a bar)\n";
    times.print(out);
}

void print_quantiles(std::ostream& out, const measurement& measured) {
    constexpr int name_width = 40, width = 10;
    std::ostringstream heading;
    heading << std::left << std::setw(name_width) << "microseconds" << std::right;
    for (const auto* column : {"median", "99 %", "99.9 %", "max"}) heading << std::setw(width) << column;
    out << "\n" << example::bold(heading.str()) << "\n" << std::fixed << std::setprecision(1);
    for (const auto& [name, times] : {std::pair{wake_up, &measured.late},
                                      {round_trip, &measured.round_trip},
                                      {clock_error, &measured.clock_error},
                                      {difference, &measured.difference}}) {
        if (times->count() == 0) continue;
        out << std::left << std::setw(name_width) << name << std::right;
        for (const auto time : {times->quantile(0.5), times->quantile(0.99), times->quantile(0.999), times->max()})
            out << std::setw(width) << std::chrono::duration<double, std::micro>{time}.count();
        out << "\n";
    }
}

/// Takes no more frames after Ctrl-C, so that a job of the master's ends.
class stoppable_link {
  public:
    explicit stoppable_link(jauscat::net::any_link& link) : link_{link} {}
    bool send(std::span<const std::byte> frame) { return !example::stop_requested && link_.send(frame); }
    std::size_t receive(std::span<std::byte> buffer, std::chrono::nanoseconds timeout) {
        return link_.receive(buffer, timeout);
    }

  private:
    jauscat::net::any_link& link_;
};

template <class T> void require(const ethercat::master_result<T>& result, const std::string& what) {
    if (!result && example::stop_requested) throw std::runtime_error{"stopped before all slaves were in OP"};
    example::require(result, what);
}

/// That of this thread.
std::chrono::nanoseconds processor_time() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return seconds{time.tv_sec} + std::chrono::nanoseconds{time.tv_nsec};
}

/// The clocks of all slaves of the ring.
struct clock_set {
    std::vector<ethercat::clock_record> records{};
    ethercat::clock_network network{};
    std::uint64_t time_at_start{}; ///< system time when `start` was
    jauscat::time_point start{};

    [[nodiscard]] std::uint64_t time() const {
        return time_at_start + static_cast<std::uint64_t>((jauscat::net::now() - start).count());
    }
};

/// Delays, offsets, drift, and SYNC0 in each `period`. The slaves are in PRE-OP.
void set_up_clocks(clock_set& clocks, const std::vector<std::uint16_t>& stations, microseconds period,
                   const auto& run) {
    constexpr std::chrono::sys_days epoch{std::chrono::year{2000} / 1 / 1};
    clocks.start = jauscat::net::now();
    clocks.time_at_start =
        static_cast<std::uint64_t>(std::chrono::nanoseconds{std::chrono::system_clock::now() - epoch}.count());
    for (const auto station : stations)
        clocks.records.push_back(
            {.station = station,
             .sync = {.assign_activate = 0x0300,
                      .sync0_cycle = static_cast<std::uint32_t>(std::chrono::nanoseconds{period}.count())}});
    clocks.network =
        *run(ethercat::set_up_clocks{.slaves = clocks.records, .system_time = clocks.time()}, "distributed clocks");
    static_cast<void>(run(ethercat::start_sync{.slaves = clocks.records, .system_time = clocks.time()}, "SYNC0"));
    for (const auto& each : clocks.records) {
        if (!each.has_clock()) continue;
        example::write_event(
            example::events::clock_set_up,
            {{"station", each.station}, {"delay_ns", each.delay}, {"difference_ns", each.difference.magnitude}},
            "cyclic: slave " + std::to_string(each.station) + ": clock, " + std::to_string(each.delay) +
                " ns from the reference clock, difference " + std::to_string(each.difference.magnitude) + " ns\n");
    }
}

/// Every slave to SAFE-OP under the stations `first` and up. `clocks`: nullptr, or to be set up, too.
std::vector<std::uint16_t> set_up(jauscat::net::any_link& medium, ethercat::master& master, std::uint16_t first,
                                  milliseconds watchdog, clock_set* clocks, microseconds period) {
    stoppable_link link{medium};
    const auto run = [&](const auto& job, const std::string& what) {
        constexpr std::chrono::seconds limit{60}; // the frames for the drift of clocks take 1 ms each on a long bus
        const auto result = jauscat::net::run(link, master, job, limit);
        require(result, what);
        return result;
    };
    const auto slaves = *run(ethercat::scan{}, "no slaves");
    std::vector<std::uint16_t> stations;
    for (std::size_t i = 0; i != slaves; ++i) {
        const auto station = static_cast<std::uint16_t>(first + i);
        const auto name = "slave " + std::to_string(station);
        static_cast<void>(run(ethercat::bring_up{.position = static_cast<std::uint16_t>(i), .station = station},
                              name + " to PRE-OP"));
        const auto place = run(ethercat::configure{.station = station, .watchdog = watchdog}, name + ", process data");
        example::write_event(example::events::slave_configured,
                             {{"station", station}, {"outputs", place->output_size}, {"inputs", place->input_size}},
                             "cyclic: " + name + ": " + std::to_string(place->output_size) + " bytes of outputs, " +
                                 std::to_string(place->input_size) + " of inputs\n");
        stations.push_back(station);
    }
    if (clocks != nullptr) set_up_clocks(*clocks, stations, period, run);
    for (const auto station : stations)
        static_cast<void>(run(ethercat::change_state{.station = station, .goal = ethercat::al_state::safe_op},
                              "slave " + std::to_string(station) + " to SAFE-OP"));
    return stations;
}

/// Uploads an object of one slave after the other.
class uploads {
  public:
    uploads(std::vector<std::uint16_t> stations, milliseconds every) : stations_{std::move(stations)}, every_{every} {}

    void work(ethercat::master& master, measurement& counts) {
        if (runs_ && master.idle()) {
            const auto result = master.result<ethercat::upload>();
            ++(result ? counts.uploads : counts.failed_uploads);
            if (!result)
                example::write_event(example::events::upload_failed, {{"reason", example::explain(result.error())}},
                                     example::bad("cyclic: upload: " + example::explain(result.error())) + "\n");
            runs_ = false;
        }
        const auto now = std::chrono::steady_clock::now();
        if (runs_ || !master.idle() || every_ == milliseconds{} || now < due_) return;
        due_ = now + every_;
        const auto station = stations_[next_++ % stations_.size()];
        if (!master.find(station)->mailbox.coe) return;
        runs_ = static_cast<bool>(master.start(ethercat::upload{station, identity_object, vendor, value_}));
    }

  private:
    static constexpr std::uint16_t identity_object = 0x1018;
    static constexpr std::uint8_t vendor = 1;

    std::vector<std::uint16_t> stations_;
    milliseconds every_;
    std::chrono::steady_clock::time_point due_{};
    std::size_t next_{};
    bool runs_{};
    std::array<std::byte, 4> value_{};
};

/// Reports the emergencies of slaves; takes them out of one mailbox after the other.
class emergency_watch {
  public:
    explicit emergency_watch(std::vector<std::uint16_t> stations) : stations_{std::move(stations)} {}

    void work(ethercat::master& master) {
        for (const auto& slave : master.slaves()) {
            if (slave.emergencies.kept().empty()) continue;
            for (const auto& each : slave.emergencies.kept()) report(slave.station, each);
            master.clear_emergencies(slave.station);
        }
        const auto now = std::chrono::steady_clock::now();
        if (!master.idle() || now < due_) return;
        due_ = now + every;
        const auto station = stations_[next_++ % stations_.size()];
        if (master.find(station)->mailbox.coe)
            static_cast<void>(master.start(ethercat::collect_emergencies{station})); // else the next time
    }

  private:
    static constexpr milliseconds every{100};

    static void report(std::uint16_t station, const ethercat::coe_emergency& emergency) {
        using namespace jauscat::text;
        example::write_event(example::events::slave_emergency,
                             {{"station", station},
                              {"error_code", emergency.error_code},
                              {"error_register", emergency.error_register},
                              {"data", hex(emergency.data)}},
                             example::bad("cyclic: slave " + std::to_string(station) + ": emergency: error code " +
                                          hex_number(emergency.error_code, 4) + ", error register " +
                                          hex_number(emergency.error_register, 2) + ", data " + hex(emergency.data)) +
                                 "\n");
    }

    std::vector<std::uint16_t> stations_;
    std::chrono::steady_clock::time_point due_{};
    std::size_t next_{};
};

/// Reports when a slave stops running, and when it runs again.
class slave_watch {
  public:
    slave_watch(const ethercat::master& master, const ethercat::process_data& data, std::chrono::nanoseconds patience)
        : master_{master}, data_{data}, patience_{patience} {}

    /// Ten times in the patience.
    void look() {
        const auto now = jauscat::net::now();
        if (now < next_look_) return;
        next_look_ = now + patience_ / 10;
        for (const auto& slave : master_.slaves()) {
            const auto& status = data_.status(slave);
            // One that has just reached OP has yet to be seen there.
            const bool runs = status.ran_within(patience_, now) || now - begun_ < patience_;
            if (stopped_.contains(slave.station) != runs) continue;
            const auto name = "cyclic: slave " + std::to_string(slave.station);
            if (runs) {
                stopped_.erase(slave.station);
                example::write_event(example::events::slave_runs_again, {{"station", slave.station}},
                                     name + " is in OP again\n");
            } else {
                stopped_.insert(slave.station);
                example::write_event(example::events::slave_stopped,
                                     {{"station", slave.station},
                                      {"condition", condition_name(status.condition_within(patience_, now))}},
                                     example::bad(name + " does not run: " + reason(status, now)) + "\n");
            }
        }
    }
    [[nodiscard]] bool all_run() const noexcept { return stopped_.empty(); }

  private:
    [[nodiscard]] std::string reason(const ethercat::slave_status& status, jauscat::time_point now) const {
        const auto condition = status.condition_within(patience_, now);
        std::string text{describe(condition)};
        if (condition == ethercat::slave_condition::not_in_op)
            text += ": state " + jauscat::text::to_text(status.al.state) + ", " +
                    jauscat::text::hex_number(static_cast<std::uint16_t>(status.al.code), 4) + ", " +
                    std::string{describe(status.al.code)};
        return text;
    }

    static const char* condition_name(ethercat::slave_condition condition) {
        switch (condition) {
        case ethercat::slave_condition::silent: return "silent";
        case ethercat::slave_condition::running: return "running";
        case ethercat::slave_condition::incomplete: return "incomplete";
        case ethercat::slave_condition::not_in_op: return "not_in_op";
        case ethercat::slave_condition::absent: return "absent";
        case ethercat::slave_condition::duplicate: return "duplicate";
        }
        return "unknown";
    }

    const ethercat::master& master_;
    const ethercat::process_data& data_;
    std::chrono::nanoseconds patience_;
    jauscat::time_point begun_ = jauscat::net::now();
    jauscat::time_point next_look_ = begun_;
    std::set<std::uint16_t> stopped_{};
};

/// Every slave to PRE-OP, without waiting for those that do not answer: their watchdog takes them out of OP.
void leave_op(jauscat::net::any_link& link, ethercat::master& master, const std::vector<std::uint16_t>& stations) {
    master.cancel(ethercat::master_errc::timeout); // an upload that still runs
    const auto deadline = std::chrono::steady_clock::now() + milliseconds{500};
    for (const auto station : stations) {
        const auto left = deadline - std::chrono::steady_clock::now();
        if (left <= left.zero()) return;
        static_cast<void>(
            jauscat::net::run(link, master, ethercat::change_state{station, ethercat::al_state::pre_op}, left));
    }
}

std::string in_microseconds(std::chrono::nanoseconds time) {
    return std::to_string(std::chrono::duration_cast<microseconds>(time).count()) + " us";
}

/// Cycles until they follow the reference clock, for at most `limit`. Says each second how far they are.
void wait_for_lock(auto& cycles, const ethercat::clock_cycle& clocks, seconds limit) {
    std::uint64_t count = 0;
    const auto begin = std::chrono::steady_clock::now();
    seconds told{0};
    const auto& control = clocks.control();
    const auto how_far = [&] {
        return "frames pass the reference clock " + in_microseconds(std::chrono::abs(control.mean_error())) +
               " off their phase, " + in_microseconds(control.deviation()) + " on average; it has not answered " +
               std::to_string(clocks.statistics().unanswered) + " of " + std::to_string(count) + " cycles";
    };
    while (!control.is_locked()) {
        cycles.run([] {});
        if (example::stop_requested) throw std::runtime_error{"stopped before the cycles followed the reference clock"};
        if (clocks.is_lost()) throw std::runtime_error{"no slave answers as the reference clock any longer"};
        ++count;
        const auto waited = std::chrono::steady_clock::now() - begin;
        if (waited >= limit)
            throw std::runtime_error{"after " + std::to_string(limit.count()) +
                                     " s the cycles do not follow the reference clock (--clock-limit): " + how_far() +
                                     "; try --spin 100, --priority 80, or a longer --period"};
        if (waited < told + seconds{1}) continue;
        told = std::chrono::duration_cast<seconds>(waited);
        example::write_event(example::events::clocks_settling,
                             {{"seconds", told.count()},
                              {"mean_error_ns", control.mean_error().count()},
                              {"deviation_ns", control.deviation().count()},
                              {"unanswered", clocks.statistics().unanswered}},
                             "cyclic: waits for the clocks: " + how_far() + "\n");
    }
    example::write_event(example::events::clocks_locked, {{"cycles", count}, {"drift_ppb", clocks.control().drift()}},
                         "cyclic: after " + std::to_string(count) +
                             " cycles they follow the reference clock; this one is " +
                             std::to_string(clocks.control().drift() / 1000) + " ppm faster\n");
}

std::string clocks_line(const ethercat::clock_cycle& clocks) {
    const auto& counts = clocks.statistics();
    return "clocks: cycles " + std::string{clocks.control().is_locked() ? "follow" : "do not follow"} +
           ", frames lost " + std::to_string(counts.lost) + ", reference clock without answer " +
           std::to_string(counts.unanswered) + ", replaced " + std::to_string(counts.takeovers) + "\n";
}

constexpr std::size_t max_slaves = 1000;

int measure(jauscat::net::any_link& link, const auto& values) {
    std::vector<ethercat::slave_record> records(max_slaves);
    ethercat::master master{records, {.frame_timeout = milliseconds{values["frame-timeout"].template as<unsigned>()}}};
    const microseconds period{values["period"].template as<unsigned>()};
    const bool has_clocks = values["clocks"].template as<bool>();
    clock_set clock_records;
    const auto stations =
        set_up(link, master, values["station"].template as<std::uint16_t>(),
               milliseconds{values["watchdog"].template as<unsigned>()}, has_clocks ? &clock_records : nullptr, period);
    const bool watches = !values["unwatched"].template as<bool>();
    // [memory]
    std::vector<ethercat::process_slot> slots(stations.size());
    std::vector<std::byte> bytes(ethercat::process_image::of(master.slaves()).size);
    ethercat::process_data data{slots, bytes};
    data.set_slaves(master.slaves(), {.watch_slaves = watches, .watch_together = watches});
    // [memory end]
    if (bytes.empty()) throw std::runtime_error{"no slave has process data"};
    if (!data.fits()) throw std::runtime_error{"process data and states of a slave do not fit into one frame"};

    jauscat::net::cycle_runner cycles{link,
                                      data,
                                      master,
                                      {.period = period,
                                       .spin = microseconds{values["spin"].template as<unsigned>()},
                                       .order = values["receive-first"].template as<bool>()
                                                    ? jauscat::net::cycle_order::receive_first
                                                    : jauscat::net::cycle_order::send_first}};
    const auto nothing = [](auto&&...) {};
    std::optional<ethercat::clock_cycle> clocks;
    if (has_clocks) {
        clocks.emplace(clock_records.records, clock_records.network, clock_records.time(),
                       ethercat::clock_watch_options{.control = ethercat::cycle_control_options::of_period(period)});
        cycles.set_clocks(&*clocks);
    }
    try {
        if (clocks) wait_for_lock(cycles, *clocks, seconds{values["clock-limit"].template as<unsigned>()});
        for (const auto station : stations) { // outputs have to flow while a slave goes to OP
            const auto give_up_on_stop = [&](const auto&) {
                if (example::stop_requested) master.cancel(ethercat::master_errc::timeout);
            };
            require(cycles.run_job(ethercat::change_state{.station = station, .goal = ethercat::al_state::op},
                                   seconds{10}, nothing, give_up_on_stop),
                    "slave " + std::to_string(station) + " to OP");
        }
    } catch (...) {
        leave_op(link, master, stations);
        throw;
    }
    example::write_event(example::events::ready, {{"slaves", stations.size()}, {"period_us", period.count()}},
                         "cyclic: " + std::to_string(stations.size()) + " in OP, a cycle every " +
                             std::to_string(period.count()) + " us (Ctrl-C ends)\n");
    std::cout << std::flush;

    const auto before = data.statistics();
    const auto processor_before = processor_time();
    const auto overruns_before = cycles.overruns();
    const auto end = std::chrono::steady_clock::now() + seconds{values["seconds"].template as<unsigned>()};
    uploads mailbox{stations, milliseconds{values["upload-every"].template as<unsigned>()}};
    emergency_watch emergencies{stations};
    slave_watch slaves{master, data, std::max<std::chrono::nanoseconds>(longest_silence, 3 * period)};
    const auto result = std::make_unique<measurement>();
    while (!example::stop_requested && std::chrono::steady_clock::now() < end) {
        result->add(cycles.run([&] {
            if (clocks) result->add(*clocks); // of the cycle before, whose frame is back in both orders
        }));
        if (watches) slaves.look();
        mailbox.work(master, *result);
        emergencies.work(master);
    }

    const auto processor = processor_time() - processor_before;
    const auto& after = data.statistics();
    const auto processor_each = processor / std::max<std::uint64_t>(after.sent - before.sent, 1);
    std::ostringstream text;
    print_distribution(text, wake_up, result->late);
    if (result->round_trip.count() != 0) print_distribution(text, round_trip, result->round_trip);
    if (clocks) print_distribution(text, clock_error, result->clock_error);
    print_quantiles(text, *result);
    text << "\ncycles " << after.sent - before.sent << ", complete " << after.complete - before.complete
         << ", with another working counter " << after.incomplete - before.incomplete << ", lost "
         << after.lost - before.lost << ", left out " << cycles.overruns() - overruns_before
         << "\nprocessor time of each cycle " << std::chrono::duration<double, std::micro>{processor_each}.count()
         << " us\nuploads meanwhile " << result->uploads << ", failed " << result->failed_uploads << "\n";
    if (clocks) text << clocks_line(*clocks);
    const auto in_us = [](auto time) { return std::chrono::duration<double, std::micro>{time}.count(); };
    example::event_members of_clocks;
    if (clocks)
        of_clocks = {{"clock_error_median_us", in_us(result->clock_error.quantile(0.5))},
                     {"clock_error_p99_us", in_us(result->clock_error.quantile(0.99))},
                     {"difference_max_ns", result->difference.max().count()},
                     {"locked", clocks->control().is_locked()}};
    example::write_event(example::events::measured,
                         example::event_members{{"cycles", after.sent - before.sent},
                                                {"complete", after.complete - before.complete},
                                                {"incomplete", after.incomplete - before.incomplete},
                                                {"lost", after.lost - before.lost},
                                                {"skipped", cycles.overruns() - overruns_before},
                                                {"processor_us", in_us(processor_each)},
                                                {"uploads", result->uploads},
                                                {"failed_uploads", result->failed_uploads},
                                                {"late_max_us", in_us(result->late.max())},
                                                {"round_trip_max_us", in_us(result->round_trip.max())}} +
                             of_clocks,
                         text.str());
    leave_op(link, master, stations);
    return after.complete != before.complete && slaves.all_run() ? example::success : example::failure;
}

} // namespace

int main(int argc, char** argv) {
    return example::run("cyclic", [&] {
        namespace po = boost::program_options;
        po::options_description options;
        // clang-format off
        options.add_options()
            ("period", po::value<unsigned>()->default_value(1000), "period in microseconds, 1 to 1000000")
            ("seconds", po::value<unsigned>()->default_value(10), "duration in seconds")
            ("receive-first", po::bool_switch(), "each cycle receives what the one before has sent, and then sends: less processor time, inputs one period older")
            ("unwatched", po::bool_switch(), "process data alone: without asking each slave for its state, a datagram for each; what stops shows in the working counter only")
            ("spin", po::value<unsigned>()->default_value(0), "the last microseconds of each wait are spent polling: more exact, and uses processor time")
            ("priority", po::value<unsigned>()->default_value(0), "real-time priority, 1 to 99; 0: none")
            ("upload-every", po::value<unsigned>()->default_value(1000), "milliseconds between two SDO uploads; 0: none")
            ("clocks", po::bool_switch(), "set up distributed clocks and SYNC0; the cycles follow the reference clock")
            ("clock-limit", po::value<unsigned>()->default_value(30), "seconds for which --clocks waits until the cycles follow")
            ("watchdog", po::value<unsigned>()->default_value(100), "milliseconds without outputs after which a slave leaves OP, 1 to 6553")
            ("station", po::value<std::uint16_t>()->default_value(1), "station address of the first slave; the others follow")
            ("frame-timeout", po::value<unsigned>()->default_value(20), "milliseconds after which a frame is lost");
        // clang-format on
        example::add_log_option(options);
        example::add_medium_options(options);
        const auto values = example::parse(argc, argv, options, help);
        if (const auto period = values["period"].as<unsigned>(); period < 1 || period > 1'000'000)
            throw example::usage_error{"--period must be 1 to 1000000"};
        if (const auto watchdog = values["watchdog"].as<unsigned>(); watchdog < 1 || watchdog > 6553)
            throw example::usage_error{"--watchdog must be 1 to 6553"};
        const auto priority = values["priority"].as<unsigned>();
        if (priority > 99) throw example::usage_error{"--priority must be 0 to 99"};
        if (priority != 0) become_real_time(static_cast<int>(priority));
        // Locked memory grows only with CAP_IPC_LOCK.
        const auto after = priority != 0 ? example::privileges::kept : example::privileges::dropped;
        return example::with_link(
            values, example::link_end::master,
            [&](auto& link, const std::string& where) {
                example::write_event(example::events::link_opened, {{"link", where}}, "cyclic: " + where + "\n");
                return measure(link, values);
            },
            after);
    });
}
