// Asynchronous operations in Asio's way: the handler behind a virtual function, so that what starts them is no
// template.
#pragma once
#include <jauscat/base/compilation.hpp>

// clang-format off
#include <utility> // first: asio/awaitable.hpp of Boost 1.74 uses it
// clang-format on
#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/associated_executor.hpp>
#include <boost/asio/async_result.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/version.hpp>
#if BOOST_VERSION >= 107700
#    include <boost/asio/associated_cancellation_slot.hpp>
#endif

#include <atomic>
#include <functional>
#include <memory>
#include <tuple>

namespace jauscat {
inline namespace JAUSCAT_WAY {

#ifdef BOOST_ASIO_HAS_CO_AWAIT
/// Of an operation without a completion token: its result is awaited by a coroutine.
using default_token = boost::asio::use_awaitable_t<>;
#else
struct default_token; // this compiler has no coroutines: a callback or use_future is needed
#endif

namespace app {

using boost::system::error_code;

/// An operation of the application's that waits for its outcome. Only the first outcome counts.
template <class... Results> class operation {
  public:
    operation() = default;
    virtual ~operation() = default;
    operation(const operation&) = delete;
    operation& operator=(const operation&) = delete;

    /// On any thread. The handler is called later.
    void complete(error_code error, Results... results) {
        if (!is_done_.exchange(true)) deliver(error, std::move(results)...);
    }
    [[nodiscard]] bool is_done() const noexcept { return is_done_; }
    /// Aborts it, on the thread of the io_context.
    void cancel() {
        if (is_done_) return;
        complete(boost::asio::error::operation_aborted, Results{}...);
        if (when_cancelled) when_cancelled();
    }

    std::function<void()> when_cancelled{}; ///< ends what it has begun

  private:
    virtual void deliver(error_code error, Results... results) = 0;
    std::atomic<bool> is_done_{};
};
template <class... Results> using operation_ptr = std::shared_ptr<operation<Results...>>;

/// `Convert` makes what the handler gets of the results: a tuple that begins with the error.
template <class Handler, class Convert, class... Results> class handler_operation final : public operation<Results...> {
    using executor_type = boost::asio::associated_executor_t<Handler, boost::asio::any_io_executor>;

  public:
    handler_operation(Handler handler, Convert convert, const boost::asio::any_io_executor& otherwise)
        : handler_{std::move(handler)},
          convert_{std::move(convert)},
          work_{boost::asio::get_associated_executor(handler_, otherwise)} {}

  private:
    void deliver(error_code error, Results... results) override {
        boost::asio::post(work_.get_executor(),
                          [handler = std::move(handler_), all = convert_(error, std::move(results)...)]() mutable {
                              std::apply([&](auto&... each) { std::move(handler)(std::move(each)...); }, all);
                          });
        work_.reset();
    }

    Handler handler_;
    Convert convert_;
    boost::asio::executor_work_guard<executor_type> work_;
};

/// Makes the operation of a handler. `executor`: of the node or bus; it calls a handler that has none of its own. Where
/// the handler has a cancellation slot, the operation is aborted through it.
template <class... Results, class Handler, class Convert>
operation_ptr<Results...> make_operation(Handler handler, Convert convert,
                                         const boost::asio::any_io_executor& executor) {
#if BOOST_VERSION >= 107700
    auto slot = boost::asio::get_associated_cancellation_slot(handler);
#endif
    operation_ptr<Results...> made =
        std::make_shared<handler_operation<Handler, Convert, Results...>>(std::move(handler), convert, executor);
#if BOOST_VERSION >= 107700
    if (slot.is_connected())
        slot.assign([weak = std::weak_ptr{made}, executor](boost::asio::cancellation_type) {
            if (weak.expired()) return; // and perhaps the context
            boost::asio::post(executor, [weak] {
                if (const auto still = weak.lock()) still->cancel();
            });
        });
#endif
    return made;
}

/// The result alone.
struct no_conversion {
    template <class... Results> std::tuple<error_code, Results...> operator()(error_code error, Results... results) {
        return {error, std::move(results)...};
    }
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
