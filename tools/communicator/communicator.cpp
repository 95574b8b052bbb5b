// The interactive node: shows the messages that arrive, and sends any message by its name or code.
#include "completion.hpp"
#include "line_source.hpp"
#include "support/component_of.hpp"
#include "support/known_messages.hpp"
#include "support/message_event.hpp"
#include "support/node_options.hpp"
#include "support/repeated_lines.hpp"
#include "support/say.hpp"
#include <jauscat/app/component.hpp>
#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/net/config/jaus_config.hpp>
#include <jauscat/net/detail/endpoint_text.hpp>
#include <jauscat/net/node/run_until.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/jaus.hpp>

#include <unistd.h>

namespace {

namespace events = example::events;
namespace jaus = jauscat::jaus;
namespace net = jauscat::net;
namespace text = jauscat::text;
using namespace std::chrono_literals;

constexpr const char* help =
    R"(communicator: a JAUS node that sends messages from the keyboard or a script, and shows those that arrive.

  communicator [options]

Examples:
  communicator --this a
  communicator --this b --open
  printf 'send b set_component_authority authority_code=5\nexit\n' | communicator --this a
  printf 'wait 10\n' | communicator --this b
  printf 'send b D101 hex=000301f00132\nexit\n' | communicator --this a --unacknowledged

A message with an unknown code, such as a private one (D000h to FFFFh), is sent with its body in hex and shown in hex. With the cmake
option JAUSCAT_PRIVATE_MESSAGES=HEADER the messages of a header have names and fields here; docs/catalogue.md says how.
Private messages that are known are acknowledged; other commands are refused, for nothing here obeys them.

On a terminal, Tab completes commands, systems, messages, fields and names of values, and the history is kept in
~/.local/state/jauscat/communicator (or below $XDG_STATE_HOME).

It is the first component that the configuration lists for its node, or else component 32.
Exit code: 0; 1 if the node cannot be started, or if in a script a line was wrong or a message was refused or not
answered; 2 for a wrong command line.
)";

constexpr const char* commands =
    R"(  send WHOM MESSAGE [FIELD=VALUE ...]   WHOM: name of a system or a JAUS ID, such as b or 2.1.32.1
                                        MESSAGE: as in the standard, such as set_component_authority or 0001
  send WHOM MESSAGE hex=DIGITS          the same with the body byte for byte; MESSAGE may be any code, such as D101
  acknowledge on|off                    request acknowledgements of commands, as is the default, or none
  peers                                 list the systems of the configuration and the detected peers
  log on|off                            also show messages to the node manager, and repeated lines
  wait SECONDS                          wait before the next line
  help                                  this text
  exit                                  end the program; also q and quit
On a terminal, Tab completes commands, systems, messages and fields.
)";

using boost::system::error_code;
using words = std::vector<std::string>;

class communicator {
  public:
    /// `acknowledged`: commands request an acknowledgement.
    communicator(const net::jaus_config& config, jauscat::node_options options, bool acknowledged,
                 std::unique_ptr<line_source> input)
        : input_{std::move(input)},
          acknowledged_{acknowledged},
          config_{config},
          self_{own_component(config.me(), options.node)},
          node_{context_, with_hooks(std::move(options))},
          unit_{node_, {.id = self_.component, .instance = self_.instance, .name = "communicator"}} {
        unit_.on_others([](const jaus::header& head, auto) { return outcome_of(head); });
        node_.when_appeared([this](const jaus::address& who) {
            present_.push_back(who);
            tell("presence", events::peer_heard, {{"address", text::to_text(who)}}, text::to_text(who) + " is there\n");
        });
        node_.when_disappeared([this](const jaus::address& who) {
            std::erase(present_, who);
            tell("presence", events::peer_lost, {{"address", text::to_text(who)}}, text::to_text(who) + " is gone\n");
        });
        unit_.ready();
        node_.start();
        tell_changes();
        show(events::ready,
             {{"address", text::to_text(self_)},
              {"system", config.this_system},
              {"endpoint", net::detail::text(config.me().endpoint())}},
             "communicator: " + text::to_text(self_) + " of " + config.this_system + " at " + net_address(config.me()) +
                 "; help lists the commands\n");
    }

