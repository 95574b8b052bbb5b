// expect: object_dictionary: the source has no read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte>
// out) that returns an object_read
#include <jauscat/ethercat/slave/object_dictionary.hpp>

using namespace jauscat::ethercat;

struct lamp {
    object_read read(std::uint16_t, std::span<std::byte>) noexcept { return {}; }
    abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept { return {}; }
} one;
object_dictionary objects{one};
