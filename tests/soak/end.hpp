// What both programs of the soak have.
#pragma once

#include "soak/large_traffic.hpp"
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/net/node/jaus_node.hpp>

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include <atomic>
#include <exception>
#include <functional>
#include <future>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace soak {

using namespace std::chrono_literals;
using std::chrono::nanoseconds;

constexpr auto large_data_pause = 100ms; // three sets each second

constexpr jaus::address operator_id{1, 32, 1, 1}, supervisor_id{1, 34, 1, 1}, robot_id{1, 33, 1, 2};

/// What both ends have: a thread, a node that notices whom it hears, large data sets.
class end {
  public:
    end(const net::jaus_config& config, const jaus::address& self, const jaus::address& other)
        : large{self, other}, node_{context_, config, options()} {}
    end(const end&) = delete;
    end& operator=(const end&) = delete;
    virtual ~end() = default;

    void start() {
        node_.start();
        pulse();
        thread_ = std::thread{[this] {
            try {
                context_.run();
            } catch (const std::exception& error) {
                note(std::string{"ended: "} + error.what());
            }
        }};
    }
    /// In the end's own thread; returns when it is done.
    void call(std::function<void()> work) {
        std::promise<void> done;
        boost::asio::post(context_, [&] {
            work();
            done.set_value();
        });
        done.get_future().wait();
    }
    void stop() {
        if (!thread_.joinable()) return;
        call([this] {
            stopped();
            node_.stop();
            pulse_.cancel();
        });
        thread_.join();
    }
    [[nodiscard]] net::udp_counters counts() {
        net::udp_counters found{};
        call([&] { found = node_.counts(); });
        return found;
    }
    [[nodiscard]] std::vector<std::string> notes() {
        const std::lock_guard lock{mutex_};
        return notes_;
    }

    /// Packets that the node dropped because they had waited in its socket, and the longest time in which its thread
    /// did nothing.
    struct pauses {
        unsigned dropped{};
        nanoseconds longest{};
    };
    [[nodiscard]] pauses paused() {
        pauses found{};
        call([&] { found = pauses_; });
        return found;
    }

    large_traffic large;
    std::atomic<unsigned> appeared{}, disappeared{};
    std::atomic<std::uint64_t> heartbeats{};

  protected:
    virtual void stopped() = 0;

    /// The first lines are kept: of thousands of one kind nobody reads the last.
    void note(std::string line) {
        const std::lock_guard lock{mutex_};
        if (notes_.size() < 20) notes_.push_back(std::move(line));
    }

    boost::asio::io_context context_{1};

  private:
    net::jaus_node_options options() {
        net::jaus_node_options made{};
        made.beat.period = 200ms;
        made.timeout = 2s; // 9 of 10 heartbeats may be lost
        made.socket.receive_buffer = std::size_t{4} << 20U;
        made.log_limit.per_second = 0; // none: a line that is left out might be one that matters
        made.log = [this](std::string_view line) {
            // The scene has the first; repeats that cross their acknowledgement have the second.
            for (const std::string_view usual :
                 {"the sender does not control the component", "acknowledgement that no message waits for"})
                if (line.find(usual) != line.npos) return;
            if (line.find("dropped: waited in the socket") != line.npos) { // right when the machine stood still
                ++pauses_.dropped;
                return;
            }
            note(std::string{line});
        };
        made.appeared = [this](const jaus::address&) { ++appeared; };
        made.disappeared = [this](const jaus::address&) { ++disappeared; };
        made.on_message = [this](const jaus::address&, const jaus::header& head, std::span<const std::byte>,
                                 jaus::component_outcome) {
            if (head.command_code == jaus::command_code_of<jaus::report_heartbeat_pulse>) ++heartbeats;
        };
        made.large_data_pause = large_data_pause;
        made.large_data_done = [this](const jaus::header&, jaus::delivered what) { large.done(what); };
        return made;
    }

    void pulse() {
        pulse_.expires_after(pulse_period);
        pulse_.async_wait([this, begun = net::jaus_node::now()](boost::system::error_code stopped) {
            if (stopped) return;
            pauses_.longest = std::max(pauses_.longest, net::jaus_node::now() - begun);
            pulse();
        });
    }

    static constexpr auto pulse_period = 5ms;

    std::mutex mutex_{};
    std::vector<std::string> notes_{};
    boost::asio::steady_timer pulse_{context_};
    pauses pauses_{}; ///< of the end's own thread
    std::thread thread_{};

  protected:
    net::jaus_node node_;
};

/// What comes large is for `large`.
inline jaus::message_outcome take_large(large_traffic& large, const jaus::header& head,
                                        std::span<const std::byte> body) {
    if (head.command_code != image_code) return jaus::message_outcome::unhandled;
    large.received(body);
    return jaus::message_outcome::handled;
}

} // namespace soak