    /// Until the user quits, the input ends or a signal comes. True if nothing went wrong.
    bool run() {
        while (!example::stop_requested && !done()) {
            if (!quitting_ && now() >= next_line_at_) {
                if (const auto line = input_->next())
                    obey(*line);
                else if (input_->ended())
                    quit();
            }
            static_cast<void>(net::run_until(context_, 10ms, [] { return example::stop_requested.load(); }));
            tell_changes();
        }
        node_.stop();
        show(events::stopped, counts(), "communicator: stopped; " + summary(node_.counts()) + "\n");
        return !any_wrong_;
    }

  private:
    /// Reports, answers and private messages that are known are shown and no more; another command cannot be obeyed.
    static jaus::message_outcome outcome_of(const jaus::header& head) {
        constexpr std::array<std::uint16_t, 5> answers{0x0009, 0x000F, 0x0010, 0x01F3, 0x01F4};
        const bool informs = head.command_code >= 0x4000 && head.command_code < 0x6000;
        const bool is_known_private =
            jaus::is_private(head.command_code) && example::known_messages().find(head.command_code) != nullptr;
        return informs || is_known_private || std::ranges::find(answers, head.command_code) != answers.end()
                   ? jaus::message_outcome::handled
                   : jaus::message_outcome::unhandled;
    }
    /// State and controller, if they have changed.
    void tell_changes() {
        const auto self = text::to_text(self_);
        const auto state = unit_.state();
        if (const auto before = std::exchange(state_, state); before != state)
            tell("state", events::state_changed,
                 {{"address", self}, {"from", state_name(before)}, {"to", state_name(state)}},
                 "state: " + state_name(state) + "\n");
        const auto controller = unit_.controller();
        const bool is_same = controller == controller_ && (!controller || authority_ == told_authority_);
        controller_ = controller;
        told_authority_ = authority_;
        if (is_same) return;
        if (controller)
            tell("controller", events::controller_taken,
                 {{"address", self}, {"controller", text::to_text(*controller)}, {"authority", authority_}},
                 "controlled by " + text::to_text(*controller) + "\n");
        else
            tell("controller", events::controller_gone, {{"address", self}}, "controlled by no component\n");
    }
    /// The authority of the controller is in its request.
    void note_authority(const jaus::header& head, std::span<const std::byte> body) {
        jaus::request_component_control request{};
        if (head.command_code == jaus::command_code_of<jaus::request_component_control> &&
            unit_.controller() == head.source && jauscat::wire::decode(request, body))
            authority_ = request.authority_code;
    }
    /// A command has an acknowledgement, or none.
    void delivered(const jaus::header& head, error_code error) {
        --open_;
        const bool is_sent = !error || error == jauscat::node_errc::refused || error == jauscat::node_errc::no_answer;
        if (!is_sent) return not_sent(head, error.message());
        const auto what = !error                                 ? jaus::delivered::acknowledged
                          : error == jauscat::node_errc::refused ? jaus::delivered::refused
                                                                 : jaus::delivered::timed_out;
        const auto line = example::message_name(head.command_code) + " to " + text::to_text(head.destination) + ": " +
                          std::string{describe(what)};
        const example::event_members members{{"code", head.command_code},
                                             {"destination", text::to_text(head.destination)},
                                             {"result", result_name(what)}};
        if (!error)
            show(events::delivery, members, line + "\n");
        else
            wrong(events::delivery, members, line);
    }
    /// A query has its report, or none.
    void answered(const jaus::header& head, error_code error) {
        --open_;
        if (error == jauscat::node_errc::no_answer) {
            const auto report = jaus::report_code_of(head.command_code);
            wrong(events::no_answer, {{"code", report}, {"address", text::to_text(head.destination)}},
                  "no " + example::message_name(report) + " from " + text::to_text(head.destination));
        } else if (error)
            not_sent(head, error.message());
    }
    static bool is_like(const jaus::header& a, const jaus::header& b) {
        return a.command_code == b.command_code && a.destination == b.destination;
    }
    /// Shows the first copy of a message of the user's.
    void sent(std::span<const std::byte> message) {
        const auto parts = jaus::split(message);
        const auto& head = parts.header;
        const auto found = std::ranges::find_if(unsent_, [&](const auto& one) { return is_like(one, head); });
        if (found == unsent_.end() || head.source != self_) return;
        unsent_.erase(found);
        show(events::message_sent, example::message_members(head, parts.body, example::message_name(head.command_code)),
             "sent " + example::message_name(head.command_code) + " to " + text::to_text(head.destination) + "\n");
    }
    void not_sent(const jaus::header& head, const std::string& why) {
        std::erase_if(unsent_, [&](const auto& one) { return is_like(one, head); });
        wrong(events::not_sent, {{"code", head.command_code}}, why);
    }

