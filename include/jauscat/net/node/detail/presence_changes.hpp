// Queue of appeared and disappeared components.
#pragma once

#include <jauscat/schema/jaus/header.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace jauscat::net::detail {

class presence_changes {
    struct change {
        jaus::address who{};
        bool is_there{};
    };
    struct noter {
        std::vector<change>& list;
        bool is_there;
        void operator()(const jaus::address& who) const { list.push_back({who, is_there}); }
    };
    std::vector<change> list_{}, current_{};

  public:
    presence_changes() = default;
    presence_changes(const presence_changes&) = delete;
    presence_changes& operator=(const presence_changes&) = delete;

    noter appeared{list_, true}, disappeared{list_, false};

    void clear() noexcept {
        list_.clear();
        current_.clear();
    }
    /// Calls `use(who, is_there)` for each, until one of them calls `clear`. Not from within `use`.
    void take(auto&& use) {
        std::swap(list_, current_);
        for (std::size_t i = 0; i < current_.size(); ++i) {
            const auto [who, is_there] = current_[i];
            use(who, is_there);
        }
        current_.clear();
    }
};

} // namespace jauscat::net::detail
