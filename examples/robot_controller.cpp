// The robot controller: receives JAUS messages over UDP, sends SDO downloads over EtherCAT, and returns reports.
#include "robot_controller/command_line.hpp"
#include "robot_controller/narrator.hpp"
#include "support/live_node.hpp"
#include <jauscat/app.hpp>
#include <jauscat/app/own_table.hpp>
#include <jauscat/catalogue/ra_3_3.hpp>

#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>

#include <deque>
#include <optional>
#include <thread>

namespace example {

/// A JAUS node, the bus of its slave, and the bridge between them. Several work on threads of their own.
class front {
  public:
    // [front]
    front(const place& at, const values_map& values, std::deque<front>& all, jauscat::net::live_feed* feed)
        : config_{at.config},
          say_{at.name.empty() ? "controller" : "controller " + at.name, {{"system", config_.this_system}}},
          log_{say_, at.name},
          options_{bridge_options_of(values)},
          node_{watched(log_.of_node(node_options_of(at, values)), feed)},
          bus_{node_.context(), at.link, log_.of_bus(bus_options_of(at, values))},
          reporter_{node_.context(), feed, [this, link = describe_link(at.link)] { return live_state(link); }} {
        say_(events::link_opened, {{"link", describe_link(at.link)}}, describe_link(at.link));
        const auto connect = [&]<class Table>() { return bridge_.emplace(node_, bus_, Table{}, options_), success; };
        with_table(values, connect);
        bridge_->observe(log_.observer());
        bridge_->when_up([this](const auto&) { return bridge_->is_up() ? tell_ready() : void(); });
        for (const auto& [component, names] : components_of(config_.me(), node_.manager().node))
            bridge_->serve(component, slaves_of(bus_, names), joints_of(names.size(), values));
        node_.when_appeared([this](const auto& who) { log_.peer(who, true); });
        node_.when_disappeared([this, &all](const auto& who) {
            log_.peer(who, false);
            for (auto& each : all) each.lose(who);
        });
        stop_.async_wait([this](auto error, int) {
            if (!error) node_.stop();
        });
        node_.start();
    }
    // [front end]

    /// A front's node manager has lost a component. From any thread.
    void lose(const jauscat::jaus::address& who) {
        boost::asio::post(node_.context(), [this, who] { node_.lose(who); });
    }

    /// Works until Ctrl-C, then brings the slave to rest; false if that was not confirmed. Throws if the slave is not
    /// there after `wait`, unless it may come later.
    bool run(std::chrono::milliseconds wait, bool may_come_later) {
        if (stop_requested) return true; // by a signal before this took them
        wait_.expires_after(wait);
        wait_.async_wait([this, wait, may_come_later](auto error) {
            if (error || is_ready_ || bridge_->is_up()) return; // it is or was there
            const auto why = !log_.failure().empty()
                                 ? log_.failure()
                                 : "none was up after " + std::to_string(wait.count()) + " ms; --wait gives them more";
            if (!may_come_later) throw std::runtime_error{"no slave to work with: " + why};
            tell_ready();
        });
        node_.context().run();
        log_.stopped(node_.manager().node, bridge_->at_rest());
        return bridge_->at_rest();
    }
    /// Brings the slave to rest after an error of `run`.
    void fail(const std::string& problem) {
        say_.bad(events::failed, {}, problem);
        node_.stop();
    }

  private:
    [[nodiscard]] jauscat::net::live_state live_state(const std::string& link) {
        const auto components = node_.components();
        const auto slaves = bus_.statuses();
        errors_.ask(slaves);
        return {.systems = live_systems(config_, components),
                .components = live_components(components),
                .buses = {live_bus_of(link, bus_.statistics(), slaves, errors_)}};
    }
    void tell_ready() {
        if (std::exchange(is_ready_, true)) return;
        log_.ready(config_.me(), node_.manager().node, options_.period > jauscat::duration{}, bridge_->is_up());
    }

    jauscat::net::jaus_config config_;
    speaker say_;
    narrator log_;
    jauscat::bridge_options options_;
    jauscat::node node_;
    jauscat::bus bus_;
    live_errors errors_{bus_};
    live_reporter reporter_;
    std::optional<jauscat::bridge> bridge_{};
    boost::asio::signal_set stop_{node_.context(), SIGINT, SIGTERM};
    boost::asio::steady_timer wait_{node_.context()};
    bool is_ready_{};
};

/// Each front on a thread of its own, until Ctrl-C. The error of a single one is thrown.
int run_all(std::deque<front>& fronts, std::chrono::milliseconds wait) {
    if (fronts.size() == 1) return fronts.front().run(wait, false) ? success : failure;
    std::atomic<bool> is_well{true};
    std::vector<std::jthread> threads;
    for (auto& front : fronts)
        threads.emplace_back([&] {
            try {
                if (!front.run(wait, true)) is_well = false;
            } catch (const std::exception& problem) {
                front.fail(problem.what());
                is_well = false;
            }
        });
    threads.clear(); // waits for them
    return is_well ? success : failure;
}

} // namespace example

int main(int argc, char** argv) {
    using namespace example;
    return run("robot_controller", [&] {
        const auto values = parse(argc, argv, controller_options(), controller_help);
        const auto places = places_of(values);
        live_view view{"robot_controller", values, places.front().config.this_system, jauscat::catalogue::ra_3_3()};
        std::deque<front> fronts;
        for (const auto& at : places) fronts.emplace_back(at, values, fronts, view.make_feed());
        if (std::ranges::any_of(places, [](const auto& at) { return is_raw_link(at.link); })) give_up_privileges();
        view.start();
        view.tell();
        return run_all(fronts, wait_of(places, values));
    });
}
