// A message inside a message: encoded in place, decoded without a copy.
#pragma once
#include <jauscat/wire/count.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>
#include <jauscat/wire/list.hpp>

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace jauscat::wire {

/// A message that lies elsewhere: a message of the caller's, which is encoded with the one around it, or bytes, as
/// decoding leaves it. Either must outlive the message around it.
class embedded_message {
  public:
    /// No bytes.
    constexpr embedded_message() noexcept = default;
    /// Bytes of an encoded message, which the caller keeps.
    constexpr explicit embedded_message(std::span<const std::byte> bytes) noexcept : bytes_{bytes} {}
    /// A message that the caller keeps. Its type need not be known where it is encoded.
    template <message T> [[nodiscard]] static embedded_message of(const T& inner) noexcept {
        embedded_message made;
        made.object_ = &inner;
        made.type_ = &type_of<T>;
        return made;
    }
    template <message T> static embedded_message of(const T&&) = delete;

    /// The bytes; none where it refers to a message that is still to be encoded.
    [[nodiscard]] constexpr blob bytes() const noexcept { return bytes_; }
    /// Whether it refers to a message that is still to be encoded.
    [[nodiscard]] constexpr bool is_to_encode() const noexcept { return type_ != nullptr; }
    /// Encoded size in bytes.
    [[nodiscard]] constexpr std::size_t size() const noexcept {
        return type_ == nullptr ? bytes_.size() : type_->size(object_);
    }
    /// Decodes the bytes as a `T`; text and further embedded messages point into them.
    template <message T> [[nodiscard]] constexpr result<std::size_t, errc> decode(T& inner) const noexcept {
        return wire::decode(inner, bytes_);
    }
    /// The same for a message with lists.
    template <message T>
    [[nodiscard]] constexpr result<std::size_t, errc> decode(T& inner, arena& memory) const noexcept {
        return wire::decode(inner, bytes_, memory);
    }
    /// Writes the message to `out`, which has room for it.
    constexpr out_cursor put(std::byte* out) const noexcept {
        if (type_ != nullptr) return type_->put(object_, out);
        if (std::is_constant_evaluated())
            std::copy(bytes_.begin(), bytes_.end(), out);
        else if (!bytes_.empty())
            std::memcpy(out, bytes_.data(), bytes_.size());
        return {out + bytes_.size(), errc::ok};
    }
    /// See wire::check_values. Bytes have no value sets.
    [[nodiscard]] constexpr errc check_values() const noexcept {
        return type_ == nullptr ? errc::ok : type_->check_values(object_);
    }

    /// The same bytes, or the same message of the caller's.
    friend constexpr bool operator==(const embedded_message& a, const embedded_message& b) noexcept {
        return a.type_ == b.type_ && a.object_ == b.object_ && a.bytes_ == b.bytes_;
    }

  private:
    struct functions {
        std::size_t (*size)(const void* object) noexcept;
        out_cursor (*put)(const void* object, std::byte* out) noexcept;
        errc (*check_values)(const void* object) noexcept;
    };
    template <class T> static std::size_t size_of(const void* object) noexcept {
        return encoded_size(*static_cast<const T*>(object));
    }
    template <class T> static out_cursor put_of(const void* object, std::byte* out) noexcept {
        return detail::put_message(*static_cast<const T*>(object), out);
    }
    template <class T> static errc values_of(const void* object) noexcept {
        return wire::check_values(*static_cast<const T*>(object));
    }
    template <class T> static constexpr functions type_of{&size_of<T>, &put_of<T>, &values_of<T>};

    blob bytes_{};
    const void* object_{};
    const functions* type_{};
};

namespace detail {
template <auto Member, class Is> inline constexpr bool is_embedded_member = std::is_same_v<Is, embedded_message>;
} // namespace detail

/// The member, an embedded_message, after its size in bytes or with its size elsewhere (`count`, `counted_by`). Its
/// bytes are not decoded with the message around it.
template <auto Member, class Count> struct embedded {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using value_type = member_value_t<Member>;
    using raw_type = member_t<Member>;
    using count_type = Count;
    using refers = references_of<Count>;
    static_assert(detail::is_embedded_member<Member, value_type>, "embedded: the member must be an embedded_message");
    static_assert(detail::checked_count<Count, owner_t<Member>>,
                  "embedded: the second argument is not a count (it needs prefix_size, contextual, put, get and peek)");
    static constexpr bool optional = is_optional_member<Member>;
    static constexpr bool contextual = Count::contextual;
    static constexpr bool checks_values = true;
    static constexpr std::size_t min_size = Count::prefix_size, max_size = unbounded;

    static consteval std::string_view name() { return name_of<Member>(); }

    JAUSCAT_INLINE static constexpr std::size_t size(const auto& object, const auto&) noexcept {
        return Count::prefix_size + value_of<Member>(object).size();
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto& here) noexcept {
        const auto& inner = value_of<Member>(object);
        c = Count::put(inner.size(), c, here);
        return c.error == errc::ok ? inner.put(c.at) : c;
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto& here) noexcept {
        std::size_t size{};
        if (!Count::get(size, c, here)) return c;
        if (!detail::spend(c, size)) return c;
        emplace_in<Member>(object) = embedded_message{std::span{c.at, size}};
        c.at += size;
        return c;
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto& here) noexcept {
        const std::size_t size = Count::peek(c.at, here);
        if (!detail::spend(c, size)) return c;
        c.at += Count::prefix_size + size;
        return c;
    }
    JAUSCAT_INLINE static constexpr std::size_t extent(const std::byte* in, const auto& here) noexcept {
        return Count::prefix_size + Count::peek(in, here);
    }
    template <auto, reading> JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        return embedded_message{std::span{in + Count::prefix_size, Count::peek(in, here)}};
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(embedded{}, member_of<Member>(object));
    }
};

} // namespace jauscat::wire
