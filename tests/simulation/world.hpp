// Simulated time, chance, and what is told of it.
#pragma once

#include "simulation/agenda.hpp"
#include "simulation/contract.hpp"
#include "simulation/faults.hpp"
#include "simulation/story.hpp"

#include <functional>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace simulation {

/// One run: everything in it follows from the seed.
class world {
  public:
    explicit world(std::uint64_t seed, fault_set enabled = every_fault)
        : random_{generator{seed}.stream(0)}, faults{generator{seed}, enabled} {}

    [[nodiscard]] time now() const noexcept { return now_; }
    void at(time when, actor& who, std::uint8_t what, std::uint32_t argument = 0) {
        agenda_.put(std::max(when, now_), who, what, argument);
    }
    void in(time pause, actor& who, std::uint8_t what, std::uint32_t argument = 0) {
        agenda_.put(now_ + pause, who, what, argument);
    }
    /// Gets a line for each happening.
    std::ostream* trace{};
    /// What is checked after each step.
    std::function<void()> check{};
    /// Until then, or until the contract is broken.
    void run(time until) {
        while (!broken_ && !agenda_.empty() && agenda_.next() <= until) {
            const event next = agenda_.take();
            now_ = next.at;
            ++steps_;
            next.who->on_event(next.what, next.argument);
            if (check) check();
        }
        if (!broken_) now_ = until;
    }
    [[nodiscard]] std::uint64_t steps() const noexcept { return steps_; }

    /// A generator of its own for the actor of this number.
    [[nodiscard]] generator stream(std::uint64_t number) const noexcept { return random_.stream(number); }

    /// The number of a new actor.
    std::uint8_t add(std::string name) {
        names_.push_back(std::move(name));
        return static_cast<std::uint8_t>(names_.size() - 1);
    }
    [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }

    void tell(happening one) {
        one.at = now_;
        told.tell(one);
        if (trace != nullptr) *trace << line_of(one, names_) << '\n';
    }
    /// What somebody sends or tells, that is no happening: it counts in the digest.
    void sees(const char* what, std::span<const std::byte> content = {}) {
        told.mix(now_, what, content);
        if (trace != nullptr) *trace << line_of(now_, what, content) << '\n';
    }
    void sees(const char* what, std::string_view text) { sees(what, std::as_bytes(std::span{text})); }
    /// Of many breaches the first counts.
    void breaks(violation broken) {
        if (broken_) return;
        broken.at = now_;
        broken_ = std::move(broken);
    }
    [[nodiscard]] const std::optional<violation>& broken() const noexcept { return broken_; }
    void compares(comparison what) noexcept { ++compared_[static_cast<std::size_t>(what)]; }
    [[nodiscard]] const comparison_counts& compared() const noexcept { return compared_; }

  private:
    generator random_;
    agenda agenda_{};
    time now_{};
    std::uint64_t steps_{};
    std::vector<std::string> names_{"network"};
    std::optional<violation> broken_{};
    comparison_counts compared_{};

  public:
    fault_source faults;
    story told{};
};

} // namespace simulation
