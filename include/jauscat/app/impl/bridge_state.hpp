// A bridge behind its handle: components of a node in front of a slave of a bus.
#pragma once
#include <jauscat/app/bridge_options.hpp>
#include <jauscat/app/bus_options.hpp>
#include <jauscat/app/detail/unit.hpp>
#include <jauscat/app/impl/bus_state.hpp>
#include <jauscat/app/impl/node_part.hpp>
#include <jauscat/bridge/any_exchange.hpp>
#include <jauscat/bridge/component.hpp>
#include <jauscat/bridge/process_part.hpp>
#include <jauscat/net/limited_log.hpp>

#include <boost/asio/steady_timer.hpp>

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

class bridge_state;
class node_state;
class served_slave;
using exchange_maker = std::unique_ptr<bridging::any_exchange> (*)(const bridging::slave_identity& slave);

/// The messages of a component besides those of the core.
struct slave_messages {
    /// Nullptr: the slave has objects for them, and may have more than these.
    const bridging::process_part* part{};

    jaus::message_outcome operator()(const jaus::header&, bytes) const { return jaus::message_outcome::unhandled; }
    void list_messages(auto&& takes, auto&& sends) const;
};

/// A component for the node, which refers to it as long as it lives; the unit exists while the bridge works.
class bridged_component {
  public:
    /// Without process data `part` is empty; without one of the application's, `of_slaves` has none.
    bridged_component(const jaus::address& self, const served_component& options, const bus_state& bus,
                      std::span<served_slave* const> slaves, std::unique_ptr<bridging::process_part> part,
                      const slave_messages& of_slaves)
        : messages{of_slaves},
          self_{self},
          options_{options},
          bus_{bus},
          slaves_{slaves.begin(), slaves.end()},
          part_{std::move(part)} {}

    void start(bridge_state& of);

    [[nodiscard]] const jaus::address& self() const noexcept { return self_; }
    jaus::component_outcome on_message(const jaus::header& head, bytes body, time_point now, jaus::message_sink out,
                                       auto&& application) {
        const auto locked = bus_.lock();
        return unit ? unit->on_message(head, body, now, out, application) : jaus::component_outcome::unknown;
    }
    void on_time(time_point now, jaus::message_sink out) {
        const auto locked = bus_.lock();
        if (unit) unit->on_time(now, out);
    }
    [[nodiscard]] std::optional<time_point> next_event() const {
        const auto locked = bus_.lock();
        return unit ? unit->next_event() : std::optional<time_point>{};
    }
    void on_lost(const jaus::address& who) {
        const auto locked = bus_.lock();
        if (unit) unit->on_lost(who);
    }
    jaus::message_outcome answer_query(const jaus::header& query, bytes body, time_point now, jaus::message_sink out) {
        const auto locked = bus_.lock();
        return unit ? unit->answer_query(query, body, now, out) : jaus::message_outcome::unhandled;
    }
    [[nodiscard]] std::uint8_t authority() const noexcept { return options_.authority; }
    [[nodiscard]] std::span<served_slave* const> slaves() const noexcept { return slaves_; }

    std::optional<bridging::component> unit{};
    const slave_messages messages;

  private:
    jaus::address self_;
    served_component options_;
    const bus_state& bus_;
    std::vector<served_slave*> slaves_; ///< one or more
    std::unique_ptr<bridging::process_part> part_;
};

/// Exchanges packets with a slave whose station address is not the number of the node of its components.
class renumbered_exchange final : public bridging::any_exchange {
  public:
    renumbered_exchange(std::unique_ptr<bridging::any_exchange> under, std::uint8_t node, std::uint8_t station)
        : under_{std::move(under)}, node_{node}, station_{station} {}

    JAUSCAT_DECL bridging::exchange_step begin(bytes message, std::span<std::byte> buffer) override;
    JAUSCAT_DECL bridging::exchange_step on_confirmation(bytes confirmation, std::span<std::byte> buffer) override;
    [[nodiscard]] hilscher::packet_status status() const override { return under_->status(); }
    [[nodiscard]] translate::errc error() const override { return under_->error(); }

  private:
    std::unique_ptr<bridging::any_exchange> under_;
    std::uint8_t node_, station_;
    std::vector<std::byte> message_{};
};

/// Process data of a Primitive Driver without an image of its own.
[[nodiscard]] JAUSCAT_DECL std::unique_ptr<bridging::process_part> make_wrench_effort_part();

/// A slave of a bridge, with the components in front of it.
class served_slave final : public bus_user {
  public:
    served_slave(bridge_state& of, const slave_choice& which, std::unique_ptr<bridging::any_exchange> exchange,
                 std::uint16_t station)
        : bridge_{of}, which_{which}, station_{station}, exchange_{std::move(exchange)} {}

    /// Throws `std::invalid_argument` if it has the most components already.
    void check_place() const;
    void add(bridged_component& component) { components_.push_back(&component); }
    /// Its front exists from here until `stop`.
    void start();
    /// Has the ring serve the slave once its position is known; until then it is looked for.
    void find();
    /// The bus leaves the slave as it is.
    void leave() noexcept;
    void stop() noexcept { front_.reset(); }
    /// It answers, or has been lost and was not seen at rest since.
    [[nodiscard]] bool may_move() const noexcept { return is_up() || (has_been_up_ && !at_rest()); }
    /// It may have moved and should have been brought to rest: if it was not, that is logged.
    [[nodiscard]] bool check_rest();
    [[nodiscard]] const slave_choice& choice() const noexcept { return which_; }
    [[nodiscard]] std::uint16_t station() const noexcept { return station_; }
    [[nodiscard]] bool is_served() const noexcept { return is_served_; }
    [[nodiscard]] bool at_rest() const noexcept;
    [[nodiscard]] bool is_up() const noexcept { return front_ && front_->up(); }

