#include "simulation/recorded_runs.hpp"

#include <atomic>
#include <chrono>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace simulation {

std::vector<recorded_run> read_recorded_runs(const std::string& path) {
    std::ifstream file{path};
    if (!file) throw std::runtime_error{path + ": cannot be read"};
    std::vector<recorded_run> found;
    std::string line, note;
    for (unsigned number = 1; std::getline(file, line); ++number) {
        if (line.empty() || line.front() == '#') {
            note += line + '\n';
            continue;
        }
        std::istringstream fields{line};
        std::string system;
        long seconds{};
        recorded_run one{.note = std::exchange(note, {})};
        fields >> system >> one.what.seed >> seconds;
        const auto kind = system_of(system);
        if (!fields || !kind)
            throw std::runtime_error{path + ':' + std::to_string(number) +
                                     ": is not SYSTEM SEED SECONDS DIGEST: " + line};
        fields >> std::hex >> one.digest;
        one.what.system = *kind;
        one.what.length = std::chrono::seconds{seconds};
        found.push_back(std::move(one));
    }
    return found;
}

std::string line_of(const recorded_run& one) {
    std::ostringstream text;
    text << one.note << name_of(one.what.system) << ' ' << one.what.seed << ' '
         << one.what.length / std::chrono::seconds{1} << ' ' << std::hex << std::setw(16) << std::setfill('0')
         << one.digest << '\n';
    return text.str();
}

std::vector<recorded_run> renewed(std::vector<recorded_run> runs, unsigned jobs) {
    std::atomic<std::size_t> next{};
    const auto work = [&] {
        for (std::size_t i = next++; i < runs.size(); i = next++) {
            const auto result = run(runs[i].what);
            runs[i].digest = result.digest;
            runs[i].breaks = result.broken.has_value();
        }
    };
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i != jobs; ++i) workers.emplace_back(work);
    workers.clear();
    return runs;
}

} // namespace simulation
