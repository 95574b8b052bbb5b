// expect: repeated: an element may take no bytes at all, so it needs a count of one byte
#include "small_message.hpp"

struct nothing {};
struct many_of_nothing {
    jauscat::wire::list<nothing> element{};
};

template <> struct jauscat::wire::schema<nothing> {
    using type = layout<>;
};
template <> struct jauscat::wire::schema<many_of_nothing> {
    using type = layout<repeated<&many_of_nothing::element, count<"elements", u16le>>>;
};

static_assert(size_of_wrong<many_of_nothing> != 0);
