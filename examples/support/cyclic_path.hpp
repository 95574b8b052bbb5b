// The cyclic path to the robot arm: its process data, kept running, and JAUS messages in and out of them.
#pragma once
#include "support/any_link.hpp"
#include "support/trace.hpp"
#include <jauscat/ethercat/describe.hpp>
#include <jauscat/ethercat/image_exchange.hpp>
#include <jauscat/ethercat/process_data.hpp>
#include <jauscat/net/run_cycle.hpp>
#include <jauscat/net/run_master.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/watchdog.hpp>
#include <jauscat/schema/translation/wrench_effort_image.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace example {

/// Wrench efforts through the process data of one slave in OP.
class cyclic_path {
  public:
    /// JAUS component ID of a Primitive Driver.
    static constexpr std::uint8_t component = 33;

    /// `watchdog`: after which the slave leaves OP if it gets no outputs; 0 leaves that to the slave (100 ms).
    cyclic_path(any_link& link, jauscat::ethercat::master& master, const jauscat::ethercat::slave_identity& slave,
                std::chrono::nanoseconds period, std::chrono::milliseconds watchdog, const std::string& who = {})
        : link_{link, who},
          master_{master},
          station_{slave.station},
          exchange_{slave, component},
          period_{period},
          watchdog_{watchdog} {}

    /// From PRE-OP to OP.
    jauscat::ethercat::outcome start() {
        const auto prepare = [this] { began_ = std::chrono::steady_clock::now(); };
        runs_ = checking_ = false;
        using jauscat::ethercat::al_state;
        master_.configure(station_);
        if (const auto result = jauscat::net::run(link_, master_, patience); !result) return result;
        if (const auto result = set_watchdog(); !result) return result;
        master_.change_state(station_, al_state::safe_op);
        if (const auto result = jauscat::net::run(link_, master_, patience); !result) return result;
        data_ = jauscat::ethercat::process_data{master_.slaves()};
        cycles_.emplace(link_, data_, master_, jauscat::net::cycle_config{.period = period_});
        master_.change_state(station_, al_state::op); // outputs have to flow meanwhile
        auto result = cycles_->run_job(patience, prepare, [](const auto&) {});
        if (!result) return result;
        for (int tries = 0; tries != 100 && !data_.is_complete(); ++tries) cycles_->run(prepare);
        if (!data_.is_complete()) return {.error = jauscat::ethercat::master_errc::working_counter};
        // A slave with other process data cannot be commanded by these tables.
        if (!exchange_.start(outputs(), inputs())) return {.error = jauscat::ethercat::master_errc::size_mismatch};
        runs_ = true;
        bad_cycles_ = 0;
        return result;
    }

    /// Waits for the next cycle's instant and exchanges the process data.
    void cycle() {
        note(cycles_->run([this] { began_ = std::chrono::steady_clock::now(); }));
        check_state();
    }
    /// When the outputs should be ready for the next cycle: a bit before its instant.
    [[nodiscard]] std::chrono::steady_clock::time_point next_outputs_by() const noexcept {
        return began_ + period_ - std::min<std::chrono::nanoseconds>(period_ / 4, most_margin);
    }
    /// The master is busy with a job of this path's: another has to wait for a cycle or two.
    [[nodiscard]] bool busy() const noexcept { return checking_; }
    /// Cycles until the master's job is done.
    jauscat::ethercat::outcome run_job(std::chrono::nanoseconds limit) {
        return cycles_->run_job(
            limit, [this] { began_ = std::chrono::steady_clock::now(); }, [this](const auto& report) { note(report); });
    }

    /// The slave is in OP, has answered lately, and takes commands.
    [[nodiscard]] bool runs() const noexcept { return runs_; }
    /// If not: why.
    [[nodiscard]] const std::string& problem() const noexcept { return problem_; }
    /// Bytes of the slave's in the process image.
    [[nodiscard]] std::span<std::byte> outputs() { return data_.outputs(*master_.find(station_)); }
    [[nodiscard]] std::span<const std::byte> inputs() { return data_.inputs(*master_.find(station_)); }
    [[nodiscard]] auto& exchange() noexcept { return exchange_; }
    [[nodiscard]] const auto& statistics() const noexcept { return data_.statistics(); }

  private:
    static constexpr auto patience = std::chrono::seconds{2};
    static constexpr auto longest_silence = std::chrono::seconds{1};
    static constexpr auto check_interval = std::chrono::milliseconds{50};
    static constexpr auto most_margin = std::chrono::microseconds{200};

    // The register's unit is 100 us where nobody has changed the divider.
    jauscat::ethercat::outcome set_watchdog() {
        using namespace jauscat::ethercat;
        constexpr auto units_in_ms = std::chrono::milliseconds{1} / watchdog_time(default_watchdog_divider, 1);
        if (watchdog_ == watchdog_.zero()) return {};
        const esc_word units{static_cast<std::uint16_t>(watchdog_.count() * units_in_ms)};
        std::array<std::byte, jauscat::wire::max_size<esc_word>> bytes{};
        static_cast<void>(jauscat::wire::encode(units, bytes));
        master_.exchange(command::fpwr, station_, esc_registers::process_data_watchdog.address, bytes);
        return jauscat::net::run(link_, master_, patience);
    }

    void note(const jauscat::net::cycle_report&) {
        const auto taken = exchange_.taken(inputs());
        const bool good = data_.is_complete() && (taken == exchange_.given(outputs()) || taken != taken_);
        bad_cycles_ = good ? 0 : bad_cycles_ + 1;
        taken_ = taken;
        if (bad_cycles_ * period_ > longest_silence) stop("no longer takes process data");
    }

    // A slave that has left OP still takes part in the exchange.
    void check_state() {
        using namespace jauscat::ethercat;
        const auto now = std::chrono::steady_clock::now();
        if (checking_ && master_.idle()) {
            checking_ = false;
            al_status status{};
            const bool answered = master_.result() && master_.result().detail == 1; // its working counter
            if (answered && jauscat::wire::decode_prefix(status, status_) && status.state != al_state::op)
                stop("is no longer in OP: " + std::string{describe(status.code)});
        } else if (!checking_ && now >= next_check_) {
            checking_ = master_.exchange(command::fprd, station_, esc_registers::al_status.address, status_);
            next_check_ = now + check_interval;
        }
    }

    void stop(const std::string& why) {
        if (runs_) problem_ = why;
        runs_ = false;
    }

    traced_link<any_link> link_;
    jauscat::ethercat::master& master_;
    std::uint16_t station_;
    jauscat::ethercat::image_exchange<jauscat::translation::set_wrench_effort_table,
                                      jauscat::translation::report_wrench_effort_table>
        exchange_;
    std::chrono::nanoseconds period_;
    std::chrono::milliseconds watchdog_;
    jauscat::ethercat::process_data data_{};
    std::optional<jauscat::net::cycle_runner<traced_link<any_link>>> cycles_{};
    std::chrono::steady_clock::time_point began_{}; ///< the last cycle
    bool runs_{};
    std::string problem_{};
    bool checking_{};
    std::array<std::byte, jauscat::wire::max_size<jauscat::ethercat::al_status>> status_{};
    std::chrono::steady_clock::time_point next_check_{};
    unsigned bad_cycles_{}; ///< in a row: not of all slaves, or the slave has not taken a command
    std::uint16_t taken_{}; ///< the last command that it says it has taken
};

} // namespace example
