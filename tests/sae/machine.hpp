// A transport with its memory, and a network between several in simulated time.
#pragma once
#include "support/instant.hpp"
#include <jauscat/sae/transport/transport.hpp>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <vector>

namespace jauscat::test {

using namespace std::chrono_literals;

inline constexpr sae::transport_sizes small_sizes{
    .peers = 8, .seen = 128, .fragments = 32, .queue = 32, .replies = 16, .payload_size = 64, .message_size = 1024};

/// What a component got, with a copy of its payload.
struct kept_message {
    sae::received_message message;
    std::vector<std::byte> payload;
};

struct machine {
    std::vector<sae::local_component> components;
    std::unique_ptr<sae::transport_storage<small_sizes>> storage{
        std::make_unique<sae::transport_storage<small_sizes>>()};
    sae::transport transport;
    std::vector<kept_message> received{};

    explicit machine(std::vector<sae::local_component> list, const sae::transport_options& options = {})
        : components{std::move(list)}, transport{components, storage->memory(), options} {}
    machine(const machine&) = delete;
    machine& operator=(const machine&) = delete;

    jaus::datagram_form receive(std::span<const std::byte> datagram, support::instant now, std::uint64_t from = 1) {
        return transport.on_datagram({from}, datagram, now, [this](const sae::received_message& m) {
            received.push_back({m, {m.payload.begin(), m.payload.end()}});
        });
    }
};

/// Carries datagrams between machines; the endpoint of each is its number. Loses, doubles and delays them.
class datagram_network {
  public:
    unsigned lose{}, duplicate{}, delay{}; ///< chances in percent
    duration longest{200ms};               ///< of a delay
    time_point now{};

    explicit datagram_network(unsigned seed) : random_{seed} {}

    void add(machine& m) { machines_.push_back(&m); }
    /// Called after each step.
    std::function<void()> work{[] {}};

    void run(support::instant end) {
        for (;;) {
            for (std::size_t from = 0; from != machines_.size(); ++from)
                while (const auto datagram = machines_[from]->transport.next_datagram(now)) put(from, *datagram);
            work();
            std::optional<time_point> next;
            if (!travelling_.empty()) next = travelling_.begin()->first;
            for (const auto* m : machines_)
                if (const auto due = m->transport.next_event(); due && (!next || *due < *next)) next = due;
            if (!next || *next > end.at) return;
            now = std::max(now, *next);
            while (!travelling_.empty() && travelling_.begin()->first <= now) {
                const auto arrived = travelling_.extract(travelling_.begin()).mapped();
                machines_[arrived.to]->receive(arrived.bytes, now, arrived.from);
            }
        }
    }

  private:
    struct packet {
        std::size_t from{}, to{};
        std::vector<std::byte> bytes{};
    };
    bool happens(unsigned percent) { return random_() % 100 < percent; }
    void put(std::size_t from, const sae::outgoing_datagram& datagram) {
        for (std::size_t to = 0; to != machines_.size(); ++to) {
            if (datagram.to ? datagram.to->value != to : to == from) continue;
            if (happens(lose)) continue;
            for (int copies = happens(duplicate) ? 2 : 1; copies != 0; --copies) {
                time_point at = now + 1ms;
                if (happens(delay)) at += duration{static_cast<std::int64_t>(random_()) % longest.count()};
                travelling_.emplace(at, packet{from, to, {datagram.bytes.begin(), datagram.bytes.end()}});
            }
        }
    }

    std::mt19937 random_;
    std::vector<machine*> machines_{};
    std::multimap<time_point, packet> travelling_{};
};

} // namespace jauscat::test
