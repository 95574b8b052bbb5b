// expect: repeated: the third argument is neither record nor an element (it needs codec_type and name)
#include "small_message.hpp"

struct own {
    jauscat::wire::list<std::uint8_t> value{};
};

template <> struct jauscat::wire::schema<own> {
    using type = layout<repeated<&own::value, count<"values", u8>, u8>>;
};

static_assert(size_of_wrong<own> != 0);
