// Reference to a user's callable. Does not allocate or own.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

namespace jauscat::jaus {

/// Refers to a callable, or to none. Made from an lvalue only, which must outlive it.
template <class Signature> class callback;

template <class Result, class... Arguments> class callback<Result(Arguments...)> {
  public:
    constexpr callback() noexcept = default;
    /// Refers to `function`, which must outlive it.
    template <class F>
    requires(!std::same_as<std::remove_const_t<F>, callback> && !std::is_function_v<F> &&
             std::is_invocable_r_v<Result, F&, Arguments...>)
    constexpr callback(F& function) noexcept
        : function_{const_cast<void*>(static_cast<const void*>(&function))},
          call_{[](void* f, Arguments... arguments) -> Result {
              return (*static_cast<F*>(f))(std::forward<Arguments>(arguments)...);
          }} {}

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return call_ != nullptr; }
    /// Not for a callback that refers to none.
    Result operator()(Arguments... arguments) const { return call_(function_, std::forward<Arguments>(arguments)...); }

  private:
    void* function_{};
    Result (*call_)(void*, Arguments...){};
};

} // namespace jauscat::jaus
