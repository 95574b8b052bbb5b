#include "small_message.hpp"

using jauscat::wire::errc;
using jauscat::wire::in_cursor;
using jauscat::wire::out_cursor;
using jauscat::wire::u8;

struct own {
    std::uint8_t value{};
};

struct shared_part {
    using keys = jauscat::wire::key_list<&own::value>;
    static constexpr bool optional = false;
    static constexpr void visit(auto& object, auto&& visitor) { visitor(shared_part{}, object.value); }
};
struct fixed_size : shared_part {
    static constexpr std::size_t min_size = 1, max_size = 1;
};
struct fixed_put {
    static constexpr errc put(const auto& object, std::byte* out) { return u8::store(out, object.value); }
};
struct fixed_get {
    static constexpr errc get(auto& object, const std::byte* in) { return u8::load(in, object.value); }
};
struct fixed_read {
    template <auto, jauscat::wire::reading> static constexpr auto read(const std::byte* in, const auto&) {
        std::uint8_t value{};
        u8::load(in, value);
        return value;
    }
};
struct variable_item : shared_part {
    static constexpr std::size_t min_size = 0, max_size = 1;
    static constexpr out_cursor put(const auto&, out_cursor c, const auto&) { return c; }
    static constexpr in_cursor get(auto&, in_cursor c, const auto&) { return c; }
};
struct variable_size {
    static constexpr std::size_t size(const auto&, const auto&) { return 0; }
};
struct variable_measure {
    static constexpr in_cursor measure(in_cursor c, const auto&) { return c; }
};
struct variable_extent {
    static constexpr std::size_t extent(const std::byte*, const auto&) { return 0; }
};

#ifdef GOOD
// expect: no error
struct own_item : fixed_size, fixed_put, fixed_get, fixed_read {};
#endif

#ifdef NO_KEYS
// expect: layout: an item has no keys, the key_list of its members in wire order
struct own_item : fixed_put, fixed_get, fixed_read {
    static constexpr std::size_t min_size = 1, max_size = 1;
    static constexpr bool optional = false;
    static constexpr void visit(auto& object, auto&& visitor) { visitor(own_item{}, object.value); }
};
#endif

#ifdef NO_SIZES
// expect: layout: an item has no min_size and max_size, the bytes it takes
struct own_item : shared_part, fixed_put, fixed_get, fixed_read {};
#endif

#ifdef NO_OPTIONAL
// expect: layout: an item has no optional, which says whether its member is a std::optional
struct own_item : fixed_put, fixed_get, fixed_read {
    using keys = jauscat::wire::key_list<&own::value>;
    static constexpr std::size_t min_size = 1, max_size = 1;
    static constexpr void visit(auto& object, auto&& visitor) { visitor(own_item{}, object.value); }
};
#endif

#ifdef NO_VISIT
// expect: layout: an item has no visit(object, visitor)
struct own_item : fixed_put, fixed_get, fixed_read {
    using keys = jauscat::wire::key_list<&own::value>;
    static constexpr std::size_t min_size = 1, max_size = 1;
    static constexpr bool optional = false;
};
#endif

#ifdef NO_PUT
// expect: layout: a fixed item has no put(object, std::byte*) that returns errc
struct own_item : fixed_size, fixed_get, fixed_read {};
#endif

#ifdef GET_OF_ANOTHER_RESULT
// expect: layout: a fixed item has no get(object, const std::byte*) that returns errc
struct own_item : fixed_size, fixed_put, fixed_read {
    static constexpr bool get(auto& object, const std::byte* in) { return u8::load(in, object.value) == errc::ok; }
};
#endif

#ifdef NO_READ
// expect: view: the item of this member has no read<Member, reading>(const std::byte*, scope)
struct own_item : fixed_size, fixed_put, fixed_get {};
#endif

#ifdef NO_SIZE
// expect: layout: a variable item has no size(object, scope) that returns std::size_t
struct own_item : variable_item, variable_measure, variable_extent {};
#endif

#ifdef NO_MEASURE
// expect: layout: a variable item has no measure(in_cursor, scope) that returns in_cursor
struct own_item : variable_item, variable_size, variable_extent {};
#endif

#ifdef EXTENT_OF_ANOTHER_RESULT
// expect: layout: the extent(const std::byte*, scope) of a variable item does not return std::size_t
struct own_item : variable_item, variable_size, variable_measure {
    static constexpr int extent(const std::byte*, const auto&) { return 0; }
};
#endif

template <> struct jauscat::wire::schema<own> {
    using type = layout<own_item>;
};

constexpr bool comes_back() {
    std::array<std::byte, 1> out{};
    own found{};
    return jauscat::wire::encode(own{7}, out) && jauscat::wire::decode(found, out) && found.value == 7;
}
static_assert(comes_back());
constexpr std::array<std::byte, 1> bytes{};
static_assert(jauscat::wire::view<own>{bytes}.get<&own::value>() == 0);
