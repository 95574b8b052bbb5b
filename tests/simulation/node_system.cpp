#include "simulation/node_system.hpp"

#include "simulation/memory_watch.hpp"
#include "simulation/messages.hpp"
#include "simulation/node_judge.hpp"
#include "simulation/node_program.hpp"
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/jaus/component/component_clock.hpp>
#include <jauscat/jaus/events/event_consumer.hpp>
#include <jauscat/jaus/events/events.hpp>
#include <jauscat/jaus/events/service_connections.hpp>
#include <jauscat/jaus/events/service_consumer.hpp>

#include <array>
#include <cstring>
#include <deque>

namespace simulation {
namespace {

using std::chrono::milliseconds, std::chrono::seconds;

constexpr std::uint16_t report_code = jaus::command_code_of<jaus::report_wrench_effort>;
constexpr std::uint16_t broadcast_code = 0xD118;
constexpr std::uint8_t component_id = 40;
constexpr std::array<jaus::address, 4> node_ids{{{1, 1, 1, 1}, {1, 1, 2, 1}, {1, 1, 1, 2}, {1, 1, 2, 2}}};
constexpr std::array<const char*, 4> node_names{"base", "panel", "robot", "arm"};

constexpr jaus::address component_of(std::size_t node) {
    return {1, component_id, node_ids[node].node, node_ids[node].subsystem};
}
std::optional<std::size_t> node_of(const jaus::address& who) {
    for (std::size_t i = 0; i != node_ids.size(); ++i)
        if (node_ids[i].subsystem == who.subsystem && node_ids[i].node == who.node) return i;
    return std::nullopt;
}

template <class T> std::array<std::byte, sizeof(T)> bytes_of(const T& value) {
    std::array<std::byte, sizeof(T)> made{};
    std::memcpy(made.data(), &value, sizeof value);
    return made;
}
template <class T> std::optional<T> read_as(bytes body) {
    if (body.size() != sizeof(T)) return std::nullopt;
    T made{};
    std::memcpy(&made, body.data(), sizeof made);
    return made;
}

/// How the nodes are connected.
struct links {
    bool has_primaries{}; ///< panel - base - robot - arm, where base and robot relay; without, all know all
    /// The next node on the way.
    [[nodiscard]] std::size_t next(std::size_t from, std::size_t to) const {
        if (!has_primaries) return to;
        constexpr std::array<std::size_t, 4> chain{1, 0, 2, 3}; // nodes, from its begin
        const auto place = [&](std::size_t node) {
            return static_cast<std::size_t>(std::ranges::find(chain, node) - chain.begin());
        };
        return chain[place(to) < place(from) ? place(from) - 1 : place(from) + 1];
    }
    [[nodiscard]] std::vector<std::uint8_t> path(std::size_t from, std::size_t to) const {
        std::vector<std::uint8_t> made{static_cast<std::uint8_t>(from)};
        while (made.back() != to) made.push_back(static_cast<std::uint8_t>(next(made.back(), to)));
        return made;
    }
    [[nodiscard]] net::jaus_config configuration(std::size_t mine) const {
        net::jaus_config made{.this_system = node_names[mine], .source = "simulation"};
        const auto add = [&](std::string name, const jaus::address& jausip, std::size_t by) {
            made.systems.push_back({.name = std::move(name),
                                    .jausip = jausip,
                                    .ip = endpoint_of(static_cast<std::uint8_t>(by)).address(),
                                    .port = udp_port});
        };
        for (std::size_t i = 0; i != node_ids.size(); ++i) {
            const bool is_own = node_ids[i].subsystem == node_ids[mine].subsystem;
            if (!has_primaries || is_own)
                add(node_names[i], {0, 0, node_ids[i].node, node_ids[i].subsystem}, next_or_self(mine, i));
        }
        // One route leads to the other subsystem.
        const std::size_t other = mine < 2 ? 2 : 0;
        if (has_primaries) add("others", {0, 0, 0, node_ids[other].subsystem}, next(mine, other));
        return made;
    }

