// A value or an error: how every function that can fail returns.
#pragma once
#include <concepts>
#include <type_traits>
#include <utility>

namespace jauscat {

/// An error is an enumeration whose 0 is called `ok`, or a structure that compares equal to its default while there is
/// no error: a code and its typed detail.
template <class E> concept error_type = std::default_initializable<E> && std::equality_comparable<E>;

/// A value, or why there is none. `T` is what the function gives, `E` its error; a `T` is made without arguments where
/// there is an error, so no storage is shared and nothing can throw.
template <class T, error_type E> class [[nodiscard]] result {
    static_assert(!std::is_convertible_v<T, E> && !std::is_convertible_v<E, T>,
                  "result: value and error must not convert to each other");

  public:
    using value_type = T;
    using error_type = E;

    constexpr result(T value) noexcept(std::is_nothrow_move_constructible_v<T>) : value_{std::move(value)} {}
    /// `error` is not `ok`.
    constexpr result(E error) noexcept(std::is_nothrow_move_constructible_v<E>) : error_{std::move(error)} {}

    /// Both, without a branch: `value` counts only if `error` is `ok`.
    constexpr result(T value, E error) noexcept(std::is_nothrow_move_constructible_v<T> &&
                                                std::is_nothrow_move_constructible_v<E>)
        : value_{std::move(value)}, error_{std::move(error)} {}

    [[nodiscard]] constexpr bool has_value() const noexcept { return error_ == E{}; }
    [[nodiscard]] constexpr explicit operator bool() const noexcept { return has_value(); }
    /// `ok`, or why there is no value.
    [[nodiscard]] constexpr const E& error() const noexcept { return error_; }

    /// The value; only where there is one.
    [[nodiscard]] constexpr const T& operator*() const& noexcept { return value_; }
    [[nodiscard]] constexpr T& operator*() & noexcept { return value_; }
    [[nodiscard]] constexpr T&& operator*() && noexcept { return std::move(value_); }
    [[nodiscard]] constexpr const T* operator->() const noexcept { return &value_; }
    [[nodiscard]] constexpr T* operator->() noexcept { return &value_; }
    [[nodiscard]] constexpr T value_or(T other) const& { return has_value() ? value_ : std::move(other); }

    friend constexpr bool operator==(const result& a, const result& b)
    requires std::equality_comparable<T>
    {
        return a.error_ == b.error_ && a.value_ == b.value_;
    }

  private:
    T value_{};
    E error_{};
};

/// Success, or why not.
template <error_type E> class [[nodiscard]] result<void, E> {
  public:
    using value_type = void;
    using error_type = E;

    constexpr result() noexcept = default;
    /// `ok`: success.
    constexpr result(E error) noexcept(std::is_nothrow_move_constructible_v<E>) : error_{std::move(error)} {}

    [[nodiscard]] constexpr bool has_value() const noexcept { return error_ == E{}; }
    [[nodiscard]] constexpr explicit operator bool() const noexcept { return has_value(); }
    [[nodiscard]] constexpr const E& error() const noexcept { return error_; }

    friend constexpr bool operator==(const result& a, const result& b) { return a.error_ == b.error_; }

  private:
    E error_{};
};

} // namespace jauscat
