// expect: object_dictionary: the source describes its objects in part: next_index(index), describe(index) and
// describe(index, subindex) go together, const and noexcept
#include <jauscat/ethercat/slave/object_dictionary.hpp>

using namespace jauscat::ethercat;

struct lamp {
    object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept { return {}; }
    abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept { return {}; }
    std::uint16_t next_index() const noexcept { return 0; }
    std::optional<object_info> describe(std::uint16_t) const noexcept { return std::nullopt; }
    std::optional<entry_info> describe(std::uint16_t, std::uint8_t) const noexcept { return std::nullopt; }
} one;
object_dictionary objects{one};
