// The program of the simulation: many seeds, or one with its story.
#include "simulation/recorded_runs.hpp"
#include "simulation/simulation.hpp"

#include <boost/program_options.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <mutex>
#include <random>
#include <span>
#include <stdexcept>
#include <thread>

namespace {

using namespace simulation;
namespace po = boost::program_options;
using wall = std::chrono::steady_clock;

constexpr const char* help =
    R"(simulate: whole systems in simulated time, and the contract of docs/safety.md checked after every step.

Each seed is a run of its own: operators, a network, robots, a bridge and its slaves, with faults at random. It replays
exactly. At the first violation the program tries to do with fewer faults and actors, prints what happened, and exits
with 1.

Examples:
  simulate --for 60                    new seeds for a minute
  simulate --hours 10                  ten simulated hours
  simulate --hours 10 --system drives  the same of rings of drives alone
  simulate --seed 4711                 one seed, again
  simulate --seed 4711 --whole         the same with all that happened in the end
  simulate --seed 4711 --trace         the same with all that happens and is sent
  simulate --hours 1 --without process-frozen --without clock-leap
)";

std::atomic<bool> interrupted{};

struct options {
    std::uint64_t first_seed{};
    bool whole{}, keep_going{}, shrinks{true};
    double hours{};   ///< simulated; 0: no limit
    double seconds{}; ///< real; 0: no limit
    unsigned jobs{};
    settings each{};
};

fault_set faults_of(const po::variables_map& values) {
    const auto named = [](const std::string& name) {
        const auto kind = fault_of(name);
        if (!kind) throw std::runtime_error{"there is no fault " + name + "; --list names them"};
        return only(*kind);
    };
    fault_set chosen = every_fault;
    if (values.count("only") != 0) {
        chosen = 0;
        for (const auto& name : values["only"].as<std::vector<std::string>>()) chosen |= named(name);
    }
    if (values.count("without") != 0)
        for (const auto& name : values["without"].as<std::vector<std::string>>()) chosen &= ~named(name);
    return chosen;
}

/// All that the runs have shown so far.
struct totals {
    std::mutex mutex{};
    double simulated{};                             ///< seconds
    std::array<double, 1 + system_count> of_each{}; ///< the same by system
    std::uint64_t steps{}, runs{};
    fault_counts faults{};
    comparison_counts compared{};
    unsigned violations{};

    void add(const run_result& one) {
        simulated += std::chrono::duration<double>(one.length).count();
        of_each[static_cast<std::size_t>(one.system)] += std::chrono::duration<double>(one.length).count();
        steps += one.steps;
        ++runs;
        for (std::size_t i = 0; i != fault_count; ++i) faults[i] += one.faults[i];
        for (std::size_t i = 0; i != compared.size(); ++i) compared[i] += one.compared[i];
        if (one.broken) ++violations;
    }
};

void show_violation(settings what, const run_result& first, const options& chosen) {
    std::printf("\nseed %llu breaks the contract\n", static_cast<unsigned long long>(what.seed));
    std::fflush(stdout);
    if (chosen.shrinks) what = shrink(what, *first.broken);
    const auto again = chosen.shrinks ? run(what) : first;
    std::fputs(story_text(what, again, chosen.whole).c_str(), stdout);
    std::string without;
    for (std::size_t i = 0; i != fault_count; ++i)
        if ((chosen.each.faults & only(static_cast<fault>(i))) == 0)
            without.append(" --without ").append(fault_names[i]);
    std::printf("again: scripts/simulate --system %s --seed %llu --seconds %lld%s\n",
                std::string{name_of(chosen.each.system)}.c_str(), static_cast<unsigned long long>(what.seed),
                static_cast<long long>(chosen.each.length / std::chrono::seconds{1}), without.c_str());
}

void show_progress(totals& all, wall::time_point begin) {
    const std::lock_guard lock{all.mutex};
    const double real = std::chrono::duration<double>(wall::now() - begin).count();
    std::printf("%7.0f s: %9.3f simulated hours, %5.0f times real time, %llu seeds, %llu steps, %u violations\n", real,
                all.simulated / 3600, all.simulated / real, static_cast<unsigned long long>(all.runs),
                static_cast<unsigned long long>(all.steps), all.violations);
    std::fflush(stdout);
}

