// expect: bit_fields: a part has no fits(object) that returns bool
#include "small_message.hpp"

struct own {
    std::uint8_t value{};
};

struct own_part {
    using keys = jauscat::wire::key_list<&own::value>;
    static constexpr std::size_t width = 8;
    static constexpr std::uint64_t value(const auto& object) { return object.value; }
    static constexpr void assign(auto& object, std::uint64_t bits) { object.value = static_cast<std::uint8_t>(bits); }
    static constexpr void visit(auto& object, auto&& visitor) { visitor(own_part{}, object.value); }
};

template <> struct jauscat::wire::schema<own> {
    using type = layout<bit_fields<u8, own_part>>;
};

static_assert(size_of_wrong<own> != 0);
