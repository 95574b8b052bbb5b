// The functions of slave_status.
#pragma once
#include <jauscat/ethercat/master/slave_status.hpp>

namespace jauscat::ethercat {

JAUSCAT_CONSTEXPR std::string_view describe(slave_condition condition) noexcept {
    switch (condition) {
    case slave_condition::silent: return "frames do not return: check cable, interface and that a slave is running";
    case slave_condition::running: return "in OP, process data exchanged";
    case slave_condition::incomplete: return "in OP, process data not exchanged: configure the slave again";
    case slave_condition::not_in_op: return "not in OP: see its AL status code";
    case slave_condition::absent: return "no slave has its station address: it was reset, bring it up again";
    case slave_condition::duplicate: return "several slaves answer to its station address: choose another one";
    }
    return "unknown condition";
}

JAUSCAT_CONSTEXPR bool slave_status::ran_within(std::chrono::nanoseconds limit, time_point now) const noexcept {
    return is_within(last_running, limit, now);
}

JAUSCAT_CONSTEXPR bool slave_status::has_inputs_within(std::chrono::nanoseconds limit, time_point now) const noexcept {
    return is_within(last_inputs, limit, now);
}

JAUSCAT_CONSTEXPR slave_condition slave_status::condition_within(std::chrono::nanoseconds limit,
                                                                 time_point now) const noexcept {
    if (ran_within(limit, now)) return slave_condition::running;
    return is_within(last_frame, limit, now) ? condition : slave_condition::silent;
}

JAUSCAT_CONSTEXPR bool slave_status::is_within(const std::optional<time_point>& at, std::chrono::nanoseconds limit,
                                               time_point now) noexcept {
    return at && now - *at <= limit;
}

} // namespace jauscat::ethercat
