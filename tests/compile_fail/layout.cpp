#include "small_message.hpp"
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/schema/jaus/dynamic_configuration.hpp>

#include <string>

#ifdef ARENA_OF_DESTRUCTORS
// expect: arena: its elements are never destroyed
auto make(jauscat::wire::arena& memory) { return memory.allocate<std::string>(1); }
#endif

#ifdef CASE_OF_ANOTHER_TYPE
// expect: selected: a case does not fit the member's type
// and: fits_member<&text_or_number::value,
struct text_or_number {
    std::uint8_t tag{};
    std::string_view value{};
};

template <> struct jauscat::wire::schema<text_or_number> {
    using T = text_or_number;
    using type = layout<field<&T::tag, u8>, selected<&T::value, by<&T::tag>, when<0, u8>>>;
};

static_assert(size_of_wrong<text_or_number> != 0);
#endif

#ifdef CODEC_NO_LOAD
// expect: codec: it has no load(const std::byte*, value_type&) that returns errc
struct own {
    std::uint8_t value{};
};

struct half_codec {
    using value_type = std::uint8_t;
    static constexpr std::size_t size = 1;
    static constexpr auto store(std::byte* out, value_type value) { return jauscat::wire::u8::store(out, value); }
};

template <> struct jauscat::wire::schema<own> {
    using type = layout<field<&own::value, half_codec>>;
};

static_assert(size_of_wrong<own> != 0);
#endif

#ifdef DECODE_OF_LISTS_WITHOUT_ARENA
// expect: decode: the message has lists; give an arena as the third argument
struct listing {
    jauscat::wire::list<std::uint8_t> number{};
};

template <> struct jauscat::wire::schema<listing> {
    using type = layout<repeated<&listing::number, count<"numbers", u8>, element<"number", u8>>>;
};

listing value{};
const auto result = jauscat::wire::decode(value, {});
#endif

#ifdef DISPATCHER_OF_LISTS_WITHOUT_ARENA
// expect: dispatcher: a message has lists; give an arena as the third argument
jauscat::jaus::dispatcher handlers{jauscat::jaus::on<jauscat::jaus::report_services>([](const auto&, const auto&) {})};
const auto done = handlers(jauscat::jaus::header{}, {});
#endif

#ifdef EMPTY_RANGE
// expect: scaled: the range is empty (min must be below max)
struct upside_down {
    static constexpr double min = 100, max = 0;
};

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<u8, upside_down>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef ENUMERATION_OF_ANOTHER_SIZE
// expect: enumeration: the enumeration's underlying type must be the carrier's integer type
enum class mode : std::uint8_t { off, on };
struct with_mode {
    mode value{};
};

template <> struct jauscat::wire::schema<with_mode> {
    using type = layout<field<&with_mode::value, enumeration<mode, u16le>>>;
};

static_assert(size_of_wrong<with_mode> != 0);
#endif

#ifdef GATED_MEMBER_NOT_OPTIONAL
// expect: gated_by: the member must be a std::optional
// and: may_be_absent<&always_present::number,
struct always_present {
    bool present{};
    std::uint8_t number{};
};

template <> struct jauscat::wire::schema<always_present> {
    using T = always_present;
    using type = layout<presence<u8, presence_flag<&T::present>, gated_by<&T::present, field<&T::number, u8>>>>;
};

static_assert(size_of_wrong<always_present> != 0);
#endif

#ifdef MEMBER_FORGOTTEN
// expect: layout: a member of the message is missing from its layout
// and: level
template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type = layout<field<&T::number, u16le>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef MEMBER_OF_ANOTHER
// expect: layout: a field names a member of another struct
// and: has_type<&stranger::number,
struct stranger {
    std::uint16_t number{};
};

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type = layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>,
                        presence<u8, field<&T::extra, u8>>, field<&stranger::number, u16le>>;
};

static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef MEMBER_TWICE
// expect: layout: a member is listed twice
// and: member_once<&small_message::number, 2
template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type = layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>, field<&T::number, u16le>,
                        presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef NOT_A_CODEC
// expect: field: the second argument is not a codec
template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, percent>, field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef NOT_AN_AGGREGATE
// expect: layout: a message must be a plain aggregate
class closed {
  public:
    closed() {}
    std::uint8_t value{};
};

template <> struct jauscat::wire::schema<closed> {
    using type = layout<field<&closed::value, u8>>;
};

static_assert(size_of_wrong<closed> != 0);
#endif

#ifdef OPTIONAL_MEMBER_FORGOTTEN
// expect: layout: a member of the message is missing from its layout
// and: extra
template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type = layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>>;
};

static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef OPTIONAL_OUTSIDE_PRESENCE
// expect: layout: a std::optional member needs a presence vector
// and: item_always_there<jauscat::wire::field<&small_message::extra
template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type = layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>, field<&T::extra, u8>>;
};

static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef PART_NO_FITS
// expect: bit_fields: a part has no fits(object) that returns bool
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
#endif

#ifdef OF_NOTHING
// expect: presence: no item is optional, so the vector has nothing to announce
struct without_options {
    std::uint8_t value{};
};

template <> struct jauscat::wire::schema<without_options> {
    using type = layout<presence<u8, field<&without_options::value, u8>>>;
};

static_assert(size_of_wrong<without_options> != 0);
#endif

#ifdef TOO_SMALL
// expect: presence: more optional fields than bits in the presence vector
struct crowded {
    std::optional<std::uint8_t> a{}, b{}, c{}, d{}, e{}, f{}, g{}, h{}, i{};
};

template <> struct jauscat::wire::schema<crowded> {
    using T = crowded;
    using type =
        layout<presence<u8, field<&T::a, u8>, field<&T::b, u8>, field<&T::c, u8>, field<&T::d, u8>, field<&T::e, u8>,
                        field<&T::f, u8>, field<&T::g, u8>, field<&T::h, u8>, field<&T::i, u8>>>;
};

static_assert(size_of_wrong<crowded> != 0);
#endif

#ifdef SCALED_CASE_OF_VARIANT
// expect: selected: scaled cases need a plain member
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
#endif

#ifdef SCALED_ON_FLOAT
// expect: scaled: the carrier must be an integer codec
template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<f32le, percent>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef TREE_OF_OTHER_NODES
// expect: tree: the member must be a list of nodes
// and: has_type<&planted::tree,
struct node {
    std::uint8_t children{};
};
struct planted {
    jauscat::wire::list<small_message> tree{};
};

template <> struct jauscat::wire::schema<node> {
    using type = layout<field<&node::children, u8>>;
};
template <> struct jauscat::wire::schema<planted> {
    using type = layout<tree<&planted::tree, &node::children, 4>>;
};

static_assert(size_of_wrong<planted> != 0);
#endif

#ifdef UNKNOWN_MEMBER_IN_VIEW
// expect: view: the message has no such member in its layout
struct stranger {
    std::uint16_t number{};
};

template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u16le>, field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);

constexpr std::array<std::byte, 4> bytes{};
constexpr auto number = jauscat::wire::view<small_message>{bytes}.get<&stranger::number>();
#endif

#ifdef WRONG_MEMBER_TYPE
// expect: field: the member's type is not the type its codec carries
// and: is_carried<&small_message::number,
template <> struct jauscat::wire::schema<small_message> {
    using T = small_message;
    using type =
        layout<field<&T::number, u32le>, field<&T::level, scaled<u8, percent>>, presence<u8, field<&T::extra, u8>>>;
};

static_assert(size_of_wrong<small_message> != 0);
#endif
