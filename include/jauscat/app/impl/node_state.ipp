// The functions of node_state and node.
#pragma once
#include <jauscat/app/impl/component_state.hpp>
#include <jauscat/app/impl/node_state.hpp>
#include <jauscat/app/node.hpp>
#include <jauscat/net/config/read_jaus_config.hpp>
#include <jauscat/net/detail/endpoint_text.hpp>
#include <jauscat/net/detail/quoted.hpp>
#include <jauscat/net/node/detail/configured_identity.hpp>
#include <jauscat/version.hpp>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

inline net::jaus_config read_config(const node_options& options) {
    auto config = options.config_text.empty() ? net::read_jaus_config(options.config)
                                              : net::parse_jaus_config(options.config_text, "config_text");
    return options.this_system.empty() ? config : config.with_this(options.this_system);
}

JAUSCAT_DECL node_state::node_state(boost::asio::io_context* context, node_options options)
    : options_{std::move(options)},
      own_context_{context == nullptr ? std::make_shared<boost::asio::io_context>(1) : nullptr},
      context_{context == nullptr ? std::make_shared<node_context>(own_context_)
                                  : std::make_shared<node_context>(*context)},
      net_{context_->get(), read_config(options_), net_options()} {}

JAUSCAT_DECL net::jaus_node_options node_state::net_options() {
    net::jaus_node_options net{.accept = options_.open ? net::access::open : net::access::closed,
                               .node = options_.node,
                               .primary = options_.primary,
                               .type = options_.type,
                               .socket = {.reuse_address = options_.reuse_address}};
    net.log = [this](std::string_view line) { log(line); };
    net.explain_malformed = [this](std::uint16_t command_code, bytes body) {
        std::string error;
        for (const auto& one : components_)
            if (!one->malformed_because.empty()) error = std::exchange(one->malformed_because, {});
        const auto why = options_.explain_malformed ? options_.explain_malformed(command_code, body) : std::string{};
        return why.empty() ? error : why;
    };
    net.large_data_done = [this](const jaus::header& head, jaus::delivered what) {
        for (const auto& one : components_)
            if (one->is_running() && one->self() == head.source) one->on_large_delivered(head, what);
    };
    net.on_received = options_.on_received;
    net.on_sent = options_.on_sent;
    net.on_message = options_.on_handled;
    net.appeared = [this](const jaus::address& who) {
        for (const auto& one : components_)
            if (one->is_running()) one->on_appeared(who);
        if (on_appeared) on_appeared(who);
    };
    net.disappeared = [this](const jaus::address& who) {
        if (on_disappeared) on_disappeared(who);
    };
    return net;
}

JAUSCAT_DECL void node_state::log(std::string_view line) const {
    if (options_.log) return options_.log(line);
    std::string whole = options_.name.empty() ? std::string{} : options_.name + ": ";
    std::cerr << whole.append(line).append("\n");
}

JAUSCAT_DECL void node_state::add(const std::shared_ptr<component_state>& component) {
    const auto& self = component->self();
    if (net_.running())
        throw std::logic_error{"the component " + net::to_jausip(self) + " is made after the start of its node"};
    if (!jaus::names_one_component(self))
        throw std::invalid_argument{"component ID and instance are 1 to 254, not " + net::to_jausip(self)};
    if (has(self))
        throw std::invalid_argument{"the node has a component " + net::to_jausip(self) +
                                    " already; give this one another ID or instance"};
    components_.push_back(component);
}
JAUSCAT_DECL bool node_state::has(const jaus::address& self) const {
    return self == net_.manager() ||
           std::ranges::any_of(components_,
                               [&](const auto& one) { return one->self() == self && !one->is_closed(); }) ||
           std::ranges::any_of(parts_, [&](const auto& one) { return one.has(self); });
}

