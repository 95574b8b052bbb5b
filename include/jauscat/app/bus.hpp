// An EtherCAT bus: finds its slaves, and what all operations on them share.
#pragma once
#include <jauscat/app/bus_error.hpp>
#include <jauscat/app/bus_options.hpp>
#include <jauscat/app/detail/operation.hpp>
#include <jauscat/app/slave.hpp>

#include <boost/asio/io_context.hpp>

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {

/// The master of an EtherCAT bus of up to 256 slaves, with up to 32 KiB of process data.
///
///     jauscat::bus bus{node.context(), "eth0"};
///     co_await bus.async_start();
///     auto drive = bus.slave({.position = 2});
///     co_await drive.async_write(0x6060, 0, std::int8_t{9});
///
/// Operations are executed one after the other, in the order of their start; none blocks. Each takes a completion token
/// of Boost.Asio (by default the result is awaited by a coroutine) and may end with
/// - `not_started`, `no_such_slave`, `ambiguous`: there is no such slave;
/// - `no_reply`, `not_sent`: the link is out;
/// - `timed_out`: the options' `timeout` has passed;
/// - `stopped`: a bridge on this bus had to stop an actuator first;
/// - boost::asio::error::operation_aborted: by the handler's cancellation slot, by `cancel`, `stop` or the end of the
///   bus.
///
/// Between operations the states of all slaves are watched. A slave that does not answer is lost: this is logged, the
/// callback is called, operations go on to try it. When it answers again, it is used again; if it was reset, it is
/// brought to PRE-OP first, provided that it is the same slave.
///
/// With the option `thread` the bus has a thread of its own, with a real-time priority if wanted; all that the
/// application gets is still called by the io_context, or by the executor of a handler.
///
/// Use it, its slaves and its bridges on the thread that runs the io_context. While it works, run() of the io_context
/// does not return.
class bus {
  public:
    /// Opens the link: raw Ethernet on the network interface `where` ("eth0"; needs CAP_NET_RAW), or EtherCAT in UDP
    /// with slaves at "udp:HOST" or "udp:HOST:PORT". Throws `net::open_error`. The io_context must outlive the bus.
    JAUSCAT_DECL bus(boost::asio::io_context& context, std::string_view where, const bus_options& options = {});
    /// Brings what bridges move to rest, for at most 0.7 s, and aborts all operations.
    JAUSCAT_DECL ~bus();
    bus(const bus&) = delete;
    bus& operator=(const bus&) = delete;

    /// Finds all slaves, clears them of what an earlier master has left, brings each to PRE-OP and reads its identity,
    /// alias and name. Slaves of a bridge that works already are left as they are. At a second time all is found again.
    /// If some slaves cannot be brought up, the first one's error is the operation's, each is logged, and the others
    /// can be used. While a slave is in OP that is none of this bus, nothing is changed, unless the options say
    /// `takes_over`. Errors: in_use, no_reply, not_sent, no_slaves, too_many_slaves, not_configurable,
    /// state_not_reached, slave_lost, AL status codes. `void(error_code)`.
    template <class Token = default_token> auto async_start(Token&& token = Token{}) {
        return boost::asio::async_initiate<Token, void(app::error_code)>(
            [](auto handler, bus* self) {
                self->start(app::make_operation<>(std::move(handler), app::no_conversion{}, self->executor()));
            },
            token, this);
    }

    /// A handle of the slave that is as `which` requires. Throws `std::invalid_argument` if that requires nothing.
    [[nodiscard]] JAUSCAT_DECL jauscat::slave slave(const slave_choice& which) const;
    /// The slaves, in the order of their positions; empty until `async_start`.
    [[nodiscard]] JAUSCAT_DECL std::vector<slave_info> slaves() const;

    /// The state of each slave that was found or is served, in the order of their positions.
    [[nodiscard]] JAUSCAT_DECL std::vector<slave_status> statuses() const;

    /// Of the process data.
    [[nodiscard]] JAUSCAT_DECL bus_statistics statistics() const;

    /// Aborts all operations that are not done.
    JAUSCAT_DECL void cancel();
    /// As at its end: nothing is sent until an operation is started.
    JAUSCAT_DECL void stop();

    /// Called in each cycle, when the process data of slaves in operation have returned or are lost: reads inputs and
    /// writes outputs (`slave::inputs`, `slave::outputs`). From the first `async_operate` on it is called with its
    /// period until the bus stops, also while no slave is in operation. In the thread of the bus if it has one, which
    /// it must not delay; else by the io_context. It must not end the bus, and is not called any more once the bus
    /// stops or ends: what it refers to must live until then. If it throws, all slaves in operation are brought to
    /// rest, and it is not called until the next `async_operate`.
    JAUSCAT_DECL void every_cycle(std::function<void()> f);
    /// Called when a slave is lost: it does not answer, or has ended its operation.
    JAUSCAT_DECL void when_lost(std::function<void(const slave_info& slave, boost::system::error_code why)> f);
    /// Called when a lost slave answers again.
    JAUSCAT_DECL void when_found(std::function<void(const slave_info& slave)> f);
    /// Called when a slave is in another state than before, or has an error.
    JAUSCAT_DECL void when_changed(std::function<void(const slave_info& slave, const ethercat::al_status& now)> f);
    /// Called for each emergency that a slave has sent.
    JAUSCAT_DECL void
    when_emergency(std::function<void(const slave_info& slave, const ethercat::coe_emergency& emergency)> f);

    [[nodiscard]] JAUSCAT_DECL boost::asio::io_context& context() const noexcept;
    /// For the classes of this folder.
    [[nodiscard]] const std::shared_ptr<app::bus_state>& state() const noexcept { return state_; }

  private:
    JAUSCAT_DECL void start(app::operation_ptr<> done);
    [[nodiscard]] boost::asio::any_io_executor executor() const noexcept { return context().get_executor(); }

    std::shared_ptr<app::bus_state> state_;
};

} // namespace JAUSCAT_WAY
} // namespace jauscat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/app/impl/bus.ipp>
#    include <jauscat/app/impl/bus_jobs.ipp>
#    include <jauscat/app/impl/bus_state.ipp>
#    include <jauscat/app/impl/bus_users.ipp>
#endif
