// Pairs of benchmarks: the library's code and code written by hand, for the same work on the same data.
#pragma once
#include <benchmark/benchmark.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bench {

inline constexpr std::string_view jauscat_suffix = "/jauscat", hand_written_suffix = "/hand-written";

/// One side of a pair, once over all of its items: what an instruction counter runs.
struct counted_work {
    std::string name{};
    std::size_t items{};
    std::function<void()> run{};
};
inline std::vector<counted_work> all_work;

/// Registers a pair: `jauscat(item)` over one set of items and `hand_written(item)` over another. The items must
/// outlive the run; their number is a power of two.
template <class Ours, class Theirs>
void pair(const std::string& name, std::span<Ours> our_items, auto jauscat, std::span<Theirs> their_items,
          auto hand_written) {
    const auto add = [&name](std::string_view suffix, auto items, auto work) {
        benchmark::RegisterBenchmark((name + std::string{suffix}).c_str(), [items, work](benchmark::State& state) {
            std::size_t at = 0;
            for (auto _ : state) {
                auto outcome = work(items[at++ & (items.size() - 1)]);
                benchmark::DoNotOptimize(outcome);
                benchmark::ClobberMemory();
            }
        });
        all_work.push_back({name + std::string{suffix}, items.size(), [items, work] {
                                for (auto& item : items) {
                                    auto outcome = work(item);
                                    benchmark::DoNotOptimize(outcome);
                                    benchmark::ClobberMemory();
                                }
                            }});
    };
    add(jauscat_suffix, our_items, jauscat);
    add(hand_written_suffix, their_items, hand_written);
}

/// Each file of benchmarks adds its pairs; false when both ways of doing the work do not agree.
bool add_codec_benchmarks();
bool add_translate_benchmarks();
bool add_dispatch_benchmarks();
bool add_path_benchmarks();
bool add_image_benchmarks();
bool add_route_benchmarks();
bool add_sae_benchmarks();
bool add_sae_codec_benchmarks();

} // namespace bench
