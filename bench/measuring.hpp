// What the benches that run threads share: a processor for each thread, and the time that it has worked there.
#pragma once

#include <chrono>
#include <ctime>
#include <pthread.h>
#include <sched.h>

namespace measuring {

/// Time that this thread has spent on a processor.
inline std::chrono::nanoseconds cpu_time() {
    std::timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds{time.tv_sec} + std::chrono::nanoseconds{time.tv_nsec};
}

/// Keeps this thread on one processor; no effect where there is no such processor, or if it is negative.
inline void pin(int processor) {
    if (processor < 0) return;
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(static_cast<unsigned>(processor), &set);
    ::pthread_setaffinity_np(::pthread_self(), sizeof set, &set);
}

/// In microseconds.
inline double us(std::chrono::nanoseconds time) { return static_cast<double>(time.count()) / 1000; }

} // namespace measuring
