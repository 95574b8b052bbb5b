// Runs a master's jobs over a link, on this thread, until they are done.
#pragma once

#include <jauscat/ethercat/link.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/net/now.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <span>

namespace jauscat::net {

/// Runs the job that has been started and says how it has ended; returns at once if none runs. The job is abandoned
/// after `limit`; duration::max(): without limit. Errors in addition to those of the job: timeout, not_sent.
template <class Link>
ethercat::master_result<> run(Link& link, ethercat::master& master, duration limit = std::chrono::seconds{10}) {
    ethercat::require_link<Link>();
    std::array<std::byte, ethercat::max_frame_size> frame;
    const deadline end{now(), limit};
    while (!master.idle()) {
        const auto at = now();
        if (end.is_reached(at)) master.cancel(ethercat::master_errc::timeout);
        master.on_time(at);
        if (const auto size = master.next_frame(frame, at); size != 0 && !link.send(std::span{frame}.first(size)))
            master.cancel(ethercat::master_errc::not_sent);
        const auto wake = master.next_event();
        if (!wake) continue; // the job has ended
        const auto wait = std::max(std::min(*wake, end.at()) - now(), duration{});
        if (const auto size = link.receive(frame, wait); size != 0)
            master.on_frame(std::span{frame}.first(size), now());
    }
    return master.error();
}

/// Runs a job and returns its result:
/// `const auto slave = net::run(link, master, ethercat::bring_up{.position = 0, .station = 1})`. Error `busy` if
/// another job runs, which is not affected.
template <class Link, ethercat::master_job Job>
typename Job::result_type run(Link& link, ethercat::master& master, const Job& job,
                              duration limit = std::chrono::seconds{10}) {
    if (const auto started = master.start(job); !started) return started.error();
    static_cast<void>(run(link, master, limit));
    return master.result<Job>();
}

} // namespace jauscat::net
