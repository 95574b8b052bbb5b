// Planning subgroup of RA 3.3 part 3: missions of JAUS messages that a Mission Spooler keeps and sends.
#pragma once
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/wire/schema.hpp>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::jaus {

/// A whole JAUS message inside another. 16 bytes or more.
struct embedded_message {
    jaus::header header{}; ///< its data_size says how long the body is
    wire::blob body{};     ///< bytes of the body
    friend constexpr bool operator==(const embedded_message&, const embedded_message&) = default;

    struct schema : wire::items {
        using T = embedded_message;
        using type = layout<
            nested<&T::header>,
            bytes<&T::body, counted_by<&T::header, &jaus::header::data_size>>>;
    };
};

/// One message of a mission task. 19 bytes or more. A peer prints the blocking flag's meaning the other way round.
struct mission_command {
    std::uint16_t message_uid{};  ///< names the message within the mission
    embedded_message message{};   ///< what is to be sent
    std::uint8_t blocking_flag{}; ///< 0: the next message may go at once, 1: it waits for this one
    friend constexpr bool operator==(const mission_command&, const mission_command&) = default;

    struct schema : wire::items {
        using T = mission_command;
        static constexpr std::string_view field_name = "mission_message"; // of the record in each element of a group
        using type = layout<
            field<&T::message_uid, u16le>,
            nested<&T::message>,
            field<&T::blocking_flag, u8>>;
    };
};

/// A node of the mission tree. 6 bytes or more, its children not counted. A peer's child offsets below the first level
/// start elsewhere, so a receiver should not use them.
struct mission_task {
    std::uint16_t task_id{};               ///< names the task within the mission
    std::uint16_t number_of_children{};    ///< tasks right below this one
    wire::list<std::uint32_t> offset{};    ///< byte of the body at which each child starts
    wire::list<mission_command> message{}; ///< the task's own messages, in the order of sending
    friend constexpr bool operator==(const mission_task&, const mission_task&) = default;

    struct schema : wire::items {
        using T = mission_task;
        using type = layout<
            field<&T::task_id, u16le>,
            field<&T::number_of_children, u16le>,
            repeated<&T::offset, counted_by<&T::number_of_children>, element<"child_offset", u32le>>,
            repeated<&T::message, count<"number_of_messages", u16le>>>;
    };
};

/// Append Flag of Spool Mission.
enum class append_flag : std::uint8_t {
    replace_the_current_mission = 0,
    append_to_the_current_mission = 1,
};

/// Spool Mission: hands a tree of tasks with their messages to the spooler.
/// Code 0E00h, command class, 9 bytes or more.
struct spool_mission {
    std::uint16_t mission_id{};              ///< names the mission
    jaus::append_flag append_flag{};         ///< what becomes of the mission at hand
    wire::list<mission_task> mission_tree{}; ///< depth first: each task is followed by its children, left to right
    friend constexpr bool operator==(const spool_mission&, const spool_mission&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0E00;
        using T = spool_mission;
        using type = layout<
            field<&T::mission_id, u16le>,
            field<&T::append_flag, enumeration<jaus::append_flag, u8>>,
            tree<&T::mission_tree, &mission_task::number_of_children, 16>>;
    };
};

/// Run Mission: starts a spooled mission. Code 0E01h, command class, 2 bytes.
struct run_mission {
    std::uint16_t mission_id{}; ///< the mission to start
    friend constexpr bool operator==(const run_mission&, const run_mission&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0E01;
        using T = run_mission;
        using type = layout<field<&T::mission_id, u16le>>;
    };
};

/// Abort Mission: ends a mission or one of its tasks. Code 0E02h, command class, 4 bytes.
struct abort_mission {
    std::uint16_t mission_id{}; ///< the mission
    std::uint16_t task_id{};    ///< the task, 0 for the whole mission
    friend constexpr bool operator==(const abort_mission&, const abort_mission&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0E02;
        using T = abort_mission;
        using type = layout<
            field<&T::mission_id, u16le>,
            field<&T::task_id, u16le>>;
    };
};

/// Pause Mission: holds a mission or one of its tasks. Code 0E03h, command class, 4 bytes.
struct pause_mission {
    std::uint16_t mission_id{}; ///< the mission
    std::uint16_t task_id{};    ///< the task, 0 for the whole mission
    friend constexpr bool operator==(const pause_mission&, const pause_mission&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0E03;
        using T = pause_mission;
        using type = layout<
            field<&T::mission_id, u16le>,
            field<&T::task_id, u16le>>;
    };
};

/// Resume Mission: continues a paused mission or task. Code 0E04h, command class, 4 bytes.
struct resume_mission {
    std::uint16_t mission_id{}; ///< the mission
    std::uint16_t task_id{};    ///< the task, 0 for the whole mission
    friend constexpr bool operator==(const resume_mission&, const resume_mission&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0E04;
        using T = resume_mission;
        using type = layout<
            field<&T::mission_id, u16le>,
            field<&T::task_id, u16le>>;
    };
};

/// Remove Messages: takes messages out of a spooled task.
/// Code 0E05h, command class, 6 bytes or more.
struct remove_messages {
    std::uint16_t mission_id{};              ///< the mission
    std::uint16_t task_id{};                 ///< the task
    wire::list<std::uint16_t> message_uid{}; ///< the messages to remove
    friend constexpr bool operator==(const remove_messages&, const remove_messages&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0E05;
        using T = remove_messages;
        using type = layout<
            field<&T::mission_id, u16le>,
            field<&T::task_id, u16le>,
            repeated<&T::message_uid, count<"number_of_messages", u16le>, element<"message", u16le>>>;
    };
};

/// Replace Messages: exchanges messages of a spooled task for others.
/// Code 0E06h, command class, 8 bytes or more.
struct replace_messages {
    std::uint16_t mission_id{};                     ///< the mission
    std::uint16_t task_id{};                        ///< the task
    wire::list<std::uint16_t> message_uid{};        ///< the messages to remove
    wire::list<mission_command> inserted_message{}; ///< the messages to put in their place
    friend constexpr bool operator==(const replace_messages&, const replace_messages&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x0E06;
        using T = replace_messages;
        using type = layout<
            field<&T::mission_id, u16le>,
            field<&T::task_id, u16le>,
            repeated<&T::message_uid, count<"number_of_messages_to_remove", u16le>, element<"removed_message", u16le>>,
            repeated<&T::inserted_message, count<"number_of_messages_to_insert", u16le>>>;
    };
};

/// Query Spooling Preference: asks for Report Spooling Preference.
/// Code 2E00h, query class, no body.
struct query_spooling_preference {
    friend constexpr bool operator==(const query_spooling_preference&, const query_spooling_preference&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2E00;
        using report = struct report_spooling_preference;
        using type = layout<>;
    };
};

/// Type of Query Mission Status and Report Mission Status: what the status is of.
enum class mission_status_type : std::uint8_t {
    mission = 0,
    task = 1,
    message = 2,
};

/// Query Mission Status: asks for Report Mission Status.
/// Code 2E01h, query class, 8 bytes. Whether the presence vector gates the three IDs is open; they are always sent
/// here, as the peer does.
struct query_mission_status {
    std::uint8_t presence_vector{};   ///< bit 0 Mission ID, 1 Task ID, 2 Message UID
    jaus::mission_status_type type{}; ///< what the status is asked of
    std::uint16_t mission_id{};       ///< the mission
    std::uint16_t task_id{};          ///< the task
    std::uint16_t message_uid{};      ///< the message
    friend constexpr bool operator==(const query_mission_status&, const query_mission_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x2E01;
        using report = struct report_mission_status;
        using T = query_mission_status;
        using type = layout<
            field<&T::presence_vector, u8>,
            field<&T::type, enumeration<mission_status_type, u8>>,
            field<&T::mission_id, u16le>,
            field<&T::task_id, u16le>,
            field<&T::message_uid, u16le>>;
    };
};

/// Spooling Preference Type of Report Spooling Preference.
enum class spooling_preference_type : std::uint8_t {
    message_count = 0,
    distance = 1,
    time = 2,
};

/// Report Spooling Preference: how far ahead a spooler is to send messages.
/// Code 4E00h, inform class, 5 bytes.
struct report_spooling_preference {
    jaus::spooling_preference_type spooling_preference_type{}; ///< what data counts
    std::int32_t data{};                                       ///< messages, metres or seconds, by the type
    friend constexpr bool operator==(const report_spooling_preference&, const report_spooling_preference&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4E00;
        using query = query_spooling_preference;
        using T = report_spooling_preference;
        using type = layout<
            field<&T::spooling_preference_type, enumeration<jaus::spooling_preference_type, u8>>,
            field<&T::data, i32le>>;
    };
};

/// Status of Report Mission Status.
enum class mission_status : std::uint8_t {
    spooling = 0,
    pending = 1,
    paused = 2,
    aborted = 3,
    finished = 4,
};

/// Secondary Status of Report Mission Status.
enum class mission_secondary_status : std::uint8_t {
    non_error_condition = 0,
    lost_component_control = 1,
    tolerance_not_met = 2,
};

/// Report Mission Status: how far a mission, a task or a message is.
/// Code 4E01h, inform class, 9 bytes.
struct report_mission_status {
    jaus::mission_status_type type{};                  ///< what the status is of
    jaus::mission_status status{};                     ///< how far it is
    jaus::mission_secondary_status secondary_status{}; ///< why
    std::uint16_t mission_id{};                        ///< the mission
    std::uint16_t task_id{};                           ///< the task
    std::uint16_t message_uid{};                       ///< the message
    friend constexpr bool operator==(const report_mission_status&, const report_mission_status&) = default;

    struct schema : wire::items {
        static constexpr std::uint16_t command_code = 0x4E01;
        using query = query_mission_status;
        using T = report_mission_status;
        using type = layout<
            field<&T::type, enumeration<mission_status_type, u8>>,
            field<&T::status, enumeration<mission_status, u8>>,
            field<&T::secondary_status, enumeration<mission_secondary_status, u8>>,
            field<&T::mission_id, u16le>,
            field<&T::task_id, u16le>,
            field<&T::message_uid, u16le>>;
    };
};

/// The messages of the subgroup, by command code.
using planning_subgroup = message_list<
    spool_mission,
    run_mission,
    abort_mission,
    pause_mission,
    resume_mission,
    remove_messages,
    replace_messages,
    query_spooling_preference,
    query_mission_status,
    report_spooling_preference,
    report_mission_status>;

} // namespace jauscat::jaus
