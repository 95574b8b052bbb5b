// What a part of a component needs.
#pragma once
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

#include <concepts>
#include <optional>
#include <span>

namespace jauscat::jaus {

/// One concept for each operation of a part, so that a violation names the one that is missing.
namespace operations {

template <class Part>
concept has_on_message = requires(Part& part, const header& head, std::span<const std::byte> body, time_point now,
                                  message_sink out) { part.on_message(head, body, now, out); };
template <class Part>
concept has_message_outcome =
    requires(Part& part, const header& head, std::span<const std::byte> body, time_point now, message_sink out) {
        { part.on_message(head, body, now, out) } -> std::same_as<message_outcome>;
    };
template <class Part>
concept has_on_time = requires(Part& part, time_point now, message_sink out) { part.on_time(now, out); };
template <class Part>
concept has_next_event = requires(const Part& part) {
    { part.next_event() } -> std::same_as<std::optional<time_point>>;
};
template <class Part> concept has_on_lost = requires(Part& part, const address& who) { part.on_lost(who); };

struct message_listing {
    void operator()(const supported_message&) const noexcept {}
};
template <class Part>
concept lists_messages =
    requires(const Part& part, message_listing takes, message_listing sends) { part.list_messages(takes, sends); };
// A list_messages that is there and cannot be called would be left out without a word.
template <class Part>
concept has_useless_list = !lists_messages<Part> && (
    requires { &Part::list_messages; } ||
    requires(Part& part, message_listing takes, message_listing sends) { part.list_messages(takes, sends); });

} // namespace operations

/// A part of a component: a state machine that gets the messages that the core leaves, and the time. Needed:
/// - `on_message(const header&, std::span<const std::byte> body, time_point now, message_sink out)`
///   returns a message_outcome; `unhandled` hands the message to the next part, and at last to the application.
/// - `on_time(now, out)` does what is due, at `next_event()` or later; it may be called earlier.
/// - `next_event() const` returns when on_time has something to do, as std::optional<time_point>.
/// - `on_lost(const address& who)`: a component has disappeared, or all of a level for which an octet is 255; see
///   stands_for. Ends what depends on it.
///
/// Optional: `list_messages(takes, sends) const` calls `takes(supported_message)` for each message that the part takes,
/// and `sends` for each that it sends, for Report Services.
template <class Part>
concept component_part =
    operations::has_message_outcome<Part> && operations::has_on_time<Part> && operations::has_next_event<Part> &&
    operations::has_on_lost<Part> && !operations::has_useless_list<Part>;

/// Does not compile for a part that lacks an operation, and says which.
template <class Part> consteval void require_part() noexcept {
    static_assert(operations::has_on_message<Part>,
                  "component: a part has no on_message(const header&, std::span<const std::byte>,"
                  " time_point, message_sink)");
    static_assert(!operations::has_on_message<Part> || operations::has_message_outcome<Part>,
                  "component: on_message of a part does not return a message_outcome");
    static_assert(operations::has_on_time<Part>, "component: a part has no on_time(time_point, message_sink)");
    static_assert(operations::has_next_event<Part>, "component: a part has no next_event() const that returns a"
                                                    " std::optional<time_point>");
    static_assert(operations::has_on_lost<Part>, "component: a part has no on_lost(const address&)");
    static_assert(!operations::has_useless_list<Part>,
                  "component: list_messages of a part is not const, or has other parameters than (takes, sends)");
}

} // namespace jauscat::jaus
