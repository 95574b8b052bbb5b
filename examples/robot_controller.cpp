// The robot controller: JAUS messages in over UDP, SDO downloads out over EtherCAT, and reports the way back.
#include "support/any_exchange.hpp"
#include "support/cyclic_path.hpp"
#include "support/explain.hpp"
#include "support/link_options.hpp"
#include "support/link_watch.hpp"
#include "support/robot_messages.hpp"
#include "support/trace.hpp"
#include <jauscat/ethercat/message_assembly.hpp>
#include <jauscat/ethercat/packet_job.hpp>
#include <jauscat/net/run_master.hpp>
#include <jauscat/text/jaus.hpp>
#include <jauscat/text/packet_status.hpp>

#include <deque>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

namespace {

namespace ethercat = jauscat::ethercat;
namespace jaus = jauscat::jaus;
namespace text = jauscat::text;

constexpr const char* help = R"(robot_controller: carries JAUS messages to an EtherCAT slave and its reports back.

It brings the slave to PRE-OP with the station address --station, which is the slave's JAUS node, and then translates each
message for that node into an SDO download. After a query it uploads the report and sends it to the asker.

With --cycle the slave runs in OP, and wrench efforts take the cyclic path: a Set Wrench Effort is in the slave's outputs
in the next cycle, and Query Wrench Effort is answered from its inputs. All other messages go by the mailbox, in between.

Examples:
  robot_controller --this b                   EtherCAT in UDP to 127.0.0.1, port 34980
  robot_controller --this b --table self-contained
  robot_controller --this b --link raw --interface eth0
  robot_controller --this b --link raw --interface eth0 --cycle 1000
)";

/// Carries messages between a UDP socket and one slave.
class robot_controller {
  public:
    robot_controller(jauscat::net::jaus_config config, example::any_link& link, example::any_exchange& exchange,
                     std::uint16_t station, std::chrono::milliseconds frame_timeout,
                     const ethercat::download_options& options, std::chrono::nanoseconds period,
                     std::chrono::milliseconds watchdog)
        : config_{std::move(config)},
          link_{link},
          exchange_{exchange},
          station_{station},
          options_{options},
          udp_{context_, config_.me().endpoint()},
          master_{{.frame_timeout = frame_timeout}} {
        const ethercat::slave_identity slave{.subsystem = config_.me().jausip.subsystem, .station = station};
        if (period > std::chrono::nanoseconds{}) cyclic_.emplace(link_, master_, slave, period, watchdog);
    }

    /// Brings the slave to PRE-OP, or to OP for the cyclic path; tries again until `patience` is over.
    void bring_up(std::chrono::milliseconds patience) {
        const auto deadline = std::chrono::steady_clock::now() + patience;
        while (!try_bring_up()) {
            if (std::chrono::steady_clock::now() >= deadline || example::stop_requested)
                throw std::runtime_error{"no slave to work with: " + example::explain(master_.result())};
            std::this_thread::sleep_for(std::chrono::milliseconds{100});
        }
    }

    /// Works until Ctrl-C.
    int serve() {
        udp_.start([this](auto bytes, const auto& from, auto) { this->received(bytes, from); },
                   [](std::string_view problem) { std::cout << "controller: " << problem << "\n"; });
        std::cout << "controller: ready: JAUS on " << udp_.local() << ", slave " << station_
                  << (cyclic_ ? " in OP" : " in PRE-OP") << " (Ctrl-C ends)\n";
        while (!example::stop_requested)
            if (cyclic_)
                serve_cycle();
            else
                jauscat::net::run_until(context_, std::chrono::milliseconds{100},
                                        [] { return example::stop_requested.load(); });
        std::cout << "controller: stopped\n";
        return example::success;
    }

  private:
    static constexpr auto exchange_timeout = std::chrono::seconds{2};
    static constexpr std::size_t longest_queue = 64;

    bool try_bring_up() {
        master_.bring_up(0, station_);
        up_ = static_cast<bool>(jauscat::net::run(link_, master_, exchange_timeout));
        watch_.look(master_, link_, "controller");
        if (up_) {
            const auto& slave = master_.slaves().front();
            std::cout << "controller: slave " << station_ << " is in PRE-OP: vendor "
                      << text::hex_number(slave.identity.vendor, 8) << ", product "
                      << text::hex_number(slave.identity.product, 8) << "\n";
            if (cyclic_) return start_cycles();
        }
        return up_;
    }

    bool start_cycles() {
        const auto result = cyclic_->start([] {});
        up_ = static_cast<bool>(result);
        std::cout << "controller: "
                  << (up_ ? "slave " + std::to_string(station_) + " is in OP"
                          : "no process data: " + example::explain(result))
                  << "\n";
        return up_;
    }

