// A JAUS node in front of one slave, with the bridge to it: everything of it runs on one thread, and nothing blocks it.
#pragma once
#include "message_kinds/message_kinds.hpp"
#include "robot_controller/front_component.hpp"
#include "robot_controller/narrator.hpp"
#include "support/component_of.hpp"
#include "support/program.hpp"
#include "support/repeated_lines.hpp"
#include <jauscat/net/link/any_link.hpp>
#include <jauscat/net/link/ring_runner.hpp>

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace example {

/// The components of a node that stand in front of a slave: those that the configuration gives this system there, or
/// the one of its jausip, or a Primitive Driver.
inline std::vector<jauscat::net::component_entry> components_in_front(const jauscat::net::system_entry& me,
                                                                      std::uint8_t node) {
    constexpr std::uint8_t primitive_driver = 33;
    std::vector<jauscat::net::component_entry> found;
    std::ranges::copy_if(me.components, std::back_inserter(found),
                         [&](const auto& entry) { return entry.id.node == node && !is_node_manager(entry.id); });
    const auto& own = me.jausip;
    if (found.empty())
        found.push_back({.id = {.instance = std::max<std::uint8_t>(own.instance, 1),
                                .component = own.component != 0 ? own.component : primitive_driver,
                                .node = node,
                                .subsystem = own.subsystem}});
    return found;
}

/// How a front works.
struct front_options {
    bridging::slave_options slave{};
    bridging::bridge_options timing{};
    jauscat::net::access who{};
    std::string trace_name{}; ///< in front of the lines about SDOs on the wire
};

class front {
  public:
    using clock = std::chrono::steady_clock;

    /// Opens the node's socket. `config` is seen by the system that this front is; its slave's station is the node.
    front(const jauscat::net::jaus_config& config, jauscat::net::any_link& link,
          std::unique_ptr<bridging::any_exchange> exchange, const front_options& options, const speaker& say)
        : say_{say},
          timing_{options.timing},
          link_{link, options.trace_name, say.about()},
          exchange_{std::move(exchange)},
          narrator_{say},
          slave_{options.slave, *exchange_, timing_, memory_, narrator_.observer()},
          node_{context_, config,
                node_options(static_cast<std::uint8_t>(options.slave.identity.station), options.who)} {
        for (const auto& entry : components_in_front(config.me(), node_.manager().node)) {
            if (components_.size() == bridging::component_capacity)
                throw std::runtime_error{"more than " + std::to_string(bridging::component_capacity) +
                                         " components in front of one slave"};
            node_.add(components_.emplace_back(entry.id, slave_, component_options(entry.authority), say),
                      nothing_more_);
        }
        static_cast<void>(ring_.add(slave_)); // the only one
        link_.is_quiet = [this] { return ring_.keeps_alive(); };
        slave_.on_work(runner_.wake());
        runner_.after_turn = [this] { look_at_link(); };
        node_.start();
    }

    /// What has ended this front.
    void say_failed(const std::string& problem) const { say_.bad(events::failed, {}, problem); }
    /// Called for each component that this front's node manager has lost. Set before `run`.
    std::function<void(const jauscat::jaus::address& who)> disappeared{};

    /// Works until Ctrl-C, then brings the slave to rest; false if that was not confirmed. Throws if the slave cannot
    /// be brought up within `patience`, unless it may come later.
    bool run(std::chrono::milliseconds patience, bool may_come_later) {
        runner_.start();
        run_until(clock::now() + patience, [&] { return slave_.up() || stop_requested; });
        if (!slave_.up() && !may_come_later && !stop_requested)
            throw std::runtime_error{"no slave to work with: " + explain(ring_.bring_up_error(slave_))};
        if (!stop_requested)
            say_.good(events::ready,
                      {{"endpoint", jauscat::net::detail::text(node_.config().me().endpoint())},
                       {"station", slave_.station()},
                       {"cyclic", slave_.options().cyclic},
                       {"slave_up", slave_.up()}},
                      "ready: JAUS on " + jauscat::net::detail::text(node_.config().me().endpoint()) + ", " +
                          (slave_.up() ? place() : "waiting for its slave: " + explain(ring_.bring_up_error(slave_))) +
                          " (Ctrl-C ends)");
        while (!stop_requested) run_until(clock::now() + std::chrono::seconds{1}, [] { return stop_requested.load(); });
        const bool is_at_rest = bring_to_rest();
        runner_.stop();
        node_.stop();
        say_(events::stopped, {}, "stopped");
        return is_at_rest;
    }

    /// Another front's node manager has lost a component. From any thread.
    void lose(const jauscat::jaus::address& who) {
        boost::asio::post(context_, [this, who] {
            if (node_.present() != nullptr) return; // it detects this itself
            const auto gone = is_node_manager(who) ? jauscat::jaus::address{255, 255, who.node, who.subsystem} : who;
            for (auto& component : components_) component.on_lost(gone);
            node_.wake();
        });
    }

  private:
    // The node identifies its components; they handle all other messages.
    struct no_application {
        jauscat::jaus::message_outcome operator()(const jauscat::jaus::header&, std::span<const std::byte>) const {
            return jauscat::jaus::message_outcome::unhandled;
        }
        /// The slave has objects for these, and may have more.
        static void list_messages(auto&& takes, auto&& sends) {
            const auto list = [&]<class M>() {
                const jauscat::jaus::supported_message m{jauscat::jaus::command_code_of<M>,
                                                         jauscat::jaus::presence_bits_of<M>};
                jauscat::jaus::command_code_of<M> < 0x4000 ? takes(m) : sends(m);
            };
            [&]<class... M>(jauscat::jaus::message_list<M...>) {
                (list.template operator()<M>(), ...);
            }(robot_messages{});
        }
    };

    jauscat::jaus::component_options component_options(std::uint8_t authority) const {
        return {.control = {.authority_code = authority, .timeout = timing_.control_timeout}};
    }
    jauscat::net::jaus_node_options node_options(std::uint8_t node, jauscat::net::access who) {
        return {.accept = who,
                .node = node,
                .log =
                    [this](std::string_view line) {
                        if (const auto times = log_lines_.shown(line))
                            say_(events::node_log, {{"line", line}, {"times", *times}}, log_lines_.text(line, *times));
                    },
                .explain_malformed = &why_malformed,
                .appeared =
                    [this](const jauscat::jaus::address& who_came) {
                        const auto name = jauscat::text::to_text(who_came);
                        say_(events::peer_heard, {{"address", name}}, name + " is heard");
                    },
                .disappeared =
                    [this](const jauscat::jaus::address& who_went) {
                        const auto name = jauscat::text::to_text(who_went);
                        say_(events::peer_lost, {{"address", name}}, name + " is no longer heard");
                        if (disappeared) disappeared(who_went);
                    }};
    }
    [[nodiscard]] std::string place() const {
        return "slave " + std::to_string(slave_.station()) + (slave_.options().cyclic ? " in OP" : " in PRE-OP");
    }

    /// A signal does not wake the io_context: it is polled twenty times a second.
    void run_until(clock::time_point until, auto&& done) {
        constexpr auto glance = std::chrono::milliseconds{50};
        while (!done() && clock::now() < until) {
            context_.restart();
            context_.run_until(std::min(until, clock::now() + glance));
        }
    }
    bool bring_to_rest() {
        constexpr auto longest = std::chrono::milliseconds{700}; // Ctrl-C ends the program within a second
        const bool was_up = slave_.up();
        ring_.shut_down(runner_.now(), said_);
        const auto until = clock::now() + longest;
        while (!ring_.at_rest() && clock::now() < until) context_.run_one_until(until);
        const bool is_at_rest = was_up && slave_.up() && ring_.at_rest();
        if (!is_at_rest)
            say_.bad(events::not_at_rest, {{"station", slave_.station()}},
                     place() + " has not confirmed that it is at rest: it stops by its own watchdog or not at all");
        return is_at_rest || !was_up;
    }

    // Information about the wire, logged once when it comes up.
    void look_at_link() {
        if (slave_.up()) problem_.clear();
        if (const auto& now = link_.problem(); !now.empty() && std::exchange(problem_, now) != now)
            say_.bad(events::link_problem, {{"problem", now}}, now);
        const auto& seen = ring_.master().statistics();
        if (seen.foreign != 0 && !std::exchange(second_master_, true))
            say_.bad(events::second_master, {}, "frames of another master are on this wire; only one may use it");
        if (seen.circulated != 0 && !std::exchange(broken_ring_, true))
            say_.bad(events::broken_ring, {}, "frames return marked as circulating: a cable between two slaves is out");
    }

    speaker say_;
    bridging::bridge_options timing_;
    boost::asio::io_context context_{};
    traced_link<jauscat::net::any_link> link_;
    std::unique_ptr<bridging::any_exchange> exchange_;
    narrator narrator_;
    bridging::order_memory<> memory_{};
    bridging::slave_front slave_;
    bridging::ring ring_{timing_};
    repeated_lines log_lines_{};
    no_application nothing_more_{};
    std::deque<front_component> components_{};
    jauscat::net::jaus_node node_;
    said_messages said_{say_, node_.out()};
    jauscat::net::ring_runner<traced_link<jauscat::net::any_link>> runner_{context_, link_, ring_, said_};
    std::string problem_{}; ///< of the link: logged once, and again after the slave was up
    bool second_master_{}, broken_ring_{};
};

} // namespace example
