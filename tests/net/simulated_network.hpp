// Nodes without sockets on a network in simulated time that loses, doubles and delays datagrams.
#pragma once

#include <jauscat/net/node/node_machine.hpp>

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <vector>

namespace net_test {

/// Carries datagrams between node machines by their endpoints.
class simulated_network {
  public:
    using machine = jauscat::net::node_machine;
    using endpoint = machine::endpoint;

    /// Chances in percent.
    struct faults_type {
        unsigned lose{};
        unsigned duplicate{};
        unsigned delay{};
        jauscat::duration longest{std::chrono::milliseconds{3}}; ///< of a delay
    } faults{};
    jauscat::time_point now{std::chrono::hours{1}};
    jauscat::duration trip{std::chrono::microseconds{100}}; ///< one way
    std::size_t sent{};                                     ///< datagrams
    std::optional<endpoint> deaf{};                         ///< nothing arrives there

    explicit simulated_network(unsigned seed = 1) : random_{seed} {}

    /// What a machine at `from` is to be made with.
    machine::send_handler sender(const endpoint& from) {
        return [this, from](machine::bytes message, const endpoint& to, jauscat::jaus::framing framing) {
            ++sent;
            if (happens(faults.lose)) return;
            for (int copies = happens(faults.duplicate) ? 2 : 1; copies != 0; --copies) {
                jauscat::time_point at = now + trip;
                if (happens(faults.delay))
                    at += jauscat::duration{random_() % static_cast<std::uint64_t>(faults.longest.count())};
                travelling_.emplace(at, datagram{from, to, framing, {message.begin(), message.end()}});
            }
        };
    }
    void attach(const endpoint& at, machine& node) { nodes_.insert_or_assign(at, &node); }
    void detach(const endpoint& at) { nodes_.erase(at); }

    /// Until `done()` or `end`; whether it is done.
    bool run(jauscat::time_point end, const std::function<bool()>& done = [] { return false; }) {
        while (!done()) {
            std::optional<jauscat::time_point> next;
            if (!travelling_.empty()) next = travelling_.begin()->first;
            for (const auto& [at, node] : nodes_)
                if (const auto due = node->next_event(); due && (!next || *due < *next)) next = due;
            if (!next || *next > end) {
                now = std::max(now, end);
                return done();
            }
            now = std::max(now, *next);
            while (!travelling_.empty() && travelling_.begin()->first <= now)
                arrive(travelling_.extract(travelling_.begin()).mapped());
            for (const auto& [at, node] : std::map{nodes_})
                if (const auto due = node->next_event(); due && *due <= now) node->on_time(now);
        }
        return true;
    }

  private:
    struct datagram {
        endpoint from{}, to{};
        jauscat::jaus::framing framing{};
        std::vector<std::byte> message{};
    };

    bool happens(unsigned percent) { return random_() % 100 < percent; }
    void arrive(const datagram& d) {
        if (const auto to = nodes_.find(d.to); to != nodes_.end() && d.to != deaf)
            to->second->on_datagram(d.message, d.from, d.framing, false, now);
    }

    std::mt19937_64 random_;
    std::map<endpoint, machine*> nodes_{};
    std::multimap<jauscat::time_point, datagram> travelling_{};
};

} // namespace net_test
