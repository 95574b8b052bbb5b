// What the application of a component needs: the handler of the messages that the core and the parts leave.
#pragma once
#include <jauscat/jaus/component/answer.hpp>

#include <concepts>
#include <span>
#include <type_traits>

namespace jauscat::jaus {

/// Result of dispatching a message.
enum class dispatched : std::uint8_t { handled, unknown, malformed, acknowledgement };

/// The outcome of an application that returns message_outcome.
[[nodiscard]] constexpr message_outcome outcome_of(message_outcome outcome) noexcept { return outcome; }
/// The outcome of an application that is a dispatcher.
[[nodiscard]] constexpr message_outcome outcome_of(dispatched what) noexcept {
    if (what == dispatched::unknown) return message_outcome::unhandled;
    return what == dispatched::malformed ? message_outcome::malformed : message_outcome::handled;
}

namespace detail {

template <class F> concept takes_message = std::invocable<F&, const header&, std::span<const std::byte>>;

} // namespace detail

/// The application of a component: a function, or an object such as a dispatcher, for the messages that the core and
/// the parts leave. Needed: `application(const header&, std::span<const std::byte> body)` returns a message_outcome, or
/// `dispatched`.
///
/// Optional for an object that is added to a node: `list_messages(takes, sends) const`, see component_part.
template <class F>
concept component_application =
    detail::takes_message<F> &&
    (std::same_as<std::invoke_result_t<F&, const header&, std::span<const std::byte>>, message_outcome> ||
     std::same_as<std::invoke_result_t<F&, const header&, std::span<const std::byte>>, dispatched>);

/// Does not compile for what is no application; `F` is without reference.
template <class F> consteval void require_application() noexcept {
    static_assert(detail::takes_message<F>,
                  "component: the application cannot be called with (const header&, std::span<const std::byte>)");
    if constexpr (detail::takes_message<F>)
        static_assert(component_application<F>,
                      "component: the application returns neither a message_outcome nor what a dispatcher does");
}

} // namespace jauscat::jaus