    static const char* result_name(jaus::delivered what) {
        switch (what) {
        case jaus::delivered::acknowledged: return "acknowledged";
        case jaus::delivered::refused: return "refused";
        case jaus::delivered::timed_out:
        case jaus::delivered::control_lost: return "timed_out";
        }
        return "unknown";
    }
    /// Those of the socket that are not 0.
    [[nodiscard]] example::event_members counts() const {
        example::event_members made;
        const auto all = node_.counts();
        for (const auto& [name, value] : net::udp_counter_list)
            if (all.*value != 0) made.emplace_back(counter_name(name), all.*value);
        return made;
    }
    /// `unknown peer`: unknown_peer.
    static std::string_view counter_name(std::string_view name) {
        if (name == "unknown peer") return "unknown_peer";
        if (name == "wrong sender") return "wrong_sender";
        if (name == "rate-limited") return "rate_limited";
        if (name == "would block") return "would_block";
        return name;
    }
    static std::string state_name(jaus::primary_status_code state) { return std::string{text::enumerator_name(state)}; }
    static std::string padded(std::string text, std::size_t width) {
        text.resize(std::max(text.size() + 1, width), ' ');
        return text;
    }
    static jauscat::time_point now() { return net::now(); }
    static std::string net_address(const net::system_entry& me) {
        return me.ip.to_string() + " port " + std::to_string(me.port);
    }
    static jaus::address own_component(const net::system_entry& me, std::uint8_t node) {
        auto id = example::component_of(me);
        if (node != 0) id.node = node;
        return id;
    }

    jauscat::node_options with_hooks(jauscat::node_options options) {
        options.config = config_.source;
        options.this_system = config_.this_system;
        options.node = self_.node;
        options.log = [this](std::string_view line) {
            const auto times = log_lines_.shown(line);
            if (times || log_) // the node limits them
                show(events::node_log, {{"line", line}, {"times", times.value_or(1)}},
                     "log: " + log_lines_.text(line, times.value_or(1)) + "\n");
        };
        options.explain_malformed = example::known_messages().explainer();
        options.on_handled = [this](const jaus::address& component, const jaus::header& head,
                                    std::span<const std::byte> body,
                                    jaus::component_outcome what) { seen(component, head, body, what); };
        options.on_sent = [this](std::span<const std::byte> message) { sent(message); };
        return options;
    }
    void show(example::event_kind kind, const example::event_members& members, const std::string& lines,
              std::uint64_t left_out = 0) {
        input_->show(example::log_lines(kind, members, lines, left_out));
    }
    /// An event caused by a peer, limited: a peer may send without end.
    void tell(const std::string& cause, example::event_kind kind, const example::event_members& members,
              const std::string& lines) {
        if (const auto left_out = limit_.admit(cause)) show(kind, members, lines, *left_out);
    }
    void wrong(example::event_kind kind, const example::event_members& members, const std::string& line) {
        any_wrong_ = true;
        show(kind, members, example::bad(line) + "\n");
    }
    /// A line of the user that cannot be obeyed.
    void wrong(const std::string& line) { wrong(events::line_refused, {}, line); }

