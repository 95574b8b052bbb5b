#include <jauscat/ethercat/slave/object_dictionary.hpp>

using namespace jauscat::ethercat;

struct good_source {
    object_read read(std::uint16_t, std::uint8_t, std::span<std::byte>) noexcept { return {}; }
    abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept { return {}; }
};

// A case hides what it has otherwise than `good_source`.
#ifdef GOOD
// expect: no error
good_source one;
struct described_lamp : good_source {
    std::uint16_t next_index(std::uint16_t) const noexcept { return 0; }
    std::optional<object_info> describe(std::uint16_t) const noexcept { return std::nullopt; }
    std::optional<entry_info> describe(std::uint16_t, std::uint8_t) const noexcept { return std::nullopt; }
} other;
static_assert(object_source<good_source> && !described_object_source<good_source>);
static_assert(described_object_source<described_lamp>);
object_dictionary described{other};
#endif

#ifdef DESCRIBED_IN_PART
// expect: object_dictionary: the source describes its objects in part: next_index(index), describe(index) and
// describe(index, subindex) go together, const and noexcept
struct lamp : good_source {
    std::optional<object_info> describe(std::uint16_t) const noexcept { return std::nullopt; }
} one;
#endif

#ifdef NEXT_INDEX_PARAMETERS
// expect: object_dictionary: the source describes its objects in part: next_index(index), describe(index) and
// describe(index, subindex) go together, const and noexcept
struct lamp : good_source {
    std::uint16_t next_index() const noexcept { return 0; }
    std::optional<object_info> describe(std::uint16_t) const noexcept { return std::nullopt; }
    std::optional<entry_info> describe(std::uint16_t, std::uint8_t) const noexcept { return std::nullopt; }
} one;
#endif

#ifdef READ_PARAMETERS
// expect: object_dictionary: the source has no read(std::uint16_t index, std::uint8_t subindex, std::span<std::byte>
// out) that returns an object_read
struct lamp : good_source {
    object_read read(std::uint16_t, std::span<std::byte>) noexcept { return {}; }
} one;
#endif

#ifdef THROWS
// expect: object_dictionary: read or write of the source is not noexcept
struct lamp : good_source {
    abort_code write(std::uint16_t, std::uint8_t, std::span<const std::byte>) { return {}; }
} one;
#endif

#ifdef WRITE_RESULT
// expect: object_dictionary: the source has no write(std::uint16_t index, std::uint8_t subindex, std::span<const
// std::byte> data) that returns an abort_code
struct lamp : good_source {
    bool write(std::uint16_t, std::uint8_t, std::span<const std::byte>) noexcept { return true; }
} one;
#endif

object_dictionary objects{one};
