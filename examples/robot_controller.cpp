// The robot controller: JAUS messages in over UDP, SDO downloads out over EtherCAT, and reports the way back.
#include "support/link_options.hpp"
#include "support/robot_messages.hpp"
#include "support/trace.hpp"
#include <jauscat/ethercat/delivery.hpp>
#include <jauscat/ethercat/master.hpp>
#include <jauscat/net/run_master.hpp>
#include <jauscat/text/jaus.hpp>

#include <thread>

namespace {

namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;
namespace text = jauscat::text;

constexpr const char* help = R"(robot_controller: carries JAUS messages to an EtherCAT slave and its reports back.

It brings the slave to PRE-OP with the station address --station, which is the slave's JAUS node, and then translates each
message for that node into an SDO download. After a query it uploads the report and sends it to the asker.

Examples:
  robot_controller --this b                   EtherCAT in UDP to 127.0.0.1, port 34980
  robot_controller --this b --table self-contained
  robot_controller --this b --link raw --interface eth0
)";

std::string explain(const ethercat::outcome& result) {
    std::string why{describe(result.error)};
    if (const auto detail = describe_detail(result); !detail.empty())
        why += ": " + std::string{detail} + " (" + text::hex_number(result.detail, 8) + ")";
    return why;
}

/// Carries messages between a UDP socket and one slave. `Table` is the translation table, `Link` the EtherCAT medium.
template <class Table, class Link> class robot_controller {
  public:
    robot_controller(jauscat::net::jaus_config config, Link& link, std::uint16_t station,
                     std::chrono::milliseconds frame_timeout)
        : config_{std::move(config)},
          link_{link},
          station_{station},
          udp_{context_, config_.me().endpoint()},
          master_{{.frame_timeout = frame_timeout}} {}

    /// Brings the slave to PRE-OP; tries again until `patience` is over.
    void bring_up(std::chrono::milliseconds patience) {
        const auto deadline = std::chrono::steady_clock::now() + patience;
        while (!try_bring_up()) {
            if (std::chrono::steady_clock::now() >= deadline || example::stop_requested)
                throw std::runtime_error{"no slave to work with: " + explain(master_.result())};
            std::this_thread::sleep_for(std::chrono::milliseconds{100});
        }
    }

    /// Works until Ctrl-C.
    int serve() {
        udp_.start([this](auto bytes, const auto& from, auto) { this->received(bytes, from); },
                   [](std::string_view problem) { std::cout << "controller: " << problem << "\n"; });
        std::cout << "controller: ready: JAUS on " << udp_.local() << ", slave " << station_
                  << " in PRE-OP (Ctrl-C ends)\n";
        while (!example::stop_requested)
            jauscat::net::run_until(context_, std::chrono::milliseconds{100},
                                    [] { return example::stop_requested.load(); });
        std::cout << "controller: stopped\n";
        return example::success;
    }

  private:
    using delivery = ethercat::delivery<Table>;
    using translator = typename delivery::translator;
    static constexpr auto exchange_timeout = std::chrono::seconds{2};

    bool try_bring_up() {
        master_.bring_up(0, station_);
        up_ = static_cast<bool>(jauscat::net::run(link_, master_, exchange_timeout));
        if (up_) {
            const auto& slave = master_.slaves().front();
            std::cout << "controller: slave " << station_ << " is in PRE-OP: vendor "
                      << text::hex_number(slave.identity.vendor, 8) << ", product "
                      << text::hex_number(slave.identity.product, 8) << "\n";
        }
        return up_;
    }

    void received(std::span<const std::byte> bytes, const auto& from) {
        const auto message = jaus::split(bytes);
        if (!message) {
            std::cout << "controller: dropped " << bytes.size() << " bytes from " << from << ": "
                      << describe(message.error) << "\n";
            return;
        }
        std::cout << "controller: received " << text::summary(message.header) << "\n"
                  << text::annotate_message(bytes, robot_messages{});
        if (jaus::is_acknowledgement(message.header)) return;
        const std::string problem = deliver(message.header, bytes);
        if (!problem.empty()) std::cout << "controller: not delivered: " << problem << "\n";
        if (message.header.ack_nak == jaus::ack_nak::request)
            acknowledge(message.header, problem.empty() ? jaus::ack_nak::ack : jaus::ack_nak::nak);
        if (problem.empty() && is_query(message.header)) report(message.header);
    }

    /// To the slave; returns why not, or nothing.
    std::string deliver(const jaus::header& head, std::span<const std::byte> message) {
        const auto mine = config_.me().jausip.subsystem;
        if (head.destination.subsystem != mine && head.destination.subsystem != 255)
            return "subsystem " + std::to_string(head.destination.subsystem) + " is not this one (" +
                   std::to_string(mine) + ")";
        if (const auto error = delivery::deliverable(head); error != jauscat::translate::errc::ok)
            return std::string{describe(error)};
        if (head.destination.node != station_)
            return "no slave has node " + std::to_string(head.destination.node) + "; the one here is " +
                   std::to_string(station_);

        std::array<std::byte, translator::max_packet_size> packet{};
        const auto size = translator::forth(message, packet);
        if (!size) return std::string{describe(size.error())};
        const auto bytes = std::span{packet}.first(size.size());
        std::cout << "controller: translated to an SDO download packet\n" << example::packet_text(bytes);

        const auto object = delivery::object_of(bytes);
        return exchange([&] { return master_.download(object.station, object.index, object.subindex, object.data); });
    }

    /// Fetches the report that a query has prepared in the slave, and sends it to the asker.
    void report(const jaus::header& query) {
        auto head = query;
        head.command_code = static_cast<std::uint16_t>(query.command_code + report_code_offset);
        std::array<std::byte, jaus::header_size> message{};
        head.data_size = 0;
        std::array<std::byte, translator::max_packet_size> packet{};
        static_cast<void>(jauscat::wire::encode(head, message));
        const auto size = translator::forth(message, packet);
        if (!size) {
            std::cout << "controller: no report: " << describe(size.error()) << "\n";
            return;
        }
        auto object = delivery::object_of(std::span{packet}.first(size.size()));
        std::array<std::byte, Table::max_data> data{};
        const auto problem =
            exchange([&] { return master_.upload(object.station, object.index, object.subindex, data); });
        if (!problem.empty()) {
            std::cout << "controller: no report: " << problem << "\n";
            return;
        }
        object.data = std::span{data}.first(master_.result().size);

        std::array<std::byte, translator::max_message_size> answer{};
        const auto answered =
            delivery::message_of(object, {.subsystem = query.destination.subsystem, .station = station_}, answer);
        if (!answered) {
            std::cout << "controller: the slave's report is no message: " << describe(answered.error()) << "\n";
            return;
        }
        // The slave's object has the slave's address; the answer goes from the one asked to the asker.
        auto report_head = jaus::answer_to(query);
        report_head.command_code = head.command_code;
        report_head.data_size = static_cast<std::uint16_t>(answered.size() - jaus::header_size);
        static_cast<void>(jauscat::wire::encode(report_head, answer));
        send(report_head, std::span{answer}.first(answered.size()));
    }

    void acknowledge(const jaus::header& request, jaus::ack_nak how) {
        auto head = jaus::answer_to(request);
        head.command_code = request.command_code;
        head.ack_nak = how;
        std::array<std::byte, jaus::header_size> message{};
        static_cast<void>(jauscat::wire::encode(head, message));
        send(head, message);
    }

    void send(const jaus::header& head, std::span<const std::byte> message) {
        const auto sent = send_to_next_hop(udp_, config_, message);
        std::cout << "controller: " << (sent ? "sent " + text::summary(head) : "cannot answer: " + sent.problem())
                  << "\n";
    }

    /// Runs one job of the master, brought up again first if the slave was lost; returns what went wrong, or nothing.
    std::string exchange(auto&& start) {
        if (!up_ && !try_bring_up()) return explain(master_.result());
        start();
        example::traced_link traced{link_};
        const auto result = jauscat::net::run(traced, master_, exchange_timeout);
        if (result) return {};
        using enum ethercat::master_errc;
        if (result.error != sdo_abort && result.error != mailbox_error && result.error != data_too_long) up_ = false;
        return explain(result);
    }

    static bool is_query(const jaus::header& head) noexcept {
        return head.command_code >= 0x2000 && head.command_code < 0x4000;
    }
    static constexpr std::uint16_t report_code_offset = 0x2000; // from a query's command code to its report's

    jauscat::net::jaus_config config_;
    Link& link_;
    std::uint16_t station_;
    boost::asio::io_context context_{};
    jauscat::net::udp_transport udp_;
    ethercat::master master_;
    bool up_{};
};

} // namespace

