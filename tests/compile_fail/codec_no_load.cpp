// expect: codec: it has no load(const std::byte*, value_type&) that returns errc
#include "small_message.hpp"

struct own {
    std::uint8_t value{};
};

struct half_codec {
    using value_type = std::uint8_t;
    static constexpr std::size_t size = 1;
    static constexpr auto store(std::byte* out, value_type value) { return jauscat::wire::u8::store(out, value); }
};

template <> struct jauscat::wire::schema<own> {
    using type = layout<field<&own::value, half_codec>>;
};

static_assert(size_of_wrong<own> != 0);
