// A node that works in a thread of its own, and its components. What Python calls is done by that thread; what waits
// for it lets go of the interpreter's lock, and ends for a signal.
#pragma once
#include "messages.hpp"
#include <jauscat/app/component.hpp>
#include <jauscat/catalogue/any_message.hpp>
#include <jauscat/net/config_error.hpp>
#include <jauscat/net/open_error.hpp>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>

#include <csignal>
#include <future>
#include <memory>
#include <pthread.h>
#include <set>
#include <thread>
#include <type_traits>

namespace python {

class component;

using boost::system::error_code;

[[noreturn]] inline void raise(const error_code& why, const std::string& what) {
    const auto& classes = error_classes::all();
    PyObject* const type = why == jauscat::node_errc::refused     ? classes.refused
                           : why == jauscat::node_errc::no_answer ? classes.no_answer
                                                                  : classes.node;
    raise(type, what + ": " + why.message(), why.message());
}
[[noreturn]] inline void raise_not_running(const std::string& what) {
    raise(make_error_code(jauscat::node_errc::not_running), what);
}

/// Waits without the interpreter's lock, until `is_given_up()` too. Throws what a signal's handler raises, such as
/// KeyboardInterrupt.
auto wait_for(auto& done, auto&& is_given_up) {
    using namespace std::chrono_literals;
    for (;;) {
        {
            const py::gil_scoped_release others_run;
            if (done.wait_for(50ms) == std::future_status::ready) break; // at once where it is there
        }
        if (is_given_up()) raise_not_running("the operation");
        if (PyErr_CheckSignals() != 0) throw py::error_already_set{};
    }
    try {
        return done.get();
    } catch (const std::future_error&) { // the node has stopped
        raise_not_running("the operation");
    }
}

/// A function of Python that any thread may copy and destroy.
class callback {
  public:
    explicit callback(py::function f)
        : f_{new py::function{std::move(f)}, [](py::function* last) {
                 const py::gil_scoped_acquire lock;
                 delete last;
             }} {}

    /// use(f), with the interpreter's lock. What Python raises becomes an exception that needs no lock.
    auto operator()(auto&& use) const {
        const py::gil_scoped_acquire lock;
        try {
            return use(*f_);
        } catch (const py::error_already_set& error) {
            throw std::runtime_error{error.what()};
        }
    }

  private:
    std::shared_ptr<py::function> f_;
};

class node : public std::enable_shared_from_this<node> {
  public:
    explicit node(const jauscat::node_options& options) : node_{made(options)} {}
    node(const node&) = delete;
    node& operator=(const node&) = delete;
    ~node();

    /// It lives as long as the node.
    std::shared_ptr<component> add(const jauscat::component_options& options);
    void start() {
        if (thread_.joinable()) throw std::logic_error{"the node is running"};
        try {
            node_->start();
        } catch (const jauscat::net::open_error& error) {
            raise(error_classes::all().configuration, error.what(), describe(error.code()));
        } catch (const std::invalid_argument& error) {
            raise(error_classes::all().configuration, error.what());
        }
        context_.restart();
        work_.emplace(context_.get_executor());
        over_ = {};
        is_over_ = over_.get_future().share();
        // Signals are for Python's main thread, which they wake up.
        sigset_t all{}, before{};
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before);
        thread_ = std::thread{[this] { context_.run(); }};
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
        running().insert(shared_from_this());
    }
    void stop() {
        if (!thread_.joinable()) return;
        if (is_loop()) throw std::logic_error{"a node is not stopped by a function that it calls"};
        const auto kept = shared_from_this();
        running().erase(kept);
        const py::gil_scoped_release others_run; // handlers are called to the last
        boost::asio::post(context_, [this] {
            node_->stop();
            work_.reset();
            boost::asio::post(context_, [this] { context_.stop(); }); // behind the handlers of aborted operations
        });
        thread_.join();
        context_.restart(); // what other threads have posted behind the end finds that the node does not run
        context_.poll();
        over_.set_value();
    }
    /// Works until `stop` or a signal, whose exception it throws.
    void run() {
        if (!thread_.joinable()) start();
        try {
            auto over = is_over_;
            wait_for(over, [] { return false; });
        } catch (...) {
            stop();
            throw;
        }
    }
    static void stop_all() {
        while (!running().empty()) (*running().begin())->stop();
    }

    [[nodiscard]] bool is_running() const noexcept { return thread_.joinable(); }
    [[nodiscard]] jauscat::node& get() noexcept { return *node_; }

