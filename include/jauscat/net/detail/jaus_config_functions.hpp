// The functions of net/jaus_config.hpp.
#pragma once

#include <jauscat/net/detail/jaus_config_reader.hpp>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

namespace jauscat::net {

inline const system_entry* jaus_config::find(std::string_view name) const noexcept {
    const auto entry = std::ranges::find(systems, name, &system_entry::name);
    return entry == systems.end() ? nullptr : &*entry;
}

inline jaus_config jaus_config::with_this(std::string_view name) const {
    if (!find(name)) throw config_error{source + ": " + detail::config_reader::no_such_system(*this, name), 0};
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

inline jaus_config read_jaus_config(const std::filesystem::path& path) {
    std::ifstream file{path, std::ios::binary};
    file.peek(); // a directory opens, and fails here
    if (!file && !file.eof())
        throw config_error{path.string() + ": cannot be read: " + std::generic_category().message(errno) +
                               "; give the path of a JausConfig.xml, such as examples/JausConfig.xml",
                           0};
    std::ostringstream text;
    text << file.rdbuf();
    return parse_jaus_config(text.str(), path.string());
}

inline jaus_config parse_jaus_config(std::string_view text, std::string source) {
    return detail::config_reader{text, std::move(source)}.read();
}

} // namespace jauscat::net
