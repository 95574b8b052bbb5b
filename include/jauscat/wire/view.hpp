// One field out of received bytes, without decoding the rest.
#pragma once
#include <jauscat/wire/layout.hpp>

#include <span>

namespace jauscat::wire {

/// Looks at the bytes of a `T`, which must outlive it. Construction checks that the structure is complete, so that
/// reading cannot leave the bytes; it does not look at values.
///
///     wire::view<set_wrench_effort> message{body};
///     if (!message) return message.error();
///     if (auto effort = message.get<&set_wrench_effort::propulsive_linear_effort_x>()) use(*effort);
template <message T> class view {
  public:
    constexpr explicit view(std::span<const std::byte> bytes) noexcept : bytes_{bytes}, error_{check(bytes)} {}

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return error_ == errc::ok; }
    /// truncated, trailing_bytes or unknown_presence_bit; the view must not be read then.
    [[nodiscard]] constexpr errc error() const noexcept { return error_; }
    [[nodiscard]] constexpr std::span<const std::byte> bytes() const noexcept { return bytes_; }

    /// The member's value. A std::optional where the field may be absent or is scaled: empty when it is absent, or when
    /// its raw value is not legal. A nested message gives a view of it.
    template <auto Member> [[nodiscard]] constexpr auto get() const noexcept {
        return layout_of<T>::template read<Member, reading::real>(bytes_.data());
    }
    /// The integer on the wire. A std::optional where the field may be absent.
    template <auto Member> [[nodiscard]] constexpr auto get_raw() const noexcept {
        return layout_of<T>::template read<Member, reading::raw>(bytes_.data());
    }

    /// A view of bytes that are known to be complete: for the codec itself.
    [[nodiscard]] static constexpr view of_measured(std::span<const std::byte> bytes) noexcept {
        return view{bytes, errc::ok};
    }

  private:
    constexpr view(std::span<const std::byte> bytes, errc error) noexcept : bytes_{bytes}, error_{error} {}

    static constexpr errc check(std::span<const std::byte> bytes) noexcept {
        if (bytes.size() < min_size<T>) return errc::truncated;
        const in_cursor end = layout_of<T>::measure({bytes.data(), bytes.size() - min_size<T>});
        if (end.at == nullptr) return end.error();
        return end.at == bytes.data() + bytes.size() ? errc::ok : errc::trailing_bytes;
    }

    std::span<const std::byte> bytes_;
    errc error_;
};

} // namespace jauscat::wire
