// A bridge behind its handle: components of a node in front of a slave of a bus.
#pragma once
#include <jauscat/app/bridge_options.hpp>
#include <jauscat/app/bus_options.hpp>
#include <jauscat/app/impl/bus_state.hpp>
#include <jauscat/app/impl/node_part.hpp>
#include <jauscat/bridge/component.hpp>
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

class node_state;

/// A component for the node, which refers to it as long as it lives; the unit exists while the bridge works.
class bridged_component {
  public:
    bridged_component(const jaus::address& self, std::uint8_t authority) : self_{self}, authority_{authority} {}

    [[nodiscard]] const jaus::address& self() const noexcept { return self_; }
    jaus::component_outcome on_message(const jaus::header& head, bytes body, time_point now, jaus::message_sink out,
                                       auto&& application) {
        return unit ? unit->on_message(head, body, now, out, application) : jaus::component_outcome::unknown;
    }
    void on_time(time_point now, jaus::message_sink out) {
        if (unit) unit->on_time(now, out);
    }
    [[nodiscard]] std::optional<time_point> next_event() const {
        return unit ? unit->next_event() : std::optional<time_point>{};
    }
    void on_lost(const jaus::address& who) {
        if (unit) unit->on_lost(who);
    }
    [[nodiscard]] std::uint8_t authority() const noexcept { return authority_; }

    std::optional<bridging::component> unit{};

  private:
    jaus::address self_;
    std::uint8_t authority_;
};

/// Refers to the bus, which it keeps in memory, and to the node, which keeps it.
class bridge_state final : public node_part, public bus_user, public std::enable_shared_from_this<bridge_state> {
  public:
    bridge_state(node_state& of, std::shared_ptr<bus_state> on, std::unique_ptr<bridging::any_exchange> exchange,
                 const bridge_options& options);

    void serve(const served_component& component, const slave_choice& by);
    [[nodiscard]] const std::shared_ptr<bus_state>& bus() const noexcept { return bus_; }
    [[nodiscard]] bool at_rest() const noexcept;
    [[nodiscard]] bool is_up() const noexcept { return front_ && front_->up(); }
    /// The handle has gone.
    void close() noexcept;

    void start() override;
    void stop() noexcept override;
    [[nodiscard]] bool has(const jaus::address& component) const override;

    void send(bytes message) override;
    void bus_ends() noexcept override;
    [[nodiscard]] bridging::slave_front& front() noexcept override { return *front_; }

    std::function<void(const slave_choice&)> on_up{};
    std::function<void(const slave_choice&, error_code)> on_lost{};
    std::function<void(const jaus::address&, jaus::primary_status_code)> on_changed{};
    std::function<void(const jaus::address&)> on_at_rest{};
    std::function<void(const slave_choice&, const ethercat::coe_emergency&)> on_emergency{};

  private:
    struct nothing_more {
        jaus::message_outcome operator()(const jaus::header&, bytes) const { return jaus::message_outcome::unhandled; }
        /// The slave has objects for these, and may have more.
        static void list_messages(auto&& takes, auto&& sends);
    };
    struct search;

    // The bridge's observer.
    void slave_up(const bridging::slave_front&, const ethercat::slave_record& record, bool ready);
    void bring_up_failed(const bridging::slave_front&, const ethercat::master_error& why);
    void slave_lost(const bridging::slave_front&, bridging::loss what, const ethercat::master_error& why);
    void slave_emergency(const bridging::slave_front&, const ethercat::coe_emergency& emergency);
    void no_keep_alive(const bridging::slave_front&, const bridging::refusal_reason& why);
    void changed_state(const bridging::component& unit, jaus::primary_status_code from, jaus::primary_status_code to);
    void stop_refused(const bridging::component& unit, bridging::stop_order what, const bridging::refusal_reason& why,
                      unsigned attempts);
    void settled(const bridging::component& unit);
    void refused(const bridging::component& unit, const jaus::header& message, const bridging::refusal_reason& why);
    [[nodiscard]] bridging::observer observer() noexcept;

    /// Has the ring serve the slave once its position is known; until then it is looked for.
    void find_slave();
    void found(std::uint16_t position, const ethercat::identity_check& expected);
    void retry();
    /// Sends what the ring has for others: not within its turn, because a receiver in this program may end the bridge.
    void flush();
    void log(std::string_view line);
    [[nodiscard]] std::string name() const;
    template <class F, class... Arguments> void call_later(F bridge_state::* function, Arguments... arguments);

    node_state& node_;
    std::shared_ptr<bus_state> bus_;
    std::unique_ptr<bridging::any_exchange> exchange_;
    bridge_options options_;
    std::optional<slave_choice> which_{};
    std::deque<bridged_component> components_{};
    nothing_more application_{};
    bridging::order_memory<> memory_{};
    std::optional<bridging::slave_front> front_{};
    std::optional<boost::asio::steady_timer> timer_{};
    net::limited_log limited_{[this](std::string_view line) { log(line); }};
    std::vector<std::vector<std::byte>> outbox_{};
    std::string last_problem_{};
    bool works_{};     ///< between start and stop
    bool is_served_{}; ///< the ring has the front
    bool is_closed_{};
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
