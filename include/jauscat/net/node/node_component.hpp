// What a component needs that is added to a node.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/component_application.hpp>
#include <jauscat/jaus/component/component_outcome.hpp>
#include <jauscat/jaus/component/component_part.hpp>

#include <concepts>

namespace jauscat::net {

namespace detail {

struct any_application {
    jaus::message_outcome operator()(const jaus::header&, std::span<const std::byte>) const noexcept {
        return jaus::message_outcome::unhandled;
    }
};

template <class C>
concept has_self = requires(const C& component) {
    { component.self() } -> std::convertible_to<const jaus::address&>;
};
template <class C>
concept takes_component_message = requires(C& component, const jaus::header& head, std::span<const std::byte> body,
                                           time_point now, jaus::message_sink out, any_application application) {
    { component.on_message(head, body, now, out, application) } -> std::same_as<jaus::component_outcome>;
};

} // namespace detail

/// A component for a node: a jaus::component, a bridging::component, or an object in front of one. Needed:
/// - `self() const` returns its jaus::address.
/// - `on_message(head, body, now, out, application)` returns a jaus::component_outcome; see jaus::component. What the
///   component leaves goes to `application`, a jaus::component_application of any type.
/// - `on_time`, `next_event` and `on_lost` as in jaus::component_part.
///
/// Optional: `list_messages(takes, sends) const`, see jaus::component_part; `answer_query`, see jaus::component.
template <class C>
concept node_component =
    detail::has_self<C> && detail::takes_component_message<C> && jaus::operations::has_on_time<C> &&
    jaus::operations::has_next_event<C> && jaus::operations::has_on_lost<C> && !jaus::operations::has_useless_list<C>;

/// Does not compile for a component that lacks an operation, and says which.
template <class Component> consteval void require_component() noexcept {
    static_assert(detail::has_self<Component>, "node: the component has no self() const that returns a jaus::address");
    static_assert(detail::takes_component_message<Component>,
                  "node: the component has no on_message(const header&, std::span<const std::byte>,"
                  " time_point, message_sink, auto&& application) that returns a component_outcome");
    static_assert(jaus::operations::has_on_time<Component>,
                  "node: the component has no on_time(time_point, message_sink)");
    static_assert(jaus::operations::has_next_event<Component>,
                  "node: the component has no next_event() const that returns a"
                  " std::optional<time_point>");
    static_assert(jaus::operations::has_on_lost<Component>, "node: the component has no on_lost(const address&)");
    static_assert(!jaus::operations::has_useless_list<Component>,
                  "node: list_messages of the component is not const, or has other parameters than (takes, sends)");
}
/// The same for its application.
template <class Application> consteval void require_application() noexcept {
    jaus::require_application<Application>();
    static_assert(!jaus::operations::has_useless_list<Application>,
                  "node: list_messages of the application is not const, or has other parameters than (takes, sends)");
}

} // namespace jauscat::net