    /// Calls f() by the node's thread and returns what it does; it must not hold anything of Python.
    template <class F> auto call(F f) -> std::invoke_result_t<F&> {
        if (!is_running() || is_loop()) return f();
        auto task = std::make_shared<std::packaged_task<std::invoke_result_t<F&>()>>(std::move(f));
        auto done = task->get_future();
        boost::asio::post(context_, [task] { (*task)(); });
        return wait_for(done, [this] { return !is_running(); });
    }
    /// Calls start(handler), and waits until handler(error_code, Value) or handler(error_code) is called.
    template <class Value, class Start> Value complete(const std::string& what, Start start) {
        if (!is_running()) raise_not_running(what);
        if (is_loop()) throw std::logic_error{what + ": a handler cannot wait for an answer; use another thread"};
        auto promise = std::make_shared<std::promise<std::pair<error_code, Value>>>();
        auto done = promise->get_future();
        call([start = std::move(start), promise]() mutable {
            start([promise](const error_code& why, Value value = {}) { promise->set_value({why, std::move(value)}); });
        });
        auto [why, value] = wait_for(done, [this] { return !is_running(); });
        if (why) raise(why, what);
        return std::move(value);
    }

  private:
    std::unique_ptr<jauscat::node> made(const jauscat::node_options& options) {
        try {
            return std::make_unique<jauscat::node>(context_, options);
        } catch (const jauscat::net::config_error& error) {
            raise(error_classes::all().configuration, error.what(), describe(error.code()), {error.name(), {}});
        }
    }
    /// They live until they are stopped, so that none ends in its own thread.
    static std::set<std::shared_ptr<node>>& running() {
        static std::set<std::shared_ptr<node>> all;
        return all;
    }
    [[nodiscard]] bool is_loop() const noexcept { return std::this_thread::get_id() == thread_.get_id(); }

    boost::asio::io_context context_{1};
    std::unique_ptr<jauscat::node> node_;
    std::vector<std::shared_ptr<component>> components_{};
    std::optional<boost::asio::executor_work_guard<boost::asio::io_context::executor_type>> work_{};
    std::thread thread_{};
    std::promise<void> over_{};
    std::shared_future<void> is_over_{};
};

/// Control of another component.
class control {
  public:
    control(std::shared_ptr<node> of, std::shared_ptr<jauscat::control> held)
        : node_{std::move(of)}, held_{std::move(held)} {}
    control(const control&) = delete;
    control& operator=(const control&) = delete;
    ~control() {
        try {
            node_->call([last = std::move(held_)]() mutable { last.reset(); }); // does not wait for the peer
        } catch (const py::error_already_set&) { // of Ctrl-C, which is raised again where it can be caught
            PyErr_SetInterrupt();
        } catch (...) { // the node has stopped, which has ended the control
        }
    }

    void send(const py::object& name, const py::dict& fields) {
        const auto type = find(name, generation::ra);
        node_->complete<int>(std::string{type.entry.name()},
                             [held = held_, code = type.entry.command_code(), body = type.encode(fields)](auto done) {
                                 held->async_send(code, body, [done](error_code why) { done(why); });
                             });
    }
    [[nodiscard]] bool is_held() {
        return node_->call([held = held_] { return held->is_held(); });
    }
    void release() {
        if (!node_->is_running() || !is_held()) return;
        node_->complete<int>("the release of control",
                             [held = held_](auto done) { held->async_release([done](error_code why) { done(why); }); });
    }

  private:
    std::shared_ptr<node> node_;
    std::shared_ptr<jauscat::control> held_;
};

class component {
  public:
    component(node& of, const jauscat::component_options& options) : node_{&of} {
        try {
            component_ = std::make_unique<jauscat::component>(node_->get(), options);
        } catch (const std::invalid_argument& error) {
            raise(error_classes::all().configuration, error.what());
        }
    }
    component(const component&) = delete;
    component& operator=(const component&) = delete;

    void on(const py::object& name, py::function f) {
        const auto type = find(name, generation::ra);
        node_->call([this, type, f = callback{std::move(f)}] {
            component_->on(type.entry, [this, type, f](const catalogue::any_message& what, const jaus::header& from) {
                return f([&](const py::function& handler) { return handle(type, what, from, handler); });
            });
        });
    }
    void when_stopped(py::function f) {
        node_->call([this, f = callback{std::move(f)}] {
            component_->when_stopped([f] { f([](const py::function& handler) { handler(); }); });
        });
    }
    void ready() {
        node_->call([this] { component_->ready(); });
    }
    void fail(const std::string& why) {
        node_->call([this, why] { component_->fail(why); });
    }