int main(int argc, char** argv) {
    return example::run("robot_controller", [&] {
        namespace po = boost::program_options;
        po::options_description options{"Options"};
        // clang-format off
        options.add_options()
            ("help", "show this text")
            ("config", po::value<std::string>()->default_value("JausConfig.xml"), "configuration file")
            ("this", po::value<std::string>(), "the system this controller is, instead of the file's <thissystem>")
            ("station", po::value<std::uint16_t>()->default_value(2), "station address and JAUS node of the slave, 1 to 254")
            ("wait", po::value<unsigned>()->default_value(5000), "milliseconds to wait for the slave at the start")
            ("frame-timeout", po::value<unsigned>()->default_value(20), "milliseconds after which a frame is lost");
        // clang-format on
        example::add_link_options(options);
        const auto values = example::parse(argc, argv, options, help);
        const auto station = values["station"].as<std::uint16_t>();
        if (station < 1 || station > 254) throw example::usage_error{"--station must be 1 to 254"};
        return example::with_link(values, example::link_end::master, [&](auto& link, const std::string& where) {
            return example::with_table(values, [&]<class Table>() {
                std::cout << "controller: " << where << "\n";
                const std::chrono::milliseconds frame_timeout{values["frame-timeout"].as<unsigned>()};
                robot_controller<Table, std::remove_cvref_t<decltype(link)>> controller{example::load_config(values),
                                                                                        link, station, frame_timeout};
                controller.bring_up(std::chrono::milliseconds{values["wait"].as<unsigned>()});
                return controller.serve();
            });
        });
    });
}