void show_faults(const totals& all) {
    std::printf("simulated hours:\n");
    for (std::size_t i = 1; i != all.of_each.size(); ++i)
        std::printf("  %-18s %12.3f\n", std::string{name_of(static_cast<system_kind>(i))}.c_str(),
                    all.of_each[i] / 3600);
    std::printf("faults:\n");
    for (std::size_t i = 0; i != fault_count; ++i)
        std::printf("  %-18s %12llu\n", std::string{fault_names[i]}.c_str(),
                    static_cast<unsigned long long>(all.faults[i]));
}

bool waits_for_fault(const totals& all, std::size_t check) {
    const auto needed = needed_by(static_cast<comparison>(check));
    return needed && all.faults[static_cast<std::size_t>(*needed)] == 0;
}

/// Whether each has compared something, as far as the run was long enough for it.
bool show_comparisons(const totals& all) {
    std::printf("comparisons:\n");
    bool is_each = true;
    for (std::size_t i = 0; i != all.compared.size(); ++i) {
        std::printf("  %-42s %12llu\n", std::string{comparison_names[i]}.c_str(),
                    static_cast<unsigned long long>(all.compared[i]));
        is_each = is_each && (all.compared[i] != 0 || waits_for_fault(all, i));
    }
    const bool is_long = std::ranges::all_of(std::span{all.of_each}.subspan(1, system_count - 1),
                                             [](double seconds) { return seconds >= 1800; });
    if (is_each || !is_long) return true;
    std::printf("a check has compared nothing: this run has not proved what it checks\n");
    return false;
}

bool run_seeds(const options& chosen) {
    const auto begin = wall::now();
    totals all{};
    std::atomic<std::uint64_t> next{chosen.first_seed};
    std::atomic<bool> over{};
    const auto work = [&] {
        while (!over && !interrupted) {
            settings what = chosen.each;
            what.seed = next++;
            const auto result = run(what);
            const std::lock_guard lock{all.mutex};
            all.add(result);
            if (result.broken && (!over || chosen.keep_going)) {
                if (!chosen.keep_going) over = true;
                show_violation(what, result, chosen);
            }
            if (chosen.hours != 0 && all.simulated >= chosen.hours * 3600) over = true;
            if (chosen.seconds != 0 && std::chrono::duration<double>(wall::now() - begin).count() >= chosen.seconds)
                over = true;
        }
    };
    {
        std::vector<std::jthread> workers;
        for (unsigned i = 0; i != chosen.jobs; ++i) workers.emplace_back(work);
        auto shown = begin;
        while (!over && !interrupted) {
            std::this_thread::sleep_for(std::chrono::milliseconds{100});
            if (wall::now() - shown < std::chrono::seconds{10}) continue;
            shown = wall::now();
            show_progress(all, begin);
        }
    }
    show_progress(all, begin);
    show_faults(all);
    const bool has_compared = show_comparisons(all);
    if (interrupted) std::printf("interrupted\n");
    return all.violations == 0 && has_compared;
}

bool run_one(const options& chosen) {
    settings what = chosen.each;
    what.seed = chosen.first_seed;
    const auto result = run(what);
    std::printf("seed %llu: %lld simulated seconds, %llu steps, digest %016llx\n",
                static_cast<unsigned long long>(what.seed),
                static_cast<long long>(result.length / std::chrono::seconds{1}),
                static_cast<unsigned long long>(result.steps), static_cast<unsigned long long>(result.digest));
    if (!result.broken) return true;
    show_violation(what, result, chosen);
    return false;
}

