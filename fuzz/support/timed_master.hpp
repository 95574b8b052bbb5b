// A master for fuzzing and its time, which passes as fast as the master lets it.
#pragma once
#include "target.hpp"
#include <jauscat/ethercat/master/master.hpp>

#include <chrono>

namespace fuzz {

/// Short times: each job ends after a bounded number of frames.
inline constexpr jauscat::ethercat::master_config short_times{.frame_timeout = std::chrono::milliseconds{1},
                                                              .sii_timeout = std::chrono::milliseconds{1},
                                                              .state_timeout = std::chrono::milliseconds{2},
                                                              .mailbox_timeout = std::chrono::milliseconds{2}};

class timed_master {
  public:
    jauscat::ethercat::master_for<16> master{short_times};
    jauscat::time_point now{};

    /// Calls `travel(frame)` for each frame that the master sends until its job is done.
    void run(auto&& travel) {
        for (int steps = 0; !master.idle(); ++steps) {
            check(steps != 20'000, "a job ends");
            byte_vector frame(jauscat::ethercat::max_frame_size);
            frame.resize(master.next_frame(frame, now));
            if (!frame.empty()) {
                now += std::chrono::microseconds{5};
                travel(frame);
                continue;
            }
            if (const auto event = master.next_event()) now = std::max(now, *event);
            master.on_time(now);
        }
    }
};

} // namespace fuzz
