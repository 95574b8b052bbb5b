// A node behind its handle.
#pragma once
#include <jauscat/app/impl/component_state.hpp>
#include <jauscat/app/impl/node_context.hpp>
#include <jauscat/app/impl/node_part.hpp>
#include <jauscat/app/node_options.hpp>
#include <jauscat/net/node/jaus_node.hpp>

#include <boost/asio/signal_set.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// The node of net/ with the components of the application. Its io_context is its own, or the application's.
class node_state {
  public:
    node_state(boost::asio::io_context* context, node_options options);

    int run();
    void start();
    void stop();
    void add(const std::shared_ptr<component_state>& component);
    void add(node_part part) { parts_.push_back(std::move(part)); }
    /// A component has this ID.
    [[nodiscard]] bool has(const jaus::address& self) const;
    [[nodiscard]] std::vector<component_status> statuses() const;
    void log(std::string_view line) const;
    /// Of the component's state machines: its next event may be earlier.
    void wake() { net_.wake(); }

    [[nodiscard]] boost::asio::io_context& context() noexcept { return context_->get(); }
    [[nodiscard]] const std::shared_ptr<node_context>& shared_context() const noexcept { return context_; }
    /// Where it is not the application's: components keep it.
    [[nodiscard]] const std::shared_ptr<boost::asio::io_context>& own_context() const noexcept { return own_context_; }
    /// The node ends: what outlives it does not refer to it any more.
    void release() noexcept;
    [[nodiscard]] bool is_open() const noexcept { return options_.open; }
    [[nodiscard]] net::jaus_node& net() noexcept { return net_; }
    [[nodiscard]] const net::jaus_node& net() const noexcept { return net_; }

    std::function<void(const jaus::address& who)> on_appeared{}, on_disappeared{};

  private:
    net::jaus_node_options net_options();
    void await_signals();
    /// In a context of its own: calls the handlers of what `stop` has aborted.
    void finish();
    /// Throws `std::logic_error` where the node runs, or may be in a call of one of its functions.
    void require_stopped() const;
    /// Of the components, for the log.
    [[nodiscard]] std::string names() const;

    node_options options_;
    std::shared_ptr<boost::asio::io_context> own_context_{};
    std::shared_ptr<node_context> context_;
    std::optional<boost::asio::signal_set> signals_{}; ///< while `run` works
    bool is_stopping_{};
    bool is_stopped_{};
    std::shared_ptr<char> alive_{std::make_shared<char>()}; ///< a handler may be queued at the end
    std::vector<std::shared_ptr<component_state>> components_{};
    std::vector<node_part> parts_{};
    net::jaus_node net_;
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