  private:
    [[nodiscard]] std::size_t next_or_self(std::size_t from, std::size_t to) const {
        return from == to ? to : next(from, to);
    }
};

/// What a node's component wants of others, by service connection and by events.
class subscriber {
  public:
    struct wish {
        std::size_t provider{};
        report_way way{};
        double rate{};
        std::optional<std::size_t> place{};
    };
    /// `tell` gets what it does with its connections and reports; the other node is a number of node_ids there.
    subscriber(std::size_t mine, node_judge& judge, std::span<wish> wishes, std::function<void(happening)> tell)
        : mine_{mine},
          judge_{judge},
          wishes_{wishes},
          tell_{std::move(tell)},
          connections_{component_of(mine), {}, jaus::bound<&subscriber::connects>(*this)},
          events_{component_of(mine)} {}
    subscriber(const subscriber&) = delete;
    subscriber& operator=(const subscriber&) = delete;
    ~subscriber() = default;

    jaus::message_outcome on_message(const jaus::header& head, bytes body, jauscat::time_point now,
                                     jaus::message_sink out) {
        const auto of_connection = connections_.on_message(head, body, now, out);
        if (of_connection.what == jaus::consumer_notice::report) gets(report_way::connection, body);
        if (of_connection.what == jaus::consumer_notice::old_report) ignores(head.source, head.sequence_number);
        if (of_connection.what != jaus::consumer_notice::unhandled) return jaus::message_outcome::handled;
        const auto of_event = events_.on_message(head, body, now, out);
        if (of_event.what == jaus::event_notice::event) {
            const bool is_periodic = events_.requested()[of_event.place].type == jaus::event_type::periodic;
            gets(is_periodic ? report_way::periodic_event : report_way::change_event, of_event.report);
        }
        if (of_event.what == jaus::event_notice::repeated) ignores(head.source, read_number(body));
        return of_event.what == jaus::event_notice::unhandled ? jaus::message_outcome::unhandled
                                                              : jaus::message_outcome::handled;
    }
    void on_time(jauscat::time_point now, jaus::message_sink out) {
        connections_.on_time(now, out);
        events_.on_time(now, out);
    }
    [[nodiscard]] std::optional<jauscat::time_point> next_event() const {
        const auto a = connections_.next_event(), b = events_.next_event();
        return a && b ? std::min(a, b) : a ? a : b;
    }
    void on_lost(const jaus::address& who) { events_.on_lost(who); }

    /// Requests what is not requested, and again what was given up.
    void look_after(jauscat::time_point now, jaus::message_sink out) {
        for (auto& each : wishes_) {
            if (each.way == report_way::connection) {
                using enum jaus::consumed_state;
                const auto state = each.place ? connections_.connections()[*each.place].state : free;
                if (state == free || state == refused || state == unanswered)
                    each.place =
                        connections_.ask(component_of(each.provider), report_code, each.rate, 0xFFFF, now, out);
                continue;
            }
            using enum jaus::requested_state;
            const auto state = each.place ? events_.requested()[*each.place].state : free;
            if (state != free && state != rejected && state != unanswered) continue;
            jaus::create_event wanted{.message_code = report_code, .event_type = jaus::event_type::every_change};
            if (each.way == report_way::periodic_event) {
                wanted.event_type = jaus::event_type::periodic;
                wanted.requested_periodic_rate = each.rate;
            }
            each.place = events_.create(component_of(each.provider), wanted, now, out);
        }
    }

