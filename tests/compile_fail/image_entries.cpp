#include <jauscat/ethercat/slave/image_entries.hpp>

#include <cstdint>

#ifdef SIGNED_BITS
// expect: image_entries: EtherCAT has no data type for a signed field of bits; declare it as a number
struct trim {
    std::int8_t pitch{};
    std::uint8_t mode{};
};

template <> struct jauscat::wire::schema<trim> {
    using type = layout<bit_fields<u8, bit_field<&trim::pitch, 4>, bit_field<&trim::mode, 4>>>;
};

static_assert(jauscat::ethercat::image_entries<trim, 0x7000>.size() == 2);
#endif

#ifdef WIDE_BITS
// expect: image_entries: a field of bits has 8 at most, BIT1 to BIT8; declare it as a number
struct status {
    std::uint16_t count{};
    std::uint8_t mode{};
};

template <> struct jauscat::wire::schema<status> {
    using type = layout<bit_fields<u16le, bit_field<&status::count, 12>, bit_field<&status::mode, 4>>>;
};

static_assert(jauscat::ethercat::image_entries<status, 0x7000>.size() == 2);
#endif
