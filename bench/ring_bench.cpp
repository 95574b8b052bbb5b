// Measures a master with many slaves on a pair of virtual Ethernet interfaces, jc0 and jc1: see scripts/measure wire.
#include "support/program.hpp"
#include "wire/bridge_end.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>
#include <unistd.h>

namespace {

using namespace wire_bench;
using std::chrono::microseconds, std::chrono::milliseconds, std::chrono::seconds;
using json = nlohmann::ordered_json;

constexpr const char* help =
    R"(ring_bench: a master on jc0 and many slaves, a process of their own, on jc1: scripts/measure wire runs it.
)";

double ms(nanoseconds time) { return us(time) / 1000; }

json histogram(const jauscat::net::latency_histogram& times) {
    json all = json::array();
    times.for_each_bucket(
        [&](nanoseconds from, nanoseconds below, std::uint64_t count) { all.push_back({us(from), us(below), count}); });
    return all;
}
json summary(const jauscat::net::latency_histogram& times) {
    return {{"count", times.count()},
            {"min_us", us(times.min())},
            {"median_us", us(times.quantile(0.5))},
            {"p99_us", us(times.quantile(0.99))},
            {"max_us", us(times.max())},
            {"histogram", histogram(times)}};
}

class bench {
  public:
    explicit bench(const boost::program_options::variables_map& values)
        : count_{values["count"].as<unsigned>()},
          time_{seconds{values["seconds"].as<unsigned>()}},
          busy_poll_{microseconds{values["busy-poll"].as<unsigned>()}},
          only_orders_{values["orders"].as<bool>()},
          json_{values["json"].as<std::string>()} {
        if (!values["no-pin"].as<bool>() && std::thread::hardware_concurrency() > 1) other_processor_ = 1;
        if (other_processor_ == 1) pin(0);
    }

    int run() {
        if (!only_orders_) bring_ups(), cycles();
        orders();
        if (!only_orders_) downloads();
        if (json_.empty()) return example::success;
        std::ofstream file{json_};
        file << results_.dump(1) << "\n";
        if (!file.flush()) throw std::runtime_error{"cannot write " + json_};
        return example::success;
    }

  private:
    [[nodiscard]] chain_options chain(std::size_t slaves) const {
        return {.slaves = slaves, .busy_poll = busy_poll_, .processor = other_processor_};
    }
    static void begin(const std::string& what) {
        if (example::stop_requested) throw std::runtime_error{"interrupted"};
        std::fprintf(stderr, "ring_bench: %s\n", what.c_str());
        ::alarm(300); // ends a measurement that hangs
    }

