// expect: object_dictionary: read or write of the source is not noexcept
#include <jauscat/ethercat/slave/object_dictionary.hpp>

using namespace jauscat::ethercat;

struct lamp {
    object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept { return {}; }
    abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) { return {}; }
} one;
object_dictionary objects{one};