    void seen(const jaus::address& component, const jaus::header& head, std::span<const std::byte> body,
              jaus::component_outcome what) {
        if (component == self_) {
            note_authority(head, body);
            tell_changes();
        }
        if (component != self_ && !log_) return;
        auto first = "received " + example::summary(head);
        if (what != jaus::component_outcome::handled) first += "; " + std::string{describe(what)};
        auto lines = example::bold(first) + "\n";
        if (!body.empty()) lines += example::body_lines(head.command_code, body, 0);
        tell("received", events::message_received,
             example::message_members(head, body, example::message_name(head.command_code)) +
                 example::event_members{{"result", std::string{describe(what)}}},
             lines);
    }

    void obey(const std::string& line) {
        const auto split = text::split(line);
        if (!split) return wrong(split.error().message);
        const words& all = *split;
        if (all.empty() || all.front().starts_with('#')) return;
        const auto& verb = all.front();
        if (verb == "send" && all.size() >= 3) return send(all);
        if (verb == "send") return wrong("send WHOM MESSAGE [FIELD=VALUE ...], such as: send b query_component_status");
        if (verb == "exit" || verb == "quit" || verb == "q") return quit();
        if (verb == "help") return show(events::command_help, {}, commands);
        if (verb == "peers") return peers();
        if (verb == "log" && all.size() == 2 && (all[1] == "on" || all[1] == "off")) {
            log_ = all[1] == "on";
            return show(events::log_switched, {{"on", log_}}, "log " + all[1] + "\n");
        }
        if (verb == "acknowledge" && all.size() == 2 && (all[1] == "on" || all[1] == "off")) {
            acknowledged_ = all[1] == "on";
            return show(events::acknowledgement_switched, {{"on", acknowledged_}}, "acknowledge " + all[1] + "\n");
        }
        if (verb == "wait" && all.size() == 2) {
            char* end{};
            const double seconds = std::strtod(all[1].c_str(), &end);
            if (end != all[1].c_str() && *end == '\0' && seconds >= 0 && seconds <= 86400) {
                next_line_at_ =
                    now() + std::chrono::duration_cast<jauscat::duration>(std::chrono::duration<double>{seconds});
                return;
            }
        }
        wrong("'" + line + "' is not a command; help lists the commands");
    }
    void quit() { quitting_ = true; }
    /// Quitting waits for answers; each arrives or times out within two seconds.
    [[nodiscard]] bool done() const { return quitting_ && open_ == 0; }

    void send(const words& all) {
        jaus::header head{.source = self_};
        if (const auto* const system = config_.find(all[1]))
            head.destination = example::component_of(*system);
        else if (const auto id = net::parse_jausip(all[1]))
            head.destination = *id;
        else
            return wrong("'" + all[1] + "' is neither a system of the configuration nor a JAUS ID; see peers");
        const auto message = example::read_message(all[2], std::span{all}.subspan(3));
        if (!message) return wrong(message.error().message);
        head.command_code = message->command_code;
        const std::span<const std::byte> body = message->body;
        const bool asks = jaus::report_code_of(head.command_code) != 0;
        unsent_.push_back(head);
        if (!jaus::names_one_component(head.destination) || (!acknowledged_ && !asks)) {
            const auto done = unit_.send(head.destination, head.command_code, body);
            if (!done) not_sent(head, done.error().message);
            return;
        }
        ++open_;
        if (asks)
            unit_.async_ask(head.destination, head.command_code, body, {.timeout = 2s, .acknowledged = false},
                            [this, head](error_code error, auto&&) { answered(head, error); });
        else
            unit_.async_send(head.destination, head.command_code, body,
                             [this, head](error_code error) { delivered(head, error); });
    }
    void peers() {
        std::string lines, names, heard;
        for (const auto& system : config_.systems) {
            if (!system.has_ra) continue;
            names += (names.empty() ? "" : " ") + system.name;
            lines += "  " + padded(system.name, 12) + padded(net::to_jausip(system.jausip), 17) +
                     padded(net_address(system), 28) + "framing " + std::string{jaus::name(system.framing)} +
                     (system.name == config_.this_system ? ", this system" : "") + "\n";
        }
        if (!present_.empty()) {
            lines += "  heard:";
            for (const auto& who : present_) heard += (heard.empty() ? "" : " ") + text::to_text(who);
            lines += ' ' + heard + "\n";
        } else
            lines += "  no peers\n";
        show(events::peers, {{"systems", names}, {"heard", heard}}, lines);
    }

