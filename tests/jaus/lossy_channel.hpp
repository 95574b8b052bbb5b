// A channel in simulated time that loses, doubles and delays messages, and so changes their order.
#pragma once
#include "jaus/messages.hpp"
#include "support/instant.hpp"

#include <chrono>
#include <functional>
#include <map>
#include <random>

namespace jauscat::test {

/// Chances in percent.
struct channel_faults {
    unsigned lose{};
    unsigned duplicate{};
    unsigned delay{};
    std::chrono::nanoseconds longest{std::chrono::milliseconds{300}}; ///< of a delay
};

/// Carries messages to those that listen, by the destination of their header.
class lossy_channel {
  public:
    using listener = std::function<void(const jaus::header&, std::span<const std::byte> body)>;
    /// Does what is due at `now`, and says when there is more to do.
    using worker = std::function<std::optional<time_point>()>;

    channel_faults faults{};
    time_point now{};
    duration trip{std::chrono::milliseconds{1}}; ///< one way

    explicit lossy_channel(unsigned seed = 1) : random_{seed} {}

    void listen(const jaus::address& at, listener take) { listeners_.emplace_back(at, std::move(take)); }
    void work(worker w) { workers_.push_back(std::move(w)); }

    void send(std::span<const std::byte> message) {
        if (happens(faults.lose)) return;
        for (int copies = happens(faults.duplicate) ? 2 : 1; copies != 0; --copies) {
            time_point at = now + trip;
            if (happens(faults.delay)) at += duration{random_() % static_cast<std::uint64_t>(faults.longest.count())};
            travelling_.emplace(at, bytes(message.begin(), message.end()));
        }
    }
    [[nodiscard]] auto sink() {
        return [this](std::span<const std::byte> message) { send(message); };
    }

    /// Until nothing travels and nobody has anything to do, or until `end`.
    void run(support::instant until) {
        const time_point end = until;
        for (;;) {
            std::optional<time_point> next;
            if (!travelling_.empty()) next = travelling_.begin()->first;
            for (const auto& w : workers_)
                if (const auto due = w(); due && (!next || *due < *next)) next = due;
            // A worker may have sent something that arrives before all the rest.
            if (!travelling_.empty()) next = std::min(*next, travelling_.begin()->first);
            if (!next || *next > end) break;
            now = std::max(now, *next);
            while (!travelling_.empty() && travelling_.begin()->first <= now)
                arrive(travelling_.extract(travelling_.begin()).mapped());
        }
        now = std::max(now, end);
    }

  private:
    bool happens(unsigned percent) { return random_() % 100 < percent; }
    void arrive(const bytes& message) {
        const auto m = jaus::split(message);
        REQUIRE(m);
        for (const auto& [at, take] : listeners_)
            if (at == m.header.destination) take(m.header, m.body);
    }

    std::mt19937_64 random_;
    std::vector<std::pair<jaus::address, listener>> listeners_{};
    std::vector<worker> workers_{};
    std::multimap<time_point, bytes> travelling_{};
};

} // namespace jauscat::test
