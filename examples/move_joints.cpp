// An operator of an arm: moves its joints, waits until they are there, and shows where they are.
//     move_joints --this a
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/manipulator.hpp>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <iostream>

namespace asio = boost::asio;
namespace jaus = jauscat::jaus;

asio::awaitable<void> move(jauscat::component& unit, jaus::address arm) {
    auto control = co_await unit.async_control(arm, {.authority = 100}); // until the end of the scope
    const jaus::set_joint_positions goal{.joint_position = {0.5, -0.5, 1.0, -1.0, 0.25, 0.1}}; // radians
    co_await control.async_send(goal); // acknowledged when all joints have their targets
    asio::steady_timer timer{co_await asio::this_coro::executor};
    for (;;) {
        const auto now = co_await unit.async_ask(arm, jaus::query_joint_positions{});
        std::cout << "joints at";
        for (const double each : now.joint_position) std::cout << ' ' << std::round(each * 100) / 100;
        std::cout << " rad\n";
        if (std::ranges::equal(now.joint_position, goal.joint_position,
                               [](double is, double wanted) { return std::abs(is - wanted) < 0.02; }))
            co_return;
        timer.expires_after(std::chrono::milliseconds{100});
        co_await timer.async_wait(asio::use_awaitable);
    }
}

int main(int argc, char** argv) {
    jauscat::node node{argc, argv};
    jauscat::component unit{node, {.id = 32, .name = "operator"}};
    unit.ready();
    const jaus::address arm{.instance = 1, .component = 54, .node = 1, .subsystem = 2};
    asio::co_spawn(node.context(), move(unit, arm), [&](const std::exception_ptr& problem) {
        node.stop();
        if (problem) std::rethrow_exception(problem); // run logs it, and returns 1
    });
    const int code = node.run();
    if (!std::cout.flush()) return std::cerr << "move_joints: standard output cannot be written\n", 1;
    return code;
}
