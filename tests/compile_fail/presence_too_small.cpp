// expect: presence: more optional fields than bits in the presence vector
#include "small_message.hpp"

struct crowded {
    std::optional<std::uint8_t> a{}, b{}, c{}, d{}, e{}, f{}, g{}, h{}, i{};
};

template <> struct jauscat::wire::schema<crowded> {
    using T = crowded;
    using type =
        layout<presence<u8, field<&T::a, u8>, field<&T::b, u8>, field<&T::c, u8>, field<&T::d, u8>, field<&T::e, u8>,
                        field<&T::f, u8>, field<&T::g, u8>, field<&T::h, u8>, field<&T::i, u8>>>;
};

static_assert(size_of_wrong<crowded> != 0);
