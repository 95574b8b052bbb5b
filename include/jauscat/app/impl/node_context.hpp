// The io_context of a node, and what the application has begun on other threads.
#pragma once
#include <jauscat/app/detail/operation.hpp>

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/io_context.hpp>

#include <deque>
#include <functional>
#include <memory>
#include <mutex>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// Shared by a node, its components and their handles, which may outlive it. Handles do not keep a context of the node:
/// the coroutines in it have handles.
class node_context : public std::enable_shared_from_this<node_context> {
  public:
    explicit node_context(boost::asio::io_context& of_program) : context_{of_program}, is_of_program_{true} {}
    explicit node_context(const std::shared_ptr<boost::asio::io_context>& own) : context_{*own}, own_{own} {}

    /// While it exists.
    [[nodiscard]] boost::asio::io_context& get() const noexcept { return context_; }
    /// Calls the handlers that have no executor of their own.
    [[nodiscard]] boost::asio::any_io_executor executor() const noexcept;
    /// Has `work(false)` called by the io_context. Once the node is stopped, it is `work(true)`, at once or by `close`:
    /// the state of the node is not touched then. From any thread.
    void post(std::function<void(bool is_over)> work);
    void open() noexcept;
    void close();

  private:
    void call_next();

    boost::asio::io_context& context_;
    std::weak_ptr<boost::asio::io_context> own_{};
    bool is_of_program_{};
    std::mutex mutex_{};
    std::deque<std::function<void(bool is_over)>> waiting_{};
    bool is_over_{};
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