    void bring_ups() {
        std::printf("| slaves | to | times | frames | bytes | wire ms | median ms | 99 %% ms | CPU ms |\n"
                    "| ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
        for (const std::size_t slaves : {1U, 16U, 64U, 256U}) {
            begin("bring-up of " + std::to_string(slaves) + " slaves");
            const slave_process there{chain(slaves)};
            master_end master{slaves, busy_poll_};
            measured to_pre_op, to_safe_op;
            const auto times = std::clamp<std::size_t>(count_ / (10 * slaves), 5, 200);
            for (std::size_t i = 0; i != times && !example::stop_requested; ++i) {
                master.to_pre_op(to_pre_op);
                master.to_safe_op(to_safe_op);
            }
            for (const auto& [to, all] : {std::pair{"PRE-OP", &to_pre_op}, {"SAFE-OP", &to_safe_op}}) {
                std::printf("| %zu | %s | %llu | %.0f | %.0f | %.2f | %.2f | %.2f | %.2f |\n", slaves, to,
                            static_cast<unsigned long long>(all->times.count()), all->each(all->sent.frames),
                            all->each(all->sent.bytes), all->each(ms(all->sent.wire)), ms(all->times.quantile(0.5)),
                            ms(all->times.quantile(0.99)), all->each(ms(all->cpu)));
                results_["bring_up"].push_back({{"slaves", slaves},
                                                {"to", to},
                                                {"frames", all->each(all->sent.frames)},
                                                {"bytes", all->each(all->sent.bytes)},
                                                {"wire_us", all->each(us(all->sent.wire))},
                                                {"cpu_us", all->each(us(all->cpu))},
                                                {"time", summary(all->times)}});
            }
        }
        std::printf("\n");
    }

    void cycles() {
        std::printf("| slaves | watched | period us | frames | bytes | wire us | late 99 %% | inputs 50 %% | inputs 99 "
                    "%% | lost "
                    "| CPU | CPU of the slaves |\n"
                    "| ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
        for (const std::size_t slaves : {6U, 32U, 100U})
            for (const bool watched : {false, true})
                for (const microseconds period : {microseconds{1000}, microseconds{250}})
                    cycle(slaves, watched, period);
        std::printf("\n");
    }
    void cycle(std::size_t slaves, bool watched, microseconds period) {
        begin("cycle of " + std::to_string(period.count()) + " us with " + std::to_string(slaves) + " slaves" +
              (watched ? ", watched" : ""));
        const slave_process there{chain(slaves)};
        master_end master{slaves, busy_poll_};
        measured unused;
        master.to_pre_op(unused);
        master.to_safe_op(unused);
        const auto cpu = there.cpu_time();
        const auto wire = master.wire_time(watched);
        if (wire > period) {
            std::printf("| %zu | %s | %lld | | | %.1f | | | | | | |\n", slaves, watched ? "yes" : "no",
                        static_cast<long long>(period.count()), us(wire));
            return;
        }
        const auto all = master.cycle(period, watched, time_);
        const auto each = [&](auto sum) {
            return static_cast<double>(sum) / static_cast<double>(std::max<std::uint64_t>(all.cycles, 1));
        };
        const auto slaves_cpu = each(us(there.cpu_time() - cpu));
        const auto lost = 100 * each(all.lost);
        std::printf("| %zu | %s | %lld | %.0f | %.0f | %.1f | %.1f | %.1f | %.1f | %.2f %% | %.1f | %.1f |\n", slaves,
                    watched ? "yes" : "no", static_cast<long long>(period.count()), each(all.sent.frames),
                    each(all.sent.bytes), each(us(all.sent.wire)), us(all.late.quantile(0.99)),
                    us(all.back.quantile(0.5)), us(all.back.quantile(0.99)), lost, each(us(all.cpu)), slaves_cpu);
        results_["cycle"].push_back({{"slaves", slaves},
                                     {"watched", watched},
                                     {"period_us", period.count()},
                                     {"frames", each(all.sent.frames)},
                                     {"bytes", each(all.sent.bytes)},
                                     {"wire_us", each(us(all.sent.wire))},
                                     {"cycles", all.cycles},
                                     {"lost", all.lost},
                                     {"incomplete", all.incomplete},
                                     {"left_out", all.overruns},
                                     {"cpu_us", each(us(all.cpu))},
                                     {"slaves_cpu_us", slaves_cpu},
                                     {"late", summary(all.late)},
                                     {"inputs", summary(all.back)}});
    }

    /// The processor time of a cycle in both orders, beside a loop by hand, in rounds.
    void orders() {
        constexpr std::size_t slaves = 40;
        constexpr microseconds period{1000};
        constexpr int rounds = 5;
        std::printf("| cycle of 40 slaves | CPU | by hand | ratio | lost | by hand |\n"
                    "| --- | ---: | ---: | ---: | ---: | ---: |\n");
        for (const auto& [name, order] :
             {std::pair{"sends first", cycle_order::send_first}, {"receives first", cycle_order::receive_first}}) {
            begin(std::string{"cycle that "} + name);
            const slave_process there{chain(slaves)};
            master_end master{slaves, busy_poll_};
            measured unused;
            master.to_pre_op(unused);
            master.to_safe_op(unused);
            master_end::cycle_result ours, by_hand;
            const auto add = [](master_end::cycle_result& to, const master_end::cycle_result& more) {
                to.cpu += more.cpu;
                to.cycles += more.cycles;
                to.lost += more.lost;
            };
            for (int i = 0; i != rounds; ++i) {
                add(ours, master.cycle(period, false, time_ / rounds, order));
                add(by_hand, master.cycle_by_hand(period, time_ / rounds, order));
            }
            const auto each = [](const master_end::cycle_result& of) {
                return us(of.cpu) / static_cast<double>(std::max<std::uint64_t>(of.cycles, 1));
            };
            std::printf("| %s | %.1f | %.1f | %.2f | %llu of %llu | %llu of %llu |\n", name, each(ours), each(by_hand),
                        each(ours) / each(by_hand), static_cast<unsigned long long>(ours.lost),
                        static_cast<unsigned long long>(ours.cycles), static_cast<unsigned long long>(by_hand.lost),
                        static_cast<unsigned long long>(by_hand.cycles));
            results_["orders"].push_back({{"order", name},
                                          {"slaves", slaves},
                                          {"cpu_us", each(ours)},
                                          {"by_hand_us", each(by_hand)},
                                          {"lost", ours.lost},
                                          {"lost_by_hand", by_hand.lost}});
        }
        std::printf("\n");
    }

    void downloads() {
        std::printf(
            "| downloads to six slaves | slaves answer | times | frames | bytes | median us | 99 %% us | CPU us |\n"
            "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n");
        for (const microseconds application : {microseconds{0}, microseconds{1000}}) {
            auto options = chain(6);
            options.application = application;
            const slave_process there{options};
            bridge_end bridge{options.slaves, busy_poll_};
            for (const bool at_once : {false, true}) {
                const auto* const order = at_once ? "at once" : "one by one";
                const auto* const answers = application.count() == 0 ? "at once" : "once in 1 ms";
                begin(std::string{"downloads "} + order + " to six slaves that answer " + answers);
                measured warm_up, all;
                const auto times = std::max(count_ / (application.count() == 0 ? 5 : 20), 10U);
                for (unsigned i = 0; i != times / 10; ++i) bridge.command_all(warm_up, at_once);
                for (unsigned i = 0; i != times && !example::stop_requested; ++i) bridge.command_all(all, at_once);
                std::printf("| %s | %s | %llu | %.1f | %.0f | %.1f | %.1f | %.1f |\n", order, answers,
                            static_cast<unsigned long long>(all.times.count()), all.each(all.sent.frames),
                            all.each(all.sent.bytes), us(all.times.quantile(0.5)), us(all.times.quantile(0.99)),
                            all.each(us(all.cpu)));
                results_["downloads"].push_back({{"slaves", options.slaves},
                                                 {"at_once", at_once},
                                                 {"application_us", application.count()},
                                                 {"frames", all.each(all.sent.frames)},
                                                 {"bytes", all.each(all.sent.bytes)},
                                                 {"cpu_us", all.each(us(all.cpu))},
                                                 {"time", summary(all.times)}});
            }
        }
    }

    unsigned count_;
    nanoseconds time_;
    nanoseconds busy_poll_;
    bool only_orders_;
    std::string json_;
    int other_processor_ = -1;
    json results_ = json::object();
};

} // namespace

int main(int argc, char** argv) {
    return example::run("ring_bench", [&] {
        namespace po = boost::program_options;
        po::options_description options;
        // clang-format off
        options.add_options()
            ("count", po::value<unsigned>()->default_value(10000), "more or fewer bring-ups and downloads")
            ("seconds", po::value<unsigned>()->default_value(10), "how long each cycle is measured")
            ("busy-poll", po::value<unsigned>()->default_value(50), "microseconds that both links poll before they sleep")
            ("no-pin", po::bool_switch(), "leave it to the system which processor runs master and slaves, instead of one each")
            ("orders", po::bool_switch(), "compares the two orders of a cycle with a loop by hand, and nothing else")
            ("json", po::value<std::string>()->default_value(""), "file for all results and their histograms");
        // clang-format on
        return bench{example::parse(argc, argv, options, help)}.run();
    });
}
