#include "small_message.hpp"

#ifdef CAPACITY_ABOVE_COUNT
// expect: repeated: the list's capacity exceeds what its count can say
struct long_list {
    jauscat::wire::inline_list<std::uint8_t, 256> number{};
};

template <> struct jauscat::wire::schema<long_list> {
    using type = layout<repeated<&long_list::number, count<"numbers", u8>, element<"number", u8>>>;
};

static_assert(size_of_wrong<long_list> != 0);
#endif

#ifdef NO_PEEK
// expect: count: it has no peek(const std::byte*, scope) that returns std::size_t
struct own {
    jauscat::wire::list<std::uint8_t> value{};
};

struct pairs {
    static constexpr std::size_t prefix_size = 0;
    static constexpr bool contextual = false;
    static constexpr auto put(std::size_t, jauscat::wire::out_cursor c, const auto&) { return c; }
    static constexpr bool get(std::size_t& elements, jauscat::wire::in_cursor&, const auto&) {
        elements = 2;
        return true;
    }
};

template <> struct jauscat::wire::schema<own> {
    using type = layout<repeated<&own::value, pairs, element<"value", u8>>>;
};

static_assert(size_of_wrong<own> != 0);
#endif

#ifdef OF_FLOATING_POINT
// expect: count: the carrier must be an unsigned integer
struct counted_by_float {
    jauscat::wire::list<std::uint8_t> number{};
};

template <> struct jauscat::wire::schema<counted_by_float> {
    using type = layout<repeated<&counted_by_float::number, count<"numbers", f32le>, element<"number", u8>>>;
};

static_assert(size_of_wrong<counted_by_float> != 0);
#endif

#ifdef OF_NO_ENCLOSING_STRUCTURE
// expect: layout: a count, tag or flag names a member of no enclosing structure
struct counted_by_stranger {
    jauscat::wire::list<std::uint8_t> number{};
};

template <> struct jauscat::wire::schema<counted_by_stranger> {
    using type =
        layout<repeated<&counted_by_stranger::number, counted_by<&small_message::number>, element<"number", u8>>>;
};

const auto size = jauscat::wire::encoded_size(counted_by_stranger{});
const auto result = jauscat::wire::encode(counted_by_stranger{}, {});
#endif

#ifdef ELEMENT_IS_CODEC
// expect: repeated: the third argument is neither record nor an element (it needs codec_type and name)
struct own {
    jauscat::wire::list<std::uint8_t> value{};
};

template <> struct jauscat::wire::schema<own> {
    using type = layout<repeated<&own::value, count<"values", u8>, u8>>;
};

static_assert(size_of_wrong<own> != 0);
#endif

#ifdef ELEMENT_OF_NO_BYTES
// expect: repeated: an element may take no bytes at all, so it needs a count of one byte
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
#endif

#ifdef EXTENT_IS_NUMBER
// expect: string: the extent is neither fixed, fixed_or_rest, rest and zero_terminated nor a count
struct own {
    std::string_view name{};
};

template <> struct jauscat::wire::schema<own> {
    using type = layout<string<&own::name, u8>>;
};

static_assert(size_of_wrong<own> != 0);
#endif

#ifdef LIST_OF_FIXED_SIZE
// expect: repeated: a std::array has no count (use array)
struct heights {
    std::array<std::uint8_t, 4> height{};
};

template <> struct jauscat::wire::schema<heights> {
    using type = layout<repeated<&heights::height, count<"heights", u8>, element<"height", u8>>>;
};

static_assert(size_of_wrong<heights> != 0);
#endif

#ifdef REST_NOT_LAST
// expect: layout: an item that takes the rest of the body must be the last one
struct early_rest {
    jauscat::wire::blob bytes{};
    std::uint8_t number{};
};

template <> struct jauscat::wire::schema<early_rest> {
    using T = early_rest;
    using type = layout<bytes<&T::bytes, rest>, field<&T::number, u8>>;
};

static_assert(size_of_wrong<early_rest> != 0);
#endif

#ifdef COUNT_BEHIND_ITS_LIST
// expect: layout: a count, tag or flag stands behind what it is for; it must come before
struct legs {
    jauscat::wire::list<std::uint8_t> leg{};
    std::uint8_t n{};
};

