// Runs the benchmarks in pairs, interleaved, so that what else the machine does meets both sides alike.
#include "ratio_reporter.hpp"

int main(int argc, char** argv) {
    if (!bench::add_codec_benchmarks() || !bench::add_translate_benchmarks()) {
        std::fputs("jauscat and the hand-written code do not agree\n", stderr);
        return 1;
    }
    // Defaults first, so that the command line can overrule them.
    std::vector<std::string> text{argv[0], "--benchmark_repetitions=9", "--benchmark_enable_random_interleaving=true",
                                  "--benchmark_min_time=0.05"};
    text.insert(text.end(), argv + 1, argv + argc);
    std::vector<char*> arguments;
    for (auto& argument : text) arguments.push_back(argument.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;

    bench::ratio_reporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
}
