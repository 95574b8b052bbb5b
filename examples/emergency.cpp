// An operator stops a primitive driver by an emergency, follows its state by an event, and releases it again.
//     emergency --this a
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/text/value.hpp>

#include <boost/asio/co_spawn.hpp>

#include <exception>
#include <iostream>

namespace asio = boost::asio;
namespace jaus = jauscat::jaus;

// [emergency]
asio::awaitable<void> stop_and_release(jauscat::component& unit, jaus::address driver) {
    auto control = co_await unit.async_control(driver, {.authority = 100});
    auto states = co_await unit.async_event<jaus::report_component_status>(
        driver, {.event_type = jaus::event_type::every_change});
    const auto reaches = [&](jaus::primary_status_code wanted) -> asio::awaitable<void> {
        for (;;) {
            const auto report = co_await states.async_next();
            std::cout << jauscat::text::enumerator_name(report.primary_status_code) << std::endl;
            if (report.primary_status_code == wanted) co_return;
        }
    };
    // It needs no control: every component must be able to stop the machine.
    co_await unit.async_send(driver, jaus::set_emergency{{jaus::set_emergency_code::transition_to_emergency}});
    co_await reaches(jaus::primary_status_code::emergency);
    // Each that has set an emergency clears its own; then nothing moves before a Resume.
    co_await unit.async_send(driver, jaus::clear_emergency{{jaus::clear_emergency_code::clear_emergency}});
    co_await reaches(jaus::primary_status_code::standby);
    co_await control.async_send(jaus::resume{});
    co_await reaches(jaus::primary_status_code::ready);
}
// [emergency end]

int main(int argc, char** argv) {
    jauscat::node node{argc, argv};
    jauscat::component unit{node, {.id = 32, .name = "operator"}};
    unit.ready();
    const jaus::address driver{.instance = 1, .component = 33, .node = 1, .subsystem = 2};
    asio::co_spawn(node.context(), stop_and_release(unit, driver), [&](const std::exception_ptr& problem) {
        node.stop();
        if (problem) std::rethrow_exception(problem); // run logs it, and returns 1
    });
    return node.run();
}
