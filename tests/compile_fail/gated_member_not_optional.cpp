// expect: gated_by: the member must be a std::optional
#include "small_message.hpp"

struct always_present {
    bool present{};
    std::uint8_t number{};
};

template <> struct jauscat::wire::schema<always_present> {
    using T = always_present;
    using type = layout<presence<u8, presence_flag<&T::present>, gated_by<&T::present, field<&T::number, u8>>>>;
};

static_assert(size_of_wrong<always_present> != 0);
