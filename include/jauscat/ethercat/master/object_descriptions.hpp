// What SDO information says about a slave's objects, decoded from the caller's buffer.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/master/master_errc.hpp>
#include <jauscat/schema/ethercat/sdo_information.hpp>
#include <jauscat/wire/decode.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>

namespace jauscat::ethercat {

/// Indices of objects: a range over the bytes in which the slave has sent them.
class object_indices {
  public:
    static constexpr std::size_t index_size = wire::max_size<object_query>;

    class iterator {
      public:
        using value_type = std::uint16_t;
        using difference_type = std::ptrdiff_t;

        constexpr iterator() noexcept = default;
        constexpr explicit iterator(const std::byte* at) noexcept : at_{at} {}

        [[nodiscard]] constexpr std::uint16_t operator*() const noexcept {
            object_query query{};
            static_cast<void>(wire::decode(query, std::span{at_, index_size}));
            return query.index;
        }
        constexpr iterator& operator++() noexcept {
            at_ += index_size;
            return *this;
        }
        constexpr iterator operator++(int) noexcept {
            const auto before = *this;
            ++*this;
            return before;
        }
        friend constexpr bool operator==(const iterator&, const iterator&) noexcept = default;

      private:
        const std::byte* at_{};
    };

    constexpr object_indices() noexcept = default;
    /// An odd byte at the end is left out.
    constexpr explicit object_indices(std::span<const std::byte> bytes) noexcept
        : bytes_{bytes.first(bytes.size() / index_size * index_size)} {}

    [[nodiscard]] constexpr iterator begin() const noexcept { return iterator{bytes_.data()}; }
    [[nodiscard]] constexpr iterator end() const noexcept { return iterator{bytes_.data() + bytes_.size()}; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return bytes_.size() / index_size; }
    [[nodiscard]] constexpr bool empty() const noexcept { return bytes_.empty(); }
    [[nodiscard]] constexpr std::uint16_t operator[](std::size_t i) const noexcept {
        return *iterator{bytes_.data() + i * index_size};
    }
    /// As the slave has sent them: 2 bytes each, little-endian.
    [[nodiscard]] constexpr std::span<const std::byte> bytes() const noexcept { return bytes_; }

  private:
    std::span<const std::byte> bytes_{};
};

/// Description of an object. `name` and `bytes` refer to the caller's buffer.
struct object_description {
    object_answer object{};
    std::string_view name{};
    std::span<const std::byte> bytes{}; ///< the whole answer, as the slave has sent it
};

/// Description of an entry. The values, `name` and `bytes` refer to the caller's buffer; a value that the slave has not
/// sent is empty.
struct entry_description {
    entry_answer entry{};
    std::optional<std::uint32_t> unit{}; ///< unit type, as in ETG.1004
    std::span<const std::byte> default_value{};
    std::span<const std::byte> minimum{};
    std::span<const std::byte> maximum{};
    std::string_view name{};
    std::span<const std::byte> bytes{}; ///< the whole answer, as the slave has sent it
};

namespace detail {

[[nodiscard]] JAUSCAT_FUNCTION std::string_view name_in(std::span<const std::byte> bytes) noexcept;

} // namespace detail

/// Decodes the answer about an object. Error: unexpected_reply, where it is too short.
[[nodiscard]] JAUSCAT_FUNCTION master_result<object_description>
decode_object_description(std::span<const std::byte> bytes) noexcept;

/// Decodes the answer about an entry. Error: unexpected_reply, where it is too short. Values that do not fit are left
/// out.
[[nodiscard]] JAUSCAT_FUNCTION master_result<entry_description>
decode_entry_description(std::span<const std::byte> bytes) noexcept;

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/object_descriptions.ipp>
#endif
