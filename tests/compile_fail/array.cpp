#include "small_message.hpp"

#ifdef OF_ANOTHER_TYPE
// expect: array: the elements are not of the type that their codec carries
// and: has_type<&heights::height, double,
struct heights {
    std::array<double, 4> height{};
};

template <> struct jauscat::wire::schema<heights> {
    using type = layout<array<&heights::height, u16le>>;
};

static_assert(size_of_wrong<heights> != 0);
#endif

#ifdef OF_LIST
// expect: array: the member must be a std::array
// and: is_array_member<&heights::height,
struct heights {
    jauscat::wire::inline_list<std::uint8_t, 4> height{};
};

template <> struct jauscat::wire::schema<heights> {
    using type = layout<array<&heights::height, u8>>;
};

static_assert(size_of_wrong<heights> != 0);
#endif

#ifdef OF_NO_ELEMENTS
// expect: array: the member has no elements
struct heights {
    std::array<std::uint8_t, 0> height{};
};

template <> struct jauscat::wire::schema<heights> {
    using type = layout<array<&heights::height, u8>>;
};

static_assert(size_of_wrong<heights> != 0);
#endif

#ifdef OF_RESTS
// expect: array: an element takes the rest of the body, so that none can follow it
struct label_text {
    std::string_view text{};
};
struct labels {
    std::array<label_text, 2> text{};
};

template <> struct jauscat::wire::schema<label_text> {
    using type = layout<string<&label_text::text, rest>>;
};
template <> struct jauscat::wire::schema<labels> {
    using type = layout<array<&labels::text>>;
};

static_assert(size_of_wrong<labels> != 0);
#endif

#ifdef WITHOUT_CODEC
// expect: array: the second argument is not a codec
struct heights {
    std::array<double, 4> height{};
};

template <> struct jauscat::wire::schema<heights> {
    using type = layout<array<&heights::height, percent>>;
};

static_assert(size_of_wrong<heights> != 0);
#endif
