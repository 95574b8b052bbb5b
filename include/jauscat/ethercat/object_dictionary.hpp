// What a slave's application puts behind CoE: two functions and their context, nothing allocated.
#pragma once

#include <jauscat/schema/ethercat/coe.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
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
    { object.read(index, subindex, out) }
    noexcept->std::same_as<object_read>;
    { object.write(index, subindex, data) }
    noexcept->std::same_as<abort_code>;
};

/// A reference to an object source, without its type. Made from a source that must outlive it.
class object_dictionary {
  public:
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
              }} {}

    [[nodiscard]] object_read read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte> out) noexcept {
        return read_(source_, index, subindex, out);
    }
    [[nodiscard]] abort_code write(std::uint16_t index, std::uint8_t subindex,
                                   std::span<const std::byte> data) noexcept {
        return write_(source_, index, subindex, data);
    }

  private:
    void* source_;
    object_read (*read_)(void*, std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept;
    abort_code (*write_)(void*, std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept;
};

} // namespace jauscat::ethercat
