// Waits for an answer in a program without a main loop.
#pragma once

#include <jauscat/net/now.hpp>

#include <boost/asio/io_context.hpp>

#include <algorithm>
#include <concepts>

namespace jauscat::net {

/// Runs the handlers of `context` until `done()` is true, at most for `timeout`; duration::max(): without limit.
/// `done` is called after each handler. Returns `done()`.
template <std::predicate Done>
[[nodiscard]] bool run_until(boost::asio::io_context& context, duration timeout, Done done) {
    const deadline end{now(), std::max(timeout, duration{})};
    context.restart();
    while (!done())
        if (context.run_one_until(to_steady(end.at())) == 0) return done();
    return true;
}

} // namespace jauscat::net
