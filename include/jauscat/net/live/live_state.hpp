// State of a node and its buses, as the live view shows it.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/schema/jaus/header.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace jauscat::net {

/// A system of the configuration.
struct live_system {
    std::uint16_t subsystem{};
    std::string name{};
    std::string address{}; ///< "127.0.0.1:3794"
    bool is_sae{};         ///< it speaks SAE JAUS alone
    bool is_alive{};       ///< a component of it is heard
    friend bool operator==(const live_system&, const live_system&) = default;
};

/// A component of the node, or one that is heard.
struct live_component {
    jaus::address id{};
    bool is_own{};
    std::string name{};
    std::string state{};                       ///< "ready"; empty: unknown
    std::optional<jaus::address> controller{}; ///< nothing: no component has control, or it is unknown
    std::uint8_t authority{};                  ///< of the controller
    std::optional<duration> age{};             ///< since its last message
};

/// Error counters of a slave's EtherCAT controller.
struct live_slave_errors {
    unsigned invalid_frames{};
    unsigned forwarded{};
    unsigned lost_links{};
};
struct live_slave {
    std::uint16_t position{};
    std::uint16_t station{};
    std::string name{};
    std::string state{};     ///< "op"; empty: unknown
    std::string wanted{};    ///< the same; empty: any
    std::string al_status{}; ///< the error; empty: none
    std::optional<live_slave_errors> errors{};
    bool is_in_service{}; ///< it answers and takes messages or process data
    bool is_at_rest{};    ///< its actuator has confirmed that it is at rest
};
struct live_clock {
    std::string reference{}; ///< station address of the reference clock
    std::int64_t offset_ns{};
    bool is_in_step{};
};
struct live_bus {
    std::string name{};
    std::string state{}; ///< the lowest state of its slaves
    duration period{};   ///< of the process data; 0: there are none
    std::uint64_t cycles{};
    std::uint16_t working_counter{}, expected_working_counter{};
    std::uint64_t wrong_working_counters{};
    std::uint64_t frames_lost{};
    std::optional<live_clock> clock{};
    std::vector<unsigned> lateness_limits_us{};   ///< upper bounds of the histogram of late cycles
    std::vector<std::uint64_t> lateness_counts{}; ///< one more than bounds
    std::vector<live_slave> slaves{};
};

/// All of it, at one time.
struct live_state {
    std::vector<live_system> systems{};
    std::vector<live_component> components{};
    std::vector<live_bus> buses{};
};

} // namespace jauscat::net