    /// One cycle: messages that have come go out with it, those for the mailbox after it.
    void serve_cycle() {
        if (!up_) {
            context_.poll();
            if (!try_bring_up()) std::this_thread::sleep_for(std::chrono::milliseconds{100});
            return;
        }
        cyclic_->cycle([this] { context_.poll(); });
        acknowledge_commands();
        if (!for_mailbox_.empty() && !cyclic_->busy()) {
            const auto message = std::move(for_mailbox_.front());
            for_mailbox_.pop_front();
            deliver(message);
        }
        if (up_ && !cyclic_->runs()) {
            std::cout << "controller: slave " << station_ << " " << cyclic_->problem() << "\n";
            up_ = false;
        }
    }

    void acknowledge_commands() {
        std::array<std::byte, jaus::header_size> answer{};
        while (const auto size = cyclic_->exchange().acknowledgement(cyclic_->inputs(), now(), answer))
            send(answer, size);
    }

    /// A message into the outputs or out of the inputs.
    void exchange_image(const jaus::header& head, std::span<const std::byte> body) {
        auto& exchange = cyclic_->exchange();
        if (!up_) return refuse(head, "the slave is not in OP");
        if (head.command_code == exchange.command_code) {
            const auto error = exchange.on_command(head, body, cyclic_->outputs(), cyclic_->inputs(), now());
            if (error != jauscat::translate::errc::ok) return refuse(head, std::string{describe(error)});
            std::cout << "controller: into the process image, command " << exchange.given(cyclic_->outputs()) << ": "
                      << text::hex(cyclic_->outputs()) << "\n";
        } else {
            std::array<std::byte, example::any_exchange::buffer_size> report{};
            const auto size = exchange.on_query<jaus::query_wrench_effort>(head, body, cyclic_->inputs(), report);
            if (size == 0) return refuse(head, "the query is malformed");
            std::cout << "controller: answers from the process image: " << text::hex(cyclic_->inputs()) << "\n";
            acknowledge(head, jaus::ack_nak::ack);
            send(report, size);
        }
    }

