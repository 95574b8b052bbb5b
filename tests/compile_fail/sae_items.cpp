#include "small_message.hpp"

#include <variant>

struct part {
    std::uint8_t number{};
};
template <> struct jauscat::wire::schema<part> {
    using type = layout<field<&part::number, u8>>;
};

#ifdef VARIANT_OF_ANOTHER_MEMBER
// expect: variant: the member must be a std::variant
// and: is_variant_member<&choice::which,
struct choice {
    part which{};
};
template <> struct jauscat::wire::schema<choice> {
    using type = layout<variant<&choice::which, u8>>;
};
static_assert(size_of_wrong<choice> != 0);
#endif

#ifdef VARIANT_OF_VALUES
// expect: variant: an alternative is neither a structure with a schema nor std::monostate
// and: has_structures<&choice::which,
struct choice {
    std::variant<part, int> which{};
};
template <> struct jauscat::wire::schema<choice> {
    using type = layout<variant<&choice::which, u8>>;
};
static_assert(size_of_wrong<choice> != 0);
#endif

#ifdef VARIANT_OF_EQUAL_ALTERNATIVES
// expect: variant: two alternatives are of one type
// and: has_distinct_alternatives<&choice::which,
struct choice {
    std::variant<part, part> which{};
};
template <> struct jauscat::wire::schema<choice> {
    using type = layout<variant<&choice::which, u8>>;
};
static_assert(size_of_wrong<choice> != 0);
#endif

#ifdef VARIANT_WITH_SIGNED_TAG
// expect: variant: the tag must be an unsigned integer
struct choice {
    std::variant<part, std::monostate> which{};
};
template <> struct jauscat::wire::schema<choice> {
    using type = layout<variant<&choice::which, i8>>;
};
static_assert(size_of_wrong<choice> != 0);
#endif

#ifdef VARIANT_OUTSIDE_PRESENCE
// expect: layout: a std::optional member needs a presence vector
struct choice {
    std::optional<std::variant<part, std::monostate>> which{};
};
template <> struct jauscat::wire::schema<choice> {
    using type = layout<variant<&choice::which, u8>>;
};
static_assert(size_of_wrong<choice> != 0);
#endif

#ifdef CONSTANT_TOO_LARGE
// expect: constant: the value does not fit its codec
struct empty {};
template <> struct jauscat::wire::schema<empty> {
    using type = layout<constant<"message_id", u8, 256>>;
};
static_assert(size_of_wrong<empty> != 0);
#endif

#ifdef EMBEDDED_BLOB
// expect: embedded: the member must be an embedded_message
// and: is_embedded_member<&envelope::content,
struct envelope {
    jauscat::wire::blob content{};
};
template <> struct jauscat::wire::schema<envelope> {
    using type = layout<embedded<&envelope::content, count<"content_size", u8>>>;
};
static_assert(size_of_wrong<envelope> != 0);
#endif

#ifdef EMBEDDED_WITHOUT_COUNT
// expect: embedded: the second argument is not a count
struct envelope {
    jauscat::wire::embedded_message content{};
};
template <> struct jauscat::wire::schema<envelope> {
    using type = layout<embedded<&envelope::content, u8>>;
};
static_assert(size_of_wrong<envelope> != 0);
#endif

#ifdef VALUE_SET_WITHOUT_VALUES
// expect: in_value_set: the value set is empty
template <> struct jauscat::wire::schema<small_message> {
    using type = layout<field<&small_message::number, in_value_set<u16le>>>;
};
static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef VALUE_SET_OF_ANOTHER_KIND
// expect: in_value_set: a part of the value set is neither between nor one_of
template <> struct jauscat::wire::schema<small_message> {
    using type = layout<field<&small_message::number, in_value_set<u16le, percent>>>;
};
static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef VALUE_SET_OF_REAL
// expect: in_value_set: the codec must carry an integer or an enumeration
template <> struct jauscat::wire::schema<small_message> {
    using type = layout<field<&small_message::level, in_value_set<scaled<u8, percent>, between<0, 1>>>>;
};
static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef BETWEEN_IN_REVERSE
// expect: between: the first number is larger than the second
template <> struct jauscat::wire::schema<small_message> {
    using type = layout<field<&small_message::number, in_value_set<u16le, between<2, 1>>>>;
};
static_assert(size_of_wrong<small_message> != 0);
#endif

#ifdef COUNT_LIMIT_TOO_LARGE
// expect: count_between: the limit exceeds what the count can say
struct envelope {
    std::string_view content{};
};
template <> struct jauscat::wire::schema<envelope> {
    using type = layout<string<&envelope::content, count_between<"content_size", u8, 0, 256>>>;
};
static_assert(size_of_wrong<envelope> != 0);
#endif
