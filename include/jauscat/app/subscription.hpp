// Reports as a stream: of a service connection, or of an event.
#pragma once
#include <jauscat/app/client.hpp>

namespace jauscat {
inline namespace JAUSCAT_WAY {

/// The reports of a service connection or of an event; ended with this object.
template <jaus::coded_message Report> class subscription {
  public:
    subscription() = default;
    explicit subscription(std::shared_ptr<app::subscription_state> state) noexcept : state_{std::move(state)} {}
    ~subscription() { end(); }
    subscription(subscription&& other) noexcept = default;
    subscription& operator=(subscription&& other) noexcept {
        if (this != &other) {
            end();
            state_ = std::move(other.state_);
            is_ended_ = other.is_ended_;
        }
        return *this;
    }

    /// The next report. Errors: silent (once each time the reports stop; they may continue), connection_refused by a
    /// provider that has restarted, malformed_answer; operation_aborted after `end`, and where async_connect or
    /// async_event has not made this. One operation at a time.
    template <class Token = default_token> auto async_next(Token&& token = Token{}) {
        return boost::asio::async_initiate<Token, void(app::error_code, received<Report>)>(
            [](auto handler, const std::shared_ptr<app::subscription_state>& state) {
                app::begin_next(state, app::make_operation<app::bytes>(std::move(handler), app::decoded_as<Report>{},
                                                                       app::executor_of(state)));
            },
            token, state_);
    }
    /// Number of reports that came and were dropped, because `max_waiting` others waited for async_next.
    [[nodiscard]] std::uint64_t dropped() const noexcept { return state_ ? app::dropped_of(*state_) : 0; }
    /// Of a connection: hertz, as the provider has confirmed it; 0: not yet, or an event.
    [[nodiscard]] double rate() const noexcept { return state_ ? app::rate_of(*state_) : 0; }
    /// Ends the connection or the event.
    void end() noexcept {
        if (state_ && !std::exchange(is_ended_, true)) app::end(state_);
    }
    [[nodiscard]] explicit operator bool() const noexcept { return state_ != nullptr && !is_ended_; }

  private:
    std::shared_ptr<app::subscription_state> state_{};
    bool is_ended_{};
};

} // namespace JAUSCAT_WAY
} // namespace jauscat
