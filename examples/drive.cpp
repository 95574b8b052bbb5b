// An operator: takes control of a primitive driver, commands an effort, and receives its reports.
//     drive --this a
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>

#include <exception>
#include <iostream>
#include <string_view>

namespace asio = boost::asio;
namespace jaus = jauscat::jaus;

// [drive]
asio::awaitable<void> drive(jauscat::component& unit, jaus::address driver) {
    auto control = co_await unit.async_control(driver, {.authority = 100}); // until it goes
    boost::system::error_code why; // some peers never acknowledge: their reports show what they do
    co_await control.async_send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50},
                                asio::redirect_error(asio::use_awaitable, why));
    if (why) std::cout << why.message() << ": the reports show whether it is obeyed\n";
    const auto show = [](std::string_view what, const jaus::report_wrench_effort& report) {
        if (const auto& x = report.propulsive_linear_effort_x) std::cout << what << *x << " %\n";
    };
    const auto in_force = co_await unit.async_ask(driver, jaus::query_wrench_effort{0x0001},
                                                  asio::redirect_error(asio::use_awaitable, why));
    if (why) throw boost::system::system_error{why, "Report Wrench Effort"}; // names what was awaited
    show("in force: ", in_force);
    auto efforts = co_await unit.async_connect<jaus::report_wrench_effort>(driver, {.rate = 20});
    for (int i = 0; i != 3; ++i) show("reported: ", co_await efforts.async_next());
}
// [drive end]

int main(int argc, char** argv) {
    jauscat::node node{argc, argv};
    jauscat::component unit{node, {.id = 32, .name = "operator"}};
    unit.ready();
    const jaus::address driver{.instance = 1, .component = 33, .node = 1, .subsystem = 2};
    asio::co_spawn(node.context(), drive(unit, driver), [&](const std::exception_ptr& problem) {
        node.stop();
        if (problem) std::rethrow_exception(problem); // run logs it, and returns 1
    });
    const int code = node.run();
    if (!std::cout.flush()) return std::cerr << "drive: standard output cannot be written\n", 1;
    return code;
}
