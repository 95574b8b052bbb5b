// From a received message to the handler of its type, in constant time and without a heap.
#pragma once
#include <jauscat/jaus/message.hpp>
#include <jauscat/wire/code_index.hpp>

#include <tuple>

namespace jauscat::jaus {

/// What became of a message.
enum class dispatched : std::uint8_t { handled, unknown, malformed, acknowledgement };

namespace detail {

template <coded_message T, class F> struct typed_handler {
    using message_type = T;
    F handle;
};
template <class F> struct unknown_handler { F handle; };
template <class F> struct malformed_handler { F handle; };
template <class F> struct acknowledgement_handler { F handle; };

template <class H> concept is_typed = requires { typename H::message_type; };

template <template <class> class Kind, class H> inline constexpr bool is_kind = false;
template <template <class> class Kind, class F> inline constexpr bool is_kind<Kind, Kind<F>> = true;

/// Calls `call` with each handler of a kind: none or one.
template <template <class> class Kind, class... Handlers>
constexpr void each_of(std::tuple<Handlers...>& handlers, auto&& call) {
    const auto one = [&]<class H>([[maybe_unused]] H& handler) {
        if constexpr (is_kind<Kind, H>) call(handler);
    };
    std::apply([&](auto&... handler) { (one(handler), ...); }, handlers);
}

template <class T>
constexpr wire::result decode_body(T& message, std::span<const std::byte> body,
                                   [[maybe_unused]] wire::arena* memory) noexcept {
    if constexpr (wire::needs_memory<T>)
        return wire::decode(message, body, *memory);
    else
        return wire::decode(message, body);
}

template <std::size_t I, class... Handlers>
constexpr dispatched decode_and_handle(std::tuple<Handlers...>& handlers, const header& head,
                                       std::span<const std::byte> body, wire::arena* memory) {
    auto& handler = std::get<I>(handlers);
    typename std::tuple_element_t<I, std::tuple<Handlers...>>::message_type message{};
    if (const wire::result decoded = decode_body(message, body, memory); !decoded) {
        each_of<malformed_handler>(handlers, [&](auto& h) { h.handle(head, body, decoded.error()); });
        return dispatched::malformed;
    }
    handler.handle(head, std::as_const(message));
    return dispatched::handled;
}

/// The command codes of the typed handlers, and beside each the function that decodes for it.
template <class... Handlers> struct dispatch_table {
    using step = dispatched (*)(std::tuple<Handlers...>&, const header&, std::span<const std::byte>, wire::arena*);
    static constexpr std::size_t count = (std::size_t{is_typed<Handlers>} + ... + 0);
    static constexpr auto places = [] {
        constexpr std::array<bool, sizeof...(Handlers)> typed{is_typed<Handlers>...};
        std::array<std::size_t, count> found{};
        for (std::size_t i = 0, at = 0; i != typed.size(); ++i)
            if (typed[i]) found[at++] = i;
        return found;
    }();
    template <std::size_t I> using handler = std::tuple_element_t<places[I], std::tuple<Handlers...>>;
    static constexpr bool needs_memory = []<std::size_t... I>(std::index_sequence<I...>) {
        return (wire::needs_memory<typename handler<I>::message_type> || ... || false);
    }
    (std::make_index_sequence<count>{});

    static constexpr auto codes = []<std::size_t... I>(std::index_sequence<I...>) {
        return std::array<std::uint16_t, count>{command_code_of<typename handler<I>::message_type>...};
    }
    (std::make_index_sequence<count>{});
    static constexpr auto steps = []<std::size_t... I>(std::index_sequence<I...>) {
        return std::array<step, count>{&decode_and_handle<places[I], Handlers...>...};
    }
    (std::make_index_sequence<count>{});
};

} // namespace detail

/// Handles the message `T`: `handle(const header&, const T&)`.
template <coded_message T, class F> constexpr auto on(F handle) {
    return detail::typed_handler<T, F>{std::move(handle)};
}
/// Handles command codes that no handler takes: `handle(const header&, std::span<const std::byte> body)`.
template <class F> constexpr auto on_unknown(F handle) { return detail::unknown_handler<F>{std::move(handle)}; }
/// Handles bodies that do not decode: `handle(const header&, std::span<const std::byte> body, wire::errc)`.
template <class F> constexpr auto on_malformed(F handle) { return detail::malformed_handler<F>{std::move(handle)}; }
/// Handles ACK and NAK, which have a command code but no body: `handle(const header&)`.
template <class F> constexpr auto on_acknowledgement(F handle) {
    return detail::acknowledgement_handler<F>{std::move(handle)};
}

/// Calls the handler of a message's type with the decoded message.
///
///     jaus::dispatcher arm{jaus::on<jaus::set_wrench_effort>([&](const jaus::header&, const auto& efforts) { ... }),
///                          jaus::on_unknown([&](const jaus::header& head, auto body) { ... })};
///     arm(head, body);
template <class... Handlers> class dispatcher {
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

  private:
    using table = detail::dispatch_table<Handlers...>;
    using codes = wire::code_index<table::codes>;

    constexpr dispatched dispatch(const header& head, std::span<const std::byte> body, wire::arena* memory) {
        if (is_acknowledgement(head) && body.empty()) {
            detail::each_of<detail::acknowledgement_handler>(handlers_, [&](auto& h) { h.handle(head); });
            return dispatched::acknowledgement;
        }
        const std::size_t place = codes::find(head.command_code);
        if (place == codes::npos) {
            detail::each_of<detail::unknown_handler>(handlers_, [&](auto& h) { h.handle(head, body); });
            return dispatched::unknown;
        }
        return table::steps[place](handlers_, head, body, memory);
    }

    std::tuple<Handlers...> handlers_;
};

} // namespace jauscat::jaus
