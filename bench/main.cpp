// Runs the benchmarks in pairs, interleaved, so that what else the machine does meets both sides alike.
#include "ratio_reporter.hpp"

#if __has_include(<valgrind/callgrind.h>)
#    include <valgrind/callgrind.h>
#endif

namespace {

// Runs everything once under callgrind, which leaves a file of counts for each side of each pair.
int count_instructions() {
#ifdef CALLGRIND_ZERO_STATS
    CALLGRIND_DUMP_STATS; // else the first file has some of the setup's instructions, in spite of CALLGRIND_ZERO_STATS
    for (const auto& work : bench::all_work) {
        CALLGRIND_ZERO_STATS;
        work.run();
        const std::string name = work.name + "/" + std::to_string(work.items);
        CALLGRIND_DUMP_STATS_AT(name.c_str());
    }
    return 0;
#else
    std::fputs("built without valgrind's headers (package valgrind)\n", stderr);
    return 1;
#endif
}

} // namespace

int main(int argc, char** argv) {
    if (!bench::add_codec_benchmarks() || !bench::add_translate_benchmarks() || !bench::add_dispatch_benchmarks() ||
        !bench::add_path_benchmarks() || !bench::add_image_benchmarks() || !bench::add_route_benchmarks() ||
        !bench::add_sae_benchmarks() || !bench::add_sae_codec_benchmarks()) {
        std::fputs("jauscat and the hand-written code do not agree\n", stderr);
        return 1;
    }
    if (argc == 2 && std::string_view{argv[1]} == "--count-instructions") return count_instructions();
    // Defaults first, so that the command line can overrule them.
    std::vector<std::string> text{argv[0], "--benchmark_repetitions=9", "--benchmark_enable_random_interleaving=true",
                                  "--benchmark_min_time=0.05"};
    text.insert(text.end(), argv + 1, argv + argc);
    std::vector<char*> arguments;
    arguments.reserve(text.size());
    for (auto& argument : text) arguments.push_back(argument.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;

    bench::ratio_reporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
}
