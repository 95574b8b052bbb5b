// The distributed clocks of a ring: the slaves that take part, and the cycles with the reference clock's time.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/ethercat/master/clock_cycle.hpp>
#include <jauscat/ethercat/master/clock_jobs.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace jauscat::bridging {

/// Of a ring whose memory has records for clocks. A slave that does not answer while they are set up is left out from
/// then on, as cable.
class ring_clocks {
  public:
    /// Two records for each slave: those in use, and those that are set up.
    explicit ring_clocks(std::span<ethercat::clock_record> memory) noexcept
        : used_{memory.first(memory.size() / 2)}, next_{memory.last(memory.size() / 2)} {}

    [[nodiscard]] bool has_memory() const noexcept { return !next_.empty(); }
    /// Its frames go out in each cycle.
    [[nodiscard]] bool runs() const noexcept { return cycle_.has_value(); }
    [[nodiscard]] const std::optional<ethercat::clock_cycle>& cycle() const noexcept { return cycle_; }
    void stop() noexcept { cycle_.reset(); }

    /// Slaves to set up: all that are known and present, each with `is_present`, and `runs` for those whose clocks are
    /// in use.
    void choose(std::span<const ethercat::slave_record> slaves, auto&& is_present, auto&& runs) noexcept {
        next_count_ = 0;
        int last = -1;
        while (next_count_ != next_.size()) {
            const ethercat::slave_record* first = nullptr;
            for (const auto& each : slaves)
                if (each.position > last && (first == nullptr || each.position < first->position) && is_present(each) &&
                    !is_left_out(each.station))
                    first = &each;
            if (first == nullptr) return;
            last = first->position;
            auto& made = next_[next_count_++];
            made = {.station = first->station, .runs = runs(*first)};
            if (const auto* const old = made.runs ? find(made.station) : nullptr) made.start_time = old->start_time;
        }
    }
    [[nodiscard]] std::span<ethercat::clock_record> chosen() const noexcept { return next_.first(next_count_); }
    /// They are set up.
    JAUSCAT_FUNCTION void use(const ethercat::clock_network& network, std::uint64_t system_time,
                              duration period) noexcept;
    /// The cycles have another period: they follow the reference clock anew. 0: there are none.
    JAUSCAT_FUNCTION void set_period(duration period) noexcept;
    /// They could not be set up.
    JAUSCAT_FUNCTION void leave_out(std::uint16_t station) noexcept;
    /// The slaves of the ring are others.
    JAUSCAT_FUNCTION void leave_out_none() noexcept;

    /// Those in use.
    [[nodiscard]] std::span<ethercat::clock_record> records() const noexcept { return used_.first(used_count_); }
    [[nodiscard]] JAUSCAT_FUNCTION ethercat::clock_record* find(std::uint16_t station) const noexcept;
    /// The slave is lost: its time is no reference any more, also where it returns before that was noticed.
    JAUSCAT_FUNCTION void lost(std::uint16_t station) noexcept;

    void begin_cycle() noexcept { is_due_ = runs(); }
    [[nodiscard]] JAUSCAT_FUNCTION std::size_t next_frame(std::span<std::byte> frame, time_point now,
                                                          duration late) noexcept;
    bool on_frame(std::span<const std::byte> frame) noexcept { return cycle_ && cycle_->on_frame(frame); }
    /// By how much later the next cycle is due.
    duration end_cycle() noexcept { return cycle_ ? cycle_->end_cycle() : duration{}; }

  private:
    JAUSCAT_FUNCTION void begin(std::uint64_t system_time, duration period) noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION bool is_left_out(std::uint16_t station) const noexcept;

    std::span<ethercat::clock_record> used_, next_;
    std::size_t used_count_{}, next_count_{};
    std::array<std::uint16_t, 8> left_out_{};
    std::size_t left_out_count_{};
    ethercat::clock_network network_{};
    duration period_{};
    std::optional<ethercat::clock_cycle> cycle_{};
    bool is_due_{};
};

} // namespace jauscat::bridging

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/bridge/impl/ring_clocks.ipp>
#endif
