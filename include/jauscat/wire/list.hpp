// Members that hold any number of things without a heap: lists inside the message, lists and bytes elsewhere.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <type_traits>

namespace jauscat::wire {

/// Elements that lie elsewhere: in an array of the caller's when encoding, in the arena given to decode. They must
/// outlive the message. Equal when the elements are.
template <class T> class list : public std::span<const T> {
  public:
    using std::span<const T>::span;
    /// Refers to elements that the caller keeps.
    constexpr list(std::span<const T> elements) noexcept : std::span<const T>{elements} {}

    friend constexpr bool operator==(const list& a, const list& b) noexcept {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }
};

/// Bytes that lie elsewhere: in a buffer of the caller's, or in the received bytes. Equal when the bytes are.
using blob = list<std::byte>;

/// Up to `Capacity` elements inside the message.
template <class T, std::size_t Capacity> class inline_list {
  public:
    using value_type = T;
    static constexpr std::size_t capacity = Capacity;

    constexpr inline_list() noexcept = default;
    /// More elements than the capacity do not compile in a constant; at run time those that do not fit are omitted.
    /// push_back returns whether its element fits.
    constexpr inline_list(std::initializer_list<T> elements) noexcept {
        for (const T& element : elements)
            if (!push_back(element)) return;
    }

    /// False, and nothing is added, when the list is full.
    [[nodiscard]] constexpr bool push_back(const T& element) noexcept {
        if (size_ == Capacity) return false;
        elements_[size_++] = element;
        return true;
    }
    /// Default elements are added, or the last ones dropped; false, and nothing changes, beyond the capacity.
    [[nodiscard]] constexpr bool resize(std::size_t size) noexcept {
        if (size > Capacity) return false;
        for (std::size_t i = size_; i < size; ++i) elements_[i] = T{};
        size_ = static_cast<size_type>(size);
        return true;
    }
    constexpr void clear() noexcept { size_ = 0; }

    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] constexpr T& operator[](std::size_t i) noexcept { return elements_[i]; }
    [[nodiscard]] constexpr const T& operator[](std::size_t i) const noexcept { return elements_[i]; }
    [[nodiscard]] constexpr T* begin() noexcept { return elements_.data(); }
    [[nodiscard]] constexpr const T* begin() const noexcept { return elements_.data(); }
    [[nodiscard]] constexpr T* end() noexcept { return elements_.data() + size_; }
    [[nodiscard]] constexpr const T* end() const noexcept { return elements_.data() + size_; }

    friend constexpr bool operator==(const inline_list& a, const inline_list& b) noexcept {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }

  private:
    using size_type = std::conditional_t<(Capacity < 256), std::uint8_t, std::uint32_t>;
    std::array<T, Capacity> elements_{};
    size_type size_{};
};

/// Properties of a member type that holds elements: `list`, `inline_list`, std::array.
template <class List> struct list_traits;
template <class T> struct list_traits<list<T>> {
    using value_type = T;
    template <class Other> using of = list<Other>; ///< the same with other elements
    static constexpr bool elsewhere = true;        ///< the elements are not in the message
    static constexpr bool counted = true;          ///< how many there are varies
};
template <class T, std::size_t Capacity> struct list_traits<inline_list<T, Capacity>> {
    using value_type = T;
    template <class Other> using of = inline_list<Other, Capacity>;
    static constexpr bool elsewhere = false;
    static constexpr bool counted = true;
    static constexpr std::size_t capacity = Capacity;
};
template <class T, std::size_t Size> struct list_traits<std::array<T, Size>> {
    using value_type = T;
    template <class Other> using of = std::array<Other, Size>;
    static constexpr bool elsewhere = false;
    static constexpr bool counted = false;
    static constexpr std::size_t capacity = Size;
};

} // namespace jauscat::wire
