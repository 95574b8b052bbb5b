// Questions and commands to other components: options, received messages, and the requests as bytes.
#pragma once
#include <jauscat/app/detail/handler.hpp>
#include <jauscat/app/detail/operation.hpp>
#include <jauscat/app/error.hpp>
#include <jauscat/schema/jaus/event.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {

/// A received message together with the bytes and lists that it refers to.
template <class T> class owned {
  public:
    owned() = default;
    /// Decodes `body`.
    explicit owned(app::bytes body, wire::errc& why) {
        bytes_.assign(body.begin(), body.end());
        if constexpr (wire::needs_memory<T>) {
            for (std::size_t size = 16 * body.size() + 64;; size *= 2) {
                lists_.reset(new std::byte[size]);
                wire::arena memory{{lists_.get(), size}};
                const auto decoded = wire::decode(value_, bytes_, memory);
                why = decoded ? wire::errc::ok : decoded.error();
                if (why != wire::errc::arena_full) return;
                value_ = {};
            }
        } else {
            const auto decoded = wire::decode(value_, bytes_);
            why = decoded ? wire::errc::ok : decoded.error();
        }
    }
    owned(owned&&) noexcept = default;
    owned& operator=(owned&&) noexcept = default;
    owned(const owned&) = delete; // a copy would refer to the memory of another
    owned& operator=(const owned&) = delete;

    [[nodiscard]] const T& operator*() const noexcept { return value_; }
    [[nodiscard]] const T* operator->() const noexcept { return &value_; }

  private:
    std::vector<std::byte> bytes_{};
    std::unique_ptr<std::byte[]> lists_{};
    T value_{};
};

namespace app {

/// Whether a value refers to bytes or lists outside of itself.
template <class V> struct refers {
    static constexpr bool value = false;
};
template <> struct refers<std::string_view> {
    static constexpr bool value = true;
};
template <class E> struct refers<wire::list<E>> {
    static constexpr bool value = true;
};
template <class V> struct refers<std::optional<V>> : refers<V> {};
template <class V, std::size_t N> struct refers<std::array<V, N>> : refers<V> {};
template <class V, std::size_t N> struct refers<wire::inline_list<V, N>> : refers<V> {};
template <class... V> struct refers<std::variant<V...>> {
    static constexpr bool value = (refers<V>::value || ...);
};
template <wire::message T> struct refers<T> {
    template <auto... Members> static constexpr bool any(wire::key_list<Members...>) {
        return (refers<wire::member_t<Members>>::value || ... || false);
    }
    static constexpr bool value =
        !wire::layout_of<T>::all_items([]<class Item>() { return !any(typename Item::keys{}); });
};

template <class T> struct received_form {
    using type = T;
};
template <class T>
requires refers<T>::value
struct received_form<T> {
    using type = owned<T>;
};

} // namespace app

/// What an operation gives that receives a message: the message itself, or where it refers to text, bytes or lists an
/// `owned` one.
template <jaus::coded_message T> using received = typename app::received_form<T>::type;

struct control_options {
    std::uint8_t authority{128}; ///< 0 lowest to 255 highest: a higher one takes control from a lower one
    /// Of a request that is not answered.
    retry_policy retry{.interval = std::chrono::milliseconds{250}, .attempts = 4};
    /// Interval of requests that keep control, and detect that the component has restarted; 0: none.
    duration renewal{std::chrono::seconds{1}};
};

struct ask_options {
    duration timeout{std::chrono::seconds{2}}; ///< from the query to its report
    /// The query asks for an acknowledgement and is repeated until it has one, so that a refusal is known at once.
    /// Without, for peers that never acknowledge, it is repeated at the interval of the component's retry policy.
    bool acknowledged{true};
};

struct connect_options {
    double rate{10};                           ///< hertz, above 0 and up to 1092; the provider may confirm another
    std::uint32_t presence_vector{0xFFFFFFFF}; ///< fields of the report; by default all that it has
    std::size_t max_waiting{256}; ///< reports that async_next has not taken; then the oldest is dropped, and counted
};

