// write-a-component.md: a driver with motors, reports and a message of its own, and its operator. Both nodes run in
// this program, and talk by UDP.
//     docs_component
// [includes]
#include <jauscat/app.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/redirect_error.hpp>

#include <iostream>

namespace asio = boost::asio;
namespace jaus = jauscat::jaus;
using namespace std::chrono_literals;
// [includes end]

// [message]
namespace gripper {

struct newtons {
    static constexpr double min = 0, max = 500;
};

/// A message of this robot, with a code of the experimental range.
struct set_gripper {
    std::uint8_t finger{};
    double force{}; ///< newtons, 0 to 500

    struct schema : jauscat::wire::items {
        static constexpr std::uint16_t command_code = 0xD101;
        using T = set_gripper;
        using type = layout<field<&T::finger, u8>, field<&T::force, scaled<u16le, newtons>>>;
    };
};

} // namespace gripper
// [message end]

// [component]
class driver {
  public:
    explicit driver(jauscat::node& node) : unit_{node, {.id = 33, .name = "Primitive Driver"}} {
        unit_.on([this](const jaus::set_wrench_effort& told) { jaus::copy_present(told, told_); },
                 [](const gripper::set_gripper& told) {
                     return told.finger < 3 ? jaus::message_outcome::handled : jaus::message_outcome::refused;
                 });
        unit_.reports([this] { return in_force_; }, 100); // hertz, the most that a receiver may ask for
        unit_.every(10ms, [this] { in_force_ = told_; }); // read sensors, set motors; fail() if that goes wrong
        unit_.when_stopped([this] { in_force_ = told_ = at_rest; });
        unit_.when_controlled([](const std::optional<jaus::address>& by) {
            std::cout << (by ? "driver: controlled\n" : "driver: free\n");
        });
        unit_.ready();
    }
    [[nodiscard]] jaus::address address() const { return unit_.address(); }

  private:
    static constexpr auto at_rest = jaus::all_zero<jaus::report_wrench_effort>();
    jaus::report_wrench_effort told_ = at_rest, in_force_ = at_rest;
    jauscat::component unit_;
};
// [component end]

// [operator]
asio::awaitable<void> use(jauscat::component& unit, jaus::address driver) {
    auto control = co_await unit.async_control(driver, {.authority = 100});
    co_await control.async_send(jaus::set_wrench_effort{.propulsive_linear_effort_x = 50});
    std::cout << "operator: obeyed\n";
    auto efforts = co_await unit.async_connect<jaus::report_wrench_effort>(driver, {.rate = 20});
    for (jaus::report_wrench_effort now{}; !now.propulsive_linear_effort_x; now = co_await efforts.async_next()) {}
    std::cout << "operator: the driver reports an effort\n";
    boost::system::error_code error;
    co_await control.async_send(gripper::set_gripper{.finger = 7, .force = 20},
                                asio::redirect_error(asio::use_awaitable, error));
    std::cout << "operator: finger 7 is " << error.message() << '\n';
} // control is released, the connection is ended
// [operator end]

// [nodes]
int main() try {
    asio::io_context context;
    jauscat::node robot{context, {.config = "component.xml", .this_system = "robot", .node = 2}};
    jauscat::node operators{context, {.config = "component.xml", .this_system = "operator", .node = 1}};
    driver motors{robot};
    jauscat::component unit{operators, {.id = 32, .name = "operator"}};
    unit.ready();
    robot.start();
    operators.start();
    asio::co_spawn(context, use(unit, motors.address()), [&](const std::exception_ptr& problem) {
        if (problem) std::rethrow_exception(problem);
        operators.stop(); // sends the release
    });
    context.run_for(1s);
} catch (const std::exception& error) {
    return std::cerr << error.what() << '\n', 1;
}
// [nodes end]
