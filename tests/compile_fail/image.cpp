#include "small_image.hpp"
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/translate/image_rows.hpp>

using namespace small;

#ifdef GOOD
// expect: no error
using checked = table_of<count_row, presence_row, mode_row, left_row, right_row, wide_row>;
#endif

#ifdef COPY_CHANGES_SIGN
// expect: copy: not every value of the message's field comes back from the packet's field
struct signed_image {
    std::int8_t mode{};
};
struct mode_command {
    std::uint8_t mode{};
};
template <> struct jauscat::wire::schema<signed_image> {
    using type = layout<field<&signed_image::mode, i8>>;
};
template <> struct jauscat::wire::schema<mode_command> {
    using type = layout<field<&mode_command::mode, u8>>;
};

using checked = translate::image_table<mode_command, signed_image,
                                       translate::copy<at<&mode_command::mode>, at<&signed_image::mode>>>;
#endif

#ifdef ELEMENT_OF_ANOTHER_TYPE
// expect: element: the image's field has not the type that the optional element has on the wire
using wrong_row = translate::element<at<&command::right>, at<&image::wide>>;

using checked =
    table_of<count_row, presence_row, mode_row, left_row, wrong_row, translate::caller_set<at<&image::right>>>;
#endif

#ifdef LEAVES_IMAGE_FIELD_OUT
// expect: image_table: a field of the image is not written by any row
using checked = table_of<count_row, presence_row, mode_row, left_row, right_row>;
#endif

#ifdef LEAVES_MESSAGE_FIELD_OUT
// expect: image_table: a field of the message is used by no row
using checked =
    table_of<count_row, presence_row, mode_row, left_row, wide_row, translate::caller_set<at<&image::right>>>;
#endif

#ifdef NAMES_UNKNOWN_FIELD
// expect: image_table: a row names a field that the message or the image does not have
struct percent_of_nothing {
    int value{};
};

using checked = table_of<count_row, presence_row, mode_row, left_row, right_row, wide_row,
                         translate::caller_set<at<&percent_of_nothing::value>>>;
#endif

#ifdef PRESENCE_TOO_SMALL
// expect: presence_bits: the message has more optional elements than the image's field has bits
struct narrow {
    std::uint8_t presence{};
};
constexpr auto error_of_nothing() {
    narrow image{};
    const translate::image_message<jauscat::jaus::set_wrench_effort> message{};
    return translate::presence_bits<translate::at<&narrow::presence>>::to_packet(message, image, {});
}
static_assert(error_of_nothing() == translate::errc::ok);
using checked = table_of<count_row, presence_row, mode_row, left_row, right_row, wide_row>;
#endif

#ifdef ROW_ABOUT_SIZES
// expect: image_table: an image has a fixed size; rows about sizes and rest are for packets
using checked = table_of<count_row, presence_row, mode_row, left_row, right_row, wide_row, translate::rest>;
#endif

#ifdef ROW_WITHOUT_FROM_PACKET
// expect: table: a row has no static from_packet(const auto& packet, auto& message, sizes) noexcept that returns an
// errc
struct zero {
    using uses = translate::path_list<>;
    using writes = translate::path_list<at<&image::wide>>;
    static constexpr translate::errc to_packet(const auto&, auto&, translate::sizes) noexcept {
        return translate::errc::ok;
    }
};
using checked = table_of<count_row, presence_row, mode_row, left_row, right_row, zero>;
#endif

#ifdef TWO_COUNTERS
// expect: image_table: presence_bits and counter may be there once
using checked = table_of<count_row, presence_row, mode_row, left_row, right_row, translate::counter<at<&image::wide>>>;
#endif

#ifdef USES_FIELD_TWICE
// expect: image_table: a field of the message is used by two rows
using again = translate::copy<at<&command::mode>, at<&image::wide>>;

using checked = table_of<count_row, presence_row, mode_row, left_row, right_row, again>;
#endif

#ifdef WRITES_FIELD_TWICE
// expect: image_table: a field of the image is written by two rows
using again = translate::constant<at<&image::mode>, 1>;

using checked = table_of<count_row, presence_row, mode_row, left_row, right_row, wide_row, again>;
#endif

static_assert(error_of_nothing<checked>() == translate::errc::no_space);