    std::unique_ptr<line_source> input_;
    bool acknowledged_;
    net::jaus_config config_;
    jaus::address self_;
    example::repeated_lines log_lines_{};
    example::event_limit limit_{};
    bool log_{}, quitting_{}, any_wrong_{};
    jauscat::time_point next_line_at_{};
    std::vector<jaus::header> unsent_{}; ///< messages of the user's that are about to be sent
    std::size_t open_{};                 ///< messages that wait for their answer
    std::vector<jaus::address> present_{};
    jaus::primary_status_code state_{};
    std::optional<jaus::address> controller_{};
    std::uint8_t authority_{}, told_authority_{}; ///< of the controller

    boost::asio::io_context context_{};
    jauscat::node node_;
    jauscat::component unit_;
};

/// Where the history of a user is; empty without a home.
std::filesystem::path history_file() {
    const auto folder = [](const char* variable, const char* below) {
        const char* const value = std::getenv(variable);
        return value == nullptr || *value == '\0' ? std::filesystem::path{} : std::filesystem::path{value} / below;
    };
    auto found = folder("XDG_STATE_HOME", "jauscat");
    if (found.empty()) found = folder("HOME", ".local/state/jauscat");
    return found.empty() ? found : found / "communicator";
}

} // namespace

int main(int argc, char** argv) {
    return example::run("communicator", [&] {
        namespace po = boost::program_options;
        po::options_description options;
        // clang-format off
        options.add_options()
            ("config", po::value<std::string>()->default_value("JausConfig.xml"), "configuration file")
            ("this", po::value<std::string>(), "the system this node is, instead of the file's <thissystem>")
            ("node", po::value<unsigned>()->default_value(0), "JAUS node of this program; 0: that of the file, or 1")
            ("primary", po::value<unsigned>()->default_value(0), "the node that relays within the subsystem; 0: none")
            ("unacknowledged", po::bool_switch(), "request no acknowledgements of commands, for peers that never send them")
            ("open", "accept messages from all senders, for tests")
            ("reuse", "share address and port with other programs (SO_REUSEADDR)");
        // clang-format on
        example::add_type_option(options);
        example::add_log_option(options);
        const auto values = example::parse(argc, argv, options, help);
        const auto id = [&](const char* name) {
            const auto number = values[name].as<unsigned>();
            if (number > 254) throw example::usage_error{std::string{"--"} + name + " must be 0 to 254"};
            return static_cast<std::uint8_t>(number);
        };
        jauscat::node_options how{.node = id("node"),
                                  .primary = id("primary"),
                                  .type = example::subsystem_type(values),
                                  .open = values.count("open") != 0,
                                  .reuse_address = values.count("reuse") != 0};
        const bool by_hand = ::isatty(STDIN_FILENO) != 0;
        const auto config = example::load_config(values);
        std::vector<std::string> systems;
        for (const auto& system : config.systems)
            if (system.has_ra) systems.push_back(system.name);
        communicator node{config, std::move(how), !values["unacknowledged"].as<bool>(),
                          by_hand ? terminal_lines(
                                        "> ", [&](auto line) { return completions(line, systems); }, history_file())
                                  : std::make_unique<script_lines>()};
        return node.run() || by_hand ? example::success : example::failure;
    });
}
