// What a component asks of others: questions, commands, control, reports as streams.
#pragma once
#include <jauscat/app/client.hpp>
#include <jauscat/app/impl/node_context.hpp>
#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/jaus/component/component_part.hpp>
#include <jauscat/jaus/component/held_control.hpp>
#include <jauscat/jaus/events/event_consumer.hpp>
#include <jauscat/jaus/events/service_consumer.hpp>

#include <deque>
#include <list>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// Behind a control.
struct control_state {
    std::weak_ptr<component_state> component;
    std::shared_ptr<node_context> context;
    jaus::address of{};
    jaus::control_state state{};
    operation_ptr<std::shared_ptr<control_state>> asked{}; ///< until it is answered
    std::vector<operation_ptr<>> when_lost{};
};

/// State of a connection or an event, as its subscription has it.
enum class stream_state : std::uint8_t { asking, active, silent, refused, unanswered, over };

/// Behind a subscription.
struct subscription_state {
    std::weak_ptr<component_state> component;
    std::shared_ptr<node_context> context;
    bool is_event{};
    std::size_t max_waiting{};
    std::optional<std::size_t> place{}; ///< in the consumer
    stream_state seen{};                ///< when the consumer was last looked at
    operation_ptr<std::shared_ptr<subscription_state>> asked{};
    operation_ptr<bytes> next{};
    std::deque<std::vector<std::byte>> reports{};
    error_code news{}; ///< what async_next has to say before the next report
    std::uint64_t dropped{};
    double rate{}; ///< hertz, as confirmed; of an event 0
};

class search;

/// A part of a component, see jaus::component_part.
class clients {
  public:
    clients(component_state& component, const jaus::address& self, const retry_policy& retry);
    clients(const clients&) = delete;
    clients& operator=(const clients&) = delete;

    jaus::message_outcome on_message(const jaus::header& head, bytes body, time_point now, jaus::message_sink out);
    void on_time(time_point now, jaus::message_sink out);
    [[nodiscard]] std::optional<time_point> next_event() const;
    void on_lost(const jaus::address& who);
    /// A message of the component was acknowledged, or not.
    void on_delivered(const jaus::header& head, jaus::delivered what, bool is_large);
    /// All operations end, control is released.
    void end_all(error_code why, time_point now, jaus::message_sink out) noexcept;

    /// `by`: the control that the command needs, if any.
    void send(jaus::header head, bytes body, const operation_ptr<>& done, std::shared_ptr<control_state> by = {});
    void ask(const jaus::address& of, question_codes codes, std::vector<std::byte> body, const ask_options& options,
             const operation_ptr<bytes>& done);
    /// A message is a report that was asked for or subscribed to.
    [[nodiscard]] bool awaits(const jaus::header& head) const;
    void connect(const jaus::address& to, std::uint16_t code, const connect_options& options,
                 std::shared_ptr<subscription_state> made);
    void request_event(const jaus::address& of, bytes request, std::shared_ptr<subscription_state> made);
    void end(subscription_state& ended);
    /// Those in `heard` are there; later ones come through `appeared`.
    void begin(const std::shared_ptr<search>& made, std::span<const jaus::address> heard);
    void appeared(const jaus::address& who);
    /// From the first attempt of a message until it has failed.
    [[nodiscard]] duration patience() const noexcept { return retry_.total(); }
    void control(const control_options& options, std::shared_ptr<control_state> made);
    /// Ends what cancelled operations have begun.
    void end_cancelled();
    /// Aborts all operations; connections, events and control stay.
    void cancel();
    /// `done`, if any, ends when it is acknowledged.
    void release(control_state& released, const operation_ptr<>& done = {});

  private:
    static constexpr std::size_t capacity = 64;
    /// A confirmation may come as late, and is answered with a release.
    static constexpr duration late = std::chrono::seconds{5};

    struct sent_message { ///< waits for its acknowledgement
        jaus::header head{};
        operation_ptr<> done{};
        bool is_large{};                     ///< a large data set: numbered by last_number_
        std::shared_ptr<control_state> by{}; ///< the control that it needs
    };
    struct question { ///< waits for its report
        jaus::header head{};
        std::uint16_t report{};
        operation_ptr<bytes> done{};
        deadline until{};
        std::vector<std::byte> message{}; ///< to be repeated; empty if the component's acknowledged_sender does it
        time_point repeated_at{};
        std::uint32_t made{};
        bool is_large{};
    };
    struct held { ///< control, or what is left of it
        std::shared_ptr<control_state> state;
        std::optional<jaus::held_control> machine{};
        jaus::header release{}; ///< as sent
        time_point over_at{};   ///< control is not wanted any more
        [[nodiscard]] bool is_wanted() const noexcept {
            return state->state == jaus::control_state::held || state->state == jaus::control_state::asking;
        }
        void changed(jaus::control_state now);
    };

    struct numbering {     ///< of a provider's answers
        bool is_known{};   ///< they have the numbers of the questions
        bool is_other{};   ///< they have not
        unsigned misses{}; ///< answers in turn that were taken for late ones
    };
    static constexpr unsigned most_misses = 4;
    static constexpr std::size_t most_ended = 256;

    /// The question that a report answers; questions_.end(): none.
    [[nodiscard]] std::list<question>::iterator question_of(const jaus::header& head, bool is_large);
    /// An answer that comes now is not taken for that of a later question.
    void note_ended(const question& one);
    /// Commands of a control that is not held any more are not repeated.
    void end_uncontrolled();
    /// Sends a waiting message no more; an operation that waits for its outcome is aborted.
    void forget(const jaus::header& sent);
    [[nodiscard]] node_errc refused(const jaus::header& head, node_errc why) const;
    /// Sends a message that must be acknowledged; its sequence number, or why not.
    result<std::uint16_t, node_errc> send_acknowledged(const jaus::header& head, bytes body);
    [[nodiscard]] stream_state state_of(const subscription_state& of) const;
    /// The consumers have handled a message, or time: tells subscriptions what has changed.
    void note_streams();
    void deliver(subscription_state& to, bytes body);
    void tell(subscription_state& to, node_errc why);
    [[nodiscard]] std::shared_ptr<subscription_state> subscription_at(bool is_event, std::size_t place) const;

    component_state& component_;
    jaus::address self_;
    retry_policy retry_;
    jaus::service_consumer<capacity> connections_;
    jaus::event_consumer<capacity> events_;
    std::list<sent_message> sent_{};
    std::list<question> questions_{};
    std::deque<jaus::header> ended_{};                         ///< questions, the last ones
    std::unordered_map<std::uint32_t, numbering> numbering_{}; ///< by address
    std::uint16_t last_number_; ///< of large data sets, and of questions that are not acknowledged
    std::list<held> held_{};
    std::vector<std::shared_ptr<subscription_state>> subscriptions_{};
    std::vector<std::shared_ptr<search>> searches_{};
};

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
