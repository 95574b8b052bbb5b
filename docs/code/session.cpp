// machinery-component.md: an operator takes control of a driver, connects to its reports, and commands it. Both nodes
// run in this program, and talk by UDP.
// [includes]
#include <jauscat/jauscat.hpp>
#include <jauscat/net.hpp>

#include <iostream>
#include <random>

namespace jaus = jauscat::jaus;
namespace net = jauscat::net;
using namespace std::chrono_literals;
// [includes end]

// [robot]
/// Component 33 of the robot: executes Set Wrench Effort, and reports its efforts by service connections.
class driver {
  public:
    explicit driver(net::jaus_node& node) { node.add(core_, application_); }
    void start() { core_.change(jaus::state_event::initialized); }
    [[nodiscard]] bool is_free() const { return !core_.control().controller(); }

  private:
    using header = jaus::header;
    void on_state(jaus::primary_status_code, jaus::primary_status_code now) {
        if (now != jaus::primary_status_code::ready) effort_ = at_rest; // motors at rest
    }
    void on_controller(const std::optional<jaus::controller>& who, jaus::control_change why) {
        if (why == jaus::control_change::lost) effort_ = at_rest;
        std::cout << (who ? "driver: controlled\n" : "driver: free\n");
    }
    struct application_type {
        driver& mine;
        jaus::message_outcome operator()(const header& head, std::span<const std::byte> body) const {
            jaus::dispatcher handlers{
                jaus::on<jaus::set_wrench_effort>([&](const header&, const jaus::set_wrench_effort& commanded) {
                    jaus::copy_present(commanded, mine.effort_);
                })};
            return jaus::outcome_of(handlers(head, body));
        }
    };
    /// Writes a report with the fields that a connection requested.
    struct filler {
        driver& mine;
        std::optional<std::size_t> operator()(std::uint16_t, std::uint32_t fields, std::span<std::byte> body) const {
            auto report = mine.effort_;
            jaus::keep_requested(report, fields);
            const auto encoded = jauscat::wire::encode(report, body);
            return encoded ? std::optional{encoded->size()} : std::nullopt;
        }
    };
    static constexpr jaus::address self{.instance = 1, .component = 33, .node = 2, .subsystem = 2};
    static constexpr std::array reports{
        jaus::connectable_report{.command_code = jaus::command_code_of<jaus::report_wrench_effort>, .max_rate = 100}};

    static constexpr auto at_rest = jaus::all_zero<jaus::report_wrench_effort>();
    jaus::report_wrench_effort effort_ = at_rest;
    application_type application_{*this};
    filler fill_{*this};
    std::array<std::byte, 64> report_{};
    jaus::service_connections<4> connections_{self, reports, fill_, report_};
    jaus::component_memory<> memory_{};
    jaus::component<jaus::service_connections<4>> core_{self,
                                                        memory_,
                                                        {.on_state = jaus::bound<&driver::on_state>(*this),
                                                         .on_controller = jaus::bound<&driver::on_controller>(*this)},
                                                        {},
                                                        connections_};
};
// [robot end]

/// The same systems at ports that are free now, so that this program can run beside any other.
net::jaus_config at_free_ports(net::jaus_config config) {
    using boost::asio::ip::udp;
    boost::asio::io_context context;
    std::vector<udp::socket> held; // until all have one
    for (auto& system : config.systems)
        system.port = held.emplace_back(context, udp::endpoint{system.ip, 0}).local_endpoint().port();
    return config;
}

int main() try {
    boost::asio::io_context context;
    const auto config = at_free_ports(net::read_jaus_config("two_nodes.xml"));
    net::jaus_node robot{context, config.with_this("robot"), {.node = 2}};
    driver arm{robot};
    robot.start();
    arm.start();

    // [operator]
    const jaus::address self{.instance = 1, .component = 32, .node = 1, .subsystem = 1};
    const jaus::address target{.instance = 1, .component = 33, .node = 2, .subsystem = 2};
    net::jaus_node node{context, config, {.node = 1}};

    std::optional<jaus::delivered> outcome;
    const auto keep = [&](const jaus::awaited_message&, jaus::delivered what) { outcome = what; };
    jaus::component_memory<> memory{};
    jaus::held_control control{self, target};
    const auto first_number = static_cast<std::uint16_t>(std::random_device{}()); // differs after each start
    jaus::component unit{
        self, memory, {.on_delivered = keep}, {.acknowledgement = {.first_number = first_number}}, control};
    double forward{};
    jaus::dispatcher own{jaus::on<jaus::confirm_service_connection>([](const auto&, const auto&) {}),
                         jaus::on<jaus::report_wrench_effort>([&](const jaus::header&, const auto& report) {
                             forward = report.propulsive_linear_effort_x.value_or(0);
                         })};
    node.add(unit, own);
    node.start();
    unit.change(jaus::state_event::initialized);

    control.ask(100, node.now(), node.out());
    if (!net::run_until(context, 2s, [&] { return control.state() == jaus::control_state::held; }))
        return std::cerr << "no control\n", 1;

    const auto sent = unit.send({.destination = target}, jaus::set_wrench_effort{.propulsive_linear_effort_x = 50},
                                node.now(), node.out());
    if (!sent) return std::cerr << describe(sent.error()) << '\n', 1;
    if (!net::run_until(context, 2s, [&] { return outcome.has_value(); })) return std::cerr << "no outcome\n", 1;
    std::cout << "operator: " << (outcome == jaus::delivered::acknowledged ? "obeyed\n" : "not obeyed\n");

    const auto asked =
        node.send({.destination = target, .source = self},
                  jaus::create_service_connection{.command_code = jaus::command_code_of<jaus::report_wrench_effort>,
                                                  .requested_periodic_update_rate = 20,
                                                  .requested_presence_vector = 1});
    if (!asked) return std::cerr << asked.error().message << '\n', 1;
    if (!net::run_until(context, 2s, [&] { return forward != 0; })) return std::cerr << "no report\n", 1;
    std::cout << "operator: the driver reports " << forward << " %\n";

    control.release(node.out());
    return net::run_until(context, 2s, [&] { return arm.is_free(); }) ? 0 : 1;
    // [operator end]
} catch (const std::exception& error) {
    return std::cerr << error.what() << '\n', 1;
}
