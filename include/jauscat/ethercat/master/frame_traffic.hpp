// Sends one frame at a time: timing, matching of replies, loss, statistics.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/outstanding_frame.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// Frame statistics of a master.
struct master_statistics {
    std::uint64_t sent{};
    std::uint64_t received{};   ///< replies that were waited for
    std::uint64_t lost{};       ///< replies that did not come in time
    std::uint64_t ignored{};    ///< late, duplicate and foreign frames
    std::uint64_t foreign{};    ///< of those: never sent here. Another master uses this wire.
    std::uint64_t circulated{}; ///< replies that a slave without a link to the master has marked: the ring is broken

    /// Adds those of another master on the same link.
    constexpr master_statistics& operator+=(const master_statistics& other) noexcept {
        sent += other.sent;
        received += other.received;
        lost += other.lost;
        ignored += other.ignored;
        foreign += other.foreign;
        circulated += other.circulated;
        return *this;
    }
};

/// Does not look into frames. The master asks before it sends, and reports what it has sent.
class frame_traffic {
  public:
    /// Datagrams of a frame.
    static constexpr std::size_t max_datagrams = 64;

    /// With the times and the retries of `config`.
    explicit frame_traffic(const master_config& config) noexcept : config_{config} {}

    [[nodiscard]] const master_config& config() const noexcept { return config_; }
    void set_config(const master_config& config) noexcept { config_ = config; }
    [[nodiscard]] const master_statistics& statistics() const noexcept { return statistics_; }

    /// Another job begins: nothing was lost in it yet.
    JAUSCAT_FUNCTION void begin() noexcept;

    /// Whether a frame may go now.
    [[nodiscard]] bool may_send(time_point now) const noexcept { return !outstanding_.waits() && now >= next_send(); }
    /// Whether a frame is under way.
    [[nodiscard]] bool waits() const noexcept { return outstanding_.waits(); }
    /// The tag for the datagrams of the next frame.
    std::uint8_t next_index() noexcept { return ++index_; }
    /// `frame` is on its way.
    JAUSCAT_FUNCTION void sent(std::span<const std::byte> frame, time_point now) noexcept;
    /// The next frame goes at `time`, not before.
    void wait_until(time_point time) noexcept { not_before_ = time; }

    /// The datagrams of `frame` if it is the reply that is waited for, else none. They are views of `frame` and are
    /// kept here until the next call. The last frame `was_refused`: a copy of it counts, too, that a slave has
    /// executed.
    JAUSCAT_FUNCTION replies take(std::span<const std::byte> frame, bool was_refused = false) noexcept;

    /// Whether a frame that was not taken was sent here before: it is late, or a copy.
    JAUSCAT_FUNCTION bool claim(std::span<const std::byte> frame) noexcept;
    /// Counts a frame that was not taken.
    JAUSCAT_FUNCTION void ignore(std::span<const std::byte> frame) noexcept;

    /// Whether the reply should have come by now.
    [[nodiscard]] JAUSCAT_FUNCTION bool is_late(time_point now) const noexcept;
    /// The reply that is late is lost. What is asked next goes at once if it `repeats` what was asked and does no harm
    /// twice; all else waits until the lost frame cannot arrive. False where too many were lost in a row.
    JAUSCAT_FUNCTION bool lose(bool repeats) noexcept;
    /// Cancels the outstanding frame. Its reply may still arrive, and is ignored.
    JAUSCAT_FUNCTION void give_up() noexcept;

    /// From when on no frame that was lost can arrive any more.
    [[nodiscard]] time_point settled_at() const noexcept { return unsettled_until_; }

    /// When `is_late` or `may_send` will be true, if no frame arrives first.
    [[nodiscard]] JAUSCAT_FUNCTION time_point next_event() const noexcept;

  private:
    [[nodiscard]] JAUSCAT_FUNCTION time_point next_send() const noexcept;

    master_config config_;
    outstanding_frame<max_datagrams> outstanding_{};
    std::uint8_t index_{};
    unsigned losses_{}; // in a row
    bool repeats_{};    // the next frame asks again what the lost one asked
    time_point not_before_ = time_point::min();
    time_point unsettled_until_ = time_point::min(); // a lost frame may arrive until then
    master_statistics statistics_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/frame_traffic.ipp>
#endif
