// Configuration of all JAUS systems: endpoints, limits, own system.
#pragma once

#include <jauscat/jaus/message/framing.hpp>
#include <jauscat/jaus/routing/node_description.hpp>
#include <jauscat/net/config/jausip.hpp>
#include <jauscat/net/config/sae_entry.hpp>
#include <jauscat/net/config/slave_entry.hpp>
#include <jauscat/net/config/udp_options.hpp>
#include <jauscat/net/config_error.hpp>
#include <jauscat/net/detail/quoted.hpp>
#include <jauscat/net/rate_limit.hpp>

#include <boost/asio/ip/udp.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::net {

/// A component of a system, as announced to other systems.
struct component_entry {
    jaus::address id{};                ///< all levels named, each 1 to 254
    std::string name{};                ///< may be empty
    std::uint8_t authority{0};         ///< its authority code, 0 lowest to 255 highest
    std::vector<std::string> slaves{}; ///< behind it, in the order of its joints; names in the system's `ethercat`
    std::size_t line{};                ///< where the file declares it
    friend bool operator==(const component_entry&, const component_entry&) = default;
};

/// A node of a system, as announced to other systems.
struct node_entry {
    std::uint8_t id{};  ///< 1 to 254
    std::string name{}; ///< as in the file
    std::size_t line{};
    friend bool operator==(const node_entry&, const node_entry&) = default;
};

/// The EtherCAT master of a system, and the program that runs it. Without `slaves`, the first slave's station address
/// is the system's node.
struct ethercat_entry {
    std::string controller{};          ///< name of the system that runs the master
    std::string interface_name{};      ///< network interface, such as `eth0`; empty: EtherCAT in UDP
    std::string udp_host{};            ///< host of the slave, for EtherCAT in UDP
    std::uint16_t udp_port{};          ///< its port, for EtherCAT in UDP
    std::vector<slave_entry> slaves{}; ///< those that are named; other slaves of the bus are not looked at
    std::size_t line{};                ///< where the file declares it

    /// The slave of that name, or null.
    [[nodiscard]] const slave_entry* find(std::string_view name) const noexcept {
        const auto found = std::ranges::find(slaves, name, &slave_entry::name);
        return found == slaves.end() ? nullptr : &*found;
    }
    /// Whether both use the same interface of the same host.
    [[nodiscard]] bool same_wire(const ethercat_entry& other) const noexcept {
        return interface_name == other.interface_name && udp_host == other.udp_host && udp_port == other.udp_port;
    }
    friend bool operator==(const ethercat_entry&, const ethercat_entry&) = default;
};

/// Rate limits and memory of a system.
struct system_limits {
    rate messages{.per_second = 50'000, .burst = 5'000}; ///< that others accept from this system
    std::size_t large_data_memory{1U << 20U};            ///< bytes of this system for the reassembly of large data sets
    friend bool operator==(const system_limits&, const system_limits&) = default;
};

/// One JAUS system and the socket it listens on. It has a jausip, and so speaks the RA, or `sae`, or both.
struct system_entry {
    /// Addresses that a system may have.
    static constexpr std::size_t max_ips = 8;

    std::string name{};
    jaus::address jausip{};                                 ///< each level 0 to 254; 0 matches every ID at that level
    boost::asio::ip::address ip{};                          ///< IPv4 or IPv6; the destination of messages to it
    std::uint16_t port{};                                   ///< UDP port, 1 to 65535
    jaus::framing framing{};                                ///< framing of messages to this system; `bare` by default
    jaus::subsystem_type type{jaus::subsystem_type::other}; ///< what it calls its subsystem
    std::size_t line{};                                     ///< where the file declares it

    std::vector<boost::asio::ip::address> more_ips{}; ///< further source addresses; all different
    bool any_source_port{};                           ///< it may send from any port
    std::optional<multicast_options> multicast{};     ///< the group that it joins
    system_limits limits{};                           ///< of its messages, in number and memory
    std::vector<node_entry> nodes{};                  ///< nodes with a name; ids are unique
    std::vector<component_entry> components{};        ///< ids are unique in the whole file
    std::optional<ethercat_entry> ethercat{};         ///< the master that gets its messages
    bool has_ra{true};                                ///< false: without jausip, it does not exist for the RA
    std::optional<sae_entry> sae{};                   ///< its SAE JAUS

    boost::asio::ip::udp::endpoint endpoint() const { return {ip, port}; }
    friend bool operator==(const system_entry&, const system_entry&) = default;
};

