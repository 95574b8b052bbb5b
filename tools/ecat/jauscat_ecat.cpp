// jauscat-ecat: looks at the slaves of an EtherCAT bus.
#include "ecat/arguments.hpp"
#include "support/output.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <iostream>
#include <string_view>
#include <utility>

namespace ecat {

namespace {

std::atomic<bool> stop{false};

int run(const arguments& given) {
    using entry = std::pair<std::string_view, int (*)(const arguments&)>;
    constexpr std::array all{entry{"scan", scan},       entry{"info", info},   entry{"state", state},
                             entry{"read", read},       entry{"write", write}, entry{"sdos", sdos},
                             entry{"sii", sii},         entry{"pdos", pdos},   entry{"watch", watch},
                             entry{"monitor", monitor}, entry{"esi", esi}};
    for (const auto& [name, command] : all)
        if (name == given.command) return command(given);
    return wrong_usage;
}

} // namespace

bool stop_requested() noexcept { return stop; }

} // namespace ecat

int main(int argc, char** argv) {
    struct sigaction action{};
    action.sa_handler = [](int) { ecat::stop = true; };
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
    try {
        return example::with_output("jauscat-ecat", ecat::run(ecat::parse(argc, argv)));
    } catch (const ecat::usage_error& error) {
        std::cerr << "jauscat-ecat: " << error.what() << "\nTry 'jauscat-ecat --help'.\n";
        return error.code();
    } catch (const ecat::failure& error) {
        std::cerr << "jauscat-ecat: " << error.what() << "\n";
        return error.code();
    } catch (const std::exception& error) {
        std::cerr << "jauscat-ecat: " << error.what() << "\n";
        return ecat::failed;
    }
}
