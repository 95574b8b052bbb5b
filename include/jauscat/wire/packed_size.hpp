// A size or an error in four bytes: how functions that may stay out of line return their result.
#pragma once
#include <jauscat/base/result.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::wire {

/// A size below 2^24 bytes, or an error. One word, so it is returned in a register. The public functions around it are
/// inlined and give a `result`.
/// `Error` is an enumeration of at most 256 values whose `ok` is zero.
template <class Error> class [[nodiscard]] packed_size {
  public:
    static constexpr std::size_t max_size = 0xFFFFFF;

    /// A size, at most `max_size`.
    constexpr packed_size(std::size_t size) noexcept : word_{static_cast<std::uint32_t>(size)} {}
    /// An error, which is not `ok`.
    constexpr packed_size(Error error) noexcept : word_{static_cast<std::uint32_t>(error) << 24} {}

    /// True when there is a size and no error.
    [[nodiscard]] constexpr explicit operator bool() const noexcept { return error() == Error{}; }
    /// 0 after an error.
    [[nodiscard]] constexpr std::size_t size() const noexcept { return word_ & max_size; }
    [[nodiscard]] constexpr Error error() const noexcept { return static_cast<Error>(word_ >> 24); }

    /// The bytes of `out` that were written.
    // Unpacks without a branch: after one, GCC leaves the loads of an inlined translation before its checks, and more
    // registers are saved.
    [[gnu::always_inline]] constexpr result<std::span<std::byte>, Error> of(std::span<std::byte> out) const noexcept {
        return {out.first(size()), error()};
    }

  private:
    std::uint32_t word_;
};

} // namespace jauscat::wire
