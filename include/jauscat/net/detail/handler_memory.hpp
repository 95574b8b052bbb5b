// Reusable memory for Boost.Asio's waiting handlers, so that waiting for a datagram or moving a timer does not
// allocate. Asio's own cache is shared by all handlers of a thread, and quickly used up.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace jauscat::net::detail {

/// A few blocks: a timer that is moved has a cancelled and a waiting handler. If no block is free or large enough, the
/// heap is used. For one thread.
class handler_memory {
  public:
    static constexpr std::size_t blocks = 4, size = 256;

    void* take(std::size_t wanted) {
        if (wanted <= size)
            for (auto& one : blocks_)
                if (!std::exchange(one.used, true)) return one.bytes.data();
        return ::operator new(wanted);
    }
    void give_back(void* memory) noexcept {
        for (auto& one : blocks_)
            if (memory == one.bytes.data()) {
                one.used = false;
                return;
            }
        ::operator delete(memory);
    }

  private:
    struct block {
        alignas(std::max_align_t) std::array<std::byte, size> bytes;
        bool used;
    };
    std::array<block, blocks> blocks_{};
};

/// Its allocator, which shares ownership: Asio may deallocate a block after its owner was destroyed.
template <class T> class handler_allocator {
  public:
    using value_type = T;

    explicit handler_allocator(std::shared_ptr<handler_memory> memory) noexcept : memory_{std::move(memory)} {}
    template <class U>
    handler_allocator(const handler_allocator<U>& other) noexcept // NOLINT(google-explicit-constructor): allocators are
        : memory_{other.memory()} {}

    T* allocate(std::size_t count) { return static_cast<T*>(memory_->take(count * sizeof(T))); }
    void deallocate(T* memory, std::size_t) noexcept { memory_->give_back(memory); }

    [[nodiscard]] const std::shared_ptr<handler_memory>& memory() const noexcept { return memory_; }
    template <class U> bool operator==(const handler_allocator<U>& other) const noexcept {
        return memory_ == other.memory();
    }

  private:
    std::shared_ptr<handler_memory> memory_;
};

/// A handler that Asio allocates in `memory`.
template <class F> struct remembered_handler {
    F call;
    std::shared_ptr<handler_memory> memory;

    using allocator_type = handler_allocator<void>;
    [[nodiscard]] allocator_type get_allocator() const noexcept { return allocator_type{memory}; }
    void operator()(auto&&... result) { call(std::forward<decltype(result)>(result)...); }
};
template <class F> remembered_handler(F, std::shared_ptr<handler_memory>) -> remembered_handler<F>;

} // namespace jauscat::net::detail