    void send(const std::string& to, const py::object& name, const py::dict& fields, bool acknowledged) {
        const auto type = find(name, generation::ra);
        const auto where = address_of(to);
        const auto code = type.entry.command_code();
        const auto what = std::string{type.entry.name()} + " to " + to;
        auto body = type.encode(fields);
        if (acknowledged) {
            node_->complete<int>(what, [this, where, code, body = std::move(body)](auto done) {
                component_->async_send(where, code, body, [done](error_code why) { done(why); });
            });
            return;
        }
        const auto sent =
            node_->call([this, where, code, body = std::move(body)] { return component_->send(where, code, body); });
        if (!sent) raise(error_classes::all().node, what + ": " + sent.error().message, describe(sent.error().code));
    }
    message ask(const std::string& of, const py::object& name, const py::dict& fields, double timeout,
                bool acknowledged) {
        const auto type = find(name, generation::ra);
        if (type.entry.report() == 0) raise(error_classes::all().node, std::string{type.entry.name()} + " is no query");
        const jauscat::ask_options options{.timeout = seconds(timeout), .acknowledged = acknowledged};
        const auto body = node_->complete<std::vector<std::byte>>(
            std::string{type.entry.name()} + " to " + of,
            [this, where = address_of(of), code = type.entry.command_code(), body = type.encode(fields),
             options](auto done) {
                component_->async_ask(
                    where, code, body, options,
                    [done](error_code why, std::vector<std::byte> answer) { done(why, std::move(answer)); });
            });
        auto report = find(py::int_{type.entry.report()}, generation::ra).decode(body);
        report.source = of;
        report.destination = address();
        return report;
    }
    std::unique_ptr<control> take_control(const std::string& of, std::uint8_t authority) {
        auto held = node_->complete<std::shared_ptr<jauscat::control>>(
            "control of " + of, [this, where = address_of(of), authority](auto done) {
                component_->async_control(where, {.authority = authority},
                                          [done](error_code why, jauscat::control made) {
                                              done(why, std::make_shared<jauscat::control>(std::move(made)));
                                          });
            });
        return std::make_unique<control>(node_->shared_from_this(), std::move(held));
    }

    [[nodiscard]] std::string address() const { return jauscat::net::to_jausip(component_->address()); }
    [[nodiscard]] std::string state() {
        return std::string{text::enumerator_name(node_->call([this] { return component_->state(); }))};
    }
    [[nodiscard]] std::optional<std::string> controller() {
        const auto by = node_->call([this] { return component_->controller(); });
        return by ? std::optional{jauscat::net::to_jausip(*by)} : std::nullopt;
    }

  private:
    static jauscat::duration seconds(double count) {
        if (!(count >= 0 && count < 1e9)) throw py::value_error{"a time is 0 or more seconds"};
        return std::chrono::duration_cast<jauscat::duration>(std::chrono::duration<double>{count});
    }
    /// What a handler returns: nothing or True, False to refuse, or the fields of the report that answers.
    jaus::message_outcome handle(const message_type& type, const catalogue::any_message& what, const jaus::header& from,
                                 const py::function& handler) {
        const auto body = what.encode();
        auto received =
            to_message(what, type.of, body ? std::span<const std::byte>{*body} : std::span<const std::byte>{});
        received.source = jauscat::net::to_jausip(from.source);
        received.destination = jauscat::net::to_jausip(from.destination);
        received.sequence_number = from.sequence_number;
        received.wants_acknowledgement = from.ack_nak == jaus::ack_nak::request;
        const py::object answer = handler(received);
        if (answer.is_none() || answer.is(py::bool_{true})) return jaus::message_outcome::handled;
        if (answer.is(py::bool_{false})) return jaus::message_outcome::refused;
        if (!py::isinstance<py::dict>(answer) || type.entry.report() == 0)
            throw py::type_error{"the handler of " + std::string{type.entry.name()} + " returns None, True or False" +
                                 (type.entry.report() == 0 ? "" : ", or a dict: the fields of the report")};
        const auto report = find(py::int_{type.entry.report()}, generation::ra);
        const auto bytes = report.encode(requested(report, answer, received));
        return component_->send(from.source, report.entry.command_code(), bytes) ? jaus::message_outcome::handled
                                                                                 : jaus::message_outcome::refused;
    }
    /// The fields of a report that the presence vector of its query asks for.
    static py::dict requested(const message_type& report, const py::dict& all, const message& query) {
        if (!query.fields.contains("presence_vector")) return all;
        const auto bits = query.fields["presence_vector"].cast<std::uint64_t>();
        py::dict made = all.attr("copy")();
        for (const text::member& one : report.entry.fields().members)
            if (one.presence_bit && (bits >> *one.presence_bit & 1U) == 0)
                made.attr("pop")(to_str(one.name), py::none{});
        return made;
    }

    node* node_;
    std::unique_ptr<jauscat::component> component_;
};

inline node::~node() = default; // it is stopped: see running()
inline std::shared_ptr<component> node::add(const jauscat::component_options& options) {
    return components_.emplace_back(std::make_shared<component>(*this, options));
}

} // namespace python
