// Waiting for an answer in a program that has no main loop of its own.
#pragma once

#include <boost/asio/io_context.hpp>

#include <chrono>
#include <concepts>

namespace jauscat::net {

/// Runs the handlers of `context` until `done()` is true, at most for `timeout`. Returns `done()`.
/// `done` is asked after each handler.
template <std::predicate Done>
bool run_until(boost::asio::io_context& context, std::chrono::nanoseconds timeout, Done done) {
    const auto deadline = std::chrono::steady_clock::now() + timeout;
    context.restart();
    while (!done())
        if (context.run_one_until(deadline) == 0) return done();
    return true;
}

} // namespace jauscat::net
