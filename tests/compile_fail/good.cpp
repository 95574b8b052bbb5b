// expect: no error
#include "small_message.hpp"

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
static_assert(jauscat::wire::max_size<small_message> == 5);
constexpr std::array<std::byte, 4> bytes{};
static_assert(jauscat::wire::view<small_message>{bytes}.get<&small_message::number>() == 0);
