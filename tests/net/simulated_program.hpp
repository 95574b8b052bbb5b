// Nodes with a component each on a simulated network.
#pragma once

#include "net/node_program.hpp"
#include "net/simulated_network.hpp"
#include <jauscat/jaus/events/service_connections.hpp>

namespace net_test {

/// A node with one component, without sockets, and what it says.
struct simulated_program {
    simulated_program(simulated_network& network, const net::jaus_config& c, const jaus::address& id,
                      net::jaus_node_options options = {})
        : self{id}, at{c.me().endpoint()}, on{network}, node{c, with_hooks(std::move(options)), network.sender(at), 1} {
        core.change(jaus::state_event::initialized);
        node.add(core, application);
        node.start(network.now);
        network.attach(at, node);
    }
    ~simulated_program() { on.detach(at); }
    simulated_program(const simulated_program&) = delete;
    simulated_program& operator=(const simulated_program&) = delete;

    net::jaus_node_options with_hooks(net::jaus_node_options options) {
        options.log = [this](std::string_view line) {
            log.emplace_back(line);
            if (on_log) on_log(line);
        };
        options.on_sent = [this](std::span<const std::byte> message) {
            if (on_sent) on_sent(message);
        };
        options.on_message = [this](const jaus::address&, const jaus::header& head, std::span<const std::byte> body,
                                    auto) {
            if (heard) heard(head, body);
        };
        options.appeared = [this](const jaus::address& who) { appeared.push_back(who); };
        options.disappeared = [this](const jaus::address& who) { disappeared.push_back(who); };
        options.large_data_done = [this](const jaus::header&, jaus::delivered what) { large_done.push_back(what); };
        return options;
    }

    [[nodiscard]] bool logged(std::string_view text) const {
        return std::ranges::any_of(log, [&](const std::string& line) { return line.find(text) != line.npos; });
    }

    struct hooks_type {
        std::vector<jaus::delivered> delivered{};
        void on_delivered(const jaus::awaited_message&, jaus::delivered what) { delivered.push_back(what); }
    };

    jaus::address self;
    simulated_network::endpoint at;
    simulated_network& on;
    std::vector<std::string> log{};
    std::function<void(std::string_view)> on_log{};
    std::function<void(std::span<const std::byte>)> on_sent{};
    std::function<void(const jaus::header&, std::span<const std::byte>)> heard{};
    std::vector<jaus::address> appeared{}, disappeared{};
    std::vector<bytes> large{}; ///< that came
    jaus::message_outcome outcome{jaus::message_outcome::handled};
    std::vector<jaus::delivered> large_done{};
    hooks_type hooks{};
    jaus::component_memory<> memory{};
    jaus::held_control other{self, make(2, 1, 33), {.retry = {.interval = 2s, .attempts = 3}}};
    std::array<jaus::connectable_report, 1> reports{
        {{.command_code = jaus::command_code_of<jaus::report_wrench_effort>}}};
    std::optional<std::size_t> operator()(std::uint16_t, std::uint32_t, std::span<std::byte>) const { return 0; }
    std::array<std::byte, 64> report{};
    jaus::service_connections<2> connections{self, reports, *this, report};
    jaus::component<jaus::held_control, jaus::service_connections<2>> core{
        self, memory, {.on_delivered = jaus::bound<&hooks_type::on_delivered>(hooks)}, {}, other, connections};
    struct handler {
        simulated_program& mine;
        jaus::message_outcome operator()(const jaus::header& head, std::span<const std::byte> body) const {
            if (head.command_code != 0xD111) return jaus::message_outcome::unhandled;
            mine.large.emplace_back(body.begin(), body.end());
            return mine.outcome;
        }
    } application{*this};
    net::node_machine node;
};

} // namespace net_test
