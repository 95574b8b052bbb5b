// The JAUS node of a program.
#pragma once
#include <jauscat/app/component_status.hpp>
#include <jauscat/app/detail/unit.hpp>
#include <jauscat/app/node_options.hpp>
#include <jauscat/net/link/udp_counters.hpp>

#include <boost/asio/io_context.hpp>

#include <memory>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {

/// The JAUS node of a program: sockets, routing, heartbeats and node manager, as the configuration says. It serves the
/// components that are made of it.
///
///     int main(int argc, char** argv) {
///         jauscat::node node{argc, argv};
///         jauscat::component driver{node, {.id = 33}};
///         ...
///         return node.run();
///     }
///
/// Node, components and all handlers run on the thread that calls `run`.
class node {
  public:
    /// Takes `--config FILE` and `--this SYSTEM` from the command line. For `--help` it prints a help text and ends the
    /// program with exit code 0; for a wrong command line with 2, for an unusable configuration with 1, with a line on
    /// standard error.
    JAUSCAT_DECL node(int argc, const char* const* argv, node_options options = {});
    /// Throws `net::config_error` for an unusable configuration.
    JAUSCAT_DECL explicit node(const node_options& options = {});
    /// The same in an io_context of the program, which must outlive the node, its components and their handles.
    JAUSCAT_DECL explicit node(boost::asio::io_context& context, const node_options& options = {});
    JAUSCAT_DECL ~node();
    node(const node&) = delete;
    node& operator=(const node&) = delete;

    /// Starts the node and works until SIGINT (Ctrl-C), SIGTERM or `stop`; then the components are stopped, see
    /// component::when_stopped, and the handlers of their operations are called. Returns the exit code: 0, or 1 after
    /// an error, which is logged, as that the node runs already.
    JAUSCAT_DECL int run();
    /// Opens the sockets. For programs that run the io_context themselves. Throws `net::open_error` for an address or a
    /// port that cannot be used, `net::config_error`, and `std::logic_error`, with everything as before, if the node
    /// runs or calls this by one of its functions.
    JAUSCAT_DECL void start();
    /// Stops the components and closes the sockets. May be called by a handler.
    JAUSCAT_DECL void stop();

    [[nodiscard]] JAUSCAT_DECL boost::asio::io_context& context() noexcept;
    /// JAUS ID of the node manager, also where that is another program.
    [[nodiscard]] JAUSCAT_DECL const jaus::address& manager() const noexcept;
    /// Datagrams since the last start.
    [[nodiscard]] JAUSCAT_DECL net::udp_counters counts() const noexcept;
    /// The node's own components, its node manager included, and those that the node manager hears.
    [[nodiscard]] JAUSCAT_DECL std::vector<component_status> components() const;
    /// Called for each component whose heartbeats begin, and for each one that is lost.
    JAUSCAT_DECL void when_appeared(std::function<void(const jaus::address& who)> f);
    JAUSCAT_DECL void when_disappeared(std::function<void(const jaus::address& who)> f);
    /// A component has disappeared from another node's node manager. For a node that has none of its own; others ignore
    /// it.
    JAUSCAT_DECL void lose(const jaus::address& who);

    /// For the classes of this folder.
    [[nodiscard]] app::node_state& state() noexcept { return *state_; }

  private:
    std::unique_ptr<app::node_state, app::end_node> state_;
};

} // namespace JAUSCAT_WAY
} // namespace jauscat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/app/impl/node_context.ipp>
#    include <jauscat/app/impl/node_state.ipp>
#endif