int renew(const std::string& path, unsigned jobs) {
    const auto were = read_recorded_runs(path), are = renewed(were, jobs);
    std::string text;
    unsigned changed = 0;
    bool breaks = false;
    for (std::size_t i = 0; i != are.size(); ++i) {
        text += line_of(are[i]);
        if (are[i].breaks) std::fprintf(stderr, "simulate: a run breaks the contract: %s", line_of(are[i]).c_str());
        breaks = breaks || are[i].breaks;
        if (are[i].digest != were[i].digest) ++changed;
    }
    if (breaks) {
        std::fprintf(stderr, "simulate: %s was not changed\n", path.c_str());
        return 1;
    }
    std::ofstream file{path};
    if (!(file << text).flush()) throw std::runtime_error{path + ": cannot be written"};
    std::printf("%s: %zu runs, of which %u have another digest than before\n", path.c_str(), are.size(), changed);
    return 0;
}

int start(int argc, char** argv) {
    po::options_description known;
    // clang-format off
    known.add_options()
        ("help,h", "this text")
        ("list", "names of the faults")
        ("hours", po::value<double>()->default_value(0), "simulated hours; 0: no limit")
        ("for", po::value<double>()->default_value(0), "real seconds; 0: no limit")
        ("seed", po::value<std::uint64_t>(), "only this seed")
        ("from", po::value<std::uint64_t>(), "the first seed; without it a random one, which is printed")
        ("seconds", po::value<long>()->default_value(120), "simulated seconds of each seed")
        ("system", po::value<std::string>()->default_value("any"), "jaus, mailbox, cyclic, mixed, drives, robot, clocks, nodes or joints; any: the seed says")
        ("jobs", po::value<unsigned>()->default_value(std::max(std::thread::hardware_concurrency(), 1U)), "threads")
        ("only", po::value<std::vector<std::string>>(), "only this kind of fault; may be given several times")
        ("without", po::value<std::vector<std::string>>(), "without this kind of fault")
        ("trace", po::bool_switch(), "with --seed: all that happens and is sent, a line for each")
        ("renew", po::value<std::string>(), "write the digests of the runs in this file, see recorded_runs.txt")
        ("whole", po::bool_switch(), "the whole end of the story, not only what matters")
        ("no-shrink", po::bool_switch(), "do not look for fewer faults and actors that break the contract too")
        ("keep-going", po::bool_switch(), "go on after a violation");
    // clang-format on
    po::variables_map values;
    po::positional_options_description positional;
    positional.add("hours", 1);
    po::store(po::command_line_parser{argc, argv}.options(known).positional(positional).run(), values);
    if (values.count("help") != 0) {
        std::cout << help << "\nOptions:\n" << known;
        return 0;
    }
    if (values.count("list") != 0) {
        for (const auto name : fault_names) std::cout << name << '\n';
        return 0;
    }
    options chosen{.whole = values["whole"].as<bool>(),
                   .keep_going = values["keep-going"].as<bool>(),
                   .shrinks = !values["no-shrink"].as<bool>(),
                   .hours = values["hours"].as<double>(),
                   .seconds = values["for"].as<double>(),
                   .jobs = std::max(values["jobs"].as<unsigned>(), 1U),
                   .each = {.length = std::chrono::seconds{values["seconds"].as<long>()}, .faults = faults_of(values)}};
    const auto system = system_of(values["system"].as<std::string>());
    if (!system)
        throw std::runtime_error{
            "--system is any, jaus, mailbox, cyclic, mixed, drives, robot, clocks, nodes or joints"};
    chosen.each.system = *system;
    if (values.count("renew") != 0) return renew(values["renew"].as<std::string>(), chosen.jobs);
    if (values["trace"].as<bool>()) {
        if (values.count("seed") == 0) throw std::runtime_error{"--trace needs --seed: it shows one run"};
        chosen.each.trace = &std::cout;
    }
    if (values.count("seed") != 0) {
        chosen.first_seed = values["seed"].as<std::uint64_t>();
        return run_one(chosen) ? 0 : 1;
    }
    chosen.first_seed =
        values.count("from") != 0 ? values["from"].as<std::uint64_t>() : std::uint64_t{std::random_device{}()} << 16U;
    std::printf("seeds from %llu\n", static_cast<unsigned long long>(chosen.first_seed));
    return run_seeds(chosen) ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    std::signal(SIGINT, [](int) { interrupted = true; });
    std::signal(SIGTERM, [](int) { interrupted = true; });
    try {
        return start(argc, argv);
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "simulate: %s\n", problem.what());
        return 2;
    }
}
