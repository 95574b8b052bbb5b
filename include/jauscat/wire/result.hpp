// What every operation of the codec returns: a size or a reason, in four bytes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace jauscat::wire {

/// Why an encode or decode was refused. `ok` is zero, as in every error enumeration of this library.
enum class errc : std::uint8_t {
    ok,
    truncated,            ///< the bytes end before the layout does
    trailing_bytes,       ///< bytes are left after the last field
    no_space,             ///< the output span is smaller than the encoded message
    out_of_range,         ///< a value outside its limits, not a number, or wider than its bit-field
    unknown_presence_bit, ///< a presence vector announces a field that its layout does not have
};

/// The error in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(errc error) noexcept {
    switch (error) {
    case errc::ok: return "ok";
    case errc::truncated: return "truncated: the bytes end before the last field";
    case errc::trailing_bytes: return "trailing bytes after the last field";
    case errc::no_space: return "no space: the output buffer is too small";
    case errc::out_of_range: return "out of range: a value exceeds the limits or the width of its field";
    case errc::unknown_presence_bit: return "unknown presence bit: the presence vector announces an undefined field";
    }
    return "unknown error";
}

/// A size below 2^24 bytes, or an error. One word, so it is returned in a register.
/// `Error` is an enumeration of at most 256 values whose `ok` is zero.
template <class Error> class [[nodiscard]] basic_result {
  public:
    constexpr basic_result(std::size_t size) noexcept : word_{static_cast<std::uint32_t>(size)} {}
    constexpr basic_result(Error error) noexcept : word_{static_cast<std::uint32_t>(error) << 24} {}

    /// True when there is a size and no error.
    [[nodiscard]] constexpr explicit operator bool() const noexcept { return error() == Error{}; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return word_ & 0xFFFFFFu; }
    [[nodiscard]] constexpr Error error() const noexcept { return static_cast<Error>(word_ >> 24); }

  private:
    std::uint32_t word_;
};

using result = basic_result<errc>;

} // namespace jauscat::wire
