// expect: layout: a count, tag or flag names a member of no enclosing structure
#include "small_message.hpp"

struct counted_by_stranger {
    jauscat::wire::list<std::uint8_t> number{};
};

template <> struct jauscat::wire::schema<counted_by_stranger> {
    using type =
        layout<repeated<&counted_by_stranger::number, counted_by<&small_message::number>, element<"number", u8>>>;
};

const auto size = jauscat::wire::encoded_size(counted_by_stranger{});
const auto result = jauscat::wire::encode(counted_by_stranger{}, {});
