// Status of a slave in the cyclic exchange.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

namespace jauscat::ethercat {

/// Whether a slave runs; if not, why.
enum class slave_condition : std::uint8_t {
    silent,     ///< no frame returned
    running,    ///< in OP, and its process data were exchanged
    incomplete, ///< in OP, but its process data were not exchanged
    not_in_op,  ///< in another state, or in one that is not known: see slave_status::al
    absent,     ///< no slave answered to its station address
    duplicate,  ///< several slaves answered to its station address
};

/// The condition in one line: what happened and what to do.
[[nodiscard]] JAUSCAT_CONSTEXPR std::string_view describe(slave_condition condition) noexcept;

/// Each time is that at which the frame was sent, so that its content is never older.
struct slave_status {
    slave_condition condition{}; ///< in the last returned frame
    al_status al{};              ///< as the slave reported it last
    bool reply_waiting{};        ///< its reply mailbox was full: unless a transfer runs, collect its emergencies
    std::optional<time_point> last_frame{};   ///< that came back
    std::optional<time_point> last_running{}; ///< frame that found it running
    std::optional<time_point> last_inputs{};  ///< frame that brought its inputs

    /// Whether it was running at some instant of the last `limit`.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool ran_within(std::chrono::nanoseconds limit, time_point now) const noexcept;
    /// Whether its inputs are at most `limit` old.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool has_inputs_within(std::chrono::nanoseconds limit,
                                                           time_point now) const noexcept;
    /// Condition of the slave: running if it ran within `limit`, silent without a reply for that time.
    [[nodiscard]] JAUSCAT_CONSTEXPR slave_condition condition_within(std::chrono::nanoseconds limit,
                                                                     time_point now) const noexcept;

  private:
    JAUSCAT_CONSTEXPR static bool is_within(const std::optional<time_point>& at, std::chrono::nanoseconds limit,
                                            time_point now) noexcept;
};

/// All slaves of a ring together, in the last cycle that has returned.
struct ring_status {
    std::uint16_t slaves{};                 ///< that the frame has passed, also those without process data
    al_status all{};                        ///< the states of all, or-ed: OP without error if each is in OP
    std::optional<time_point> last_frame{}; ///< when that frame was sent
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/slave_status.ipp>
#endif
