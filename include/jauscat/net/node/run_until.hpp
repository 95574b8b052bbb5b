// Waits for an answer in a program without a main loop.
#pragma once

#include <jauscat/jaus/message/saturating_add.hpp>

#include <boost/asio/io_context.hpp>

#include <algorithm>
#include <chrono>
#include <concepts>

namespace jauscat::net {

/// Runs the handlers of `context` until `done()` is true, at most for `timeout`; nanoseconds::max(): without limit.
/// `done` is called after each handler. Returns `done()`.
template <std::predicate Done>
bool run_until(boost::asio::io_context& context, std::chrono::nanoseconds timeout, Done done) {
    using clock = std::chrono::steady_clock;
    const clock::time_point deadline{
        jaus::saturating_add(clock::now().time_since_epoch(), std::max(timeout, std::chrono::nanoseconds{}))};
    context.restart();
    while (!done())
        if (context.run_one_until(deadline) == 0) return done();
    return true;
}

} // namespace jauscat::net
