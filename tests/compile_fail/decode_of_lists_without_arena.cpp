// expect: decode: the message has lists; give an arena as the third argument
#include "small_message.hpp"

struct listing {
    jauscat::wire::list<std::uint8_t> number{};
};

template <> struct jauscat::wire::schema<listing> {
    using type = layout<repeated<&listing::number, count<"numbers", u8>, element<"number", u8>>>;
};

listing value{};
const auto result = jauscat::wire::decode(value, {});