    static ethercat::time_point now() { return std::chrono::steady_clock::now().time_since_epoch(); }

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
        if (const auto problem = not_here(message.header); !problem.empty())
            refuse(message.header, problem);
        else
            collect(message.header, bytes);
    }

    /// Delivers a message that is complete; keeps the packets of a large data set until it is.
    void collect(const jaus::header& head, std::span<const std::byte> message) {
        using enum jaus::reassembled;
        const auto what = assembly_.on_message(head, message, now(), [this](auto complete) { direct(complete); });
        if (what == too_large || what == no_room) {
            refuse(head, std::string{describe(what)});
        } else if (what == waiting || what == repeated) {
            std::cout << "controller: " << describe(what) << "\n";
            acknowledge(head, jaus::ack_nak::ack);
        }
    }

    /// Decides by which path a whole message goes.
    void direct(std::span<const std::byte> message) {
        if (!cyclic_) return deliver(message);
        const auto parts = jaus::split(message);
        if (cyclic_->exchange().takes(parts.header)) return exchange_image(parts.header, parts.body);
        if (for_mailbox_.size() == longest_queue) return refuse(parts.header, "too many messages wait for the mailbox");
        for_mailbox_.emplace_back(message.begin(), message.end());
    }

    /// Why a message is not for the slave of this controller, or nothing.
    [[nodiscard]] std::string not_here(const jaus::header& head) const {
        const auto to = head.destination;
        const auto mine = config_.me().jausip.subsystem;
        if (to.subsystem != mine && to.subsystem != 255)
            return "subsystem " + std::to_string(to.subsystem) + " is not this one (" + std::to_string(mine) + ")";
        if (to.node != station_ && to.node != 0 && to.node != 255) // those are refused by the exchange
            return "no slave has node " + std::to_string(to.node) + "; the one here is " + std::to_string(station_);
        return {};
    }

    void refuse(const jaus::header& head, const std::string& problem) {
        std::cout << "controller: not delivered: " << problem << "\n";
        acknowledge(head, jaus::ack_nak::nak);
    }

    /// If the message asks for it.
    void acknowledge(const jaus::header& head, jaus::ack_nak how) {
        if (head.ack_nak != jaus::ack_nak::request) return;
        std::array<std::byte, jaus::header_size> answer{};
        send(answer, jaus::make_acknowledgement(head, how, answer).size());
    }

    /// To the slave, and back with the report if the message is a query; then whatever acknowledgement was asked for.
    void deliver(std::span<const std::byte> message) {
        using enum ethercat::exchange_progress;
        std::array<std::byte, example::any_exchange::buffer_size> buffer{};
        auto step = exchange_.begin(message, buffer);
        if (step.what == request)
            std::cout << "controller: translated to an SDO download packet\n"
                      << example::packet_text(std::span{buffer}.first(step.size));
        while (step.what == request) {
            const auto confirmation = execute(std::span{buffer}.first(step.size));
            step = exchange_.on_confirmation(confirmation, buffer);
            if (step.what == request)
                std::cout << "controller: asks for the report by an SDO upload packet, "
                          << example::upload_text(std::span{buffer}.first(step.size)) << "\n";
        }
        if (step.what != done)
            std::cout << "controller: not delivered: "
                      << (exchange_.error() != jauscat::translate::errc::ok ? std::string{describe(exchange_.error())}
                                                                            : text::explain(exchange_.status()))
                      << "\n";
        std::array<std::byte, jaus::header_size> acknowledgement{};
        send(acknowledgement, exchange_.acknowledgement(acknowledgement));
        send(buffer, step.size);
    }

    /// Executes a request packet and returns its confirmation; brings the slave up again first if it was lost.
    std::span<const std::byte> execute(std::span<const std::byte> request) {
        ethercat::packet_job job{request, confirmation_, {.download = options_}};
        ethercat::outcome result{};
        if (!up_ && !try_bring_up()) {
            result = master_.result();
        } else {
            example::traced_link traced{link_};
            for (bool runs = job.start(master_); runs; runs = job.next(master_))
                static_cast<void>(cyclic_ ? cyclic_->run_job(exchange_timeout, [this] { context_.poll(); })
                                          : jauscat::net::run(traced, master_, exchange_timeout));
            result = job.result();
        }
        if (!result) {
            using enum ethercat::master_errc;
            if (result.error != sdo_abort && result.error != clear_refused && result.error != mailbox_error &&
                result.error != data_too_long)
                up_ = false;
            std::cout << "controller: EtherCAT: " << example::explain(result) << "\n";
        }
        watch_.look(master_, link_, "controller");
        return std::span{confirmation_}.first(job.finish(result));
    }

    /// Sends the message in the first `size` bytes of `buffer`, if any.
    void send(std::span<const std::byte> buffer, std::size_t size) {
        if (size == 0) return;
        const auto message = buffer.first(size);
        const auto sent = send_to_next_hop(udp_, config_, message);
        std::cout << "controller: "
                  << (sent ? "sent " + text::summary(jaus::split(message).header) : "cannot answer: " + sent.problem())
                  << "\n";
    }

    jauscat::net::jaus_config config_;
    example::any_link& link_;
    example::any_exchange& exchange_;
    std::uint16_t station_;
    ethercat::download_options options_;
    boost::asio::io_context context_{};
    jauscat::net::udp_transport udp_;
    ethercat::master master_;
    example::link_watch watch_{};
    std::optional<example::cyclic_path> cyclic_{};
    std::deque<std::vector<std::byte>> for_mailbox_{}; // with cycles: the mailbox works between them
    bool up_{};
    ethercat::message_assembly<jauscat::hilscher::max_sdo_data> assembly_{std::chrono::seconds{5}};
    std::array<std::byte, ethercat::packet_job::confirmation_size> confirmation_{};
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
            ("clear-subindex-0", po::bool_switch(), "write 0 to subindex 0 of an object before each message, for slaves that abort with 06010003h else")
            ("cycle", po::value<unsigned>()->default_value(0), "microseconds from one cycle of process data to the next: wrench efforts then go without the mailbox; 0: no cycles")
            ("watchdog", po::value<unsigned>()->default_value(0), "with --cycle: milliseconds without outputs after which the slave leaves OP, up to 6500; 0: the slave's own time, mostly 100")
            ("wait", po::value<unsigned>()->default_value(5000), "milliseconds to wait for the slave at the start")
            ("frame-timeout", po::value<unsigned>()->default_value(20), "milliseconds after which a frame is lost");
        // clang-format on
        example::add_link_options(options);
        const auto values = example::parse(argc, argv, options, help);
        const auto station = values["station"].as<std::uint16_t>();
        if (station < 1 || station > 254) throw example::usage_error{"--station must be 1 to 254"};
        if (values["watchdog"].as<unsigned>() > 6500) throw example::usage_error{"--watchdog must be 0 to 6500"};
        const auto config = example::load_config(values);
        return example::with_link(values, example::link_end::master, [&](auto& link, const std::string& where) {
            std::cout << "controller: " << where << "\n";
            const ethercat::slave_identity slave{.subsystem = config.me().jausip.subsystem, .station = station};
            std::unique_ptr<example::any_exchange> exchange;
            example::with_table(values, [&]<class Table>() {
                exchange = std::make_unique<example::exchange_under<Table>>(slave);
                return example::success;
            });
            const std::chrono::milliseconds frame_timeout{values["frame-timeout"].as<unsigned>()};
            const ethercat::download_options download{.clear_subindex_0 = values["clear-subindex-0"].as<bool>()};
            robot_controller controller{config,
                                        link,
                                        *exchange,
                                        station,
                                        frame_timeout,
                                        download,
                                        std::chrono::microseconds{values["cycle"].as<unsigned>()},
                                        std::chrono::milliseconds{values["watchdog"].as<unsigned>()}};
            controller.bring_up(std::chrono::milliseconds{values["wait"].as<unsigned>()});
            return controller.serve();
        });
    });
}
