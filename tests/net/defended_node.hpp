// A node behind a gate, without sockets: what tests attack.
#pragma once

#include "net/config_text.hpp"
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/large_data/reassembler.hpp>
#include <jauscat/net/node/datagram_gate.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <array>
#include <cstdint>

namespace net_test {

/// This system, two peers and what they may send.
inline const jauscat::net::jaus_config guarded_config = parse(
    "<thissystem>robot</thissystem>"
    "<system name='robot' jausip='2.0.0.0' ip='10.0.0.2' port='3794'/>"
    "<system name='ocu' jausip='1.0.0.0' ip='10.0.0.1' port='3794'><limits rate='1000' burst='100'/></system>"
    "<system name='camera' jausip='3.0.0.0' ip='10.0.0.3' port='3794'><limits rate='1000' burst='100'/></system>");

inline jauscat::net::access_list::endpoint at(const char* ip, std::uint16_t port = 3794) {
    return {boost::asio::ip::make_address(ip), port};
}

constexpr jauscat::jaus::address robot_arm{1, 33, 1, 2}, ocu{1, 32, 1, 1}, camera{1, 37, 1, 3};

/// A primitive driver: gate, reassembly, core and one command of its own.
class defended_node {
  public:
    using verdict = jauscat::net::verdict;
    using bytes = std::span<const std::byte>;

    explicit defended_node(const jauscat::net::jaus_config& config) : gate_{config} {
        core_.change(jauscat::jaus::state_event::initialized);
    }

    /// What a transport does with each datagram. `answer(bytes)` gets what is sent because of it.
    verdict receive(bytes message, const jauscat::net::access_list::endpoint& from, jauscat::time_point now,
                    auto&& answer) {
        const auto what = gate_(message, from, now);
        if (what == verdict::accepted) take(message, now, answer);
        return what;
    }
    void take(bytes message, jauscat::time_point now, auto&& answer) {
        namespace jaus = jauscat::jaus;
        const auto m = jaus::split(message);
        if (!m) return;
        ++well_formed;
        const auto whole = [&](const jaus::header& head, bytes body) {
            jaus::dispatcher own{jaus::on<jaus::set_wrench_effort>([this](auto&, auto&) { ++commands; })};
            core_.on_message(head, body, now, answer, own);
        };
        if (large_.on_packet(m.header, m.body, now, whole, [](auto&) {}) == jaus::reassembled::only)
            whole(m.header, m.body);
    }
    void on_time(jauscat::time_point now, auto&& answer) {
        core_.on_time(now, answer);
        large_.on_time(now, [](auto&) {});
    }

    std::uint64_t well_formed{}; ///< messages that were whole
    std::uint64_t commands{};    ///< Set Wrench Effort, obeyed

  private:
    jauscat::net::datagram_gate gate_;
    jauscat::jaus::component_memory<> memory_{};
    jauscat::jaus::component<> core_{robot_arm, memory_, {}, {}};
    std::array<jauscat::jaus::partial_data_set, 4> places_{};
    std::array<jauscat::jaus::held_packet, 4 * 16> packets_{};
    std::array<std::byte, 4 * 16 * jauscat::jaus::max_body_size> large_memory_{};
    jauscat::jaus::reassembler large_{places_, packets_, large_memory_, std::chrono::seconds{5}};
};

} // namespace net_test
