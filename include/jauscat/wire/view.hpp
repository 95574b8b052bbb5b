// One field out of received bytes, without decoding the rest; and an iterator over lists in them.
#pragma once
#include <jauscat/wire/repeated.hpp>
#include <jauscat/wire/tree.hpp>

#include <iterator>
#include <span>

namespace jauscat::wire {

/// Reads the bytes of a `T`, which must outlive it. Construction checks that the structure is complete, so that reading
/// cannot leave the bytes; it does not look at values.
///
///     wire::view<set_wrench_effort> message{body};
///     if (!message) return message.error();
///     if (auto effort = message.get<&set_wrench_effort::propulsive_linear_effort_x>()) use(*effort);
///
/// `Outer` is the scope around a structure that looks beyond its own bytes: a detail of views out of lists.
template <class T, class Outer = plain_root> class view {
    static_assert(message<T>, "the type has no schema: give it a struct schema with its layout as type, or specialise "
                              "jauscat::wire::schema for it");

  public:
    /// Checks the bytes, once; they must outlive the view.
    constexpr explicit view(std::span<const std::byte> bytes) noexcept : bytes_{bytes}, error_{check(bytes)} {}

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return error_ == errc::ok; }
    /// truncated, trailing_bytes, unknown_presence_bit, unknown_tag or too_deep; the view must not be read then.
    [[nodiscard]] constexpr errc error() const noexcept { return error_; }
    /// The bytes it was made of.
    [[nodiscard]] constexpr std::span<const std::byte> bytes() const noexcept { return bytes_; }

    /// The member's value. A std::optional where the field may be absent or is scaled: empty when it is absent, or when
    /// its raw value is not legal. A nested message gives a view of it, a list or an array of records a list_view, an
    /// array of values a std::array; text and bytes point into the message.
    template <auto Member> [[nodiscard]] constexpr auto get() const noexcept { return read<Member, reading::real>(); }
    /// The integer on the wire. A std::optional where the field may be absent.
    template <auto Member> [[nodiscard]] constexpr auto get_raw() const noexcept {
        return read<Member, reading::raw>();
    }

    /// A view of bytes that are known to be complete: for the codec itself.
    [[nodiscard]] static constexpr view of_measured(std::span<const std::byte> bytes,
                                                    const Outer& outer = {}) noexcept {
        return view{bytes, outer};
    }

  private:
    constexpr view(std::span<const std::byte> bytes, const Outer& outer) noexcept
        : bytes_{bytes}, error_{errc::ok}, outer_{outer} {}

    template <auto Member, reading Mode> [[nodiscard]] JAUSCAT_FLATTEN constexpr auto read() const noexcept {
        return layout_of<T>::template read<Member, Mode>(bytes_.data(), inside(bytes_));
    }
    [[nodiscard]] constexpr auto inside(std::span<const std::byte> bytes) const noexcept {
        return byte_scope<T, Outer>{bytes.data(), bytes.data() + bytes.size(), outer_};
    }
    JAUSCAT_FLATTEN constexpr errc check(std::span<const std::byte> bytes) const noexcept {
        if (bytes.size() < min_size<T>) return errc::truncated;
        const in_cursor end = layout_of<T>::measure({bytes.data(), bytes.size() - min_size<T>}, inside(bytes));
        if (end.at == nullptr) return end.error();
        return end.at == bytes.data() + bytes.size() ? errc::ok : errc::trailing_bytes;
    }

    std::span<const std::byte> bytes_;
    errc error_;
    [[no_unique_address]] Outer outer_{};
};

namespace detail {

template <class Item> inline constexpr bool lists_records = !requires { typename Item::element_type::codec_type; };

/// Bytes of the element at `at`.
template <class Item, class Outer>
[[nodiscard]] JAUSCAT_FLATTEN constexpr std::size_t element_extent(const std::byte* at, const Outer& outer) noexcept {
    if constexpr (lists_records<Item>) {
        using record_type = typename Item::value_type;
        return layout_of<record_type>::extent(at, byte_scope<record_type, Outer>{at, outer.end, outer});
    } else {
        return Item::element_type::codec_type::size;
    }
}
template <class Item, class Outer>
[[nodiscard]] JAUSCAT_FLATTEN constexpr auto element_at(const std::byte* at, const Outer& outer) noexcept {
    if constexpr (lists_records<Item>) {
        return view<typename Item::value_type, Outer>::of_measured({at, element_extent<Item>(at, outer)}, outer);
    } else {
        using codec = typename Item::element_type::codec_type;
        typename codec::value_type value{};
        [[maybe_unused]] const errc error = codec::load(at, value);
        if constexpr (requires { typename codec::raw_codec; })
            return error == errc::ok ? std::optional{value} : std::nullopt;
        else
            return value;
    }
}

} // namespace detail

/// The elements of a list or an array in received bytes: single values (real ones; a std::optional where scaled), or
/// views of records. A forward range; where all elements take the same number of bytes also by index.
template <class Item, class Outer> class list_view {
  public:
    /// Made by a view.
    constexpr list_view(const std::byte* first, std::size_t size, const Outer& outer) noexcept
        : first_{first}, size_{size}, outer_{outer} {}

    class iterator {
      public:
        using value_type = decltype(detail::element_at<Item>(nullptr, std::declval<const Outer&>()));
        using difference_type = std::ptrdiff_t;
        using iterator_concept = std::forward_iterator_tag;

        /// Made by a list_view.
        constexpr iterator() noexcept = default;
        /// Made by a list_view.
        constexpr iterator(const std::byte* at, std::size_t left, const Outer& outer) noexcept
            : at_{at}, left_{left}, outer_{outer} {}

        [[nodiscard]] constexpr value_type operator*() const noexcept { return detail::element_at<Item>(at_, outer_); }
        constexpr iterator& operator++() noexcept {
            at_ += detail::element_extent<Item>(at_, outer_);
            --left_;
            return *this;
        }
        constexpr iterator operator++(int) noexcept {
            iterator before = *this;
            ++*this;
            return before;
        }
        friend constexpr bool operator==(const iterator& a, const iterator& b) noexcept { return a.left_ == b.left_; }

      private:
        const std::byte* at_{};
        std::size_t left_{};
        Outer outer_{};
    };

    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
    /// Element `index`, which is below size().
    [[nodiscard]] constexpr auto operator[](std::size_t index) const noexcept
    requires requires { requires Item::plain_form::fixed; } // a tree has no such form
    {
        return detail::element_at<Item>(first_ + index * Item::plain_form::max_size, outer_);
    }
    [[nodiscard]] constexpr iterator begin() const noexcept { return {first_, size_, outer_}; }
    [[nodiscard]] constexpr iterator end() const noexcept { return {nullptr, 0, outer_}; }

  private:
    const std::byte* first_;
    std::size_t size_;
    Outer outer_;
};

} // namespace jauscat::wire
