// expect: image_entries: EtherCAT has no data type for a signed field of bits; declare it as a number
#include <jauscat/ethercat/slave/image_entries.hpp>

#include <cstdint>

struct trim {
    std::int8_t pitch{};
    std::uint8_t mode{};
};

template <> struct jauscat::wire::schema<trim> {
    using type = layout<bit_fields<u8, bit_field<&trim::pitch, 4>, bit_field<&trim::mode, 4>>>;
};

static_assert(jauscat::ethercat::image_entries<trim, 0x7000>.size() == 2);
