// expect: array: an element takes the rest of the body, so that none can follow it
#include "small_message.hpp"

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
