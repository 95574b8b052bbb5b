// Runs a bridge's ring over a link in an io_context, on the node's thread.
#pragma once

#include <jauscat/bridge/ring.hpp>
#include <jauscat/ethercat/link.hpp>
#include <jauscat/net/detail/wake_timer.hpp>
#include <jauscat/net/now.hpp>

#include <boost/asio/posix/stream_descriptor.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <unistd.h>

namespace jauscat::net {

/// A link with a file descriptor that is readable when a frame has come. Needed besides those of ethercat::link:
/// `native_handle()` returns it as an int.
template <class L>
concept descriptor_link = ethercat::link<L> && requires(L& medium) {
    { medium.native_handle() } -> std::same_as<int>;
};

/// Waits for frames and for the ring's next event; nothing blocks. The io_context, the link and the ring must outlive
/// it. `Link` models descriptor_link.
///
///     net::ring_runner runner{context, link, ring, node.out()};
///     front.on_work(runner.wake()); // for each slave
///     runner.start();
template <class Link> class ring_runner {
  public:
    /// `out`: sink for the JAUS messages of the ring.
    ring_runner(boost::asio::io_context& context, Link& link, bridging::ring& ring, jaus::message_sink out)
        : link_{link}, ring_{ring}, out_{out}, frames_{context, handle_of(link)}, timer_{context, [this] {
                                                                                             on_time();
                                                                                         }} {}
    ring_runner(const ring_runner&) = delete;
    ring_runner& operator=(const ring_runner&) = delete;

    /// For `on_work` of each slave_front of the ring.
    [[nodiscard]] const jaus::hook<void()>& wake() const noexcept { return wake_; }
    /// Called after each turn, for checks after frames and messages, such as the link's problem.
    std::function<void()> after_turn{};

    void start() {
        runs_ = true;
        wait_for_frames();
        timer_.arm(now());
    }
    void stop() {
        runs_ = false;
        timer_.cancel();
        boost::system::error_code ignored;
        frames_.cancel(ignored);
    }
    [[nodiscard]] static time_point now() noexcept { return net::now(); }

  private:
    static int handle_of(Link& link) {
        ethercat::require_link<Link>();
        static_assert(!ethercat::link<Link> || descriptor_link<Link>,
                      "ring_runner: the link has no native_handle() that returns an int");
        return ::dup(link.native_handle());
    }
    void wait_for_frames() {
        frames_.async_wait(boost::asio::posix::stream_descriptor::wait_read,
                           [this, alive = std::weak_ptr<char>{alive_}](const boost::system::error_code& error) {
                               if (error || alive.expired() || !runs_) return;
                               receive();
                               wait_for_frames();
                           });
    }
    // Bounded, so that a flood of frames leaves time for messages.
    void take_frames() {
        for (unsigned i = 0; i != max_frames && runs_; ++i) {
            const auto size = link_.receive(frame_, duration{});
            if (size == 0) break;
            heard_ = now();
            ring_.on_frame(std::span{frame_}.first(size), heard_, out_);
        }
    }
    void receive() {
        take_frames();
        ring_.on_time(now(), out_);
        end_turn();
    }
    void on_time() {
        take_frames(); // a cycle that is due has none of them yet
        // A link reports a problem of its interface only to a caller that waits.
        if (now() - heard_ > silence) {
            heard_ = now();
            if (const auto size = link_.receive(frame_, std::chrono::microseconds{1}); size != 0)
                ring_.on_frame(std::span{frame_}.first(size), heard_, out_);
        }
        ring_.on_time(now(), out_);
        end_turn();
    }
    void end_turn() {
        while (const auto size = ring_.next_frame(frame_, now())) {
            if (link_.send(std::span{frame_}.first(size))) continue;
            ring_.not_sent();
            ring_.on_time(now(), out_);
        }
        if (after_turn) after_turn();
        if (!runs_) return;
        if (const auto next = ring_.next_event()) timer_.arm(std::max(*next, now()));
    }

    static constexpr unsigned max_frames = 64;
    static constexpr duration silence = std::chrono::milliseconds{50};

    Link& link_;
    bridging::ring& ring_;
    jaus::message_sink out_;
    boost::asio::posix::stream_descriptor frames_;
    detail::wake_timer timer_;
    bool runs_{};
    std::shared_ptr<char> alive_{std::make_shared<char>()}; ///< a handler may be queued at destruction
    time_point heard_{};
    std::array<std::byte, ethercat::max_frame_size> frame_{};
    struct waker {
        ring_runner& mine;
        void operator()() const {
            if (mine.runs_) mine.timer_.arm(now());
        }
    } waker_{*this};
    jaus::hook<void()> wake_{waker_};
};

} // namespace jauscat::net
