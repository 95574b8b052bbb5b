// The operator of the soak, and a supervisor who takes control from him.
#pragma once

#include "soak/end.hpp"
#include "soak/ledger.hpp"
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/component/held_control.hpp>
#include <jauscat/net/link/latency_histogram.hpp>

#include <boost/asio/steady_timer.hpp>

#include <utility>

namespace soak {

/// One who wants to control the robot. Commands are repeated for 1.5 s, which outlasts the stalls of a busy machine.
struct commander {
    using listener = std::function<void(const jaus::awaited_message&, jaus::delivered)>;
    struct handler {
        large_traffic& large;
        jaus::message_outcome operator()(const jaus::header& head, std::span<const std::byte> body) const {
            return take_large(large, head, body);
        }
    };

    commander(const jaus::address& self, large_traffic& large, listener tell)
        : on_delivered{std::move(tell)},
          application{large},
          control{self, robot_id, {.retry = {.interval = 100ms, .attempts = 10}, .renewal = 250ms}},
          core{self,
               memory,
               {.on_delivered = on_delivered},
               {.acknowledgement = {.retry = {.interval = 50ms, .attempts = 30}}},
               control} {
        core.change(jaus::state_event::initialized);
    }

    listener on_delivered;
    handler application;
    jaus::held_control control;
    jaus::component_memory<512, 64, 64> memory{};
    jaus::component<jaus::held_control> core;
    /// By the sequence number of what waits for its acknowledgement.
    struct sent_effort {
        std::uint32_t number{};
        jauscat::time_point at{};
    };
    std::vector<sent_effort> efforts = std::vector<sent_effort>(65536);
    std::optional<jaus::delivered> released{}; ///< what became of the last Release Component Control
    bool has_lost_efforts{};                   ///< since the last tick, by the loss of control
};

/// Commands 1000 efforts each second, and plays the same scene again and again: control is taken, lost to the
/// supervisor, refused, given back and released.
class operator_end : public end {
  public:
    operator_end(const net::jaus_config& config, ledger& book, unsigned cycles)
        : end{config, operator_id, robot_id}, book_{book}, left_{cycles} {
        node_.add(operator_.core, operator_.application);
        node_.add(supervisor_.core, supervisor_.application);
    }
    ~operator_end() override { stop(); }

