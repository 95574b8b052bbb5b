// Reference to the function that sends messages. Does not allocate.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>

namespace jauscat::jaus {

/// Refers to a callable that takes whole messages, header first. Made from one that outlives the sink; as an argument
/// it may be a lambda: `core.on_time(now, [&](std::span<const std::byte> message) { ... })`.
class message_sink {
  public:
    /// Refers to `take`, which must outlive it.
    template <class F>
    requires(!std::same_as<std::remove_cvref_t<F>, message_sink> && std::invocable<F&, std::span<const std::byte>>)
    constexpr message_sink(F&& take) noexcept
        : take_{const_cast<void*>(static_cast<const void*>(&take))},
          call_{[](void* function, std::span<const std::byte> message) {
              (*static_cast<std::remove_reference_t<F>*>(function))(message);
          }} {}

    /// `message` is valid during the call.
    constexpr void operator()(std::span<const std::byte> message) const { call_(take_, message); }

  private:
    void* take_;
    void (*call_)(void*, std::span<const std::byte>);
};

} // namespace jauscat::jaus
