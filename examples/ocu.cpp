// The operator control unit: commands a wrench effort over JAUS, asks for it back, and compares; or sends any other
// message that the robot knows.
#include "support/program.hpp"
#include "support/robot_messages.hpp"
#include <jauscat/jaus/requested_fields.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/jaus.hpp>

#include <functional>
#include <random>

namespace {

namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
namespace text = jauscat::text;

constexpr const char* help = R"(ocu: commands the efforts of a robot arm and asks them back.

  ocu [options] [FIELD=VALUE ...]

Examples:
  ocu propulsive_linear_effort_x=50 resistive_linear_effort_x=12.5
  ocu --to 2.2.33.1 --random 7
  ocu --query
  ocu --send set_travel_speed desired_speed=2.5
  ocu --send report_component_status primary_status_code=ready secondary_status_code=0

Without --send the fields are those of Set Wrench Effort.
Exit code: 0 when the report equals the command, or the message of --send was answered as it should be; 1 when not, or
nobody answers; 2 for a wrong command line.
)";

using words = std::vector<std::string>;

/// The message with the fields that the command line names.
template <class Message> Message message_from(const words& assignments) {
    Message message{};
    wire::arena no_lists{{}};
    if (const auto wrong = text::from_words(assignments, message, no_lists); !wrong.empty())
        throw example::usage_error{wrong};
    return message;
}

jaus::set_wrench_effort random_command(std::uint32_t seed) {
    std::mt19937 random{seed};
    jaus::set_wrench_effort command{};
    wire::visit(command, [&]<class Item>(Item, auto& effort) {
        using range = typename Item::codec_type::range_type;
        if (random() % 2 != 0) effort = std::uniform_real_distribution<double>{range::min, range::max}(random);
    });
    return command;
}

/// The operator's end of the conversation: one message out, its answer in.
class operator_console {
  public:
    operator_console(jauscat::net::jaus_config config, jaus::address robot, std::chrono::milliseconds timeout)
        : config_{std::move(config)}, robot_{robot}, timeout_{timeout}, udp_{context_, config_.me().endpoint()} {
        udp_.start([this](auto bytes, const auto&, auto) { received(bytes); },
                   [](std::string_view problem) { std::cout << "ocu: " << problem << "\n"; });
    }

    /// Sends `body` and waits for the message that answers it: an acknowledgement, or the report with `report_code`.
    template <jaus::coded_message Message> bool ask(const Message& body, std::uint16_t report_code) {
        std::array<std::byte, jaus::header_size + wire::max_size<Message>> message{};
        awaited_code_ = report_code != 0 ? report_code : Message::command_code;
        ++sequence_;
        const auto size =
            jaus::make_message({.ack_nak = report_code == 0 ? jaus::ack_nak::request : jaus::ack_nak::none,
                                .destination = robot_,
                                .source = me(),
                                .sequence_number = sequence_},
                               body, message);
        if (!size) throw std::runtime_error{std::string{describe(size.error())}};
        const auto bytes = std::span{message}.first(size.size());
        show("sends", bytes);

        for (int attempt = 1; attempt <= attempts; ++attempt) {
            answer_.clear();
            if (const auto sent = send_to_next_hop(udp_, config_, bytes); !sent)
                throw std::runtime_error{sent.problem()};
            if (jauscat::net::run_until(context_, timeout_, [this] { return !answer_.empty(); })) {
                show("receives", answer_);
                return true;
            }
            if (example::stop_requested) return false;
            std::cout << "ocu: no answer within " << timeout_.count() << " ms, attempt " << attempt << " of "
                      << attempts << "\n";
        }
        return false;
    }

    [[nodiscard]] jaus::split_message answer() const { return jaus::split(answer_); }

  private:
    static constexpr int attempts = 5;

    [[nodiscard]] jaus::address me() const {
        auto id = config_.me().jausip;
        if (id.node == 0) id.node = 1;
        if (id.component == 0) id.component = 32; // Subsystem Commander
        if (id.instance == 0) id.instance = 1;
        return id;
    }
    static void show(const char* verb, std::span<const std::byte> bytes) {
        std::cout << "ocu " << verb << " " << text::summary(jaus::split(bytes).header) << "\n"
                  << text::annotate_message(bytes, robot_messages{});
    }
    void received(std::span<const std::byte> bytes) {
        const auto message = jaus::split(bytes);
        if (!message) {
            std::cout << "ocu: dropped " << bytes.size() << " bytes: " << describe(message.error) << "\n";
            return;
        }
        const bool answers = message.header.sequence_number == sequence_ &&
                             (message.header.command_code == awaited_code_ || is_acknowledgement(message.header));
        if (answers)
            answer_.assign(bytes.begin(), bytes.end());
        else
            std::cout << "ocu: not awaited: " << text::summary(message.header) << "\n";
    }

    jauscat::net::jaus_config config_;
    jaus::address robot_;
    std::chrono::milliseconds timeout_;
    boost::asio::io_context context_{};
    jauscat::net::udp_transport udp_;
    std::vector<std::byte> answer_{};
    std::uint16_t awaited_code_{};
    std::uint16_t sequence_{};
};

