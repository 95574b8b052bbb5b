// Control of another component, as long as an object lives.
#pragma once
#include <jauscat/app/client.hpp>

namespace jauscat {
inline namespace JAUSCAT_WAY {

/// Control of another component: kept by heartbeats and requests, released with this object. Made by
/// component::async_control; another one, or one that was moved from, has no control of anything.
class control {
  public:
    control() = default;
    explicit control(std::shared_ptr<app::control_state> state) noexcept : state_{std::move(state)} {}
    ~control() { release(); }
    control(control&& other) noexcept = default;
    control& operator=(control&& other) noexcept {
        if (this != &other) {
            release();
            state_ = std::move(other.state_);
            is_released_ = other.is_released_;
        }
        return *this;
    }

    /// Sends a command until it is acknowledged. Errors: as component::async_send, and control_lost.
    template <jaus::coded_message T, class Token = default_token>
    auto async_send(const T& message, Token&& token = Token{});
    /// The same for a body in bytes.
    template <class Token = default_token>
    auto async_send(std::uint16_t command_code, app::bytes body, Token&& token = Token{});
    /// Releases control, and completes when the component has acknowledged that. Errors: as component::async_send
    /// (refused: another component has control already), and control_lost.
    template <class Token = default_token> auto async_release(Token&& token = Token{});
    /// Completes when control is lost, with control_lost, or operation_aborted when it is released.
    template <class Token = default_token> auto async_lost(Token&& token = Token{}) {
        return boost::asio::async_initiate<Token, void(app::error_code)>(
            [](auto handler, const std::shared_ptr<app::control_state>& state) {
                app::begin_lost(
                    state, app::make_operation<>(std::move(handler), app::no_conversion{}, app::executor_of(state)));
            },
            token, state_);
    }
    /// Whether it is not lost and not released.
    [[nodiscard]] JAUSCAT_DECL bool is_held() const noexcept;
    /// The component that is controlled; without one {}.
    [[nodiscard]] JAUSCAT_DECL const jaus::address& of() const noexcept;
    void release() noexcept {
        if (state_ && !std::exchange(is_released_, true)) app::end(state_);
    }

  private:
    std::shared_ptr<app::control_state> state_{};
    bool is_released_{};
};

namespace app {
/// Of a control: fails with control_lost where that is lost.
JAUSCAT_DECL void begin_send(const std::shared_ptr<control_state>&, std::uint16_t code, std::vector<std::byte> body,
                             const operation_ptr<>& done);
JAUSCAT_DECL void begin_release(const std::shared_ptr<control_state>&, const operation_ptr<>& done);
} // namespace app

template <class Token> auto control::async_send(std::uint16_t command_code, app::bytes body, Token&& token) {
    return boost::asio::async_initiate<Token, void(app::error_code)>(
        [](auto handler, const std::shared_ptr<app::control_state>& state, std::uint16_t code,
           // NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved on
           std::vector<std::byte> encoded) {
            app::begin_send(state, code, std::move(encoded),
                            app::make_operation<>(std::move(handler), app::no_conversion{}, app::executor_of(state)));
        },
        token, state_, command_code, std::vector<std::byte>(body.begin(), body.end()));
}

template <class Token> auto control::async_release(Token&& token) {
    return boost::asio::async_initiate<Token, void(app::error_code)>(
        [](auto handler, const std::shared_ptr<app::control_state>& state) {
            app::begin_release(
                state, app::make_operation<>(std::move(handler), app::no_conversion{}, app::executor_of(state)));
        },
        token, state_);
}

template <jaus::coded_message T, class Token> auto control::async_send(const T& message, Token&& token) {
    std::vector<std::byte> body;
    const auto why = app::encode_into(body, message);
    return boost::asio::async_initiate<Token, void(app::error_code)>(
        [](auto handler, const std::shared_ptr<app::control_state>& state, std::vector<std::byte> encoded,
           app::error_code failed) {
            auto done = app::make_operation<>(std::move(handler), app::no_conversion{}, app::executor_of(state));
            if (failed) return done->complete(failed);
            app::begin_send(state, jaus::command_code_of<T>, std::move(encoded), done);
        },
        token, state_, std::move(body), app::not_encodable(jaus::command_code_of<T>, why));
}

} // namespace JAUSCAT_WAY
} // namespace jauscat
