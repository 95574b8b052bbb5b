// expect: image_entries: a field of bits has 8 at most, BIT1 to BIT8; declare it as a number
#include <jauscat/ethercat/slave/image_entries.hpp>

#include <cstdint>

struct status {
    std::uint16_t count{};
    std::uint8_t mode{};
};

template <> struct jauscat::wire::schema<status> {
    using type = layout<bit_fields<u16le, bit_field<&status::count, 12>, bit_field<&status::mode, 4>>>;
};

static_assert(jauscat::ethercat::image_entries<status, 0x7000>.size() == 2);
