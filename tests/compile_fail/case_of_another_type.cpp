// expect: selected: a case does not fit the member's type
#include "small_message.hpp"

struct text_or_number {
    std::uint8_t tag{};
    std::string_view value{};
};

template <> struct jauscat::wire::schema<text_or_number> {
    using T = text_or_number;
    using type = layout<field<&T::tag, u8>, selected<&T::value, by<&T::tag>, when<0, u8>>>;
};

static_assert(size_of_wrong<text_or_number> != 0);
