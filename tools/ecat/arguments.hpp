// The command line.
#pragma once
#include "ecat/ring.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace ecat {

struct arguments {
    std::string command{};
    std::vector<std::string> words{}; ///< behind the command: goal, objects, value, file
    ring_options link{};
    bool is_json{};
    std::optional<std::uint16_t> slave{}; ///< position
    std::optional<std::uint16_t> alias{}; ///< of the slave, in place of its position
    bool yes{};
    std::string type{};
    std::string output{};
    bool raw{};                         ///< sii: as hexadecimal lines
    bool entries{};                     ///< sdos: with the values of the entries
    std::chrono::microseconds period{}; ///< monitor: between two frames; watch: between two tables
    std::optional<double> seconds{};    ///< monitor and watch: until they end
};

/// Prints help or the version and ends the program where these are asked for. Throws `usage_error`.
[[nodiscard]] arguments parse(int argc, char** argv);

/// The positions that a command is for: the chosen one, or all. The guard has read the slaves. Throws `failure` if
/// there is no such slave.
[[nodiscard]] std::vector<std::uint16_t> chosen_slaves(const arguments& given, const ring& on);
/// The chosen one, or the only one.
[[nodiscard]] std::uint16_t chosen_slave(const arguments& given, const ring& on);
/// Asks on the terminal, unless --yes is given; throws `failure` without a yes.
void confirm(const arguments& given, const std::string& question);

int scan(const arguments& given);
int info(const arguments& given);
int state(const arguments& given);
int read(const arguments& given);
int write(const arguments& given);
int sdos(const arguments& given);
int sii(const arguments& given);
int pdos(const arguments& given);
int monitor(const arguments& given);
int watch(const arguments& given);
int esi(const arguments& given);

} // namespace ecat
