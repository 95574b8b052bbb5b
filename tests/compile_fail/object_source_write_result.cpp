// expect: object_dictionary: the source has no write(std::uint16_t index, std::uint8_t subindex, std::span<const
// std::byte> data) that returns an abort_code
#include <jauscat/ethercat/slave/object_dictionary.hpp>

using namespace jauscat::ethercat;

struct lamp {
    object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept { return {}; }
    bool write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept { return true; }
} one;
object_dictionary objects{one};
