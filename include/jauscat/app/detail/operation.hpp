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
#include <optional>
#include <tuple>
#include <type_traits>

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

/// Any executor that a handler may have; not boost::asio::any_io_executor, because that of use_future has no context.
using handler_executor = boost::asio::execution::any_executor<
    boost::asio::execution::blocking_t::never_t,
    boost::asio::execution::prefer_only<boost::asio::execution::outstanding_work_t::tracked_t>,
    boost::asio::execution::prefer_only<boost::asio::execution::outstanding_work_t::untracked_t>>;

/// A call of a handler, later and on its executor. Not a template, so that a program does not compile it for each
/// handler: it was half of what Asio takes for one.
class handler_call {
  public:
    handler_call(const handler_call&) = delete;
    handler_call& operator=(const handler_call&) = delete;

  protected:
    JAUSCAT_DECL explicit handler_call(const handler_executor& executor);
    ~handler_call() = default;
    /// `self` owns this object.
    JAUSCAT_DECL void call_later(std::shared_ptr<handler_call> self);

  private:
    virtual void call() = 0;

    boost::asio::executor_work_guard<handler_executor> work_;
};

/// An operation of the application's that waits for its outcome. Only the first outcome counts.
template <class... Results> class operation : public std::enable_shared_from_this<operation<Results...>> {
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
template <class Handler, class Convert, class... Results>
class handler_operation final : public operation<Results...>, handler_call {
  public:
    handler_operation(Handler handler, Convert convert, const boost::asio::any_io_executor& otherwise)
        : handler_call{handler_executor{boost::asio::get_associated_executor(handler, otherwise)}},
          handler_{std::move(handler)},
          convert_{std::move(convert)} {}

  private:
    using converted = std::invoke_result_t<Convert&, error_code, Results...>;

    void deliver(error_code error, Results... results) override {
        results_.emplace(convert_(error, std::move(results)...));
        call_later({this->shared_from_this(), static_cast<handler_call*>(this)});
    }
    void call() override { call_with(std::make_index_sequence<std::tuple_size_v<converted>>{}); }
    template <std::size_t... I> void call_with(std::index_sequence<I...>) {
        auto handler = std::move(handler_);
        auto results = std::move(*results_);
        std::move(handler)(std::move(std::get<I>(results))...);
    }

    Handler handler_;
    Convert convert_;
    std::optional<converted> results_{};
};

/// Makes the operation of a handler. `executor`: of the node or bus; it calls a handler that has none of its own. Where
/// the handler has a cancellation slot, the operation is aborted through it.
template <class... Results, class Handler, class Convert>
operation_ptr<Results...> make_operation(Handler handler, Convert convert,
                                         const boost::asio::any_io_executor& executor) {
#if BOOST_VERSION >= 107700
    auto slot = boost::asio::get_associated_cancellation_slot(handler);
#endif
    // Not make_shared: that is thirty functions more for each handler.
    using made_type = handler_operation<Handler, Convert, Results...>;
    operation_ptr<Results...> made{
        static_cast<operation<Results...>*>(new made_type(std::move(handler), convert, executor))};
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

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/app/impl/operation.ipp>
#endif
