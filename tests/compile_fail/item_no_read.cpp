// expect: view: the item of this member has no read<Member, reading>(const std::byte*, scope)
#include "small_message.hpp"

using jauscat::wire::errc;
using jauscat::wire::u8;

struct own {
    std::uint8_t value{};
};

struct own_item {
    using keys = jauscat::wire::key_list<&own::value>;
    static constexpr std::size_t min_size = 1, max_size = 1;
    static constexpr bool optional = false;
    static constexpr errc put(const auto& object, std::byte* out) { return u8::store(out, object.value); }
    static constexpr errc get(auto& object, const std::byte* in) { return u8::load(in, object.value); }
    static constexpr void visit(auto& object, auto&& visitor) { visitor(own_item{}, object.value); }
};

template <> struct jauscat::wire::schema<own> {
    using type = layout<own_item>;
};

constexpr std::array<std::byte, 1> bytes{};
static_assert(jauscat::wire::view<own>{bytes}.get<&own::value>() == 0);