  private:
    void connects(const jaus::consumed_connection& one) {
        tell_of(one.provider, {.what = deed::connects, .value = static_cast<std::uint32_t>(one.state)});
    }
    void ignores(const jaus::address& provider, std::uint16_t number) {
        tell_of(provider, {.what = deed::ignores_report, .number = number});
    }
    void tell_of(const jaus::address& provider, happening one) {
        const auto node = node_of(provider);
        if (!node) return;
        one.whom = static_cast<std::uint8_t>(*node);
        tell_(one);
    }
    [[nodiscard]] static std::uint16_t read_number(bytes body) {
        jaus::event one{};
        return wire::decode(one, body) ? one.event_sequence_number : std::uint16_t{};
    }
    void gets(report_way way, bytes body) {
        if (const auto value = read_as<reported_value>(body)) judge_.gets_report(mine_, way, *value);
    }
    std::size_t mine_;
    node_judge& judge_;
    std::span<wish> wishes_;
    std::function<void(happening)> tell_;
    jaus::service_consumer<4> connections_;
    jaus::event_consumer<4> events_;
};

/// A program with a node and a component that provides reports, subscribes to those of another node, and broadcasts.
class peer_program final : public process {
  public:
    peer_program(world& w, network& n, node_judge& judge, const links& how, std::size_t mine)
        : process{w, n, node_names[mine]}, judge_{judge}, links_{how}, mine_{mine} {
        judge.add(*this);
    }
    /// After all nodes are there.
    void plan() {
        constexpr std::array rates{10, 20, 50};
        for (const auto way : {report_way::connection, report_way::periodic_event, report_way::change_event}) {
            const auto provider = (mine_ + 1 + random_.below(node_ids.size() - 1)) % node_ids.size();
            const auto rate = rates[random_.below(rates.size())];
            wishes_.push_back({provider, way, static_cast<double>(rate), {}});
            judge_.requests(mine_, provider, way, time{seconds{1}} / rate);
        }
    }
    void check() override {
        if (!running()) return;
        const auto* const present = node_->present();
        for (std::size_t i = 0; i != node_ids.size(); ++i) {
            if (i == mine_) continue;
            judge_.sees(mine_, i, present != nullptr && present->find(node_ids[i]) != nullptr);
        }
    }

  protected:
    void boot() override {
        judge_.starts(mine_);
        count_ = 0;
        clock_.reset();
        change_value();
        for (auto& each : wishes_) each.place.reset();
        net::jaus_node_options options{.primary = static_cast<std::uint8_t>(links_.has_primaries ? 1 : 0)};
        options.node = node_ids[mine_].node;
        options.on_sent = [this](bytes message) { sent(message); };
        options.on_message = [this](const jaus::address& who, const jaus::header& head, bytes body, auto what) {
            if (who == component_of(mine_)) heard(head, body, what);
        };
        options.appeared = [this](const jaus::address& who) { tell_of(deed::hears_of, who); };
        options.disappeared = [this](const jaus::address& who) { tell_of(deed::gives_up, who); };
        node_.emplace(
            links_.configuration(mine_), std::move(options),
            [this](bytes message, const net::node_machine::endpoint& to, jaus::framing) {
                network_.send(port(), port_of(to), message, 0);
            },
            random_.next());
        unit_.emplace(*this);
        node_->add(unit_->core, application_);
        unit_->core.change(jaus::state_event::initialized);
        node_->start(now());
    }
    void kill() override {
        node_.reset();
        unit_.reset();
    }
    void receive(const datagram& one) override {
        node_->on_datagram(one.content(), endpoint_of(one.from), {}, false, now(), waited(one));
    }
    void run() override { node_->on_time(now()); }
    [[nodiscard]] std::optional<time> next() override { return since_start(node_->next_event()); }

    void act() override {
        const auto out = node_->out(now());
        unit_->wanted.look_after(now(), out);
        if (run_time() >= still_until_) change_value(), tell_change();
        if (random_.below(200) == 0) still_until_ = run_time() + random_.between(seconds{1}, seconds{9});
        if (random_.below(8) == 0) send_broadcast();
        if (random_.below(8) == 0) ask_time();
        if (random_.below(20) == 0) set_time();
        node_->wake(now());
    }

