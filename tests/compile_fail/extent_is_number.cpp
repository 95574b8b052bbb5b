// expect: string: the extent is neither fixed, fixed_or_rest, rest and zero_terminated nor a count
#include "small_message.hpp"

struct own {
    std::string_view name{};
};

template <> struct jauscat::wire::schema<own> {
    using type = layout<string<&own::name, u8>>;
};

static_assert(size_of_wrong<own> != 0);
