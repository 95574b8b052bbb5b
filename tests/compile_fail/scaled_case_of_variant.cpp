// expect: selected: scaled cases need a plain member
#include "small_message.hpp"

struct scaled_variant {
    std::uint8_t tag{};
    std::variant<double, std::uint8_t> value{};
};

template <> struct jauscat::wire::schema<scaled_variant> {
    using T = scaled_variant;
    using type =
        layout<field<&T::tag, u8>, selected<&T::value, by<&T::tag>, when<0, scaled<u8, percent>>, when<1, u8>>>;
};

static_assert(size_of_wrong<scaled_variant> != 0);