/// The content of a `JausConfig.xml`, checked: names and jausips are unique, and `this_system` names an entry. See
/// docs/configuration.md.
struct jaus_config {
    std::string this_system{};           ///< the name of the system that this program is
    std::vector<system_entry> systems{}; ///< this one and its peers, in the file's order
    std::string source{};                ///< the file's name, for messages

    /// The entry of that name, or null.
    const system_entry* find(std::string_view name) const noexcept;

    /// The entry that `this_system` names.
    const system_entry& me() const noexcept { return *find(this_system); }

    /// The same configuration for another of its systems, so that one file serves all programs.
    /// Throws `config_error` if there is no system of that name.
    [[nodiscard]] jaus_config with_this(std::string_view name) const;

    /// The system for messages to `destination`, or null if none covers it; it may be `me()`.
    /// A level of 0 in an entry covers every ID. If several entries match, the one that names the higher level is
    /// selected: 1.2.0.0 before 1.0.33.0 before 1.0.0.0 before 0.0.0.0.
    const system_entry* next_hop(const jaus::address& destination) const noexcept;

    /// The system of SAE JAUS that has a component, or null; it may be `me()`. If several ids match, the one that
    /// names the most is selected: 126.1.10 before 126.1.0 before 126.0.0.
    const system_entry* system_of(const sae::jaus_id& component) const noexcept;

    /// The systems with masters run by the system `controller`, in the order of the file.
    std::vector<const system_entry*> masters_of(std::string_view controller) const;
};

namespace detail {

/// The levels of an address, the subsystem first.
inline constexpr std::array levels{&jaus::address::subsystem, &jaus::address::node, &jaus::address::component,
                                   &jaus::address::instance};

/// Whether each level of an entry is open or that of `id`.
constexpr bool covers(const jaus::address& entry, const jaus::address& id) noexcept {
    return std::ranges::all_of(levels, [&](auto level) { return entry.*level == 0 || entry.*level == id.*level; });
}

/// One bit a level, the subsystem's the highest, set where the entry names an ID.
constexpr int rank(const jaus::address& entry) noexcept {
    int bits = 0;
    for (const auto level : levels) bits = 2 * bits + (entry.*level != 0 ? 1 : 0);
    return bits;
}

/// Error with the position in the file of `config`.
inline config_error complaint(const jaus_config& config, config_errc code, std::string name, std::size_t line,
                              const std::string& text) {
    return {code, std::move(name), line, config.source + ':' + std::to_string(line) + ": " + text};
}

inline std::string no_such_system(const jaus_config& config, std::string_view name) {
    std::string known;
    for (const auto& entry : config.systems) known += (known.empty() ? "" : ", ") + entry.name;
    return "there is no system " + quoted(name) + "; the file has: " + known;
}

} // namespace detail

inline const system_entry* jaus_config::find(std::string_view name) const noexcept {
    const auto entry = std::ranges::find(systems, name, &system_entry::name);
    return entry == systems.end() ? nullptr : &*entry;
}

inline jaus_config jaus_config::with_this(std::string_view name) const {
    if (!find(name))
        throw config_error{config_errc::no_such_system, "thissystem", 0,
                           source + ": " + detail::no_such_system(*this, name)};
    jaus_config changed = *this;
    changed.this_system = name;
    return changed;
}

inline const system_entry* jaus_config::next_hop(const jaus::address& destination) const noexcept {
    const system_entry* best = nullptr;
    for (const auto& entry : systems)
        if (entry.has_ra && detail::covers(entry.jausip, destination) &&
            (!best || detail::rank(entry.jausip) > detail::rank(best->jausip)))
            best = &entry;
    return best;
}

inline const system_entry* jaus_config::system_of(const sae::jaus_id& component) const noexcept {
    const auto named = [](const system_entry& entry) {
        return (entry.sae->id.node != 0 ? 1 : 0) + (entry.sae->id.component != 0 ? 1 : 0);
    };
    const system_entry* best = nullptr;
    for (const auto& entry : systems)
        if (entry.sae && sae::covers(entry.sae->id, component) && (!best || named(entry) > named(*best))) best = &entry;
    return best;
}

inline std::vector<const system_entry*> jaus_config::masters_of(std::string_view controller) const {
    std::vector<const system_entry*> found;
    for (const auto& entry : systems)
        if (entry.ethercat && entry.ethercat->controller == controller) found.push_back(&entry);
    return found;
}

} // namespace jauscat::net
