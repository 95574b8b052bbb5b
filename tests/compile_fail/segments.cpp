#include "object_list_messages.hpp"
#include <jauscat/translate/segments.hpp>

using namespace small;

inline constexpr std::array<std::uint16_t, 2> first_codes{0x0001, 0x0405};
inline constexpr std::array<std::uint16_t, 1> second_codes{0x0404};
using right_segments = translate::code_segments<first_codes, second_codes>;

template <class Segments, std::uint32_t Base = 0x2000>
using segmented_table =
    table_of<translate::segmented_offset<at<&head::component>, at<&packet::index>, Base, at<&head::code>, Segments>,
             translate::segmented_rank<at<&head::code>, at<&packet::subindex>, Base, at<&packet::index>, Segments>,
             size_row, spare_row, count_row, rest_row>;
using table = segmented_table<right_segments>;

#ifdef GOOD
// expect: no error
using right = jauscat::bridging::object_lists<table, 1, other_command, command>;
static_assert(right::descriptions.size() == 2 && right::descriptions[0].index == 0x2001 &&
              right::descriptions[1].index == 0x2101 && right::entries[0].subindex == 2);
#endif

#ifdef LIST_TOO_LONG
// expect: code_segments: more than 254 codes do not fit the subindices of a segment (255 is reserved)
inline constexpr auto many_codes = [] {
    std::array<std::uint16_t, 255> codes{};
    for (std::size_t i = 0; i != codes.size(); ++i) codes[i] = static_cast<std::uint16_t>(i);
    return codes;
}();
using checked = translate::code_segments<many_codes>;
static_assert(checked::count == 1);
#endif

#ifdef CODE_IN_TWO_LISTS
// expect: code_index: a code is listed twice
static_assert(translate::code_segments<first_codes, first_codes>::find(1).rank == 1);
#endif

#ifdef INDEX_BEYOND_16_BITS
// expect: segmented_offset: the index of the last segment does not fit 16 bits
constexpr auto checked = error_of_nothing<segmented_table<right_segments, 0xFE01>>();
#endif

#ifdef VALUE_OF_16_BITS
// expect: segmented_offset: the message's value has more than 8 bits
using checked =
    translate::segmented_offset<at<&head::size>, at<&packet::index>, 0x2000, at<&head::code>, right_segments>;
static_assert(checked::gives_index);
#endif

#ifdef SEVERAL_OBJECTS
// expect: object_list: the messages are in several segments, each an object: use object_lists
using wrong = jauscat::bridging::object_list<table, 1, command, other_command>;
static_assert(wrong::entries.size() == 2);
#endif

#ifdef MESSAGE_TWICE
// expect: object_lists: a message is listed twice
using wrong = jauscat::bridging::object_lists<table, 1, command, other_command, command>;
static_assert(wrong::entries.size() == 3);
#endif

#ifdef NO_RANK
// expect: object_lists: a message has no rank in the table; append its code to one of the table's lists
using wrong = jauscat::bridging::object_lists<table, 1, command, stranger_command>;
static_assert(wrong::entries.size() == 2);
#endif
