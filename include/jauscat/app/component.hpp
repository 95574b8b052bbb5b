// A JAUS component: handlers of messages, reports, and what happens when it is stopped.
#pragma once
#include <jauscat/app/client.hpp>
#include <jauscat/app/component_options.hpp>
#include <jauscat/app/control.hpp>
#include <jauscat/app/node.hpp>
#include <jauscat/app/subscription.hpp>
#include <jauscat/jaus/events/report_field.hpp>
#include <jauscat/jaus/message/presence_bits.hpp>
#include <jauscat/jaus/message/requested_fields.hpp>
#include <jauscat/net/error.hpp>
#include <jauscat/schema/jaus/core.hpp>

#include <array>
#include <concepts>
#include <string_view>

namespace jauscat {
namespace catalogue {
class any_message;
class entry;
} // namespace catalogue
inline namespace JAUSCAT_WAY {

/// A JAUS component of a node. It serves the core messages (state, control, emergencies, time, identification,
/// services), service connections and events by itself; handlers and reports are the application's. It begins in the
/// state Initialize, and is made before the node is started.
///
///     jauscat::component driver{node, {.id = 33, .name = "Primitive Driver"}};
///     driver.on([&](const jaus::set_wrench_effort& told) { jaus::copy_present(told, effort); });
///     driver.reports([&] { return effort; });
///     driver.when_stopped([&] { effort = jaus::all_zero<jaus::report_wrench_effort>(); });
///     driver.ready();
///
/// Nothing of it is called after its end. An exception of a handler is logged, refuses the message, and brings the
/// component to Failure: it is stopped.
class component {
  public:
    /// Throws `std::invalid_argument` for an ID that is no component's or that the node has already, and
    /// `std::logic_error` if the node is running.
    JAUSCAT_DECL component(node& of, const component_options& options);
    /// Stops the component: when_stopped is called.
    JAUSCAT_DECL ~component();
    component(const component&) = delete;
    component& operator=(const component&) = delete;

    /// Handlers of messages: `f(const T&)` or `f(const T&, const jaus::header&)`, where the type T of the message
    /// selects what is handled. A command is acknowledged when its handler has returned; the node refuses it before if
    /// its sender or the component's state does not permit it, see docs/safety.md. A handler returns
    /// - nothing;
    /// - a message, or a std::optional of one: the answer; an empty one refuses;
    /// - jaus::message_outcome: handled, or refused.
    ///
    /// Throws `std::logic_error` for a second handler of a message.
    template <class... F> void on(F... f);

    /// The same for a message that is known at run time only (catalogue.md): `f(const catalogue::any_message&)`, with
    /// the header behind it if it likes. It returns nothing, or jaus::message_outcome.
    template <std::same_as<catalogue::entry> Entry, class F> void on(const Entry& message, F f);

    /// Called for each message that neither the component nor a handler takes, such as an unexpected report; `f` says
    /// what has become of it. For programs that show or store messages of any type.
    JAUSCAT_DECL void on_others(std::function<jaus::message_outcome(const jaus::header& head, app::bytes body)> f);

    /// A report: `f()` returns it with all its fields, or a std::optional of it that is empty if there is none now. It
    /// answers the query of the report with the fields of the presence vector, and serves service connections and
    /// events of every kind. `f(const Query&)` gets the query, where more is in it than a presence vector; without a
    /// query, as in service connections, that has its default values.
    ///
    /// Changes are looked for after each handler and periodic function of this component; report changes at other times
    /// by `changed`. `max_rate`: hertz, of connections and events.
    template <class F> void reports(F f, double max_rate = jaus::update_rate::max);
    /// The data of reports have changed: events are sent.
    JAUSCAT_DECL void changed();

    /// Called when the actuators must come to rest: on a change to any other state than Ready, when control ends or
    /// passes to another controller, when a sender without control is lost whose motion command is in force, and at the
    /// end of component or node.
    JAUSCAT_DECL void when_stopped(std::function<void()> f);
    /// Called when the state becomes Ready: from now on motion commands are obeyed.
    JAUSCAT_DECL void when_ready(std::function<void()> f);
    /// Called when an emergency begins or ends; when_stopped has been called.
    JAUSCAT_DECL void when_emergency(std::function<void(bool begins)> f);
    /// Called when the controller has changed; empty if there is none.
    JAUSCAT_DECL void when_controlled(std::function<void(const std::optional<jaus::address>& by)> f);
    /// Calls `f` periodically while the node runs, at instants one period apart; a late call is made once.
    JAUSCAT_DECL void every(duration period, std::function<void()> f);

    /// The application is ready: from Initialize to Ready, or from Failure by Initialize to Ready.
    JAUSCAT_DECL void ready();
    /// To Failure: stopped, until `ready`. `why` is logged.
    JAUSCAT_DECL void fail(std::string_view why);
    /// Takes control back from the controller, which gets Reject Component Control.
    JAUSCAT_DECL void reject_control();
    [[nodiscard]] JAUSCAT_DECL jaus::primary_status_code state() const noexcept;
    /// The controller, if any.
    [[nodiscard]] JAUSCAT_DECL std::optional<jaus::address> controller() const noexcept;
    [[nodiscard]] JAUSCAT_DECL const jaus::address& address() const noexcept;

    /// Sends a message once, without acknowledgement, to a component or to all of a level (255). Of any size.
    template <jaus::coded_message T> result<void, net::error> send(const jaus::address& to, const T& message) {
        std::vector<std::byte> body;
        if (const auto why = app::encode_into(body, message); !why) return app::not_sent(jaus::command_code_of<T>, why);
        return send(to, jaus::command_code_of<T>, body);
    }
    /// The same for a body in bytes.
    JAUSCAT_DECL result<void, net::error> send(const jaus::address& to, std::uint16_t command_code, app::bytes body);

    /// The same for a message that is known at run time only.
    template <std::same_as<catalogue::any_message> Message>
    result<void, net::error> send(const jaus::address& to, const Message& message) {
        const auto body = message.encode();
        if (!body) return net::not_encodable(body.error());
        return send(to, message.command_code(), *body);
    }

    /// Sends a message and repeats it until it is acknowledged. Errors: refused, no_answer, not_encodable,
    /// not_one_address, unroutable, queue_full, not_running. Of any size.
    template <jaus::coded_message T, class Token = default_token>
    auto async_send(const jaus::address& to, const T& message, Token&& token = Token{});
    /// The same for a body in bytes, as of a message that a command line or a file names.
    template <class Token = default_token>
    auto async_send(const jaus::address& to, std::uint16_t command_code, app::bytes body, Token&& token = Token{});
    /// Sends a query and gives its report. Errors: as async_send, and malformed_answer.
    template <jaus::query_message Query, class Token = default_token>
    requires(!std::same_as<std::remove_cvref_t<Token>, ask_options>)
    auto async_ask(const jaus::address& of, const Query& query, Token&& token = Token{}) {
        return async_ask(of, query, ask_options{}, std::forward<Token>(token));
    }
    template <jaus::query_message Query, class Token = default_token>
    auto async_ask(const jaus::address& of, const Query& query, const ask_options& options, Token&& token = Token{});
    /// The same for a query of the standard as bytes; gives the body of its report, a std::vector<std::byte>. Errors:
    /// as async_send, and not_a_query.
    template <class Token = default_token>
    auto async_ask(const jaus::address& of, std::uint16_t command_code, app::bytes body, const ask_options& options,
                   Token&& token = Token{});
    template <class T>
    requires(!jaus::query_message<T> && !std::integral<T>)
    void async_ask(const jaus::address&, const T&, auto&&...) {
        static_assert(jaus::query_message<T>,
                      "async_ask: no report answers this message; the schema of a query names its report");
    }
    /// Requests control of a component. Errors: control_refused, no_answer, already_asked, not_one_address,
    /// not_running.
    template <class Token = default_token>
    auto async_control(const jaus::address& of, const control_options& options, Token&& token = Token{}) {
        return boost::asio::async_initiate<Token, void(app::error_code, control)>(
            [](auto handler, const std::shared_ptr<app::component_state>& state, const jaus::address& whom,
               const control_options& how) {
                app::begin_control(state, whom, how,
                                   app::make_operation<std::shared_ptr<app::control_state>>(
                                       std::move(handler), app::handled_as<control>{}, app::executor_of(state)));
            },
            token, state_, of, options);
    }
    /// A service connection: the provider sends the report periodically. Errors: connection_refused, no_answer,
    /// not_encodable (the rate), queue_full, not_one_address, not_running.
    template <jaus::coded_message Report, class Token = default_token>
    auto async_connect(const jaus::address& to, const connect_options& options, Token&& token = Token{}) {
        return boost::asio::async_initiate<Token, void(app::error_code, subscription<Report>)>(
            [](auto handler, const std::shared_ptr<app::component_state>& state, const jaus::address& whom,
               connect_options how) {
                how.presence_vector &= jaus::presence_bits_of<Report>;
                app::begin_connect(
                    state, whom, jaus::command_code_of<Report>, how,
                    app::make_operation<std::shared_ptr<app::subscription_state>>(
                        std::move(handler), app::handled_as<subscription<Report>>{}, app::executor_of(state)));
            },
            token, state_, to, options);
    }
    /// An event: the provider sends the report when `trigger` says. Its message_code and local_request_id are ignored.
    /// Errors: as async_connect.
    template <jaus::coded_message Report, class Token = default_token>
    auto async_event(const jaus::address& of, jaus::create_event trigger, Token&& token = Token{}) {
        trigger.message_code = jaus::command_code_of<Report>;
        std::vector<std::byte> body;
        const auto why = app::encode_into(body, trigger);
        return boost::asio::async_initiate<Token, void(app::error_code, subscription<Report>)>(
            [](auto handler, const std::shared_ptr<app::component_state>& state, const jaus::address& whom,
               // NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved on
               std::vector<std::byte> request, app::error_code failed) {
                auto done = app::make_operation<std::shared_ptr<app::subscription_state>>(
                    std::move(handler), app::handled_as<subscription<Report>>{}, app::executor_of(state));
                if (failed) return done->complete(failed, nullptr);
                app::begin_event(state, whom, std::move(request), connect_options{}.max_waiting, done);
            },
            token, state_, of, std::move(body), app::not_encodable(jaus::command_code_of<jaus::create_event>, why));
    }

    /// Looks for components: asks the node managers that are heard for their components, and these for identification
    /// and services. Not an error if none is found.
    template <class Token = default_token> auto async_find(const find_options& options, Token&& token = Token{}) {
        return boost::asio::async_initiate<Token, void(app::error_code, std::vector<found_component>)>(
            [](auto handler, const std::shared_ptr<app::component_state>& state, const find_options& what) {
                app::begin_find(state, what,
                                app::make_operation<std::vector<found_component>>(
                                    std::move(handler), app::no_conversion{}, app::executor_of(state)));
            },
            token, state_, options);
    }

    /// Aborts all operations of this component and of its controls and subscriptions, which stay. May be called on any
    /// thread. Boost before 1.77 has no cancellation slots, which abort one operation.
    JAUSCAT_DECL void cancel();

  private:
    template <class F> void take(F f);

    std::shared_ptr<app::component_state> state_;
};

namespace app {

template <class F> consteval bool require_handler() {
    constexpr bool has_type = has_signature<F>;
    static_assert(has_type, "on: a handler names its message: [](const jaus::set_wrench_effort& effort) { ... }");
    if constexpr (has_type) {
        using T = subject_of<F>;
        constexpr bool is_message = jaus::coded_message<T>;
        static_assert(is_message, "on: the parameter of a handler is no message with a command code; is the header of"
                                  " its schema included?");
        if constexpr (is_message) {
            constexpr bool has_parameters = handles<F, T>;
            static_assert(has_parameters, "on: a handler takes (const T&) or (const T&, const jaus::header&)");
            constexpr bool has_result = handler_result<result_of<F>>;
            static_assert(has_result, "on: a handler returns nothing, a message as the answer, or a message_outcome");
            return has_parameters && has_result;
        }
    }
    return false;
}
template <class... F> consteval bool have_different_codes() {
    const std::array<std::uint16_t, sizeof...(F)> codes{jaus::command_code_of<subject_of<F>>...};
    for (std::size_t i = 0; i != codes.size(); ++i)
        for (std::size_t j = 0; j != i; ++j)
            if (codes[i] == codes[j]) return false;
    return true;
}

/// The report that `f` returns for `request`.
template <class Query, class F> auto report_of(F& f, const Query& query) {
    if constexpr (std::invocable<F&>)
        return f();
    else
        return f(query);
}

/// The command code of what a handler returns; 0 where that is no message.
template <class R> inline constexpr std::uint16_t answer_code_of = 0;
template <jaus::coded_message R> inline constexpr std::uint16_t answer_code_of<R> = jaus::command_code_of<R>;
} // namespace app

template <class F> void component::take(F f) {
    using T = app::subject_of<F>;
    app::take(*state_, {.command_code = jaus::command_code_of<T>,
                        .answer_code = app::answer_code_of<app::plain<app::result_of<F>>>,
                        .presence_bits = jaus::presence_bits_of<T>,
                        .handle = [f = std::move(f)](const app::incoming& from) mutable {
                            T message{};
                            const auto why = app::decode_into(message, from.body, from.component);
                            return why == wire::errc::ok ? app::call(f, std::as_const(message), from)
                                                         : app::malformed(from.component, why);
                        }});
}

template <class... F> void component::on(F... f) {
    if constexpr ((app::require_handler<F>() && ...)) {
        static_assert(app::have_different_codes<F...>(), "on: two handlers of one message");
        (take(std::move(f)), ...);
    }
}

template <std::same_as<catalogue::entry> Entry, class F> void component::on(const Entry& message, F f) {
    constexpr bool has_parameters = app::handles<F, catalogue::any_message>;
    static_assert(has_parameters, "on: a handler of a catalogue's message takes (const catalogue::any_message&) or"
                                  " (const catalogue::any_message&, const jaus::header&)");
    if constexpr (has_parameters)
        app::take(*state_, {.command_code = message.command_code(),
                            .presence_bits = message.presence_bits(),
                            .handle = [message, f = std::move(f)](const app::incoming& from) mutable {
                                const auto decoded = message.decode(from.body);
                                return decoded ? app::call(f, *decoded, from)
                                               : app::malformed(from.component, decoded.error().error);
                            }});
}

template <class F> void component::reports(F f, double max_rate) {
    static_assert(app::has_signature<F>, "reports: a function without parameters that returns the report");
    if constexpr (app::has_signature<F>) {
        using Report = app::plain<app::result_of<F>>;
        constexpr bool has_query = jaus::report_message<Report>;
        static_assert(has_query, "reports: the function returns no report that a query asks for; the schema of a report"
                                 " names its query");
        if constexpr (has_query) {
            using Query = jaus::query_of<Report>;
            constexpr bool has_parameters = std::invocable<F&> || std::invocable<F&, const Query&>;
            static_assert(has_parameters, "reports: the function takes nothing, or the query of its report");
            if constexpr (has_parameters)
                app::give(*state_,
                          {.command_code = jaus::command_code_of<Report>,
                           .query_code = jaus::command_code_of<Query>,
                           .presence_bits = jaus::presence_bits_of<Report>,
                           .max_rate = max_rate,
                           .read_field = &jaus::read_field<Report>,
                           .write = [f = std::move(f)](const app::report_request& request, std::vector<std::byte>& body,
                                                       app::component_state& to) mutable {
                               Query query{};
                               auto fields = request.presence_bits;
                               if (request.query != nullptr) {
                                   const auto why = app::decode_into(query, *request.query, to);
                                   if (why != wire::errc::ok) return app::malformed(to, why);
                                   if constexpr (requires { query.presence_vector; }) fields = query.presence_vector;
                               }
                               const auto made = app::report_of(f, query);
                               Report report{};
                               if constexpr (std::same_as<std::remove_cvref_t<decltype(made)>, Report>) {
                                   report = made;
                               } else {
                                   if (!made) return jaus::message_outcome::refused;
                                   report = *made;
                               }
                               if constexpr (requires { query.presence_vector; }) jaus::keep_requested(report, fields);
                               if (const auto why = app::encode_into(body, report); !why) {
                                   app::log_not_encodable(to, jaus::command_code_of<Report>, why);
                                   return jaus::message_outcome::refused;
                               }
                               return jaus::message_outcome::handled;
                           }});
        }
    }
}

template <jaus::coded_message T, class Token>
auto component::async_send(const jaus::address& to, const T& message, Token&& token) {
    std::vector<std::byte> body;
    const auto why = app::encode_into(body, message);
    return boost::asio::async_initiate<Token, void(app::error_code)>(
        [](auto handler, const std::shared_ptr<app::component_state>& state, const jaus::address& whom,
           // NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved on
           std::vector<std::byte> encoded, app::error_code failed) {
            auto done = app::make_operation<>(std::move(handler), app::no_conversion{}, app::executor_of(state));
            if (failed) return done->complete(failed);
            app::begin_send(state, whom, jaus::command_code_of<T>, std::move(encoded), done);
        },
        token, state_, to, std::move(body), app::not_encodable(jaus::command_code_of<T>, why));
}

template <class Token>
auto component::async_send(const jaus::address& to, std::uint16_t command_code, app::bytes body, Token&& token) {
    return boost::asio::async_initiate<Token, void(app::error_code)>(
        [](auto handler, const std::shared_ptr<app::component_state>& state, const jaus::address& whom,
           // NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved on
           std::uint16_t code, std::vector<std::byte> encoded) {
            app::begin_send(state, whom, code, std::move(encoded),
                            app::make_operation<>(std::move(handler), app::no_conversion{}, app::executor_of(state)));
        },
        token, state_, to, command_code, std::vector<std::byte>(body.begin(), body.end()));
}

template <class Token>
auto component::async_ask(const jaus::address& of, std::uint16_t command_code, app::bytes body,
                          const ask_options& options, Token&& token) {
    return boost::asio::async_initiate<Token, void(app::error_code, std::vector<std::byte>)>(
        [](auto handler, const std::shared_ptr<app::component_state>& state, const jaus::address& whom,
           // NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved on
           std::uint16_t code, std::vector<std::byte> encoded, const ask_options& how) {
            auto done = app::make_operation<app::bytes>(std::move(handler), app::copied{}, app::executor_of(state));
            app::begin_ask(state, whom, {code}, std::move(encoded), how, done);
        },
        token, state_, of, command_code, std::vector<std::byte>(body.begin(), body.end()), options);
}

template <jaus::query_message Query, class Token>
auto component::async_ask(const jaus::address& of, const Query& query, const ask_options& options, Token&& token) {
    using Report = jaus::report_of<Query>;
    std::vector<std::byte> body;
    const auto why = app::encode_into(body, query);
    return boost::asio::async_initiate<Token, void(app::error_code, received<Report>)>(
        [](auto handler, const std::shared_ptr<app::component_state>& state, const jaus::address& whom,
           // NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved on
           std::vector<std::byte> encoded, const ask_options& how, app::error_code failed) {
            auto done =
                app::make_operation<app::bytes>(std::move(handler), app::decoded_as<Report>{}, app::executor_of(state));
            if (failed) return done->complete(failed, {});
            app::begin_ask(state, whom, {jaus::command_code_of<Query>, jaus::command_code_of<Report>},
                           std::move(encoded), how, done);
        },
        token, state_, of, std::move(body), options, app::not_encodable(jaus::command_code_of<Query>, why));
}

} // namespace JAUSCAT_WAY
} // namespace jauscat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/app/impl/clients.ipp>
#    include <jauscat/app/impl/component.ipp>
#    include <jauscat/app/impl/component_state.ipp>
#    include <jauscat/app/impl/search.ipp>
#endif
