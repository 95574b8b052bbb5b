// The interactive node: shows the messages that arrive, and sends any message of the standard by its name.
#include "line_source.hpp"
#include "message_kinds/message_kinds.hpp"
#include "support/component_of.hpp"
#include "support/message_event.hpp"
#include "support/program.hpp"
#include "support/repeated_lines.hpp"
#include "support/say.hpp"
#include <jauscat/jaus/component/component.hpp>
#include <jauscat/text/from_text.hpp>
#include <jauscat/text/jaus.hpp>

#include <unistd.h>

namespace {

namespace events = example::events;
namespace jaus = jauscat::jaus;
namespace net = jauscat::net;
namespace text = jauscat::text;
using namespace std::chrono_literals;

constexpr const char* help = R"(communicator: a JAUS node that sends messages from the keyboard or a script.

  communicator [options]

Examples:
  communicator --this a
  communicator --this b --open
  printf 'send b set_component_authority authority_code=5\nexit\n' | communicator --this a
  printf 'wait 10\n' | communicator --this b

It is the first component that the configuration lists for its node, or else component 32.
Exit code: 0; 1 if the node cannot be started, or if in a script a line was wrong or a message was refused or not
answered; 2 for a wrong command line.
)";

constexpr const char* commands =
    R"(  send WHOM MESSAGE [FIELD=VALUE ...]   WHOM: name of a system or a JAUS ID, such as b or 2.1.32.1
                                        MESSAGE: as in the standard, such as set_component_authority or 0001
  peers                                 list the systems of the configuration and the detected peers
  log on|off                            also show messages to the node manager, and repeated lines
  wait SECONDS                          wait before the next line
  help                                  this text
  exit                                  end the program; also q and quit
)";

using words = std::vector<std::string>;

