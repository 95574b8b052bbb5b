#include "nodes/program.hpp"

#include "support/catch.hpp"

#if __has_include(<boost/process/v1.hpp>) // from Boost 1.86 on; `boost/process.hpp` is another interface later
#    include <boost/process/v1.hpp>
#    include <boost/process/v1/extend.hpp>
namespace bp = boost::process::v1;
#else
#    include <boost/process.hpp>
#    include <boost/process/extend.hpp>
namespace bp = boost::process;
#endif

#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <optional>
#include <sstream>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>

namespace nodes {

bool is_slow() {
#if defined(__SANITIZE_ADDRESS__)
    return true;
#elif defined(__has_feature)
#    if __has_feature(address_sanitizer)
    return true;
#    endif
#endif
    return !wrapper().empty();
}

const words& wrapper() {
    static const words chosen = [] {
        const char* const value = std::getenv("NODE_WRAPPER");
        std::istringstream text{value != nullptr ? value : ""};
        return words{std::istream_iterator<std::string>{text}, {}};
    }();
    return chosen;
}

std::chrono::seconds wait_limit() { return is_slow() ? std::chrono::seconds{200} : std::chrono::seconds{60}; }

bool is_installed(const std::string& name) { return !bp::search_path(name).empty(); }

words operator+(words first, const words& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
}

namespace {

bool has_members(const json& event, const json& members) {
    for (const auto& [key, value] : members.items())
        if (!event.contains(key) || event[key] != value) return false;
    return true;
}
program::predicate equals(const json& members) {
    return [members](const json& event) { return has_members(event, members); };
}

} // namespace

struct program::state {
    std::string name{};
    bp::ipstream out{};
    bp::opstream in{};
    std::optional<bp::child> child{};
    std::optional<int> code{};

    mutable std::mutex mutex{};
    std::condition_variable news{};
    std::vector<json> events{};
    std::string output{};
    bool at_end{}; // of its output
    std::thread reader{};

    void read() {
        for (std::string line; std::getline(out, line);) {
            auto event = line.starts_with('{') ? json::parse(line, nullptr, false) : json{};
            const std::scoped_lock lock{mutex};
            output += line + "\n";
            if (event.is_object() && event.contains("event")) events.push_back(std::move(event));
            news.notify_all();
        }
        const std::scoped_lock lock{mutex};
        at_end = true;
        news.notify_all();
    }
    /// Whether `done` holds within the limit; nothing more comes after the program's end.
    bool wait_until(const std::function<bool()>& done, std::chrono::milliseconds limit) {
        std::unique_lock lock{mutex};
        news.wait_for(lock, limit, [&] { return done() || at_end; });
        return done();
    }
    [[nodiscard]] std::size_t count(std::string_view kind, const predicate& is_it) const {
        std::size_t found = 0;
        for (const auto& event : events)
            if (event["event"] == kind && is_it(event)) ++found;
        return found;
    }
};

program::program(const words& command, const std::string& input, bool keeps_input) : is_{std::make_unique<state>()} {
    std::signal(SIGPIPE, SIG_IGN); // it may end without reading its input
    is_->name = std::filesystem::path{command.at(0)}.filename().string();
    const auto path = command[0].find('/') == std::string::npos ? bp::search_path(command[0]).string() : command[0];
    is_->child.emplace(
        bp::exe = path, bp::args = words{command.begin() + 1, command.end()}, (bp::std_out & bp::std_err) > is_->out,
        bp::std_in < is_->in, bp::extend::on_exec_setup = [](auto&) { ::prctl(PR_SET_PDEATHSIG, SIGKILL); });
    is_->reader = std::thread{[this] { is_->read(); }};
    is_->in << input << std::flush;
    if (!keeps_input) is_->in.pipe().close();
}

program::~program() {
    try {
        if (!is_->code) {
            ::kill(pid(), SIGKILL);
            is_->child->wait();
        }
        if (is_->reader.joinable()) is_->reader.join();
    } catch (const std::exception& error) {
        std::cerr << is_->name << ": " << error.what() << '\n';
    }
}

json program::wait_for(std::string_view name, const json& members, std::size_t times) {
    INFO("with the members " << members.dump());
    return wait_for(name, equals(members), times);
}
json program::wait_for(std::string_view name, const predicate& is_it, std::size_t times) {
    if (!is_->wait_until([&] { return is_->count(name, is_it) >= times; }, wait_limit()))
        FAIL(is_->name << " has not logged " << name << " " << times << " times");
    const std::scoped_lock lock{is_->mutex};
    for (const auto& event : is_->events)
        if (event["event"] == name && is_it(event) && --times == 0) return event;
    return {};
}
void program::wait_for_output(const std::string& text) {
    if (!is_->wait_until([&] { return is_->output.find(text) != std::string::npos; }, wait_limit()))
        FAIL(is_->name << " has not written: " << text);
}

std::vector<json> program::events(std::string_view name, const json& members) const {
    const std::scoped_lock lock{is_->mutex};
    std::vector<json> found;
    for (const auto& event : is_->events)
        if (event["event"] == name && has_members(event, members)) found.push_back(event);
    return found;
}
std::size_t program::count(std::string_view name, const json& members) const {
    const std::scoped_lock lock{is_->mutex};
    return is_->count(name, equals(members));
}
bool program::has(std::string_view name, const json& members) const { return count(name, members) != 0; }
std::string program::output() const {
    const std::scoped_lock lock{is_->mutex};
    return is_->output;
}
bool program::has_output(const std::string& text) const { return output().find(text) != std::string::npos; }

void program::signal(int number) const { ::kill(pid(), number); }
bool program::ends_within(std::chrono::milliseconds limit) {
    if (is_->code) return true;
    if (!is_->wait_until([this] { return is_->at_end; }, limit)) return false;
    is_->child->wait();
    const int status = is_->child->native_exit_code();
    is_->code = WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
    return true;
}
int program::wait() {
    if (!ends_within(wait_limit())) FAIL(is_->name << " does not end");
    return *is_->code;
}
int program::end(int number) {
    signal(number);
    return wait();
}
void program::kill() { end(SIGKILL); }
bool program::has_ended() const { return is_->code.has_value(); }
int program::pid() const { return is_->child->id(); }
const std::string& program::name() const { return is_->name; }

} // namespace nodes
