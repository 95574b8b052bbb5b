// An EtherCAT master without I/O: frames out, frames and time in. Brings slaves up and through their states, transfers
// SDOs, asks for objects, sets up process data, one job at a time. `jauscat/net/link/run_master.hpp` drives it over a
// link; anything else that can send and receive frames may too. The cyclic exchange is process_data's.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/frame_traffic.hpp>
#include <jauscat/ethercat/master/job_machine.hpp>
#include <jauscat/ethercat/master/jobs.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

namespace jauscat::ethercat {

/// Start a job of jobs.hpp; then, until `idle()`: send what `next_frame` gives, pass what arrives to `on_frame`, and
/// call `on_time` at `next_event()`. `result<Job>()` is then what the job gives, or why it gives nothing. `master_for`
/// brings its memory along.
///
///     if (const auto started = master.start(scan{}); !started) return started.error();
///     ... // until master.idle()
///     const auto slaves = master.result<scan>();
class master {
  public:
    /// Idle, and without slaves. `memory`, for a record of each slave, outlives the master: see slave_memory.
    explicit master(std::span<slave_record> memory, const master_config& config = {}) noexcept
        : frames_{config}, ring_{slave_list{memory}} {}
    master(const master&) = delete;
    master& operator=(const master&) = delete;

    /// As newly constructed: the job that runs is forgotten, and so are all slaves.
    JAUSCAT_FUNCTION void reset(const master_config& config = {}) noexcept;

    /// Other times and retries. The logical base stays the same while slaves have process data.
    void set_config(const master_config& config) noexcept { frames_.set_config(config); }

    /// Starts a job. Error: busy, while another one runs, which is not affected.
    template <master_job Job> master_result<> start(const Job& job) noexcept {
        if (!idle()) return master_error{.code = master_errc::busy};
        runs_ = true;
        error_ = {};
        station_ = 0;
        if constexpr (requires { job.station; }) station_ = job.station;
        frames_.begin();
        auto& machine = machine_.template emplace<job_machine<Job>>();
        if (const auto wrong = machine.begin(job, ring_, frames_.config()); wrong != master_error{})
            finish(wrong);
        else if constexpr (requires { machine.is_done(); })
            if (machine.is_done()) finish({});
        return {};
    }

    template <class T> master_result<> start(const T&) noexcept {
        static_assert(master_job<T>, "master: only the jobs of ethercat/master/jobs.hpp can be started");
        return {};
    }

    /// What the last job, a `Job`, has given, or why it gave nothing. Error `busy` while it runs, and where the last
    /// job was another one.
    template <master_job Job> [[nodiscard]] typename Job::result_type result() const noexcept {
        const auto* const machine = std::get_if<job_machine<Job>>(&machine_);
        if (!idle() || machine == nullptr) return master_error{.code = master_errc::busy};
        if (error_ != master_error{}) return error_;
        if constexpr (std::is_void_v<typename Job::result_type::value_type>)
            return {};
        else
            return machine->value();
    }
    /// Why the last job, whichever it was, has failed; ok if it has not.
    [[nodiscard]] const master_error& error() const noexcept { return error_; }

    /// Gives the job up with `error`: its deadline has passed, or the link does not take frames. A transfer that the
    /// slave has open is aborted before the next one.
    JAUSCAT_FUNCTION void cancel(master_errc error) noexcept;
    /// Gives a transfer up with `error` as if it had not begun. False where the slave has taken a message of it, or may
    /// have, or a frame is under way: the transfer goes on.
    JAUSCAT_FUNCTION bool withdraw(master_errc error) noexcept;

    /// Whether no job runs, so that one may be started.
    [[nodiscard]] bool idle() const noexcept { return !runs_; }
    /// Whether the job that runs is one for this slave alone.
    [[nodiscard]] bool serves(std::uint16_t station) const noexcept { return runs_ && station_ == station; }
    [[nodiscard]] std::span<const slave_record> slaves() const noexcept { return ring_.slaves.all(); }
    /// Slaves that it has memory for.
    [[nodiscard]] std::size_t capacity() const noexcept { return ring_.slaves.capacity(); }
    /// The record of a slave; none if it has not been brought up.
    [[nodiscard]] const slave_record* find(std::uint16_t station) const noexcept { return ring_.slaves.find(station); }
    /// How long a slave may take from now on, also when it is brought up again. False if it is not known.
    JAUSCAT_FUNCTION bool set_timeouts(std::uint16_t station, const slave_timeouts& timeouts) noexcept;
    /// Lends a slave's mailbox to `other`, which knows that slave alone then: transfers of this master wait until it is
    /// returned. Only while `other` is idle. False if the slave is not known.
    JAUSCAT_FUNCTION bool lend(std::uint16_t station, master& other) noexcept;
    /// Takes it back, unless the slave was brought up again meanwhile.
    JAUSCAT_FUNCTION void take_back(const master& other) noexcept;
    /// Forgets a slave's emergencies.
    JAUSCAT_FUNCTION void clear_emergencies(std::uint16_t station) noexcept;
    [[nodiscard]] const master_statistics& statistics() const noexcept { return frames_.statistics(); }

    /// Writes the next frame to `out`, which holds 1514 bytes, and returns its size; 0 when there is nothing to send
    /// now.
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t next_frame(std::span<std::byte> out, time_point now) noexcept;

    /// Takes a frame that arrived. False if it was not the reply that is waited for: it then changed nothing, and is
    /// counted.
    JAUSCAT_FUNCTION bool on_frame(std::span<const std::byte> frame, time_point now) noexcept;
    /// The same, but not counted. For several masters on one link: first `take` of each, then `claim`.
    JAUSCAT_FUNCTION bool take(std::span<const std::byte> frame, time_point now) noexcept;

    /// Whether a frame that nobody has taken was sent by this master before: it is late, or a copy.
    bool claim(std::span<const std::byte> frame) noexcept { return frames_.claim(frame); }
    /// From when on no frame that was lost can arrive any more, so that it may serve another slave.
    [[nodiscard]] time_point settled_at() const noexcept { return frames_.settled_at(); }

    /// Time has passed: a frame that is not back after `frame_timeout` is lost and asked for again, then given up.
    JAUSCAT_FUNCTION void on_time(time_point now) noexcept;

    /// When `on_time` or `next_frame` will next have something to do, if no frame arrives first; none while idle.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<time_point> next_event() const noexcept;

  private:
    // std::visit may throw where a variant has no value, which this one always has.
    template <class Use> void with_machine(Use&& use) noexcept {
        const auto try_one = [&](auto* machine) {
            if (machine != nullptr) use(*machine);
            return machine != nullptr;
        };
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            static_cast<void>((try_one(std::get_if<I + 1>(&machine_)) || ...)); // all but std::monostate
        }(std::make_index_sequence<std::variant_size_v<any_job_machine> - 1>{});
    }

    JAUSCAT_FUNCTION void finish(const master_error& error) noexcept;

    frame_traffic frames_;
    ring_knowledge ring_;
    any_job_machine machine_{};
    bool runs_{};
    std::uint16_t station_{}; // of the job; 0: none, or several
    master_error error_{};
};

/// A master with memory for up to `Slaves` slaves: `master_for<16> master{config}`.
template <std::size_t Slaves> class master_for : private slave_memory<Slaves>, public master {
  public:
    explicit master_for(const master_config& config = {}) noexcept
        : master{std::span<slave_record>{slave_memory<Slaves>::records}, config} {}
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/master.ipp>
#endif
