// Two nodes that talk over a bad network for a long time. What must not happen: a command that is acknowledged and not
// done, or done twice; a heartbeat missed; control that is not as it was given; memory that grows.
#include "soak/memory.hpp"
#include "soak/operator_end.hpp"
#include "soak/relay.hpp"
#include "soak/robot_end.hpp"
#include "support/allocations.hpp"
#include "support/free_ports.hpp"
#include "support/program.hpp"

#include <cstdio>

namespace {

using namespace soak;
using std::chrono::seconds;

constexpr const char* help = R"(soak: two nodes that talk over a bad network for a long time.

  soak [SECONDS] [options]

A robot and an operator, each a JAUS node with a thread of its own, joined over the loopback interface by a relay that
loses datagrams. For SECONDS (600; in steps of 10, at least 20) there are, at the same time:
  1000 Set Wrench Effort each second, acknowledged, each with a value of its own
  heartbeats both ways, 5 each second
  large data sets both ways, 64 KiB to 1 MiB, 3 each second, acknowledged
  control of the robot, which is requested, taken over by a higher authority, given back and released, every 10 s
At the end the relay is cut, which both must notice. Ctrl-C ends the run early, and the checks are made all the same.

Exit code: 0 all was as it must be; 1 something was not; 2 wrong arguments.

Examples:
  soak                 10 minutes
  soak 30              half a minute
  soak 60 --loss 5     a worse network
)";

struct arguments {
    unsigned seconds{600}, loss{1}, seed{1};
};

