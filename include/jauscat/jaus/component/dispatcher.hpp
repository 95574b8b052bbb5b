// Calls the handler of a message's type, in constant time and without a heap.
#pragma once
#include <jauscat/jaus/component/component_application.hpp>
#include <jauscat/jaus/message/presence_bits.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>
#include <jauscat/wire/code_index.hpp>

#include <type_traits>
#include <utility>

namespace jauscat::jaus {

namespace detail {

template <coded_message T, class F> struct typed_handler {
    using message_type = T;
    F handle;
};
template <class F> struct unknown_handler {
    F handle;
};
template <class F> struct malformed_handler {
    F handle;
};
template <class F> struct acknowledgement_handler {
    F handle;
};

template <class H> concept is_typed = requires { typename H::message_type; };

template <template <class> class Kind, class H> inline constexpr bool is_kind = false;
template <template <class> class Kind, class F> inline constexpr bool is_kind<Kind, Kind<F>> = true;

/// Whether on, on_unknown, on_malformed or on_acknowledgement has made it.
template <class H> inline constexpr bool is_handler = is_typed<H>;
template <class F> inline constexpr bool is_handler<unknown_handler<F>> = true;
template <class F> inline constexpr bool is_handler<malformed_handler<F>> = true;
template <class F> inline constexpr bool is_handler<acknowledgement_handler<F>> = true;

/// The handlers of a dispatcher, in a flat list: all messages' handlers in a std::tuple take a minute to compile.
template <std::size_t I, class H> struct placed_handler {
    H handler;
};
template <class Places, class... Handlers> struct handler_list;
template <std::size_t... I, class... Handlers>
struct handler_list<std::index_sequence<I...>, Handlers...> : placed_handler<I, Handlers>... {
    constexpr explicit handler_list(Handlers... handlers) : placed_handler<I, Handlers>{std::move(handlers)}... {}
};
template <class... Handlers> using handlers_of = handler_list<std::index_sequence_for<Handlers...>, Handlers...>;
template <std::size_t I, class H> constexpr H& handler_at(placed_handler<I, H>& place) { return place.handler; }
template <std::size_t I, class List>
using handler_type = std::remove_cvref_t<decltype(handler_at<I>(std::declval<List&>()))>;

/// Calls the handler of a kind, if there is one.
template <template <class> class Kind, std::size_t... I, class... Handlers>
constexpr void tell(handler_list<std::index_sequence<I...>, Handlers...>& handlers, const auto&... what) {
    constexpr std::size_t place = [] {
        std::size_t at = 0;
        static_cast<void>((... || (is_kind<Kind, Handlers> || (++at, false))));
        return at;
    }();
    if constexpr (place != sizeof...(Handlers)) handler_at<place>(handlers).handle(what...);
}

template <class T>
constexpr result<std::size_t, wire::errc> decode_body(T& message, std::span<const std::byte> body,
                                                      [[maybe_unused]] wire::arena* memory) noexcept {
    if constexpr (wire::needs_memory<T>)
        return wire::decode(message, body, *memory);
    else
        return wire::decode(message, body);
}

/// Code that is the same for all handlers is in the caller, so that it is compiled once.
template <std::size_t I, class List>
constexpr wire::errc decode_and_handle(List& handlers, const header& head, std::span<const std::byte> body,
                                       wire::arena* memory) {
    typename handler_type<I, List>::message_type message{};
    if (const auto decoded = decode_body(message, body, memory); !decoded) return decoded.error();
    handler_at<I>(handlers).handle(head, std::as_const(message));
    return wire::errc::ok;
}

/// The command codes of the typed handlers, and beside each the function that decodes for it.
template <class... Handlers> struct dispatch_table {
    using list = handlers_of<Handlers...>;
    using step = wire::errc (*)(list&, const header&, std::span<const std::byte>, wire::arena*);
    static constexpr std::size_t count = (std::size_t{is_typed<Handlers>} + ... + 0);
    static constexpr auto places = [] {
        constexpr std::array<bool, sizeof...(Handlers)> typed{is_typed<Handlers>...};
        std::array<std::size_t, count> found{};
        for (std::size_t i = 0, at = 0; i != typed.size(); ++i)
            if (typed[i]) found[at++] = i;
        return found;
    }();
    template <std::size_t I> using handler = handler_type<places[I], list>;
    static constexpr bool needs_memory = []<std::size_t... I>(std::index_sequence<I...>) {
        return (wire::needs_memory<typename handler<I>::message_type> || ... || false);
    }(std::make_index_sequence<count>{});

    static constexpr auto codes = []<std::size_t... I>(std::index_sequence<I...>) {
        return std::array<std::uint16_t, count>{command_code_of<typename handler<I>::message_type>...};
    }(std::make_index_sequence<count>{});
    static constexpr auto steps = []<std::size_t... I>(std::index_sequence<I...>) {
        return std::array<step, count>{&decode_and_handle<places[I], list>...};
    }(std::make_index_sequence<count>{});
};

} // namespace detail

/// A handler of the message `T`: `handle(const header&, const T&)`, without a result.
template <class F, class T>
concept message_handler =
    std::invocable<F&, const header&, const T&> && std::is_void_v<std::invoke_result_t<F&, const header&, const T&>>;

/// Handles the message `T`: see message_handler. A component that refuses or defers messages has no dispatcher alone,
/// but an application that returns their outcome.
template <coded_message T, class F> constexpr auto on(F handle) {
    constexpr bool has_parameters = std::invocable<F&, const header&, const T&>;
    static_assert(has_parameters, "on: the handler of a message cannot be called with (const header&, const T&)");
    if constexpr (has_parameters)
        static_assert(message_handler<F, T>, "on: the handler of a message returns something, which would be ignored");
    return detail::typed_handler<T, F>{std::move(handle)};
}
template <uncoded_type T, class F> constexpr auto on(F) { refuse_uncoded_type<T>(); }
/// Handles command codes that no handler takes: `handle(const header&, std::span<const std::byte> body)`.
template <class F> constexpr auto on_unknown(F handle) {
    static_assert(std::invocable<F&, const header&, const std::span<const std::byte>&>,
                  "on_unknown: the handler cannot be called with (const header&, std::span<const std::byte>)");
    return detail::unknown_handler<F>{std::move(handle)};
}
/// Handles bodies that do not decode: `handle(const header&, std::span<const std::byte> body, wire::errc)`.
template <class F> constexpr auto on_malformed(F handle) {
    static_assert(std::invocable<F&, const header&, const std::span<const std::byte>&, const wire::errc&>,
                  "on_malformed: the handler cannot be called with (const header&, std::span<const std::byte>,"
                  " wire::errc)");
    return detail::malformed_handler<F>{std::move(handle)};
}
/// Handles ACK and NAK, which have a command code but no body: `handle(const header&)`.
template <class F> constexpr auto on_acknowledgement(F handle) {
    static_assert(std::invocable<F&, const header&>,
                  "on_acknowledgement: the handler cannot be called with (const header&)");
    return detail::acknowledgement_handler<F>{std::move(handle)};
}

/// Calls the handler of a message's type with the decoded message.
///
///     jaus::dispatcher arm{jaus::on<jaus::set_wrench_effort>([&](const jaus::header&, const auto& efforts) { ... }),
///                          jaus::on_unknown([&](const jaus::header& head, auto body) { ... })};
///     arm(head, body);
template <class... Handlers> class dispatcher {
    static_assert((detail::is_handler<Handlers> && ...),
                  "dispatcher: a handler is made by none of on, on_unknown, on_malformed and on_acknowledgement");

  public:
    constexpr explicit dispatcher(Handlers... handlers) : handlers_{std::move(handlers)...} {}

    /// A body that does not decode is never handed to a typed handler.
    constexpr dispatched operator()(const header& head, std::span<const std::byte> body) {
        static_assert(!table::needs_memory, "dispatcher: a message has lists; give an arena as the third argument");
        return dispatch(head, body, nullptr);
    }
    /// For messages with lists, which are decoded into `memory`. It is reset first: what a handler was given is valid
    /// until the next call.
    constexpr dispatched operator()(const header& head, std::span<const std::byte> body, wire::arena& memory) {
        memory.reset();
        return dispatch(head, body, &memory);
    }

    /// Calls `takes(supported_message)` for each message that is handled, and `sends` for the report of each query.
    static constexpr void list_messages(auto&& takes, auto&& sends) {
        const auto list = [&]<coded_message T>(std::type_identity<T>) {
            takes(supported_message{command_code_of<T>, presence_bits_of<T>});
            if (const auto report = report_code_of(command_code_of<T>); report != 0) sends(supported_message{report});
        };
        [&]<std::size_t... I>(std::index_sequence<I...>) {
            (list(std::type_identity<typename table::template handler<I>::message_type>{}), ...);
        }(std::make_index_sequence<table::count>{});
    }

  private:
    using table = detail::dispatch_table<Handlers...>;
    using codes = wire::code_index<table::codes>;
    static constexpr auto steps = codes::template by_slot<typename table::step>(table::steps, nullptr);

    constexpr dispatched dispatch(const header& head, std::span<const std::byte> body, wire::arena* memory) {
        if (body.empty() && is_acknowledgement(head)) [[unlikely]] {
            detail::tell<detail::acknowledgement_handler>(handlers_, head);
            return dispatched::acknowledgement;
        }
        const auto step = steps[codes::slot(head.command_code)];
        if (step == nullptr) {
            detail::tell<detail::unknown_handler>(handlers_, head, body);
            return dispatched::unknown;
        }
        if (const wire::errc error = step(handlers_, head, body, memory); error != wire::errc::ok) {
            detail::tell<detail::malformed_handler>(handlers_, head, body, error);
            return dispatched::malformed;
        }
        return dispatched::handled;
    }

    detail::handlers_of<Handlers...> handlers_;
};

} // namespace jauscat::jaus
