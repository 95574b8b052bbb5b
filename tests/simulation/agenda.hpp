// What happens when, in simulated time.
#pragma once

#include "simulation/generator.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace simulation {

/// Gets its events from the agenda.
class actor {
  public:
    actor() = default;
    actor(const actor&) = delete;
    actor& operator=(const actor&) = delete;
    virtual ~actor() = default;
    /// `what` and `argument` are those of agenda::put.
    virtual void on_event(std::uint8_t what, std::uint32_t argument) = 0;
};

/// An event of an actor.
struct event {
    time at{};
    std::uint64_t order{}; ///< events of one instant happen in the order in which they were put
    actor* who{};
    std::uint32_t argument{};
    std::uint8_t what{};
};

/// A binary heap; its memory is used again.
class agenda {
  public:
    void put(time at, actor& who, std::uint8_t what, std::uint32_t argument) {
        heap_.push_back({at, ++order_, &who, argument, what});
        std::ranges::push_heap(heap_, later{});
    }
    [[nodiscard]] bool empty() const noexcept { return heap_.empty(); }
    [[nodiscard]] time next() const noexcept { return heap_.front().at; }
    event take() {
        std::ranges::pop_heap(heap_, later{});
        const event first = heap_.back();
        heap_.pop_back();
        return first;
    }
    [[nodiscard]] std::size_t size() const noexcept { return heap_.size(); }

  private:
    struct later {
        bool operator()(const event& a, const event& b) const noexcept {
            return a.at != b.at ? a.at > b.at : a.order > b.order;
        }
    };
    std::vector<event> heap_{};
    std::uint64_t order_{};
};

} // namespace simulation