  private:
    struct unit {
        explicit unit(peer_program& mine)
            : provided{component_of(mine.mine_), reports, mine.filler_, report},
              sent_events{component_of(mine.mine_), event_reports, mine.event_filler_, event_memory},
              wanted{mine.mine_, mine.judge_, mine.wishes_, [&mine](happening one) { mine.tell(one); }},
              core{component_of(mine.mine_),
                   memory,
                   {},
                   {.control = {.harmless = harmless}},
                   provided,
                   sent_events,
                   wanted} {}
        static constexpr std::array<std::uint16_t, 1> harmless{broadcast_code};
        static constexpr std::array<jaus::connectable_report, 1> reports{{{report_code, 1, 100}}};
        static constexpr std::array<jaus::eventful_report, 1> event_reports{
            {{.command_code = report_code, .max_rate = 100}}};
        std::array<std::byte, 64> report{};
        std::array<std::byte, 1024> event_memory{};
        jaus::component_memory<8, 64, 64> memory{};
        jaus::service_connections<8> provided;
        jaus::events<16> sent_events;
        subscriber wanted;
        jaus::component<jaus::service_connections<8>, jaus::events<16>, subscriber> core;
    };

    // As the unit's consumer tells it: the other node is a number of node_ids, and so is the port.
    void tell(happening one) {
        one.who = number();
        one.whom = judge_.number_of(one.whom);
        world_.tell(one);
    }
    void tell_of(deed what, const jaus::address& who) {
        world_.tell({.what = what,
                     .who = number(),
                     .value = std::uint32_t{who.subsystem} << 24U | std::uint32_t{who.node} << 16U |
                              std::uint32_t{who.component} << 8U | who.instance});
    }
    [[nodiscard]] std::optional<std::size_t> write_report(std::span<std::byte> body) const {
        const auto made = bytes_of(value());
        if (body.size() < made.size()) return std::nullopt;
        std::ranges::copy(made, body.begin());
        return made.size();
    }
    [[nodiscard]] reported_value value() const { return {life(), count_}; }
    void change_value() {
        ++count_;
        judge_.changes(mine_, value());
    }
    void tell_change() { unit_->sent_events.changed(report_code, bytes_of(value()), now(), node_->out(now())); }

    void send_broadcast() {
        judge_.broadcasts(mine_, ++broadcasts_);
        const auto body = bytes_of(broadcasts_);
        static_cast<void>(node_->send({.command_code = broadcast_code,
                                       .destination = {255, component_id, 255, 255},
                                       .source = component_of(mine_)},
                                      bytes{body}, now()));
    }
    [[nodiscard]] jaus::address some_other() {
        return component_of((mine_ + 1 + random_.below(node_ids.size() - 1)) % node_ids.size());
    }
    void ask_time() {
        static_cast<void>(
            node_->send({.destination = some_other(), .source = component_of(mine_)}, jaus::query_time{3}, now()));
    }
    // By a wall clock that is off by up to two days, before or behind.
    void set_time() {
        constexpr time start = std::chrono::hours{24} * 365 * 40, most = std::chrono::hours{48};
        const auto stamps = jaus::stamps_of(jaus::civil_time{start + world_.now() + random_.between(-most, most)});
        static_cast<void>(node_->send({.destination = some_other(), .source = component_of(mine_)},
                                      jaus::set_time{stamps.time_stamp, stamps.date_stamp}, now()));
    }
    [[nodiscard]] static std::optional<time> time_in(const auto& stamps) {
        if (!stamps.time_stamp || !stamps.date_stamp) return std::nullopt;
        const auto of_day = jaus::time_of_day(*stamps.time_stamp);
        const auto date = jaus::date_of(*stamps.date_stamp);
        if (!of_day || !date) return std::nullopt;
        return time{date->time_since_epoch()} + *of_day;
    }