template <> struct jauscat::wire::schema<legs> {
    using type = layout<repeated<&legs::leg, counted_by<&legs::n>, element<"leg", u8>>, field<&legs::n, u8>>;
};

static_assert(size_of_wrong<legs> != 0);
#endif

#ifdef COUNT_BEHIND_A_LIST_IN_A_LIST
// expect: layout: a count, tag or flag stands behind what it is for; it must come before
struct paw {
    jauscat::wire::list<std::uint8_t> toe{};
};
struct animal {
    jauscat::wire::list<paw> paws{};
    std::uint8_t toes{};
};

template <> struct jauscat::wire::schema<paw> {
    using type = layout<repeated<&paw::toe, counted_by<&animal::toes>, element<"toe", u8>>>;
};
template <> struct jauscat::wire::schema<animal> {
    using type = layout<repeated<&animal::paws, count<"paws", u8>>, field<&animal::toes, u8>>;
};

static_assert(size_of_wrong<animal> != 0);
#endif

#ifdef TAG_BEHIND_ITS_VALUE
// expect: layout: a count, tag or flag stands behind what it is for; it must come before
struct tagged {
    std::uint32_t value{};
    std::uint8_t tag{};
};

template <> struct jauscat::wire::schema<tagged> {
    using type =
        layout<selected<&tagged::value, by<&tagged::tag>, when<0, u8>, when<1, u32le>>, field<&tagged::tag, u8>>;
};

static_assert(size_of_wrong<tagged> != 0);
#endif

#ifdef LENGTH_BEHIND_ITS_TEXT
// expect: layout: a count, tag or flag stands behind what it is for; it must come before
// and: &text::value, jauscat::wire::counted_by<&text::length>
struct text {
    std::string_view value{};
    std::uint8_t length{};
};

template <> struct jauscat::wire::schema<text> {
    using type = layout<string<&text::value, counted_by<&text::length>>, field<&text::length, u8>>;
};

static_assert(size_of_wrong<text> != 0);
#endif

#ifdef FLAGS_BEHIND_WHAT_THEY_ANNOUNCE
// expect: layout: a count, tag or flag stands behind what it is for; it must come before
struct announced {
    std::optional<std::uint8_t> value{};
    bool is_there{};
    std::optional<std::uint8_t> other{};
};

template <> struct jauscat::wire::schema<announced> {
    using type = layout<gated_by<&announced::is_there, field<&announced::value, u8>>,
                        presence<u8, presence_flag<&announced::is_there>, field<&announced::other, u8>>>;
};

static_assert(size_of_wrong<announced> != 0);
#endif

#ifdef OF_NO_LIST
// expect: repeated: the member must be a list or an inline_list
// and: is_list_member<&one::number, unsigned char>
struct one {
    std::uint8_t number{};
};

template <> struct jauscat::wire::schema<one> {
    using type = layout<repeated<&one::number, count<"numbers", u8>, element<"number", u8>>>;
};

static_assert(size_of_wrong<one> != 0);
#endif

#ifdef ELEMENTS_OF_ANOTHER_TYPE
// expect: repeated: the elements are not of the type that their codec carries
// and: is_carried<&heights::height, float, unsigned char>
struct heights {
    jauscat::wire::list<float> height{};
};

template <> struct jauscat::wire::schema<heights> {
    using type = layout<repeated<&heights::height, count<"heights", u8>, element<"height", u8>>>;
};

static_assert(size_of_wrong<heights> != 0);
#endif

#ifdef TEXT_OF_NUMBER
// expect: string: the member must be a std::string_view
// and: has_type<&named::name, int, std::basic_string_view<char
struct named {
    int name{};
};

template <> struct jauscat::wire::schema<named> {
    using type = layout<string<&named::name, count<"length", u8>>>;
};

static_assert(size_of_wrong<named> != 0);
#endif

#ifdef BYTES_OF_NUMBER
// expect: bytes: the member must be a blob
// and: has_type<&kept::data, int,
struct kept {
    int data{};
};

template <> struct jauscat::wire::schema<kept> {
    using type = layout<bytes<&kept::data, rest>>;
};

static_assert(size_of_wrong<kept> != 0);
#endif
