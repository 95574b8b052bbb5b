// expect: enumeration: the enumeration's underlying type must be the carrier's integer type
#include "small_message.hpp"

enum class mode : std::uint8_t { off, on };
struct with_mode {
    mode value{};
};

template <> struct jauscat::wire::schema<with_mode> {
    using type = layout<field<&with_mode::value, enumeration<mode, u16le>>>;
};

static_assert(size_of_wrong<with_mode> != 0);