    static constexpr std::chrono::milliseconds cycle{10'000};

    void begin() {
        call([this] {
            started_ = due_ = net::jaus_node::now();
            tick();
        });
    }
    /// After the last cycle, when every effort has its outcome and the operator has control again.
    std::atomic<bool> done{};
    std::atomic<std::uint64_t> sent{}, delivered{}, held_back{};

    /// Send no more; what is under way is brought to its end.
    void end_early() {
        call([this] { left_ = 0; });
    }
    void send_large() {
        call([this] { large.send(node_); });
    }
    [[nodiscard]] std::vector<std::string> failures() {
        std::vector<std::string> found;
        call([&] { found = failures_; });
        return found;
    }
    /// Of acknowledged efforts: all, and those that were not repeated. Read when the end is stopped.
    net::latency_histogram latency{}, first_try{};
    /// From the beginning of a step of the scene until it was so.
    net::latency_histogram steps{};
    unsigned cycles_done{};

  private:
    using state = jaus::control_state;
    struct step {
        std::chrono::milliseconds at;
        const char* what;
        std::function<void()> act;
        std::function<bool()> so;
    };

    void stopped() override {
        has_stopped_ = true; // the handler of a timer that has expired comes without an error
        timer_.cancel();
    }

    void tick() {
        const auto now = net::jaus_node::now();
        for (auto* who : {&operator_, &supervisor_})
            if (std::exchange(who->has_lost_efforts, false) && who->control.state() == state::held)
                failures_.push_back("an effort ended with the loss of control, which is held");
        for (; due_ <= now; due_ += 1ms)
            if (!finishing_) command(now);
        play(now);
        timer_.expires_at(net::to_steady(due_));
        timer_.async_wait([this](boost::system::error_code error) {
            if (!error && !has_stopped_) tick();
        });
    }
    void command(jauscat::time_point now) {
        const bool hijacks = now < hijack_until_;
        auto& who = supervisor_.control.state() == state::held && !hijacks ? supervisor_ : operator_;
        const auto number = book_.next(hijacks);
        if (!number) return;
        const auto result = who.core.send({.destination = robot_id}, effort_of(*number), now, node_.out());
        if (!result) { // as many wait as there are places: the next tick brings another
            book_.take_back();
            ++held_back;
            return;
        }
        who.efforts[*result] = {*number, now};
        ++sent;
    }
    void on_delivered(commander& who, const jaus::awaited_message& m, jaus::delivered what) {
        if (m.header.command_code != jaus::command_code_of<jaus::set_wrench_effort>) {
            who.released = what;
            return;
        }
        const auto& [number, at] = who.efforts[m.header.sequence_number];
        book_.delivered(number, what);
        ++delivered;
        if (what == jaus::delivered::control_lost) who.has_lost_efforts = true;
        if (what != jaus::delivered::acknowledged) return;
        const auto took = net::jaus_node::now() - at;
        latency.add(took);
        if (m.sent == 1) first_try.add(took);
    }

    void play(jauscat::time_point now) {
        if (waits_) {
            if (script_[next_ - 1].so()) {
                steps.add(now - step_at_);
                waits_ = false;
            } else if (now - step_at_ > 1s) {
                failures_.push_back(std::string{script_[next_ - 1].what} + " did not come within 1 s in cycle " +
                                    std::to_string(cycles_done + 1));
                waits_ = false;
            } else
                return;
        }
        if (next_ == script_.size() && now - started_ >= cycle) {
            next_ = 0;
            started_ += cycle;
            ++cycles_done;
            if (left_ != 0) --left_;
        }
        if (left_ == 0 && next_ == 0) return finish(now);
        if (next_ == script_.size() || now - started_ < script_[next_].at) return;
        step_at_ = now;
        waits_ = true;
        script_[next_++].act();
    }
    void finish(jauscat::time_point now) {
        if (!finishing_) operator_.control.ask(5, now, node_.out());
        finishing_ = true;
        if (operator_.core.waiting() + supervisor_.core.waiting() == 0 && operator_.control.state() != state::asking)
            done = true;
    }
    // A plain release may be lost; this one is repeated.
    void release(commander& who) {
        who.released.reset();
        static_cast<void>(who.core.send({.destination = robot_id}, jaus::release_component_control{},
                                        net::jaus_node::now(), node_.out()));
        who.control.release([](std::span<const std::byte>) {});
    }

    ledger& book_;
    boost::asio::steady_timer timer_{context_};
    commander operator_{operator_id, large, [this](const auto& m, auto what) { on_delivered(operator_, m, what); }};
    commander supervisor_{supervisor_id, large,
                          [this](const auto& m, auto what) { on_delivered(supervisor_, m, what); }};
    std::vector<step> script_{
        {0ms, "control for the operator", [this] { operator_.control.ask(5, net::jaus_node::now(), node_.out()); },
         [this] { return operator_.control.state() == state::held; }},
        {2000ms, "control for the supervisor, and the operator's loss of it",
         [this] { supervisor_.control.ask(200, net::jaus_node::now(), node_.out()); },
         [this] { return supervisor_.control.state() == state::held && operator_.control.state() == state::lost; }},
        {3500ms, "a refusal for the operator, who asks again",
         [this] { operator_.control.ask(5, net::jaus_node::now(), node_.out()); },
         [this] { return operator_.control.state() == state::refused; }},
        {5000ms, "commands of the operator, who has no control",
         [this] { hijack_until_ = net::jaus_node::now() + 50ms; },
         [this] { return net::jaus_node::now() > hijack_until_ + 300ms; }},
        {6500ms, "the supervisor's release", [this] { release(supervisor_); },
         [this] { return supervisor_.released == jaus::delivered::acknowledged; }},
        {8000ms, "control back to the operator",
         [this] { operator_.control.ask(5, net::jaus_node::now(), node_.out()); },
         [this] { return operator_.control.state() == state::held; }},
        {9000ms, "the operator's release", [this] { release(operator_); },
         [this] { return operator_.released == jaus::delivered::acknowledged; }},
    };
    std::size_t next_{};
    bool waits_{}, finishing_{}, has_stopped_{};
    jauscat::time_point started_{}, due_{}, step_at_{}, hijack_until_{};
    unsigned left_{};
    std::vector<std::string> failures_{};
};

} // namespace soak
