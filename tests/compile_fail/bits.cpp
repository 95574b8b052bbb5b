#include "small_message.hpp"

#ifdef DO_NOT_FILL
// expect: bit_fields: the widths must fill the carrier exactly
template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type = layout<bit_fields<u32le, bit_field<&T::number, 16>, reserved<15>>,
                        field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef OF_REAL_MEMBER
// expect: bit_field: the member must be bool, an integer or an enumeration
// and: has_bits<&with_fraction::offset, float>
struct with_fraction {
    float offset{};
};

template <> struct jauscat::wire::schema<with_fraction> {
    using type = layout<bit_fields<u8, bit_field<&with_fraction::offset, 8>>>;
};

static_assert(size_of_wrong<with_fraction> != 0);
#endif

#ifdef OVERFLOW
// expect: bit_fields: the widths must fill the carrier exactly
template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type = layout<bit_fields<u16le, bit_field<&T::number, 16>, reserved<1>>,
                        field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef WIDER_THAN_MEMBER
// expect: bit_field: the member is narrower than its bits
// and: holds_bits<&small_message::number,
template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type = layout<bit_fields<u32le, bit_field<&T::number, 17>, reserved<15>>,
                        field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef FLAG_NOT_BOOL
// expect: presence_flag: the member must be a bool
// and: has_type<&numeric_flag::present, unsigned char, bool>
struct numeric_flag {
    std::uint8_t present{};
};

template <> struct jauscat::wire::schema<numeric_flag> {
    using type = layout<presence<u8, presence_flag<&numeric_flag::present>>>;
};

static_assert(size_of_wrong<numeric_flag> != 0);
#endif

#ifdef FLAGS_OF_ANOTHER_SIZE
// expect: bit_set_codec: the enumeration's underlying type must be the carrier's integer type
enum class lamp : std::uint8_t { left };
struct lamps {
    jauscat::wire::bit_set<lamp> lit{};
};

template <> struct jauscat::wire::schema<lamps> {
    using type = layout<field<&lamps::lit, bit_set_codec<lamp, u16le>>>;
};

static_assert(size_of_wrong<lamps> != 0);
#endif

#ifdef FLAGS_OF_SIGNED_ENUMERATION
// expect: bit_set: the enumeration's underlying type must be unsigned
enum class direction : std::int8_t { left };

jauscat::wire::bit_set<direction> set{};
#endif
