// Prints, when all repetitions are done, the median times of each pair and their ratio.
#pragma once
#include "pair.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <vector>

namespace bench {

class ratio_reporter : public benchmark::BenchmarkReporter {
  public:
    bool ReportContext(const Context&) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const auto& run : runs) {
            if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
            const std::string_view name = run.run_name.function_name;
            const auto slash = name.rfind('/');
            auto& times = times_[std::string{name.substr(0, slash)}];
            (name.substr(slash) == jauscat_suffix ? times.jauscat : times.hand_written)
                .push_back(run.GetAdjustedCPUTime());
        }
    }

    void Finalize() override {
        std::printf("%-70s %10s %14s %7s\n", "", "jauscat/ns", "hand-written/ns", "ratio");
        for (auto& [name, times] : times_) {
            if (times.jauscat.empty() || times.hand_written.empty()) continue;
            const double ours = median(times.jauscat), theirs = median(times.hand_written);
            std::printf("%-70s %10.2f %15.2f %7.2f\n", name.c_str(), ours, theirs, ours / theirs);
        }
        std::printf("Median of %zu interleaved repetitions; CPU time for one message.\n",
                    times_.empty() ? 0 : times_.begin()->second.jauscat.size());
    }

  private:
    struct samples {
        std::vector<double> jauscat{}, hand_written{};
    };

    static double median(std::vector<double>& times) {
        const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
        std::nth_element(times.begin(), middle, times.end());
        return *middle;
    }

    std::map<std::string, samples> times_;
};

} // namespace bench
