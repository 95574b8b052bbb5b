// Samples of messages between one thread that writes and one that reads.
#pragma once
#include <jauscat/base/time.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace jauscat::net::detail {

/// A message as it passed.
struct live_sample {
    static constexpr std::size_t capacity = 512; ///< bytes that are kept

    time_point at{};
    std::uint64_t from{}, to{};                     ///< packed JAUS IDs
    std::size_t size{};                             ///< bytes of the message
    std::uint16_t code{};                           ///< command code or message ID
    std::uint16_t body_begin{}, body_end{}, kept{}; ///< offsets in `bytes`; bytes that are kept
    std::uint8_t way{};                             ///< of live_way
    std::uint8_t acknowledgement{}; ///< of the header: 1 one is wanted, 2 negative, 3 positive; the same in SAE JAUS
    bool is_sae{};
    bool has_body{};                         ///< it decodes as the message `code`: no acknowledgement, no part
    std::array<std::byte, capacity> bytes{}; ///< header and body
};

/// Fixed memory; a sample that finds no place is lost and counted.
class sample_ring {
  public:
    static constexpr std::size_t capacity = 4096; ///< a power of two

    /// The place of the next sample; nullptr: there is none. For the writer.
    [[nodiscard]] live_sample* begin_write() noexcept {
        const auto at = written_.load(std::memory_order_relaxed);
        if (at - read_.load(std::memory_order_acquire) == capacity) {
            lost_.fetch_add(1, std::memory_order_relaxed);
            return nullptr;
        }
        return &places_[at % capacity];
    }
    void end_write() noexcept { written_.fetch_add(1, std::memory_order_release); }

    /// The oldest sample; nullptr: there is none. For the reader.
    [[nodiscard]] const live_sample* begin_read() const noexcept {
        const auto at = read_.load(std::memory_order_relaxed);
        return at == written_.load(std::memory_order_acquire) ? nullptr : &places_[at % capacity];
    }
    void end_read() noexcept { read_.fetch_add(1, std::memory_order_release); }

    [[nodiscard]] std::uint64_t lost() const noexcept { return lost_.load(std::memory_order_relaxed); }

  private:
    std::vector<live_sample> places_ = std::vector<live_sample>(capacity);
    alignas(64) std::atomic<std::size_t> written_{};
    std::atomic<std::uint64_t> lost_{};
    alignas(64) std::atomic<std::size_t> read_{};
};

} // namespace jauscat::net::detail
