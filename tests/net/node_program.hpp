// Nodes of one process that talk over the loopback interface, for tests: with a component each, and what they say.
#pragma once

#include "net/config_text.hpp"
#include "support/free_ports.hpp"
#include "support/until.hpp"
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/component/held_control.hpp>
#include <jauscat/net/node/jaus_node.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <boost/asio/io_context.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace net_test {

namespace jaus = jauscat::jaus;
namespace net = jauscat::net;
namespace wire = jauscat::wire;
using support::free_ports;
using namespace std::chrono_literals;
using udp = boost::asio::ip::udp;
using bytes = std::vector<std::byte>;

constexpr jaus::address make(unsigned subsystem, unsigned node, unsigned component = 1, unsigned instance = 1) {
    const auto id = [](unsigned n) { return static_cast<std::uint8_t>(n); };
    return {id(instance), id(component), id(node), id(subsystem)};
}

inline std::string system(const std::string& name, const std::string& jausip, unsigned port,
                          const std::string& inside = "") {
    return "<system name='" + name + "' jausip='" + jausip + "' ip='127.0.0.1' port='" + std::to_string(port) + "'>" +
           inside + "</system>\n";
}
inline net::jaus_config config(const std::string& self, const std::string& systems) {
    return net_test::parse("<thissystem>" + self + "</thissystem>\n" + systems);
}

/// What a message of a node's components was.
struct seen_message {
    jaus::address component{};
    jaus::header head{};
    bytes body{};
    jaus::component_outcome what{};
};

/// A node with one component, and what it says.
struct program {
    using time = jauscat::time_point;

    program(boost::asio::io_context& context, const net::jaus_config& c, const jaus::address& id,
            net::jaus_node_options options = {})
        : self{id}, node{context, c, with_hooks(std::move(options))} {
        core.change(jaus::state_event::initialized);
        node.add(core, application);
        node.start();
    }
    program(const program&) = delete;
    program& operator=(const program&) = delete;

    net::jaus_node_options with_hooks(net::jaus_node_options options) {
        options.beat.period = 50ms;
        options.timeout = 2s;
        options.log = [this](std::string_view line) { log.emplace_back(line); };
        options.on_message = [this](const jaus::address& component, const jaus::header& head,
                                    std::span<const std::byte> body, jaus::component_outcome what) {
            seen.push_back({component, head, {body.begin(), body.end()}, what});
        };
        options.appeared = [this](const jaus::address& who) { appeared.push_back(who); };
        options.disappeared = [this](const jaus::address& who) { disappeared.push_back(who); };
        return options;
    }
    [[nodiscard]] bool logged(std::string_view text) const {
        return std::ranges::any_of(log, [&](const std::string& line) { return line.find(text) != line.npos; });
    }
    /// The first message of that code and source, or nullptr.
    [[nodiscard]] const seen_message* find(std::uint16_t code, const jaus::address& from) const {
        const auto found = std::ranges::find_if(
            seen, [&](const seen_message& m) { return m.head.command_code == code && m.head.source == from; });
        return found == seen.end() ? nullptr : &*found;
    }

    struct hooks_type {
        std::vector<jaus::delivered> delivered{};
        void on_delivered(const jaus::awaited_message&, jaus::delivered what) { delivered.push_back(what); }
    };

    jaus::address self;
    std::vector<std::string> log{};
    std::vector<seen_message> seen{};
    std::vector<jaus::address> appeared{}, disappeared{};
    std::vector<bytes> large{};
    hooks_type hooks{};
    jaus::component_memory<> memory{};
    jaus::held_control other{self, make(2, 1, 33), {.retry = {.interval = 2s, .attempts = 3}}};
    jaus::component<jaus::held_control> core{
        self, memory, {.on_delivered = jaus::bound<&hooks_type::on_delivered>(hooks)}, {}, other};
    struct handler {
        program& mine;
        jaus::message_outcome operator()(const jaus::header& head, std::span<const std::byte> body) const {
            if (head.command_code != 0xD111) {
                const bool is_wrench = head.command_code == jaus::command_code_of<jaus::set_wrench_effort>;
                return is_wrench ? jaus::message_outcome::handled : jaus::message_outcome::unhandled;
            }
            mine.large.emplace_back(body.begin(), body.end());
            return jaus::message_outcome::handled;
        }
    } application{*this};
    net::jaus_node node;
};

/// Two systems that know each other.
struct pair {
    boost::asio::io_context context{};
    std::array<std::uint16_t, 2> ports = free_ports<2>();
    std::string systems = system("ocu", "1.0.0.0", ports[0]) +
                          system("robot", "2.0.0.0", ports[1],
                                 "<framing>JAUS01.0</framing><node id='1' name='arm'/><component id='44'/>");
    program ocu{context, config("ocu", systems), make(1, 1, 32)};
    program robot{context, config("robot", systems), make(2, 1, 33)};

    bool until(auto done) { return support::until(context, done); }
    void run_for(std::chrono::milliseconds time) {
        static_cast<void>(net::run_until(context, time, [] { return false; }));
    }
};

inline bool has(const std::vector<jaus::address>& list, const jaus::address& who) {
    return std::ranges::find(list, who) != list.end();
}

} // namespace net_test
