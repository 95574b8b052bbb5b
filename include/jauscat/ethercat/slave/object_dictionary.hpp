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

/// A type that can stand behind a slave.
/// - `read(index, subindex, out)`: the object's bytes to `out`; `abort_code::exceeds_mailbox` if they do not fit.
/// - `write(index, subindex, data)`: `abort_code::none` if the object took `data`.
template <class T>
concept object_source = requires(T& object, std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out,
                                 std::span<const std::byte> data) {
    { object.read(index, subindex, out) } noexcept -> std::same_as<object_read>;
    { object.write(index, subindex, data) } noexcept -> std::same_as<abort_code>;
};

/// An object source that can say what it has, for SDO information and complete access.
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

/// A reference to an object source, without its type. Made from a source that must outlive it.
class object_dictionary {
  public:
    /// `source` must outlive this object.
    template <object_source T>
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
