// Runs a master's jobs over a link, on this thread, until they are done.
#pragma once

#include <jauscat/ethercat/link.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/jaus/message/saturating_add.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <span>

namespace jauscat::net {

/// Runs the job that has been started and says how it has ended; returns at once if none runs. The job is abandoned
/// after `limit`; nanoseconds::max(): without limit. Errors in addition to those of the job: timeout, not_sent.
template <class Link>
ethercat::master_result<> run(Link& link, ethercat::master& master,
                              std::chrono::nanoseconds limit = std::chrono::seconds{10}) {
    ethercat::require_link<Link>();
    const auto clock = [] {
        return std::chrono::duration_cast<std::chrono::nanoseconds>(
            std::chrono::steady_clock::now().time_since_epoch());
    };
    std::array<std::byte, ethercat::max_frame_size> frame;
    const auto deadline = jaus::saturating_add(clock(), limit);
    while (!master.idle()) {
        const auto now = clock();
        if (now >= deadline) master.cancel(ethercat::master_errc::timeout);
        master.on_time(now);
        if (const auto size = master.next_frame(frame, now); size != 0 && !link.send(std::span{frame}.first(size)))
            master.cancel(ethercat::master_errc::not_sent);
        const auto wake = master.next_event();
        if (!wake) continue; // the job has ended
        const auto wait = std::max(std::min(*wake, deadline) - clock(), std::chrono::nanoseconds{});
        if (const auto size = link.receive(frame, wait); size != 0)
            master.on_frame(std::span{frame}.first(size), clock());
    }
    return master.error();
}

/// Runs a job and returns its result:
/// `const auto slave = net::run(link, master, ethercat::bring_up{.position = 0, .station = 1})`. Error `busy` if
/// another job runs, which is not affected.
template <class Link, ethercat::master_job Job>
typename Job::result_type run(Link& link, ethercat::master& master, const Job& job,
                              std::chrono::nanoseconds limit = std::chrono::seconds{10}) {
    if (const auto started = master.start(job); !started) return started.error();
    static_cast<void>(run(link, master, limit));
    return master.result<Job>();
}

} // namespace jauscat::net