/// What a component must be or have to be found.
struct find_options {
    std::uint8_t component{};                  ///< component ID; 0: any
    std::string_view name{};                   ///< a part of its identification
    std::uint16_t command_code{};              ///< of a message that it takes or sends; 0: any
    duration timeout{std::chrono::seconds{1}}; ///< then the search ends with those that have answered
    std::size_t count{};                       ///< it ends when so many have answered; 0: at its timeout
};
/// A component that has answered.
struct found_component {
    jaus::address address{};
    std::string identification{};
    std::vector<std::uint16_t> takes{}, sends{}; ///< command codes, by Report Services
};

namespace app {

struct subscription_state;
struct control_state;

/// Calls the handlers of operations that have no executor of their own; without the state behind a handle, and without
/// its node, that of the system.
JAUSCAT_DECL boost::asio::any_io_executor executor_of(const std::shared_ptr<component_state>&) noexcept;
JAUSCAT_DECL boost::asio::any_io_executor executor_of(const std::shared_ptr<subscription_state>&) noexcept;
JAUSCAT_DECL boost::asio::any_io_executor executor_of(const std::shared_ptr<control_state>&) noexcept;
JAUSCAT_DECL void begin_send(const std::shared_ptr<component_state>&, const jaus::address& to, std::uint16_t code,
                             std::vector<std::byte> body, const operation_ptr<>& done);
/// The command codes of a query and its report.
struct question_codes {
    std::uint16_t query{};
    std::uint16_t report{}; ///< 0: that of the standard
};
JAUSCAT_DECL void begin_ask(const std::shared_ptr<component_state>&, const jaus::address& of, question_codes codes,
                            std::vector<std::byte> body, const ask_options& options, const operation_ptr<bytes>& done);
JAUSCAT_DECL void begin_connect(const std::shared_ptr<component_state>&, const jaus::address& of, std::uint16_t code,
                                const connect_options& options,
                                const operation_ptr<std::shared_ptr<subscription_state>>& done);
/// `request` is the body of a Create Event.
JAUSCAT_DECL void begin_event(const std::shared_ptr<component_state>&, const jaus::address& of,
                              std::vector<std::byte> request, std::size_t max_waiting,
                              const operation_ptr<std::shared_ptr<subscription_state>>& done);
JAUSCAT_DECL void begin_next(const std::shared_ptr<subscription_state>&, const operation_ptr<bytes>& done);
JAUSCAT_DECL void end(const std::shared_ptr<subscription_state>&) noexcept;
JAUSCAT_DECL void begin_control(const std::shared_ptr<component_state>&, const jaus::address& of,
                                const control_options& options,
                                const operation_ptr<std::shared_ptr<control_state>>& done);
JAUSCAT_DECL void begin_find(const std::shared_ptr<component_state>&, const find_options& options,
                             const operation_ptr<std::vector<found_component>>& done);
JAUSCAT_DECL void begin_lost(const std::shared_ptr<control_state>&, const operation_ptr<>& done);
JAUSCAT_DECL void end(const std::shared_ptr<control_state>&) noexcept;
JAUSCAT_DECL void cancel(const std::shared_ptr<component_state>&);
JAUSCAT_DECL std::shared_ptr<component_state> component_of(const control_state&) noexcept;
JAUSCAT_DECL std::uint64_t dropped_of(const subscription_state&) noexcept;
JAUSCAT_DECL double rate_of(const subscription_state&) noexcept;

/// Makes the message of received bytes.
template <class T> struct decoded_as {
    std::tuple<error_code, received<T>> operator()(error_code error, bytes body) const {
        if (error) return {error, received<T>{}};
        wire::errc why{};
        if constexpr (refers<T>::value) {
            owned<T> value{body, why};
            return {why == wire::errc::ok ? error : make_error_code(node_errc::malformed_answer), std::move(value)};
        } else {
            T value{};
            const auto decoded = wire::decode(value, body);
            return {decoded ? error : make_error_code(node_errc::malformed_answer), value};
        }
    }
};
/// The received bytes.
struct copied {
    std::tuple<error_code, std::vector<std::byte>> operator()(error_code error, bytes body) const {
        return {error, {body.begin(), body.end()}};
    }
};
/// Makes a handle of what is behind it.
template <class Handle> struct handled_as {
    template <class State> std::tuple<error_code, Handle> operator()(error_code error, State state) const {
        return {error, Handle{std::move(state)}};
    }
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
