#include "small_table.hpp"

using namespace small;

#ifdef GOOD
// expect: no error
using checked = right_table;
#endif

#ifdef CODE_TWICE
// expect: code_index: a code is listed twice
constexpr std::array<std::uint16_t, 3> repeated_codes{0x0001, 0x0405, 0x0001};
using repeated = translate::code_rank<at<&head::code>, at<&packet::subindex>, repeated_codes>;

using checked = table_of<index_row, repeated, size_row, spare_row, count_row, rest_row>;
#endif

#ifdef DATA_BEYOND_COUNT
// expect: table: the packet field that counts the data is too narrow for the largest data
struct narrow {
    std::uint32_t index{}, subindex{}, spare{};
    std::uint8_t count{};
};
template <> struct jauscat::wire::schema<narrow> {
    using T = narrow;
    using type =
        layout<field<&T::index, u32le>, field<&T::subindex, u32le>, field<&T::spare, u32le>, field<&T::count, u8>>;
};

using checked =
    translate::table<head, narrow, 256, translate::offset<at<&head::component>, at<&narrow::index>, 6900>,
                     translate::code_rank<at<&head::code>, at<&narrow::subindex>, codes>, size_row,
                     translate::constant<at<&narrow::spare>, 0>, translate::data_count<at<&narrow::count>>, rest_row>;
#endif

#ifdef INDEX_BEYOND_16_BITS
// expect: offset: base plus the largest value does not fit an object index of 16 bits
using high = translate::offset<at<&head::component>, at<&packet::index>, 0xFF01>;

using checked = table_of<high, subindex_row, size_row, spare_row, count_row, rest_row>;
#endif

#ifdef INDEX_BEYOND_FIELD
// expect: offset: base plus the largest value does not fit the packet's field
struct narrow {
    std::uint8_t index{};
    std::uint32_t subindex{}, spare{}, count{};
};
template <> struct jauscat::wire::schema<narrow> {
    using T = narrow;
    using type =
        layout<field<&T::index, u8>, field<&T::subindex, u32le>, field<&T::spare, u32le>, field<&T::count, u32le>>;
};

using checked =
    translate::table<head, narrow, 100, translate::offset<at<&head::component>, at<&narrow::index>, 16>,
                     translate::code_rank<at<&head::code>, at<&narrow::subindex>, codes>, size_row,
                     translate::constant<at<&narrow::spare>, 0>, translate::data_count<at<&narrow::count>>, rest_row>;
#endif

#ifdef LEAVES_MESSAGE_FIELD_OUT
// expect: table: a message field is used by no row, and there is no row `rest` to carry it
using checked = table_of<index_row, subindex_row, size_row, spare_row, count_row>;
#endif

#ifdef LEAVES_PACKET_FIELD_OUT
// expect: table: a packet field is not written by any row
using checked = table_of<index_row, subindex_row, size_row, count_row, rest_row>;
#endif

#ifdef NAMES_UNKNOWN_MESSAGE_FIELD
// expect: table: a row names a field that the message or the packet does not have
using foreign = translate::copy<at<&stranger::field>, at<&packet::spare>>;

using checked = table_of<index_row, subindex_row, size_row, foreign, count_row, rest_row>;
#endif

#ifdef NAMES_UNKNOWN_PACKET_FIELD
// expect: table: a row names a field that the message or the packet does not have
using foreign = translate::constant<at<&stranger::field>, 0>;

using checked = table_of<index_row, subindex_row, size_row, spare_row, foreign, count_row, rest_row>;
#endif

#ifdef NO_BODY_SIZE
// expect: table: exactly one row must say which message field states the body's size
using checked = table_of<index_row, subindex_row, spare_row, count_row, rest_row>;
#endif

#ifdef NO_DATA_COUNT
// expect: table: exactly one row must say which packet field counts the data
using uncounted = translate::constant<at<&packet::count>, 0>;

using checked = table_of<index_row, subindex_row, size_row, spare_row, uncounted, rest_row>;
#endif

#ifdef SPLITS_CARRIER
// expect: table: rest would split an integer that bit-fields share; use all of its fields or none
using half = translate::copy<at<&head::priority>, at<&packet::spare>>;

using checked = table_of<index_row, subindex_row, size_row, half, count_row, rest_row>;
#endif

#ifdef TOO_MANY_CODES
// expect: code_rank: more than 254 command codes do not fit a subindex (255 is reserved)
constexpr auto many_codes = [] {
    std::array<std::uint16_t, 255> codes{};
    for (std::size_t i = 0; i != codes.size(); ++i) codes[i] = static_cast<std::uint16_t>(i);
    return codes;
}();
using many = translate::code_rank<at<&head::code>, at<&packet::subindex>, many_codes>;

using checked = table_of<index_row, many, size_row, spare_row, count_row, rest_row>;
#endif

#ifdef USES_FIELD_TWICE
// expect: table: a message field is used by two rows
using again = translate::copy<at<&head::component>, at<&packet::spare>>;

using checked = table_of<index_row, subindex_row, size_row, again, count_row, rest_row>;
#endif

#ifdef WRITES_FIELD_TWICE
// expect: table: a packet field is written by two rows
using checked = table_of<index_row, subindex_row, size_row, spare_row, spare_row, count_row, rest_row>;
#endif

static_assert(error_of_nothing<checked>() == translate::errc::truncated);
