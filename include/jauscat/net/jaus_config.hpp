// Which JAUS systems there are, where each listens, and which of them this program is.
#pragma once

#include <jauscat/jaus/framing.hpp>
#include <jauscat/net/jausip.hpp>

#include <boost/asio/ip/udp.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat::net {

/// A configuration that cannot be used. `what()` is `file:line: what is wrong; what to do`.
class config_error : public std::runtime_error {
  public:
    config_error(const std::string& text, std::size_t at_line) : std::runtime_error{text}, line_{at_line} {}

    /// Line in the file, from 1; 0 when the file could not be read or the trouble is not in it.
    std::size_t line() const noexcept { return line_; }

  private:
    std::size_t line_;
};

/// One JAUS system and the socket it listens on.
struct system_entry {
    std::string name{};
    jaus::address jausip{};        ///< each level 0 to 254; 0 stands for every ID at that level
    boost::asio::ip::address ip{}; ///< IPv4 or IPv6
    std::uint16_t port{};          ///< UDP port, 1 to 65535
    jaus::framing framing{};       ///< what this system wants in front of a message; `bare` unless given
    std::size_t line{};            ///< where the file declares it

    boost::asio::ip::udp::endpoint endpoint() const { return {ip, port}; }
};

/// The content of a `JausConfig.xml`, checked: names and jausips are unique, and `this_system` names an entry.
struct jaus_config {
    std::string this_system{};
    std::vector<system_entry> systems{};
    std::string source{}; ///< the file's name, for messages

    /// The entry of that name, or null.
    const system_entry* find(std::string_view name) const noexcept;

    /// The entry that `this_system` names.
    const system_entry& me() const noexcept { return *find(this_system); }

    /// The same configuration seen by another of its systems, so that one file serves all programs.
    /// Throws `config_error` if there is no system of that name.
    jaus_config with_this(std::string_view name) const;

    /// The system that a message to `destination` goes to, or null if none covers it; it may be `me()`.
    /// A level of 0 in an entry covers every ID. Of several entries that match, the one that names the higher level
    /// is taken: 1.2.0.0 before 1.0.33.0 before 1.0.0.0 before 0.0.0.0.
    const system_entry* next_hop(const jaus::address& destination) const noexcept;
};

namespace detail {

inline std::string quoted(std::string_view text) { return '"' + std::string{text} + '"'; }

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
    if (!find(name)) throw config_error{source + ": " + detail::no_such_system(*this, name), 0};
    jaus_config changed = *this;
    changed.this_system = name;
    return changed;
}

inline const system_entry* jaus_config::next_hop(const jaus::address& destination) const noexcept {
    const system_entry* best = nullptr;
    int best_rank = -1;
    for (const auto& entry : systems) {
        int rank = 0; // one bit a level, the subsystem's the highest, set where the entry names an ID
        bool matches = true;
        for (const auto level :
             {&jaus::address::subsystem, &jaus::address::node, &jaus::address::component, &jaus::address::instance}) {
            const auto id = entry.jausip.*level;
            rank = 2 * rank + (id != 0);
            matches = matches && (id == 0 || id == destination.*level);
        }
        if (matches && rank > best_rank) {
            best = &entry;
            best_rank = rank;
        }
    }
    return best;
}

} // namespace jauscat::net
