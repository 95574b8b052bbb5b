// Runs jauscat-ecat.
#pragma once
#include "app/emulated_bus.hpp"
#include "support/paths.hpp"
#include "support/scratch.hpp"

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <sys/wait.h>
#include <vector>

namespace ecat_test {

namespace ethercat = jauscat::ethercat;
using json = nlohmann::ordered_json;
using jauscat::test::content;
using jauscat::test::emulated_bus;
using jauscat::test::scratch;

struct outcome {
    int code{};
    std::string out{}, err{};

    [[nodiscard]] bool says(const std::string& text) const { return out.find(text) != std::string::npos; }
    [[nodiscard]] bool complains(const std::string& text) const { return err.find(text) != std::string::npos; }
    [[nodiscard]] json parsed() const { return json::parse(out); }
};

/// Exit codes of the tool.
enum : int { done = 0, failed = 1, usage = 2, in_use = 3, not_confirmed = 4 };

/// `limit`: the command that limits its time.
inline outcome run(const std::string& arguments, const std::string& limit = "timeout 120") {
    const scratch files;
    const auto command = limit + " '" + support::program("jauscat-ecat") + "' " + arguments + " </dev/null >" +
                         (files / "out") + " 2>" + (files / "err");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(files / "out"), content(files / "err")};
}
/// Ends it by Ctrl-C after so many seconds.
inline outcome run_until_interrupted(const std::string& arguments, const std::string& seconds) {
    return run(arguments, "timeout --preserve-status --signal=INT --kill-after=60 " + seconds);
}

/// Three slaves, of two kinds; the second one has an alias.
inline std::vector<ethercat::slave_description> three() {
    return {{.vendor = 7, .product = 1, .revision = 3, .serial = 10, .name = "axis"},
            {.vendor = 7, .product = 2, .serial = 11, .station_alias = 300, .name = "gripper"},
            {.vendor = 7, .product = 1, .serial = 12, .name = "axis", .eight_byte_sii_reads = true}};
}

/// ` --link udp:127.0.0.1:PORT`
inline std::string on(const emulated_bus& ring) { return " --link " + ring.where() + " "; }

/// Of all slaves, as they are now.
inline std::vector<ethercat::al_state> states(emulated_bus& ring, std::size_t slaves = 3) {
    std::vector<ethercat::al_state> all;
    for (std::size_t i = 0; i != slaves; ++i) ring.with(i, [&](auto& each) { all.push_back(each.slave.state()); });
    return all;
}
inline std::vector<std::uint16_t> stations(emulated_bus& ring, std::size_t slaves = 3) {
    std::vector<std::uint16_t> all;
    for (std::size_t i = 0; i != slaves; ++i)
        ring.with(i, [&](auto& each) { all.push_back(each.slave.station_address()); });
    return all;
}
inline std::vector<ethercat::al_state> all_in(ethercat::al_state state, std::size_t slaves = 3) {
    return std::vector<ethercat::al_state>(slaves, state);
}

} // namespace ecat_test
