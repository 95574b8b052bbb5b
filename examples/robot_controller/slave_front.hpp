// A JAUS node in front of one slave, with the slave's master: everything of it runs on one thread.
#pragma once
#include "robot_controller/slave_component.hpp"
#include "support/component_of.hpp"
#include "support/program.hpp"
#include "support/repeated_lines.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <thread>

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

class slave_front {
  public:
    using clock = std::chrono::steady_clock;

    /// Opens the node's socket. `config` is seen by the system that this front is; its slave's station is the node.
    slave_front(const jauscat::net::jaus_config& config, any_link& link, std::unique_ptr<any_exchange> exchange,
                const slave_settings& settings, jauscat::net::access who, const speaker& say)
        : say_{say},
          driver_{link, std::move(exchange), settings, say},
          node_{context_, config, options(static_cast<std::uint8_t>(settings.slave.station), who)} {
        for (const auto& entry : components_in_front(config.me(), node_.manager().node))
            node_.add(components_.emplace_back(entry.id, entry.authority, driver_, say), nothing_more_);
        node_.start();
    }

    /// For what is said of this front.
    void say(const std::string& line) const { say_(line); }
    /// Hears of everybody whom this front's node manager no longer hears. Before `run`.
    std::function<void(const jauscat::jaus::address& who)> disappeared{};

    /// Works until Ctrl-C. Throws if the slave cannot be brought up within `patience`, unless it may come later.
    void run(std::chrono::milliseconds patience, bool may_come_later) {
        const auto deadline = clock::now() + patience;
        while (!try_bring_up() && clock::now() < deadline && !stop_requested)
            std::this_thread::sleep_for(std::chrono::milliseconds{100});
        if (!driver_.up() && !may_come_later) throw std::runtime_error{"no slave to work with: " + driver_.problem()};
        const auto& me = node_.config().me();
        say_.good("ready: JAUS on " + jauscat::net::detail::text(me.endpoint()) + ", " +
                  (driver_.up() ? driver_.place() : "waiting for its slave: " + driver_.problem()) + " (Ctrl-C ends)");
        while (!stop_requested) {
            if (driver_.up())
                driver_.work();
            else if (clock::now() >= next_try_)
                try_bring_up();
            serve_until(driver_.up() ? driver_.next_work() : next_try_);
        }
        node_.stop();
        say_("stopped");
    }

    /// Somebody has gone whom another front's node manager has heard. From any thread.
    void lose(const jauscat::jaus::address& who) {
        boost::asio::post(context_, [this, who] {
            if (node_.present() != nullptr) return; // it hears for itself
            const auto gone = is_node_manager(who) ? jauscat::jaus::address{255, 255, who.node, who.subsystem} : who;
            for (auto& component : components_) component.on_lost(gone);
        });
    }

  private:
    /// Between two attempts to bring the slave up the node has time for its messages.
    static constexpr auto retry_interval = std::chrono::milliseconds{500};
    static constexpr auto longest_wait = std::chrono::milliseconds{100};

    // The node answers for its components who they are; all else is theirs.
    struct no_application {
        jauscat::jaus::message_outcome operator()(const jauscat::jaus::header&, std::span<const std::byte>) const {
            return jauscat::jaus::message_outcome::not_mine;
        }
    };

    jauscat::net::jaus_node_options options(std::uint8_t node, jauscat::net::access who) {
        return {.who = who,
                .node = node,
                .log =
                    [this](std::string_view line) {
                        if (log_lines_.is_new(line)) say_(std::string{line});
                    },
                .appeared =
                    [this](const jauscat::jaus::address& who_came) {
                        say_(jauscat::text::to_text(who_came) + " is heard");
                    },
                .disappeared =
                    [this](const jauscat::jaus::address& who_went) {
                        say_(jauscat::text::to_text(who_went) + " is no longer heard");
                        if (disappeared) disappeared(who_went);
                    }};
    }

    bool try_bring_up() {
        const bool is_up = driver_.bring_up();
        next_try_ = clock::now() + retry_interval;
        if (is_up)
            for (auto& component : components_) component.slave_is_up();
        return driver_.up();
    }

    void serve_until(clock::time_point until) {
        bool over = false;
        timer_.expires_at(std::min(until, clock::now() + longest_wait));
        timer_.async_wait([&over](const auto&) { over = true; });
        context_.restart();
        while (!over) context_.run_one();
    }

    speaker say_;
    boost::asio::io_context context_{};
    boost::asio::steady_timer timer_{context_};
    slave_driver driver_;
    clock::time_point next_try_{};
    repeated_lines log_lines_{};
    no_application nothing_more_{};
    std::deque<slave_component> components_{};
    jauscat::net::jaus_node node_;
};

} // namespace example