JAUSCAT_DECL std::vector<component_status> node_state::statuses() const {
    std::vector<component_status> all;
    const auto* const present = net_.present();
    if (present != nullptr)
        all.push_back(
            {.id = net_.manager(),
             .is_own = true,
             .name = "node manager",
             .state = net_.running() ? jaus::primary_status_code::ready : jaus::primary_status_code::shutdown});
    for (const auto& one : components_)
        if (!one->is_closed())
            all.push_back({.id = one->self(),
                           .is_own = true,
                           .name = std::string{one->identity().identification},
                           .state = one->state(),
                           .controller = one->controller()});
    for (const auto& one : parts_)
        if (one.list) one.list(all);
    for (auto& one : all) {
        const jaus::identity named{.identification = one.name};
        one.name = std::string{net::detail::identity_of(net_.config(), one.id, named).identification};
    }
    if (present == nullptr) return all;
    const auto own = all.size();
    const auto now = net::now();
    present->for_each([&](const jaus::address& id) {
        const auto ours = all.begin() + static_cast<std::ptrdiff_t>(own);
        if (std::ranges::find(all.begin(), ours, id, &component_status::id) != ours) return;
        all.push_back({.id = id, .age = now - present->find(id)->last_heard_at});
    });
    return all;
}

JAUSCAT_DECL void node_state::require_stopped() const {
    if (net_.running()) throw std::logic_error{"the node is running"};
    const auto is_at_work = [](const auto& one) { return one->is_in_turn(); };
    if (net_.in_turn() || is_stopping_ || std::ranges::any_of(components_, is_at_work))
        throw std::logic_error{"a node is not started by a function that it calls: post the start"};
}

JAUSCAT_DECL void node_state::start() {
    require_stopped(); // before anything is changed: the components' state machines are built anew
    is_stopped_ = false;
    context_->open();
    const auto now = net::now();
    const auto& config = net_.config();
    const bool has_manager = net::detail::covers(config.me().jausip, net_.manager());
    static constexpr auto nothing_more = [](const jaus::header&, bytes) { return jaus::message_outcome::unhandled; };
    std::erase_if(components_, [&](const auto& one) {
        if (one->is_closed() && one->is_added) net_.remove(one->self());
        return one->is_closed();
    });
    for (const auto& one : components_)
        if (!one->is_closed() && !net::detail::covers(config.me().jausip, one->self()))
            throw std::invalid_argument{"the component " + net::to_jausip(one->self()) + " is outside of the jausip " +
                                        net::to_jausip(config.me().jausip) + " of its system " +
                                        net::detail::quoted(config.me().name) + ": no message would come to it"};
    for (const auto& one : components_) {
        one->start(net::detail::identity_of(config, one->self(), one->identity()), !has_manager, now);
        if (!std::exchange(one->is_added, true)) net_.add(*one, nothing_more);
    }
    try {
        net_.start();
    } catch (...) {
        for (const auto& one : components_) one->stop();
        throw;
    }
    for (const auto& one : components_) one->begin();
    for (const auto& one : parts_) one.start();
}

JAUSCAT_DECL void node_state::stop() {
    if (is_stopping_) return; // by a function that it calls
    struct stopping {
        bool& flag;
        explicit stopping(bool& f) : flag{f} { flag = true; }
        ~stopping() { flag = false; }
    } const now{is_stopping_};
    const bool was_stopped = std::exchange(is_stopped_, true);
    for (const auto& one : components_) one->stop();
    for (const auto& one : parts_) one.stop();
    context_->close(); // before what may throw
    net_.stop();
    signals_.reset();                                       // they keep a context at work
    if (own_context_ && !was_stopped) own_context_->stop(); // not by a handler that `finish` calls
}

JAUSCAT_DECL void node_state::await_signals() {
    signals_.emplace(context_->get(), SIGINT, SIGTERM)
        .async_wait([this, token = std::weak_ptr{alive_}](boost::system::error_code error, int) {
            if (!error && !token.expired()) stop(); // a signal that came at the end is handled after it
        });
}

JAUSCAT_DECL void node_state::finish() {
    own_context_->restart();
    bool is_last = false;
    boost::asio::post(*own_context_, [&] { is_last = true; });
    while (!is_last && own_context_->run_one() != 0) {} // a handler may stop the context itself
}

JAUSCAT_DECL void node_state::release() noexcept {
    for (const auto& one : components_) one->lose_node();
    for (const auto& one : parts_) one.end();
}

JAUSCAT_DECL std::string node_state::names() const {
    std::string all;
    for (const auto& one : components_)
        if (one->is_running())
            all.append(one->identity().identification.empty() ? "," : ", ")
                .append(one->identity().identification)
                .append(" ")
                .append(net::to_jausip(one->self()));
    return all;
}