arguments read(int argc, char** argv) {
    namespace po = boost::program_options;
    arguments found{};
    po::options_description options;
    // clang-format off
    options.add_options()
        ("seconds", po::value(&found.seconds), "how long, up to a day; --seconds itself may be left out")
        ("loss", po::value(&found.loss), "percent of the datagrams that the relay loses each way, 0 to 20; 1 unless given")
        ("seed", po::value(&found.seed), "which ones it loses; 1 unless given");
    // clang-format on
    po::positional_options_description positional;
    positional.add("seconds", 1);
    static_cast<void>(example::parse(argc, argv, options, help, positional));
    if (found.seconds == 0 || found.seconds > 86'400) throw example::usage_error{"SECONDS must be 1 to 86400"};
    if (found.loss > 20) throw example::usage_error{"--loss must be 0 to 20"};
    found.seconds = std::max(20U, (found.seconds + 9) / 10 * 10);
    return found;
}

/// This end listens at `own`; it finds the other at `other`, which is a port of the relay.
net::jaus_config config(bool of_robot, std::uint16_t own, std::uint16_t other) {
    const auto ip = boost::asio::ip::make_address("127.0.0.1");
    net::system_entry op{.name = "operator", .jausip = {.subsystem = 1}, .ip = ip, .port = of_robot ? other : own};
    net::system_entry robot{.name = "robot", .jausip = {.subsystem = 2}, .ip = ip, .port = of_robot ? own : other};
    // Two data sets of 1 MiB and more at a time, for each of two components.
    op.limits.large_data_memory = robot.limits.large_data_memory = std::size_t{16} << 20U;
    return {.this_system = of_robot ? "robot" : "operator", .systems = {op, robot}, .source = "soak"};
}

/// Waits, looking every 10 ms.
bool wait_until(nanoseconds patience, auto&& so) {
    const auto deadline = net::jaus_node::now() + patience;
    while (!so()) {
        if (net::jaus_node::now() >= deadline) return false;
        std::this_thread::sleep_for(10ms);
    }
    return true;
}

double ms(nanoseconds time) { return static_cast<double>(time.count()) / 1e6; }
double mib(std::size_t bytes) { return static_cast<double>(bytes) / (1U << 20U); }
unsigned long long number(std::uint64_t n) { return n; }

class run {
  public:
    explicit run(const arguments& a)
        : wanted_{a}, relay_{a.loss / 100.0, a.seed}, book_{std::size_t{a.seconds} * 1100 + 5000} {
        const auto ports = support::free_ports<2>();
        relay_.start(ports);
        operator_.emplace(config(false, ports[0], relay_.port(0)), book_, a.seconds / 10);
        robot_.emplace(config(true, ports[1], relay_.port(1)), book_);
        operator_->start();
        robot_->start();
    }

    int operator()() {
        check("the nodes hear each other", wait_until(10s, [&] { return operator_->appeared && robot_->appeared; }));
        if (failed_) return finish();
        operator_->begin();
        work();
        const auto found = cut_and_stop();
        print(found);
        judge(found);
        return finish();
    }

  private:
    /// What there is to say when both have ended.
    struct findings {
        // before the relay was cut
        std::size_t memory{};
        std::array<net::udp_counters, 2> counts{};
        std::array<std::vector<std::string>, 2> notes{};
        std::array<end::pauses, 2> paused{};
        unsigned missed_heartbeats{};
        bool controlled{}; ///< by the operator
        // and after it
        bool noticed{};
        std::vector<std::optional<jaus::address>> controllers{}; ///< of the robot, one after the other
        std::uint64_t no_capacity{}, repeated{};                 ///< messages at the robot
        std::vector<std::string> failures{};                     ///< of the scene
        ledger::balance efforts{};
    };

    /// Until all is sent and has its outcome.
    void work() {
        const auto start = net::jaus_node::now();
        const auto end = start + seconds{wanted_.seconds};
        auto next_large = start, next_line = start + 10s, next_peek = start + 10s;
        bool ending = false;
        while (!operator_->done) {
            std::this_thread::sleep_for(50ms);
            const auto now = net::jaus_node::now();
            if (example::stop_requested && !ending) {
                std::printf("interrupted: what is under way is brought to its end\n");
                operator_->end_early();
                ending = true;
            }
            if (now >= end || ending) {
                ending = true;
                if (now > end + 30s) break; // then the checks tell
                continue;
            }
            if (now >= next_large) {
                next_large += 333ms;
                operator_->send_large();
                robot_->send_large();
            }
            memory_.look();
            if (now >= next_peek) {
                next_peek += 10s;
                memory_.next_window();
            }
            if (now >= next_line) {
                next_line += 10s;
                progress(std::chrono::duration_cast<seconds>(now - start));
            }
        }
        wait_until(20s, [&] { return all_through(operator_->large) && all_through(robot_->large); });
        std::this_thread::sleep_for(100ms);
    }
    /// Cuts the relay, and ends both.
    findings cut_and_stop() {
        findings found{.memory = memory_.peek(),
                       .counts = {operator_->counts(), robot_->counts()},
                       .notes = {operator_->notes(), robot_->notes()},
                       .paused = {operator_->paused(), robot_->paused()},
                       .missed_heartbeats = operator_->disappeared + robot_->disappeared};
        found.controllers = robot_->controllers();
        found.controlled = !found.controllers.empty() && found.controllers.back() == operator_id;

        relay_.cut();
        found.noticed = wait_until(5s, [&] { return operator_->disappeared && robot_->disappeared; });
        found.controllers = robot_->controllers();
        found.no_capacity = robot_->count(jaus::component_outcome::no_capacity);
        found.repeated = robot_->count(jaus::component_outcome::repeated);
        found.failures = operator_->failures();
        operator_->stop();
        robot_->stop();
        found.efforts = book_.close();
        return found;
    }

    void print(const findings& found) const {
        const auto& b = found.efforts;
        std::printf("\nefforts: %zu sent (%llu repeats came to the robot), %zu acknowledged, %zu refused for want of "
                    "control, %zu ended with the loss of control, %llu held back\n",
                    b.sent, number(found.repeated), b.acknowledged, b.refused, b.control_lost,
                    number(operator_->held_back));
        std::printf("  acknowledged after      p50 %.3f ms, p99 %.3f ms, p99.9 %.3f ms, max %.3f ms\n",
                    ms(operator_->latency.quantile(0.5)), ms(operator_->latency.quantile(0.99)),
                    ms(operator_->latency.quantile(0.999)), ms(operator_->latency.max()));
        std::printf("  those not repeated      p50 %.3f ms, p99 %.3f ms\n", ms(operator_->first_try.quantile(0.5)),
                    ms(operator_->first_try.quantile(0.99)));
        for (const auto& [name, from, to] : {std::tuple{"operator to robot", &operator_->large, &robot_->large},
                                             std::tuple{"robot to operator", &robot_->large, &operator_->large}})
            std::printf("large data sets, %s: %llu sent, %llu acknowledged, %llu arrived intact, %llu damaged, %llu "
                        "twice, %llu not begun for want of room\n",
                        name, number(from->counts.sent), number(from->counts.acknowledged), number(to->counts.intact),
                        number(to->counts.damaged), number(to->counts.repeated), number(from->counts.not_sent));
        std::printf(
            "heartbeats: %llu at the operator, %llu at the robot; control: %u scenes, the slowest step took %.0f "
            "ms\n",
            number(operator_->heartbeats), number(robot_->heartbeats), operator_->cycles_done,
            ms(operator_->steps.max()));
        for (std::size_t end : {0U, 1U})
            std::printf("datagrams from the %s: %llu, of which the relay lost %llu (the cut included); its node: %s\n",
                        end == 0 ? "operator" : "robot", number(relay_.of(end).taken), number(relay_.of(end).lost),
                        net::summary(found.counts[end]).c_str());
        for (std::size_t i : {0U, 1U})
            std::printf("pauses of the %s: the longest %.0f ms; %u packets dropped, which waited in the socket\n",
                        i == 0 ? "operator" : "robot", ms(found.paused[i].longest), found.paused[i].dropped);
        std::printf("memory: %.2f MiB after the warm-up, %.2f MiB at the end\n\n", mib(memory_.first()),
                    mib(found.memory));
        for (const auto& lines : found.notes)
            for (const auto& line : lines) std::printf("log: %s\n", line.c_str());
        for (const auto& line : found.failures) std::printf("missed: %s\n", line.c_str());

        if (b.lost + b.twice + b.refused_done + b.unknown + b.timed_out + b.without_outcome + b.forbidden_done != 0)
            std::printf(
                "efforts that went wrong: %zu lost, %zu applied twice, %zu refused and applied, %zu never sent, %zu "
                "timed out, %zu without an outcome, %zu of %zu taken without control\n",
                b.lost, b.twice, b.refused_done, b.unknown, b.timed_out, b.without_outcome, b.forbidden_done,
                b.forbidden);
    }
    void judge(const findings& found) {
        const auto& b = found.efforts;
        check("every effort has one outcome, none timed out", b.without_outcome == 0 && b.timed_out == 0);
        check("every acknowledged effort was applied", b.lost == 0 && b.acknowledged > 0);
        check("no effort was applied twice", b.twice == 0);
        check("no refused effort was applied, nor one that nobody sent", b.refused_done == 0 && b.unknown == 0);
        check("every effort without control was refused", b.forbidden_done == 0 && b.forbidden > 0);
        check("nothing was dropped for want of places", found.no_capacity == 0);
        check("no heartbeat timed out while the network was there", found.missed_heartbeats == 0);
        check("both noticed that it was cut, and the robot has no controller then",
              found.noticed && found.controlled && !found.controllers.empty() && !found.controllers.back());
        check("control went as in the scene", found.failures.empty() && found.controllers == expected_controllers());
        check("every large data set arrived once, as it was sent", all_arrived());
        check("memory is flat (at most 1 MiB or 2 % more)",
              found.memory <= memory_.first() + std::max(std::size_t{1} << 20U, memory_.first() / 50));
        // Dropped after a quarter of the pause; half of that may be the time to read what came meanwhile.
        check("no packet waited in a socket but while its node's thread stood still",
              std::ranges::all_of(found.paused, [](const end::pauses& p) {
                  return p.dropped == 0 || p.longest >= large_data_pause / 8;
              }));
        check("neither node has anything in its log", found.notes[0].empty() && found.notes[1].empty());
    }
    static bool all_through(const large_traffic& large) {
        return large.counts.acknowledged + large.counts.failed == large.counts.sent;
    }
    bool all_arrived() const {
        const auto one_way = [](const large_traffic::counters& from, const large_traffic::counters& to) {
            return from.sent > 0 && from.acknowledged == from.sent && to.intact == from.sent && to.damaged == 0 &&
                   to.repeated == 0;
        };
        return one_way(operator_->large.counts, robot_->large.counts) &&
               one_way(robot_->large.counts, operator_->large.counts);
    }
    /// The scene as the robot saw it, then the operator's control until the cut.
    std::vector<std::optional<jaus::address>> expected_controllers() const {
        std::vector<std::optional<jaus::address>> all;
        for (unsigned i = 0; i != operator_->cycles_done; ++i)
            for (const auto& who :
                 {std::optional{operator_id}, std::optional{supervisor_id}, std::optional<jaus::address>{},
                  std::optional{operator_id}, std::optional<jaus::address>{}})
                all.push_back(who);
        all.emplace_back(operator_id);
        all.emplace_back(std::nullopt);
        return all;
    }
    void progress(seconds at) {
        const auto sent = operator_->sent.load(), delivered = operator_->delivered.load();
        const std::uint64_t taken = support::allocations();
        std::printf(
            "%5lld s: %llu efforts sent (%llu/s), %llu without an outcome yet; large sets %llu and %llu intact; "
            "%.2f MiB, %llu allocations/s\n",
            static_cast<long long>(at.count()), number(sent), number((sent - last_sent_) / 10),
            number(sent - std::min(sent, delivered)), number(robot_->large.counts.intact),
            number(operator_->large.counts.intact), mib(memory_.lowest()), number((taken - last_allocations_) / 10));
        std::fflush(stdout);
        last_sent_ = sent;
        last_allocations_ = taken;
    }
    void check(const char* what, bool good) {
        std::printf("%-6s %s\n", good ? "ok" : "FAILED", what);
        failed_ = failed_ || !good;
    }
    int finish() {
        std::printf("%s\n", failed_ ? "FAILED" : "all as it must be");
        return failed_ ? 1 : 0;
    }

    arguments wanted_;
    lossy_relay relay_;
    ledger book_;
    std::optional<operator_end> operator_{};
    std::optional<robot_end> robot_{};
    resident_memory memory_{};
    std::uint64_t last_sent_{}, last_allocations_{};
    bool failed_{};
};

} // namespace

int main(int argc, char** argv) {
    return example::run("soak", [&] {
        const auto wanted = read(argc, argv);
        large_blocks_go_back();
        std::printf("%u s, %u %% of the datagrams are lost each way, seed %u\n", wanted.seconds, wanted.loss,
                    wanted.seed);
        std::fflush(stdout);
        return run{wanted}();
    });
}
