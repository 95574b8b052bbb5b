// The functions of node_context.
#pragma once
#include <jauscat/app/impl/node_context.hpp>

#include <boost/asio/post.hpp>
#include <boost/asio/system_executor.hpp>

#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

JAUSCAT_DECL boost::asio::any_io_executor node_context::executor() const noexcept {
    if (is_of_program_ || !own_.expired()) return context_.get_executor();
    return boost::asio::system_executor{};
}

JAUSCAT_DECL void node_context::post(std::function<void(bool is_over)> work) {
    {
        const std::lock_guard lock{mutex_};
        if (!is_over_) {
            waiting_.push_back(std::move(work));
            // Nothing else: what waits may keep the context.
            boost::asio::post(context_, [weak = weak_from_this()] {
                if (const auto still = weak.lock()) still->call_next();
            });
            return;
        }
    }
    work(true);
}

JAUSCAT_DECL void node_context::call_next() {
    std::function<void(bool is_over)> work;
    {
        const std::lock_guard lock{mutex_};
        if (waiting_.empty()) return; // `close` has called it
        work = std::move(waiting_.front());
        waiting_.pop_front();
    }
    work(false);
}

JAUSCAT_DECL void node_context::open() noexcept {
    const std::lock_guard lock{mutex_};
    is_over_ = false;
}

JAUSCAT_DECL void node_context::close() {
    std::deque<std::function<void(bool is_over)>> all;
    {
        const std::lock_guard lock{mutex_};
        is_over_ = true;
        all.swap(waiting_);
    }
    for (const auto& work : all) work(true);
}

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
