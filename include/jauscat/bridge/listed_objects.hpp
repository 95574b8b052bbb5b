// Object dictionary of a slave, generated from object lists: objects, sizes, access rights. The application handles
// reads and writes.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/bridge/object_list.hpp>
#include <jauscat/ethercat/slave/object_dictionary.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::bridging {

/// Which sizes an object takes and gives.
enum class size_rule : std::uint8_t {
    up_to_largest, ///< any up to the largest, unless its table has fixed_length
    exact,         ///< the largest only: a strict slave, which needs a table with fixed_length
};

/// The objects of a list, in front of an application that holds what is in them. Models described_object_source: an
/// access that the list does not allow is aborted, all others reach the application. Subindex 0 is the highest
/// subindex, read only.
class listed_objects {
  public:
    /// `objects` and what `application` refers to must outlive this. The application sees indices and subindices of the
    /// list only, other than 0, with data of the sizes that `sizes` allows.
    constexpr listed_objects(std::span<const object_description> objects, ethercat::object_dictionary application,
                             size_rule sizes = size_rule::up_to_largest) noexcept
        : objects_{objects}, application_{application}, sizes_{sizes} {}

    /// Aborts: no_object, no_subindex, write_only, length_mismatch, those of the application.
    JAUSCAT_FUNCTION ethercat::object_read read(std::uint16_t index, std::uint8_t subindex,
                                                std::span<std::byte> out) noexcept;

    /// Aborts: no_object, no_subindex, read_only, length_mismatch (exact sizes), length_too_high, those of the
    /// application.
    [[nodiscard]] JAUSCAT_FUNCTION ethercat::abort_code write(std::uint16_t index, std::uint8_t subindex,
                                                              std::span<const std::byte> data) noexcept;

    [[nodiscard]] JAUSCAT_FUNCTION std::uint16_t next_index(std::uint16_t after) const noexcept;
    /// A record of octet strings.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<ethercat::object_info> describe(std::uint16_t index) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<ethercat::entry_info> describe(std::uint16_t index,
                                                                                std::uint8_t subindex) const noexcept;

  private:
    [[nodiscard]] JAUSCAT_FUNCTION const object_description* find(std::uint16_t index) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION bool is_exact(const object_description& object) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION bool allows(const object_description& object, const sub_object& entry,
                                               std::size_t size) const noexcept;

    std::span<const object_description> objects_;
    ethercat::object_dictionary application_;
    size_rule sizes_;
};

} // namespace jauscat::bridging

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/bridge/impl/listed_objects.ipp>
#endif