class communicator {
  public:
    communicator(const net::jaus_config& config, net::jaus_node_options options, std::unique_ptr<line_source> input)
        : input_{std::move(input)},
          self_{own_component(config.me(), options.node)},
          core_{self_, memory_, hooks(), {.acknowledgement = {.first_number = example::any_number()}}},
          node_{context_, config, with_hooks(std::move(options))} {
        core_.change(jaus::state_event::initialized);
        node_.add(core_, application_);
        node_.start();
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
            std::erase_if(awaited_, [this](const awaited_report& report) {
                if (!report.until.is_reached(now())) return false;
                wrong(events::no_answer, {{"code", report.command_code}, {"address", text::to_text(report.from)}},
                      "no " + text::message_name(report.command_code) + " from " + text::to_text(report.from));
                return true;
            });
        }
        node_.stop();
        show(events::stopped, counts(), "communicator: stopped; " + summary(node_.counts()) + "\n");
        return !any_wrong_;
    }

  private:
    struct awaited_report {
        std::uint16_t command_code{};
        jaus::address from{};
        jauscat::deadline until{};
    };
    void on_state(jaus::primary_status_code from, jaus::primary_status_code to) {
        tell("state", events::state_changed,
             {{"address", text::to_text(self_)}, {"from", state_name(from)}, {"to", state_name(to)}},
             "state: " + state_name(to) + "\n");
    }
    void on_controller(const std::optional<jaus::controller>& who, jaus::control_change) {
        const auto self = text::to_text(self_);
        if (who)
            tell("controller", events::controller_taken,
                 {{"address", self}, {"controller", text::to_text(who->address)}, {"authority", who->authority_code}},
                 "controlled by " + text::to_text(who->address) + "\n");
        else
            tell("controller", events::controller_gone, {{"address", self}}, "controlled by no component\n");
    }
    void on_delivered(const jaus::awaited_message& m, jaus::delivered what) {
        const auto line = text::message_name(m.header.command_code) + " to " + text::to_text(m.header.destination) +
                          ": " + std::string{describe(what)};
        const example::event_members members{{"code", m.header.command_code},
                                             {"destination", text::to_text(m.header.destination)},
                                             {"result", result_name(what)}};
        if (what == jaus::delivered::acknowledged)
            show(events::delivery, members, line + "\n");
        else
            wrong(events::delivery, members, line);
    }
    jaus::component_hooks hooks() {
        return {.on_state = jaus::bound<&communicator::on_state>(*this),
                .on_controller = jaus::bound<&communicator::on_controller>(*this),
                .on_delivered = jaus::bound<&communicator::on_delivered>(*this)};
    }
    // Reports and answers are shown and no more; a command that the core does not know cannot be obeyed.
    struct application_type {
        jaus::message_outcome operator()(const jaus::header& head, std::span<const std::byte>) const {
            constexpr std::array<std::uint16_t, 5> answers{0x0009, 0x000F, 0x0010, 0x01F3, 0x01F4};
            const bool informs = head.command_code >= 0x4000 && head.command_code < 0x6000;
            return informs || std::ranges::find(answers, head.command_code) != answers.end()
                       ? jaus::message_outcome::handled
                       : jaus::message_outcome::unhandled;
        }
    };

    static const char* result_name(jaus::delivered what) {
        switch (what) {
        case jaus::delivered::acknowledged: return "acknowledged";
        case jaus::delivered::refused: return "refused";
        case jaus::delivered::timed_out: return "timed_out";
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

    net::jaus_node_options with_hooks(net::jaus_node_options options) {
        options.log = [this](std::string_view line) {
            const auto times = log_lines_.shown(line);
            if (times || log_) // the node limits them
                show(events::node_log, {{"line", line}, {"times", times.value_or(1)}},
                     "log: " + log_lines_.text(line, times.value_or(1)) + "\n");
        };
        options.on_message = [this](const jaus::address& component, const jaus::header& head,
                                    std::span<const std::byte> body,
                                    jaus::component_outcome what) { seen(component, head, body, what); };
        options.appeared = [this](const jaus::address& who) {
            tell("presence", events::peer_heard, {{"address", text::to_text(who)}}, text::to_text(who) + " is there\n");
        };
        options.disappeared = [this](const jaus::address& who) {
            tell("presence", events::peer_lost, {{"address", text::to_text(who)}}, text::to_text(who) + " is gone\n");
        };
        options.explain_malformed = &why_malformed;
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
        std::erase_if(awaited_, [&](const awaited_report& report) {
            return report.command_code == head.command_code && report.from == head.source;
        });
        if (component != self_ && !log_) return;
        auto first = "received " + text::summary(head);
        if (what != jaus::component_outcome::handled) first += "; " + std::string{describe(what)};
        auto lines = example::bold(first) + "\n";
        const auto* const kind = find_kind(head.command_code);
        if (!body.empty()) lines += kind != nullptr ? kind->to_text(body, 0) : text::hex_dump(body);
        tell("received", events::message_received,
             example::message_members(head, body) + example::event_members{{"result", std::string{describe(what)}}},
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
    [[nodiscard]] bool done() const { return quitting_ && core_.waiting() == 0 && awaited_.empty(); }

    void send(const words& all) {
        jaus::header head{.source = self_};
        if (const auto* const system = node_.config().find(all[1]))
            head.destination = example::component_of(*system);
        else if (const auto id = net::parse_jausip(all[1]))
            head.destination = *id;
        else
            return wrong("'" + all[1] + "' is neither a system of the configuration nor a JAUS ID; see peers");
        const auto code = text::find_message(all[2]);
        if (!code) return wrong(code.error().message);
        head.command_code = *code;
        const auto* const kind = find_kind(head.command_code);
        if (kind == nullptr) return wrong(text::message_name(head.command_code) + " cannot be sent by its name");
        const auto filled = kind->from_words(std::span{all}.subspan(3));
        if (!filled) return wrong(filled.error());
        const std::span<const std::byte> body = *filled;
        head.sequence_number = ++sequence_;
        const auto report = jaus::report_code_of(head.command_code);
        const bool to_one = jaus::names_one_component(head.destination);
        if (report == 0 && to_one && body.size() <= jaus::max_body_size)
            send_acknowledged(head, body);
        else if (const auto sent = node_.send(head, body); !sent)
            wrong(events::not_sent, {{"code", head.command_code}}, sent.error().message);
        else {
            show(events::message_sent, example::message_members(head, body),
                 "sent " + text::message_name(head.command_code) + " to " + text::to_text(head.destination) + "\n");
            if (report != 0 && to_one) awaited_.push_back({report, head.destination, jauscat::deadline{now(), 2s}});
        }
    }
    void send_acknowledged(const jaus::header& head, std::span<const std::byte> body) {
        std::array<std::byte, jaus::header_size + jaus::max_body_size> message{};
        const auto made = jaus::join(head, body, message);
        if (!made) return wrong(events::not_sent, {{"code", head.command_code}}, std::string{describe(made.error())});
        show(events::message_sent, example::message_members(head, body),
             "sent " + text::message_name(head.command_code) + " to " + text::to_text(head.destination) + "\n");
        const auto what = core_.send(*made, now(), node_.out());
        if (!what) wrong(events::not_sent, {{"code", head.command_code}}, std::string{describe(what.error())});
    }
    void peers() {
        std::string lines, names, heard;
        for (const auto& system : node_.config().systems) {
            names += (names.empty() ? "" : " ") + system.name;
            lines += "  " + padded(system.name, 12) + padded(net::to_jausip(system.jausip), 17) +
                     padded(net_address(system), 28) + "framing " + std::string{jaus::name(system.framing)} +
                     (system.name == node_.config().this_system ? ", this system" : "") + "\n";
        }
        if (const auto* const present = node_.present(); present != nullptr && present->size() != 0) {
            lines += "  heard:";
            present->for_each(
                [&](const jaus::address& who) { heard += (heard.empty() ? "" : " ") + text::to_text(who); });
            lines += ' ' + heard + "\n";
        } else
            lines += "  no peers\n";
        show(events::peers, {{"systems", names}, {"heard", heard}}, lines);
    }

    std::unique_ptr<line_source> input_;
    jaus::address self_;
    boost::asio::io_context context_{};
    example::repeated_lines log_lines_{};
    example::event_limit limit_{};
    bool log_{}, quitting_{}, any_wrong_{};
    jauscat::time_point next_line_at_{};
    std::vector<awaited_report> awaited_{};
    std::uint16_t sequence_{};
    application_type application_{};
    jaus::component_memory<16, jaus::header_size + jaus::max_body_size> memory_{};
    jaus::component<> core_;
    net::jaus_node node_;
};

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
            ("open", "accept messages from all senders, for tests")
            ("reuse", "share address and port with other programs (SO_REUSEADDR)");
        // clang-format on
        example::add_log_option(options);
        const auto values = example::parse(argc, argv, options, help);
        const auto id = [&](const char* name) {
            const auto number = values[name].as<unsigned>();
            if (number > 254) throw example::usage_error{std::string{"--"} + name + " must be 0 to 254"};
            return static_cast<std::uint8_t>(number);
        };
        net::jaus_node_options how{.accept = values.count("open") != 0 ? net::access::open : net::access::closed,
                                   .node = id("node"),
                                   .primary = id("primary"),
                                   .socket = {.reuse_address = values.count("reuse") != 0}};
        const bool by_hand = ::isatty(STDIN_FILENO) != 0;
        communicator node{example::load_config(values), std::move(how),
                          by_hand ? terminal_lines("> ") : script_lines()};
        return node.run() || by_hand ? example::success : example::failure;
    });
}
