// A program with a JAUS node in it, without sockets, on the simulated network.
#pragma once

#include "simulation/model.hpp"
#include "simulation/places.hpp"
#include "simulation/process.hpp"
#include "simulation/unit_judge.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace simulation {

/// A component as its node sees it. What goes in and out is seen by `seen_in` and `seen_out`; one that is mute does
/// nothing any more, as when its thread hangs, while the node goes on.
template <class Component, class Application> class watched_component {
  public:
    watched_component(Component& component, Application& application) : it_{component}, application_{application} {}

    bool mute{};
    std::function<void(const jaus::header&, bytes)> seen_in{};
    std::function<void(bytes)> seen_out{};
    std::function<void(jaus::component_outcome)> seen_done{};
    std::function<void(const jaus::address&)> seen_lost{};
    unit_judge* judge{};

    [[nodiscard]] const jaus::address& self() const noexcept { return it_.self(); }
    jaus::component_outcome on_message(const jaus::header& head, bytes body, jauscat::time_point now,
                                       jaus::message_sink out, auto&& rest) {
        if (mute) return jaus::component_outcome::handled;
        if (seen_in) seen_in(head, body);
        if (judge != nullptr) judge->gets(head, body);
        const auto send = watching(out);
        const auto what = it_.on_message(head, body, now, send, [&](const jaus::header& h, bytes b) {
            const auto mine = application_(h, b);
            return mine == jaus::message_outcome::unhandled ? rest(h, b) : mine;
        });
        if (judge != nullptr) judge->has_handled(what);
        if (seen_done) seen_done(what);
        return what;
    }
    void on_time(jauscat::time_point now, jaus::message_sink out) {
        if (mute) return;
        const auto send = watching(out);
        if (judge != nullptr) judge->runs();
        it_.on_time(now, send);
        if (judge != nullptr) judge->has_run();
    }
    [[nodiscard]] std::optional<jauscat::time_point> next_event() const {
        return mute ? std::nullopt : it_.next_event();
    }
    void on_lost(const jaus::address& who) {
        if (seen_lost) seen_lost(who);
        if (mute) return;
        if (judge != nullptr) judge->loses(who);
        it_.on_lost(who);
        if (judge != nullptr) judge->has_lost();
    }

  private:
    [[nodiscard]] auto watching(jaus::message_sink out) {
        return [this, out](bytes message) {
            if (judge != nullptr) judge->sends(message);
            if (seen_out) seen_out(message);
            out(message);
        };
    }
    Component& it_;
    Application& application_;
};

/// The process around a node. The places are in the order of the ports.
class node_program : public process {
  public:
    node_program(world& w, network& n, model& m, const std::vector<place>& places, std::size_t which)
        : process{w, n, places[which].name}, model_{m}, places_{places}, which_{which} {}

    /// The number of the message that is being received.
    [[nodiscard]] std::uint32_t current_message() const noexcept { return current_message_; }
    [[nodiscard]] net::node_machine& node() noexcept { return *node_; }
    [[nodiscard]] bool has_node() const noexcept { return node_.has_value(); }

  protected:
    /// Adds the program's components.
    virtual void add_components(net::node_machine& node) = 0;
    virtual void remove_components() = 0;
    /// Who of the model sends as this component, if it follows it.
    [[nodiscard]] virtual std::optional<std::uint8_t> sender_of(const jaus::address& source) const = 0;
    /// How long its component waits at most for what becomes of a message that asks for an acknowledgement.
    [[nodiscard]] virtual time longest_wait() const { return {}; }
    virtual void large_data_done(const jaus::header&, jaus::delivered) {}
    virtual net::jaus_node_options node_options() { return {}; }

    void boot() override {
        auto options = node_options();
        options.large_data_done = [this](const jaus::header& head, jaus::delivered what) {
            large_data_done(head, what);
        };
        node_.emplace(
            configuration_of(places_, which_), std::move(options),
            [this](bytes message, const net::node_machine::endpoint& to, jaus::framing) { send(message, to); },
            random_.next());
        add_components(*node_);
        node_->start(now());
    }
    void kill() override {
        node_.reset();
        remove_components();
    }
    void receive(const datagram& one) override {
        current_message_ = one.message;
        node_->on_datagram(one.content(), endpoint_of(one.from), {}, false, now(), waited(one));
        current_message_ = 0;
    }
    void run() override { node_->on_time(now()); }
    [[nodiscard]] std::optional<time> next() override { return since_start(node_->next_event()); }

    model& model_;

  private:
    void send(bytes message, const net::node_machine::endpoint& to) {
        jaus::header head{};
        if (!wire::decode_prefix(head, message)) return;
        const auto sender = sender_of(head.source);
        const bool asks = head.ack_nak == jaus::ack_nak::request;
        const auto number = sender ? model_.hands_over(*sender, message, asks ? longest_wait() : time{}) : 0;
        network_.send(port(), port_of(to), message, number);
    }

    const std::vector<place>& places_;
    std::size_t which_;
    std::optional<net::node_machine> node_{};
    std::uint32_t current_message_{};
};

} // namespace simulation