    JAUSCAT_DECL void send(bytes message) override;
    JAUSCAT_DECL void bus_ends() noexcept override;
    JAUSCAT_DECL void slave_ready() override;
    [[nodiscard]] bridging::slave_front& front() noexcept override { return *front_; }
    [[nodiscard]] const bridging::slave_front& front() const noexcept override { return *front_; }
    [[nodiscard]] JAUSCAT_DECL std::uint8_t node() const noexcept override;

  private:
    struct search;

    // The bridge's observer.
    void slave_up(const bridging::slave_front&, const ethercat::slave_record& record, bool ready);
    void bring_up_failed(const bridging::slave_front&, const ethercat::master_error& why);
    void slave_lost(const bridging::slave_front&, bridging::loss what, const ethercat::master_error& why);
    void slave_emergency(const bridging::slave_front&, const ethercat::coe_emergency& emergency);
    void clocks_agree(const bridging::slave_front&, ethercat::clock_agreement how, std::uint32_t difference);
    void no_keep_alive(const bridging::slave_front&, const bridging::refusal_reason& why);
    void changed_state(const bridging::component& unit, jaus::primary_status_code from, jaus::primary_status_code to);
    void stop_refused(const bridging::component& unit, bridging::stop_order what, const bridging::refusal_reason& why,
                      unsigned attempts);
    void settled(const bridging::component& unit);
    void faulted(const bridging::component& unit, const bridging::drive_fault& what);
    void fault_ended(const bridging::component& unit);
    void refused(const bridging::component& unit, const jaus::header& message, const bridging::refusal_reason& why);
    [[nodiscard]] bridging::observer observer() noexcept;

    void found(std::uint16_t position, const ethercat::identity_check& expected);
    void retry();
    /// Waits for a slave of the bus's options.
    void await(named_slave& which);
    /// Later, not within the ring's turn, and only while the bridge works.
    template <class F> void post(F what);
    void log(std::string_view line);
    /// Logs what an observer of the application is told otherwise.
    void log_event(std::string_view line);
    [[nodiscard]] const bridging::observer& watcher() const noexcept;
    [[nodiscard]] std::string name() const;
    /// A slave of the component, by its index in the group.
    [[nodiscard]] std::string name_of_drive(const bridging::component& unit, std::size_t slave) const;

    bridge_state& bridge_;
    slave_choice which_;
    std::uint16_t station_;
    std::unique_ptr<bridging::any_exchange> exchange_;
    std::vector<bridged_component*> components_{};
    bridging::order_memory<> memory_{};
    std::optional<bridging::slave_front> front_{};
    std::optional<boost::asio::steady_timer> timer_{};
    net::limited_log limited_{[this](std::string_view line) { log_event(line); }};
    std::string last_problem_{};
    bool works_{};       ///< between start and stop
    bool is_served_{};   ///< the ring has the front
    bool has_been_up_{}; ///< since the start, until the bus ends
};

/// Keeps the bus in memory; the node keeps it.
class bridge_state final : public std::enable_shared_from_this<bridge_state> {
  public:
    bridge_state(node_state& of, std::shared_ptr<bus_state> on, exchange_maker make, const bridge_options& options);

    void serve(const served_component& component, std::span<const slave_choice> by,
               std::unique_ptr<bridging::process_part> part);
    [[nodiscard]] bool at_rest() const noexcept;
    /// All slaves are.
    [[nodiscard]] bool is_up() const noexcept;
    /// The handle has gone.
    void close() noexcept;

    [[nodiscard]] node_part as_part();

    // For its slaves.
    [[nodiscard]] const std::shared_ptr<bus_state>& bus() const noexcept { return bus_; }
    [[nodiscard]] node_state& node() noexcept { return node_; }
    [[nodiscard]] const bridge_options& options() const noexcept { return options_; }
    [[nodiscard]] const bridging::bridge_options& timing() const noexcept { return timing_; }
    /// Whether a slave has confirmed at the end.
    void note_rest(bool is_confirmed) noexcept { ended_at_rest_ = ended_at_rest_.value_or(true) && is_confirmed; }
    /// Sends the message later: not within the ring's turn, because a receiver in this program may end the bridge.
    void send(bytes message);
    /// Calls a function of the application from the io_context, unless the bridge has ended by then.
    template <class F, class... Arguments> void call_later(F bridge_state::* function, Arguments... arguments);

    std::function<void(const slave_choice&)> on_up{};
    std::function<void(const slave_choice&, error_code)> on_lost{};
    std::function<void(const jaus::address&, jaus::primary_status_code)> on_changed{};
    std::function<void(const jaus::address&)> on_at_rest{};
    std::function<void(const slave_choice&, const ethercat::coe_emergency&)> on_emergency{};
    std::function<void(const jaus::address&, const bridging::drive_fault&)> on_faulted{};
    std::function<void(const jaus::address&)> on_fault_ended{};
    std::optional<bridging::observer> watcher{}; ///< of the application

  private:
    void start();
    void stop() noexcept;
    [[nodiscard]] bool has(const jaus::address& component) const;
    void list(std::vector<component_status>& all) const;
    [[nodiscard]] served_slave& slave_of(const slave_choice& which);
    void flush();

    node_state& node_;
    std::shared_ptr<bus_state> bus_;
    exchange_maker make_;
    bridge_options options_;
    bridging::bridge_options timing_;
    std::deque<served_slave> slaves_{};
    std::deque<bridged_component> components_{};
    std::vector<std::vector<std::byte>> outbox_{};
    std::optional<bool> ended_at_rest_{};
    bool is_closed_{};
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
