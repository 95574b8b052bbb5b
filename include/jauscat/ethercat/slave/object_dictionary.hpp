// Type-erased reference to the objects of a slave's application. Does not allocate.
#pragma once

#include <jauscat/ethercat/slave/object_info.hpp>
#include <jauscat/schema/ethercat/coe.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// Result of reading an object: its size, or why not.
struct object_read {
    abort_code error{};
    std::size_t size{};
};

namespace detail {

template <class T>
concept reads_objects = requires(T& object, std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) {
    { object.read(index, subindex, out) } -> std::same_as<object_read>;
};
template <class T>
concept writes_objects =
    requires(T& object, std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) {
        { object.write(index, subindex, data) } -> std::same_as<abort_code>;
    };
template <class T>
concept is_noexcept_source = requires(T& object, std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out,
                                      std::span<const std::byte> data) {
    { object.read(index, subindex, out) } noexcept;
    { object.write(index, subindex, data) } noexcept;
};
// At least one operation of a described_object_source, perhaps with other parameters.
template <class T>
concept describes_something =
    requires { &T::next_index; } || requires { &T::describe; } || requires { &T::is_described; } ||
    requires(T& object, std::uint16_t index) { object.describe(index); } ||
    requires(T& object, std::uint16_t index, std::uint8_t subindex) { object.describe(index, subindex); };

} // namespace detail

/// The objects behind a slave. Both functions are noexcept.
/// - `read(index, subindex, out)`: the object's bytes to `out`; `abort_code::exceeds_mailbox` if they do not fit.
/// - `write(index, subindex, data)`: `abort_code::none` if the object took `data`.
template <class T>
concept object_source = detail::reads_objects<T> && detail::writes_objects<T> && detail::is_noexcept_source<T>;

/// An object source that can say what it has, for SDO information and complete access. All functions are const and
/// noexcept.
/// - `next_index(after)`: the lowest index above `after`, 0 if there is none.
/// - `describe(index)`, `describe(index, subindex)`: nothing if there is no such object or entry. Names outlive the
///   source.
/// - `is_described()`, optional: false where all this is the case for some objects only.
template <class T>
concept described_object_source =
    object_source<T> && requires(const T& object, std::uint16_t index, std::uint8_t subindex) {
        { object.next_index(index) } noexcept -> std::same_as<std::uint16_t>;
        { object.describe(index) } noexcept -> std::same_as<std::optional<object_info>>;
        { object.describe(index, subindex) } noexcept -> std::same_as<std::optional<entry_info>>;
    };

namespace detail {

// Does not compile for a source that lacks an operation, and says which.
template <class Source> consteval void require_object_source() noexcept {
    static_assert(reads_objects<Source>,
                  "object_dictionary: the source has no read(std::uint16_t index, std::uint8_t subindex,"
                  " std::span<std::byte> out) that returns an object_read");
    static_assert(writes_objects<Source>,
                  "object_dictionary: the source has no write(std::uint16_t index, std::uint8_t subindex,"
                  " std::span<const std::byte> data) that returns an abort_code");
    static_assert(!reads_objects<Source> || !writes_objects<Source> || is_noexcept_source<Source>,
                  "object_dictionary: read or write of the source is not noexcept");
    static_assert(!object_source<Source> || described_object_source<Source> || !describes_something<Source>,
                  "object_dictionary: the source describes its objects in part: next_index(index), describe(index) and"
                  " describe(index, subindex) go together, const and noexcept");
}

} // namespace detail

/// A reference to an object source, without its type. Made from an object_source that must outlive it.
class object_dictionary {
  public:
    /// `source` must outlive this object.
    template <class T>
    requires(!std::same_as<T, object_dictionary>) // a copy refers to the source, not to the copied reference
    constexpr object_dictionary(T& source) noexcept
        : source_{&source},
          read_{[](void* object, std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
              return static_cast<T*>(object)->read(index, subindex, out);
          }},
          write_{
              [](void* object, std::uint16_t index, std::uint8_t subindex, std::span<const std::byte> data) noexcept {
                  return static_cast<T*>(object)->write(index, subindex, data);
              }} {
        detail::require_object_source<T>();
        if constexpr (described_object_source<T>) {
            described_ = true;
            if constexpr (requires { source.is_described(); }) described_ = source.is_described();
            next_ = [](const void* object, std::uint16_t after) noexcept {
                return static_cast<const T*>(object)->next_index(after);
            };
            object_ = [](const void* object, std::uint16_t index) noexcept {
                return static_cast<const T*>(object)->describe(index);
            };
            entry_ = [](const void* object, std::uint16_t index, std::uint8_t subindex) noexcept {
                return static_cast<const T*>(object)->describe(index, subindex);
            };
        }
    }

    /// Puts the entry's data into `out`; their bytes, or the abort code for the master.
    [[nodiscard]] object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        return read_(source_, index, subindex, out);
    }
    /// Gives the entry data; `none`, or the abort code for the master.
    [[nodiscard]] abort_code write(std::uint16_t index, std::uint8_t subindex,
                                   std::span<const std::byte> data) noexcept {
        return write_(source_, index, subindex, data);
    }

    [[nodiscard]] constexpr bool is_described() const noexcept { return described_; }
    /// See described_object_source. A source that is none has nothing to say.
    [[nodiscard]] std::uint16_t next_index(std::uint16_t after) const noexcept {
        return next_ != nullptr ? next_(source_, after) : std::uint16_t{};
    }
    [[nodiscard]] std::optional<object_info> describe(std::uint16_t index) const noexcept {
        return object_ != nullptr ? object_(source_, index) : std::nullopt;
    }
    [[nodiscard]] std::optional<entry_info> describe(std::uint16_t index, std::uint8_t subindex) const noexcept {
        return entry_ != nullptr ? entry_(source_, index, subindex) : std::nullopt;
    }

  private:
    void* source_;
    object_read (*read_)(void*, std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept;
    abort_code (*write_)(void*, std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept;
    bool described_{};
    std::uint16_t (*next_)(const void*, std::uint16_t) noexcept {};
    std::optional<object_info> (*object_)(const void*, std::uint16_t) noexcept {};
    std::optional<entry_info> (*entry_)(const void*, std::uint16_t, std::uint8_t) noexcept {};
};

} // namespace jauscat::ethercat