JAUSCAT_DECL int node_state::run() {
    try {
        require_stopped();
    } catch (const std::logic_error& e) {
        log(e.what());
        return EXIT_FAILURE;
    }
    try {
        auto& context = context_->get();
        if (context.stopped()) context.restart(); // one of the program may have run out of work before
        await_signals();
        start();
        log("JAUS on " + net::detail::text(net_.config().me().endpoint()) + names() + " (Ctrl-C ends)");
        if (!own_context_) {
            while (!is_stopped_ && context.run_one() != 0) {} // the program may have other work in it
            stop();
            return EXIT_SUCCESS;
        }
        for (;; await_signals()) {
            context.run();
            stop();
            finish();
            if (!net_.running()) break; // a handler may have started it again
        }
        return EXIT_SUCCESS;
    } catch (const std::exception& e) {
        stop();
        log(e.what());
        return EXIT_FAILURE;
    }
}

JAUSCAT_DECL void end_node::operator()(node_state* node) const noexcept {
    try {
        node->stop();
    } catch (...) { // of the log
    }
    node->release();
    delete node;
}

/// The command line of a program that has no other options.
inline node_options options_from(int argc, const char* const* argv, node_options options) {
    const std::string path = argc > 0 ? argv[0] : "node";
    const auto name = path.substr(path.rfind('/') + 1);
    if (options.name.empty()) options.name = name;
    const auto refuse = [&](const std::string& why) {
        std::cerr << name << ": " << why << "\nTry '" << name << " --help'.\n";
        std::exit(2);
    };
    for (int i = 1; i < argc; ++i) {
        const std::string_view word{argv[i]};
        const auto equals = word.find('=');
        const auto option = word.substr(0, equals);
        if (word == "--version") {
            std::cout << name << " (JausCat) " << JAUSCAT_VERSION_TEXT << "\n";
            std::exit(0);
        }
        if (word == "--help" || word == "-h") {
            std::cout << name << " [--config FILE] [--this SYSTEM]\n\n"
                      << "  --config FILE   configuration file (default " << options.config << ")\n"
                      << "  --this SYSTEM   the system of the file that this program is, instead of its <thissystem>\n"
                      << "  --help          show this text\n"
                      << "  --version       show the version of JausCat\n\nExample:\n  " << name
                      << " --config JausConfig.xml --this b\n\nIt works until Ctrl-C.\n";
            std::exit(0);
        }
        if (option != "--config" && option != "--this") refuse("unknown option '" + std::string{word} + "'");
        if (equals == word.npos && i + 1 == argc) refuse(std::string{option} + " needs a value");
        auto& value = option == "--config" ? options.config : options.this_system;
        value = equals == word.npos ? argv[++i] : word.substr(equals + 1);
    }
    return options;
}

} // namespace app

JAUSCAT_DECL node::node(int argc, const char* const* argv, node_options options) {
    options = app::options_from(argc, argv, std::move(options));
    try {
        state_.reset(new app::node_state{nullptr, options});
    } catch (const std::exception& e) {
        std::cerr << options.name << ": " << e.what() << "\n";
        std::exit(EXIT_FAILURE);
    }
}
JAUSCAT_DECL node::node(const node_options& options) : state_{new app::node_state{nullptr, options}} {}
JAUSCAT_DECL node::node(boost::asio::io_context& context, const node_options& options)
    : state_{new app::node_state{&context, options}} {}
JAUSCAT_DECL node::~node() = default;
JAUSCAT_DECL int node::run() { return state_->run(); }
JAUSCAT_DECL void node::start() { state_->start(); }
JAUSCAT_DECL void node::stop() { state_->stop(); }
JAUSCAT_DECL boost::asio::io_context& node::context() noexcept { return state_->context(); }
JAUSCAT_DECL const jaus::address& node::manager() const noexcept { return state_->net().manager(); }
JAUSCAT_DECL net::udp_counters node::counts() const noexcept { return state_->net().counts(); }
JAUSCAT_DECL std::vector<component_status> node::components() const { return state_->statuses(); }
JAUSCAT_DECL void node::when_appeared(std::function<void(const jaus::address& who)> f) {
    state_->on_appeared = std::move(f);
}
JAUSCAT_DECL void node::when_disappeared(std::function<void(const jaus::address& who)> f) {
    state_->on_disappeared = std::move(f);
}
JAUSCAT_DECL void node::lose(const jaus::address& who) { state_->net().lose(who); }

} // namespace JAUSCAT_WAY
} // namespace jauscat
