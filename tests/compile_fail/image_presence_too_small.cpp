// expect: presence_bits: the message has more optional elements than the image's field has bits
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/translate/image_rows.hpp>

namespace translate = jauscat::translate;

struct narrow {
    std::uint8_t presence{};
};
constexpr auto error_of_nothing() {
    narrow image{};
    const translate::image_message<jauscat::jaus::set_wrench_effort> message{};
    return translate::presence_bits<translate::at<&narrow::presence>>::to_packet(message, image, {});
}
static_assert(error_of_nothing() == translate::errc::ok);
