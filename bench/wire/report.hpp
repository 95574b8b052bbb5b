// What was measured on the wire: a table for people, and JSON with the histograms for a plot.
#pragma once

#include "../measuring.hpp"
#include <jauscat/net/link/latency_histogram.hpp>

#include <cstdio>
#include <deque>
#include <optional>
#include <string>

namespace wire_bench {

using namespace measuring;
using nanoseconds = std::chrono::nanoseconds;

struct row {
    std::string name{};
    jauscat::net::latency_histogram times{};
    std::optional<double> frames{}; ///< that the master sent, each time
    nanoseconds cpu{};              ///< of the measuring thread, each time
};

/// The row's work done `count` times, and a tenth of that before, unmeasured.
template <class Work> void measure(row& into, unsigned count, Work work) {
    using clock = std::chrono::steady_clock;
    for (unsigned i = 0; i != count / 10; ++i) work();
    const auto cpu = cpu_time();
    for (unsigned i = 0; i != count; ++i) {
        const auto start = clock::now();
        work();
        into.times.add(clock::now() - start);
    }
    into.cpu = (cpu_time() - cpu) / count;
}

/// The row as a line of a Markdown table.
inline void print(const row& r) {
    std::printf("| %s | %llu | %.1f | %.1f | %.1f | %.1f |", r.name.c_str(),
                static_cast<unsigned long long>(r.times.count()), us(r.times.quantile(0.5)), us(r.times.quantile(0.99)),
                us(r.times.quantile(0.999)), us(r.times.max()));
    r.frames ? std::printf(" %.2f |", *r.frames) : std::printf(" |");
    r.cpu != nanoseconds{} ? std::printf(" %.1f |\n", us(r.cpu)) : std::printf(" |\n");
    std::fflush(stdout);
}
inline void print_head() {
    std::printf("| microseconds | times | median | 99 %% | 99.9 %% | max | frames | CPU |\n"
                "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
}

/// One line for each row and one for each bucket. False when the file cannot be written.
inline bool write_json(const std::deque<row>& rows, const std::string& path) {
    auto* const file = std::fopen(path.c_str(), "w");
    if (file == nullptr) return false;
    std::fprintf(file, "{\n\"rows\": [\n");
    const char* separator = "";
    for (const auto& r : rows) {
        std::fprintf(file,
                     "%s{\"name\": \"%s\", \"count\": %llu, \"min_us\": %.3f, \"median_us\": %.3f, \"p99_us\": %.3f, "
                     "\"p999_us\": %.3f, \"max_us\": %.3f, \"frames\": ",
                     separator, r.name.c_str(), static_cast<unsigned long long>(r.times.count()), us(r.times.min()),
                     us(r.times.quantile(0.5)), us(r.times.quantile(0.99)), us(r.times.quantile(0.999)),
                     us(r.times.max()));
        r.frames ? std::fprintf(file, "%.3f", *r.frames) : std::fprintf(file, "null");
        std::fprintf(file, ", \"cpu_us\": %.3f}", us(r.cpu));
        separator = ",\n";
    }
    std::fprintf(file, "\n],\n\"buckets\": [\n");
    separator = "";
    for (const auto& r : rows)
        r.times.for_each_bucket([&](nanoseconds from, nanoseconds below, std::uint64_t count) {
            std::fprintf(file, "%s{\"name\": \"%s\", \"from_us\": %.3f, \"below_us\": %.3f, \"count\": %llu}",
                         separator, r.name.c_str(), us(from), us(below), static_cast<unsigned long long>(count));
            separator = ",\n";
        });
    std::fprintf(file, "\n]\n}\n");
    return std::fclose(file) == 0;
}

} // namespace wire_bench
