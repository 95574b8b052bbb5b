// expect: view: the message has no such member in its layout
#include "small_message.hpp"

struct stranger {
    std::uint16_t number{};
};

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);

constexpr std::array<std::byte, 4> bytes{};
constexpr auto number = jauscat::wire::view<small_message>{bytes}.get<&stranger::number>();
