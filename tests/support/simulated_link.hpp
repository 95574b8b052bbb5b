// A link in simulated time between a master and emulated slaves, with faults on the way out and on the way back.
#pragma once

#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/slave.hpp>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace jauscat::test {

/// Chances in percent, for each direction.
struct link_faults {
    unsigned lose{};
    unsigned duplicate{}; ///< on the way back only: no wire doubles what a master sends
    unsigned copy{};      ///< on the way out: an IP network may do that
    unsigned delay{};
    unsigned corrupt{};                                             ///< one byte, delivered all the same
    std::chrono::nanoseconds longest{std::chrono::milliseconds{1}}; ///< of a delay
};

/// How many bytes an upload has brought.
[[nodiscard]] inline ethercat::master_result<std::size_t> size_of(const ethercat::upload::result_type& read) {
    if (!read) return read.error();
    return read->size();
}

class simulated_link {
  public:
    using bytes = std::vector<std::byte>;
    using nanoseconds = std::chrono::nanoseconds;

    link_faults faults{};
    jauscat::time_point now{};
    nanoseconds trip{std::chrono::microseconds{5}}; ///< one way
    std::function<void(bytes&)> on_way_back{};      ///< looks at a frame, may change or (by emptying it) lose it
    std::vector<bytes> seen{};                      ///< frames as the master sent them, if `record`
    bool record{};

    explicit simulated_link(std::span<ethercat::slave> slaves, unsigned seed = 1)
        : process_{[slaves](std::span<std::byte> frame) {
              for (auto& device : slaves) device.process(frame);
          }},
          random_{seed} {}
    explicit simulated_link(std::function<void(std::span<std::byte>)> process, unsigned seed = 1)
        : process_{std::move(process)}, random_{seed} {}

    /// Lets the master do a job, for at most `limit` of simulated time, and returns its result.
    template <ethercat::master_job Job>
    typename Job::result_type run(ethercat::master& master, const Job& job,
                                  nanoseconds limit = std::chrono::seconds{60}) {
        if (const auto started = master.start(job); !started) return started.error();
        static_cast<void>(run(master, limit));
        return master.result<Job>();
    }
    /// The same for the job that has been started.
    ethercat::master_result<> run(ethercat::master& master, nanoseconds limit = std::chrono::seconds{60}) {
        const auto deadline = now + limit;
        bytes out(ethercat::max_frame_size);
        while (!master.idle() && now < deadline) {
            if (const auto size = master.next_frame(out, now); size != 0) {
                const bytes frame(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size));
                if (record) seen.push_back(frame);
                travel(frame, true);
            }
            const auto event = master.next_event();
            if (!event) break;
            if (!travelling_.empty() && travelling_.begin()->first <= *event)
                arrive(master);
            else
                now = std::max(now, *event), master.on_time(now);
        }
        if (!master.idle()) master.cancel(ethercat::master_errc::timeout);
        return master.error();
    }

  private:
    struct passage {
        bool outwards{};
        bytes frame{};
    };

    bool happens(unsigned percent) { return random_() % 100 < percent; }

    void travel(bytes frame, bool outwards) {
        if (happens(faults.lose)) return;
        const unsigned copies = happens(outwards ? faults.copy : faults.duplicate) ? 2 : 1;
        for (unsigned copy = 0; copy != copies; ++copy) {
            auto at = now + trip;
            if (happens(faults.delay))
                at += nanoseconds{random_() % static_cast<std::uint64_t>(faults.longest.count())};
            if (happens(faults.corrupt)) frame[random_() % frame.size()] = static_cast<std::byte>(random_());
            travelling_.emplace(at, passage{outwards, frame});
        }
    }

    passage take_first() {
        auto first = travelling_.extract(travelling_.begin());
        now = std::max(now, first.key());
        return std::move(first.mapped());
    }

    void arrive(ethercat::master& master) {
        auto [outwards, frame] = take_first();
        if (outwards) {
            process_(frame);
            if (on_way_back) on_way_back(frame);
            if (!frame.empty()) travel(std::move(frame), false);
        } else {
            master.on_frame(frame, now);
        }
    }

    std::function<void(std::span<std::byte>)> process_;
    std::mt19937 random_;
    std::multimap<jauscat::time_point, passage> travelling_{};
};

} // namespace jauscat::test