bool command(operator_console& console, const jaus::set_wrench_effort& efforts) {
    if (!console.ask(efforts, 0)) {
        std::cout << "ocu: FAILED: nobody acknowledged the command; is robot_controller running?\n";
        return false;
    }
    if (console.answer().header.ack_nak == jaus::ack_nak::ack) return true;
    std::cout << "ocu: FAILED: the command was refused (NAK); robot_controller's output says why\n";
    return false;
}

/// Asks for the fields in `presence_vector` and compares with what was commanded, if anything was.
bool query(operator_console& console, std::uint16_t presence_vector, const jaus::set_wrench_effort* commanded) {
    if (!console.ask(jaus::query_wrench_effort{presence_vector}, jaus::report_wrench_effort::command_code)) {
        std::cout << "ocu: FAILED: no report\n";
        return false;
    }
    const auto answer = console.answer();
    jaus::report_wrench_effort report{};
    if (jaus::is_acknowledgement(answer.header) || !wire::decode(report, answer.body)) {
        std::cout << "ocu: FAILED: the query was refused or its report does not decode\n";
        return false;
    }
    if (commanded == nullptr) return true;
    // Both messages have the same layout, so equal efforts are equal bytes.
    std::array<std::byte, wire::max_size<jaus::set_wrench_effort>> expected{};
    const auto size = wire::encode(*commanded, expected);
    const bool equal = size && std::ranges::equal(std::span{expected}.first(size.size()), answer.body);
    std::cout << (equal ? "ocu: OK: the report equals the command\n"
                        : "ocu: FAILED: the report differs from the command\n");
    return equal;
}

/// Sends the message `name` and expects its report if it is a query, an acknowledgement else.
std::function<bool(operator_console&)> sender(const std::string& name, const words& assignments) {
    std::uint16_t code{};
    if (const auto wrong = text::find_message(name, code); !wrong.empty()) throw example::usage_error{wrong};
    std::function<bool(operator_console&)> made;
    const bool known = text::with_message(code, robot_messages{}, [&]<class Message>() {
        made = [code, message = message_from<Message>(assignments)](operator_console& console) {
            if (!console.ask(message, jaus::report_code_of(code))) {
                std::cout << "ocu: FAILED: no answer\n";
                return false;
            }
            const bool refused = console.answer().header.ack_nak == jaus::ack_nak::nak;
            std::cout << (refused ? "ocu: FAILED: the message was refused (NAK)\n" : "ocu: OK\n");
            return !refused;
        };
    });
    if (!known) throw example::usage_error{"the robot does not know " + text::message_name(code)};
    return made;
}

} // namespace

int main(int argc, char** argv) {
    return example::run("ocu", [&] {
        namespace po = boost::program_options;
        po::options_description options{"Options"};
        // clang-format off
        options.add_options()
            ("help", "show this text")
            ("config", po::value<std::string>()->default_value("JausConfig.xml"), "configuration file")
            ("this", po::value<std::string>(), "the system this unit is, instead of the file's <thissystem>")
            ("to", po::value<std::string>()->default_value("2.2.33.1"), "JAUS ID of the arm")
            ("random", po::value<std::uint32_t>(), "command random fields, from this seed")
            ("query", "ask for all efforts, command nothing")
            ("send", po::value<std::string>(), "send this message instead, with the FIELD=VALUE arguments")
            ("timeout", po::value<unsigned>()->default_value(1000), "milliseconds to wait for an answer")
            ("field", po::value<words>(), "FIELD=VALUE; --field itself may be left out");
        // clang-format on
        po::positional_options_description positional;
        positional.add("field", -1);
        const auto values = example::parse(argc, argv, options, help, positional);

        const bool query_only = values.count("query") != 0, random = values.count("random") != 0;
        const bool send = values.count("send") != 0, has_fields = values.count("field") != 0;
        if (query_only + random + (send || has_fields) != 1)
            throw example::usage_error{"give either FIELD=VALUE arguments, or --random SEED, or --query, or --send"};
        const words fields = has_fields ? values["field"].as<words>() : words{};
        jaus::set_wrench_effort efforts{};
        std::function<bool(operator_console&)> sending;
        if (send)
            sending = sender(values["send"].as<std::string>(), fields);
        else if (has_fields)
            efforts = message_from<jaus::set_wrench_effort>(fields);
        if (random) efforts = random_command(values["random"].as<std::uint32_t>());

        const auto robot = example::parse_address(values["to"].as<std::string>());
        operator_console console{example::load_config(values), robot,
                                 std::chrono::milliseconds{values["timeout"].as<unsigned>()}};
        if (send) return sending(console) ? example::success : example::failure;
        if (query_only) return query(console, 0x0FFF, nullptr) ? example::success : example::failure;
        const auto asked = static_cast<std::uint16_t>(jaus::presence_vector_of(efforts));
        return command(console, efforts) && query(console, asked, &efforts) ? example::success : example::failure;
    });
}
