// expect: copy: not every value of the message's field comes back from the packet's field
#include "small_image.hpp"

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

using namespace small;

using wrong = translate::image_table<mode_command, signed_image,
                                     translate::copy<at<&mode_command::mode>, at<&signed_image::mode>>>;
static_assert(error_of_nothing<wrong>() == translate::errc::no_space);
