// The points of the contract of docs/safety.md, and what breaks one.
#pragma once

#include "simulation/faults.hpp"
#include "simulation/generator.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace simulation {

/// docs/safety.md has their words.
enum class contract : std::uint8_t { s1, s2, s3, s4, s5, s6, s7, s8, memory, limits, availability, told };

[[nodiscard]] constexpr std::string_view name_of(contract point) noexcept {
    constexpr std::array<std::string_view, 12> names{
        "S1: what is acknowledged was executed, once",
        "S2: stop orders come first, and are repeated until they are confirmed",
        "S3: at rest in time when who commands is lost",
        "S4: no old value is given as current",
        "S5: moved only when Ready, and only by the controller",
        "S6: every wait is bounded",
        "S7: what is delivered is what was sent",
        "S8: what cannot be known is not running",
        "memory does not grow",
        "motors keep the limits of their joints, and are not switched off while they turn",
        "availability: what works is neither given up nor reset",
        "what an observer is told is so, and in its time"};
    return names[static_cast<std::size_t>(point)];
}

/// What is compared with what ought to be. A long run in which one of them has compared nothing has proved nothing of
/// it.
enum class comparison : std::uint8_t {
    acknowledgement,
    asked_for,
    stop_confirmed,
    told_of_emergency,
    told_to_rest,
    ready_after_rest,
    rest_when_lost,
    watchdog,
    efforts_reported,
    no_efforts_reported,
    status_reported,
    velocities_reported,
    obeyed,
    control_kept,
    outcome_learnt,
    brought_up,
    rest_at_end,
    large_data,
    large_data_arrives,
    known_to_run,
    kept_in_use,
    loser_dropped,
    long_data,
    silent_node_lost,
    heard_node_known,
    lost_consumer_dropped,
    reports_come,
    report_current,
    broadcast_arrives,
    time_reported,
    direct_upload,
    direct_download,
    outcome_ruled,
    answer_ruled,
    state_ruled,
    control_ruled,
    pulse_asked,
    repeat_ruled,
    request_ruled,
    outcome_told,
    order_ends,
    refusal_caused,
    slave_kept,
    orders_reported,
    kept_alive,
    efforts_kept,
    slave_returns,
    cycle_kept,
    stop_caused,
    query_answered,
    motor_limits,
    motor_moves,
    motor_rests,
    motor_stays,
    sender_silent,
    axis_wait,
    drive_fault_told,
    following_told,
    turn_idle,
    slave_told,
    attempt_paused,
    refusal_detailed,
    stop_repeated,
    emergency_told,
    others_called,
    image_told,
    keep_alive_told,
    dictionary,
    creation,
    frame_taken,
};
inline constexpr std::array<std::string_view, 70> comparison_names{"S1 acknowledged messages are executed",
                                                                   "S1 acknowledgements and refusals are asked for",
                                                                   "S2 confirmed stop orders have effect",
                                                                   "S2 a slave is told of an emergency",
                                                                   "S2 a slave is told to rest",
                                                                   "S2 Ready after rest alone",
                                                                   "S3 at rest when something is lost",
                                                                   "S3 a slave in OP has a watchdog",
                                                                   "S4 reported efforts are in force",
                                                                   "S4 reports without efforts",
                                                                   "S4 reported states are true",
                                                                   "S4 reported velocities are true",
                                                                   "S5 who may move moves",
                                                                   "S5 a living controller keeps control",
                                                                   "S6 senders learn an outcome",
                                                                   "S6 slaves that are there are brought up",
                                                                   "S6 at rest before the program ends",
                                                                   "S7 large data sets are whole",
                                                                   "S1 large data sets arrive",
                                                                   "S8 what is not known to run is not Ready",
                                                                   "slaves are given up and reset for a cause",
                                                                   "S5 queued commands of the loser are dropped",
                                                                   "S7 sets of more than 256 packets are whole",
                                                                   "S8 silent nodes are lost",
                                                                   "nodes that are heard are known",
                                                                   "S8 lost consumers get no reports",
                                                                   "subscribed reports come",
                                                                   "S4 subscribed values are current",
                                                                   "S1 broadcasts arrive once",
                                                                   "S4 reported times are true",
                                                                   "S7 direct uploads get their own answers",
                                                                   "S7 direct downloads are confirmed themselves",
                                                                   "S5 outcomes of messages follow the rules",
                                                                   "S1 answers are those of their message",
                                                                   "S5 states follow the table",
                                                                   "S5 control follows the authority",
                                                                   "S6 silent senders are asked for a pulse",
                                                                   "S6 messages are repeated in time",
                                                                   "S5 requests for control and their answers",
                                                                   "S1 outcomes are told once",
                                                                   "S6 messages for slaves end",
                                                                   "refusals have a cause",
                                                                   "slaves to which nothing happens are kept",
                                                                   "S4 unconfirmed stop orders are reported",
                                                                   "slaves by mailbox are kept alive",
                                                                   "efforts stay in force",
                                                                   "slaves to which nothing happens are used in time",
                                                                   "cycles keep their period",
                                                                   "stop orders have the cause that is told",
                                                                   "queries of the core services are answered",
                                                                   "limits of joints are kept by their motors",
                                                                   "S1 motors do what is acknowledged",
                                                                   "S2 motors stand still when stops are confirmed",
                                                                   "S2 motors stand still outside of Ready",
                                                                   "S3 motors stand still without their sender",
                                                                   "S6 waits of axes end",
                                                                   "S8 a drive fault ends Ready",
                                                                   "S8 a drive that does not follow is told",
                                                                   "a turn with nothing due does nothing",
                                                                   "what is told of slaves has its cause",
                                                                   "attempts to bring a slave up have pauses",
                                                                   "reasons of refusals are those of the slave",
                                                                   "refused stop orders are tried again in time",
                                                                   "emergencies of slaves are told once",
                                                                   "the cycle of others is called each period",
                                                                   "process data are told as they are used",
                                                                   "keep-alive is told from other traffic",
                                                                   "dictionaries follow their lists",
                                                                   "objects are created as they are listed",
                                                                   "frames of its own are taken"};
/// The fault of few runs without which it has nothing to compare.
[[nodiscard]] constexpr std::optional<fault> needed_by(comparison check) noexcept {
    switch (check) {
    case comparison::drive_fault_told: return fault::joint_lasting_fault;
    case comparison::sender_silent: return fault::joint_sender_silent;
    case comparison::following_told: return fault::joint_stops_following;
    default: return std::nullopt;
    }
}

/// How often each has compared something.
using comparison_counts = std::array<std::uint64_t, comparison_names.size()>;

/// The first breach of the contract in a run.
struct violation {
    contract point{};
    time at{};
    std::uint8_t who{};      ///< the actor
    std::uint8_t whom{};     ///< the other actor concerned, or 0
    std::uint32_t message{}; ///< the number of the message concerned, or 0
    std::string expected{};
    std::string found{};
};

} // namespace simulation
