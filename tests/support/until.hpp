// How tests wait for what others do.
#pragma once

#include <jauscat/net/node/run_until.hpp>

#include <chrono>

namespace support {

/// Long enough for a machine that is busy with something else; only a test that fails waits so long.
constexpr std::chrono::seconds wait_limit{30};

/// Runs the handlers of `context` until `done()`. Returns whether that came.
template <class Done> bool until(boost::asio::io_context& context, Done done) {
    return jauscat::net::run_until(context, wait_limit, done);
}

} // namespace support