    void sent(bytes message) {
        const auto m = jaus::split(message);
        if (!m || m.header.source != component_of(mine_)) return;
        const auto& head = m.header;
        if (head.command_code == jaus::command_code_of<jaus::report_time>) {
            jaus::report_time told{};
            if (!wire::decode(told, m.body)) return;
            if (const auto is = time_in(told)) judge_.reports_time(mine_, *is);
        }
        const bool is_report = head.command_code == jaus::command_code_of<jaus::event> ||
                               (head.command_code == report_code && head.service_connection);
        const auto to = node_of(head.destination);
        if (is_report && to) judge_.sends_report(mine_, *to);
    }
    void heard(const jaus::header& head, bytes body, jaus::component_outcome what) {
        if (head.command_code != jaus::command_code_of<jaus::set_time> || what != jaus::component_outcome::handled)
            return;
        jaus::set_time told{};
        if (!wire::decode(told, body)) return;
        const auto is = time_in(told);
        if (!is) return;
        if (clock_ && *is < *clock_ + local()) world_.faults.note(fault::wall_clock_back);
        clock_ = *is - local();
        judge_.sets_time(mine_, *is);
    }

    struct application {
        peer_program& mine;
        jaus::message_outcome operator()(const jaus::header& head, bytes body) const {
            if (head.command_code != broadcast_code) return jaus::message_outcome::unhandled;
            const auto from = node_of(head.source);
            const auto number = read_as<std::uint32_t>(body);
            if (from && number) mine.judge_.gets_broadcast(mine.mine_, *from, *number);
            return jaus::message_outcome::handled;
        }
    } application_{*this};
    struct filler {
        peer_program& mine;
        std::optional<std::size_t> operator()(std::uint16_t, std::uint32_t, std::span<std::byte> body) const {
            return mine.write_report(body);
        }
    } filler_{*this};
    struct event_filler {
        peer_program& mine;
        std::optional<std::size_t> operator()(std::uint16_t, bytes, std::span<std::byte> body) const {
            return mine.write_report(body);
        }
    } event_filler_{*this};

    node_judge& judge_;
    const links& links_;
    std::size_t mine_;
    std::vector<subscriber::wish> wishes_{};
    std::optional<unit> unit_{};
    std::optional<net::node_machine> node_{};
    std::uint32_t count_{}, broadcasts_{};
    std::optional<time> clock_{};
    time still_until_{};
};

class nodes final : public node_system {
  public:
    nodes(world& w, std::uint32_t absent)
        : world_{w}, network_{w}, judge_{w, network_}, links_{.has_primaries = w.stream(1000).below(3) != 0} {
        for (std::size_t i = 0; i != node_ids.size(); ++i)
            programs_.push_back(std::make_unique<peer_program>(w, network_, judge_, links_, i));
        for (std::size_t i = 0; i != node_ids.size(); ++i)
            for (std::size_t other = i + 1; other != node_ids.size(); ++other) judge_.connect(links_.path(i, other));
        for (auto& each : programs_) each->plan();
        network_.start();
        for (auto& each : programs_)
            if ((absent >> each->number() & 1U) == 0) each->start();
        w.check = [this] { check(); };
    }

  private:
    void check() {
        memory_.look();
        if (world_.now() - checked_ < milliseconds{10}) return;
        checked_ = world_.now();
        // What has to come back after a disturbance takes time.
        network_.set_calm(world_.now() / seconds{1} % 60 >= 30);
        for (auto& each : programs_) each->check();
        judge_.check_reports();
        judge_.check_broadcasts();
    }

    world& world_;
    network network_;
    node_judge judge_;
    links links_;
    std::vector<std::unique_ptr<peer_program>> programs_{};
    memory_watch memory_{world_};
    time checked_{};
};

} // namespace

std::unique_ptr<node_system> make_node_system(world& w, std::uint32_t absent) {
    return std::make_unique<nodes>(w, absent);
}

} // namespace simulation
