// expect: no error
#include <jauscat/ethercat/slave/object_dictionary.hpp>

using namespace jauscat::ethercat;

struct lamp {
    object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept { return {}; }
    abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept { return {}; }
} one;
struct described_lamp : lamp {
    std::uint16_t next_index(std::uint16_t) const noexcept { return 0; }
    std::optional<object_info> describe(std::uint16_t) const noexcept { return std::nullopt; }
    std::optional<entry_info> describe(std::uint16_t, std::uint8_t) const noexcept { return std::nullopt; }
} other;
static_assert(object_source<lamp> && !described_object_source<lamp> && described_object_source<described_lamp>);
object_dictionary described{other};
object_dictionary objects{one};
