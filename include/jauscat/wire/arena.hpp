// Memory that the caller lends to one message: lists of records are decoded into it.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

namespace jauscat::wire {

/// Hands out consecutive pieces of the caller's bytes, which must outlive every message decoded with it.
/// Never frees a single piece: reset() takes all of them back, and with them the lists of earlier messages.
class arena {
  public:
    /// `memory` must outlive the decoded messages.
    constexpr explicit arena(std::span<std::byte> memory) noexcept : memory_{memory} {}

    /// `count` default values of `T`, or nullptr if the arena is full.
    template <class T> [[nodiscard]] T* allocate(std::size_t count) noexcept {
        static_assert(std::is_trivially_destructible_v<T>, "arena: its elements are never destroyed");
        void* at = memory_.data() + used_;
        std::size_t left = memory_.size() - used_;
        if (count > left / sizeof(T) || std::align(alignof(T), count * sizeof(T), at, left) == nullptr) return nullptr;
        used_ = memory_.size() - left + count * sizeof(T);
        T* const first = static_cast<T*>(at);
        for (std::size_t i = 0; i != count; ++i) std::construct_at(first + i);
        return first;
    }

    /// All of the memory is free again; lists in it are gone.
    constexpr void reset() noexcept { used_ = 0; }
    /// Bytes in use, including alignment.
    [[nodiscard]] constexpr std::size_t used() const noexcept { return used_; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return memory_.size(); }

  private:
    std::span<std::byte> memory_;
    std::size_t used_{};
};

} // namespace jauscat::wire
