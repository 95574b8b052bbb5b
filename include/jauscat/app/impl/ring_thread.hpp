// Runs a bridge's ring over a link in a thread of its own, real-time if wanted.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/bridge/ring.hpp>
#include <jauscat/net/link/any_link.hpp>
#include <jauscat/net/now.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <functional>
#include <mutex>
#include <poll.h>
#include <pthread.h>
#include <string>
#include <sys/eventfd.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// A recursive mutex. A thread that holds it has the priority of the most urgent one that waits for it.
class inheriting_mutex {
  public:
    inheriting_mutex() {
        pthread_mutexattr_t attributes;
        pthread_mutexattr_init(&attributes);
        pthread_mutexattr_settype(&attributes, PTHREAD_MUTEX_RECURSIVE);
        pthread_mutexattr_setprotocol(&attributes, PTHREAD_PRIO_INHERIT);
        pthread_mutex_init(&mutex_, &attributes);
        pthread_mutexattr_destroy(&attributes);
    }
    ~inheriting_mutex() { pthread_mutex_destroy(&mutex_); }
    inheriting_mutex(const inheriting_mutex&) = delete;
    inheriting_mutex& operator=(const inheriting_mutex&) = delete;

    void lock() noexcept { pthread_mutex_lock(&mutex_); }
    void unlock() noexcept { pthread_mutex_unlock(&mutex_); }

  private:
    pthread_mutex_t mutex_{};
};

/// As net::ring_runner, in a thread. It holds the mutex except while it waits. `after_turn()` returns when it wants to
/// be called at the latest.
class ring_thread {
  public:
    ring_thread(net::any_link& link, bridging::ring& ring, jaus::message_sink out, inheriting_mutex& mutex,
                std::function<time_point()> after_turn)
        : link_{link},
          ring_{ring},
          out_{out},
          mutex_{mutex},
          after_turn_{std::move(after_turn)},
          waker_{::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)} {
        if (waker_.file < 0) throw std::system_error{errno, std::generic_category(), "no eventfd for the bus"};
        thread_ = std::thread{[this] { run(); }};
    }
    /// The mutex is not held.
    ~ring_thread() {
        stop();
        ::close(waker_.file);
    }
    ring_thread(const ring_thread&) = delete;
    ring_thread& operator=(const ring_thread&) = delete;

    /// The mutex is not held.
    void stop() {
        if (!thread_.joinable()) return;
        stops_ = true;
        wake_();
        thread_.join();
    }
    /// SCHED_FIFO; empty, or why not.
    [[nodiscard]] std::string set_priority(int priority) {
        sched_param wanted{};
        wanted.sched_priority = priority;
        const int error = pthread_setschedparam(thread_.native_handle(), SCHED_FIFO, &wanted);
        return error == 0 ? std::string{} : std::generic_category().message(error);
    }
    [[nodiscard]] const jaus::hook<void()>& wake() const noexcept { return wake_; }
    [[nodiscard]] bool is_this() const noexcept { return std::this_thread::get_id() == thread_.get_id(); }

  private:
    void run() {
        for (;;) {
            time_point wake{};
            {
                const std::lock_guard lock{mutex_};
                if (stops_) return;
                wake = turn();
            }
            wait(wake);
        }
    }
    time_point turn() {
        // A link reports a problem of its interface only to a caller that waits.
        const bool is_quiet = net::now() - heard_ > silence;
        if (is_quiet) heard_ = net::now();
        for (unsigned i = 0; i != max_frames; ++i) { // bounded, so that a flood leaves time
            const auto size = link_.receive(frame_, is_quiet && i == 0 ? duration{1000} : duration{});
            if (size == 0) break;
            heard_ = net::now();
            ring_.on_frame(std::span{frame_}.first(size), heard_, out_);
        }
        ring_.on_time(net::now(), out_);
        while (const auto size = ring_.next_frame(frame_, net::now())) {
            if (link_.send(std::span{frame_}.first(size))) continue;
            ring_.not_sent();
            ring_.on_time(net::now(), out_);
        }
        const auto next = after_turn_();
        return std::min(ring_.next_event().value_or(next), next);
    }
    void wait(time_point until) {
        const auto now = net::now();
        const auto left = until <= now ? duration{} : std::min<duration>(until - now, std::chrono::seconds{1});
        const timespec time{.tv_sec = static_cast<std::time_t>(left / std::chrono::seconds{1}),
                            .tv_nsec = static_cast<long>((left % std::chrono::seconds{1}).count())};
        std::array<pollfd, 2> files{pollfd{link_.native_handle(), POLLIN, 0}, pollfd{waker_.file, POLLIN, 0}};
        static_cast<void>(::ppoll(files.data(), files.size(), &time, nullptr));
        std::uint64_t count{};
        static_cast<void>(!::read(waker_.file, &count, sizeof count));
    }

    static constexpr unsigned max_frames = 64;
    static constexpr duration silence = std::chrono::milliseconds{50};

    struct waker {
        int file;
        void operator()() const {
            const std::uint64_t one = 1;
            static_cast<void>(!::write(file, &one, sizeof one));
        }
    };

    net::any_link& link_;
    bridging::ring& ring_;
    jaus::message_sink out_;
    inheriting_mutex& mutex_;
    std::function<time_point()> after_turn_;
    waker waker_;
    jaus::hook<void()> wake_{waker_};
    std::atomic<bool> stops_{};
    time_point heard_{};
    std::array<std::byte, ethercat::max_frame_size> frame_{};
    std::thread thread_{};
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
