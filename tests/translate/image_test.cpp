// A message into a process image, and out of one.
#include "image_samples.hpp"

using namespace jauscat;
using namespace jauscat::test;

namespace {

constexpr auto full_body = hex_literal<20>("ff0f ff7f 0180 0000 0040 01c0 0020 00ff80 336699");
constexpr auto full_image = hex_literal<22>("0100"                          // the first command
                                            "ff0f"                          // all twelve elements
                                            "ff7f 0180 0000 0040 01c0 0020" // propulsive
                                            "00ff80 336699");               // resistive

constexpr image after(image before, auto... bodies) {
    const auto ok = [&](auto body) { return command::to_image(body, before) == translate::errc::ok; };
    return (ok(bodies) && ...) ? before : image{};
}
template <class Translator, std::size_t Size> constexpr auto body_of(image from) {
    std::array<std::byte, Size> out{};
    const auto restored = Translator::from_image(from, out);
    return restored && restored->size() == Size ? out : decltype(out){};
}
image bytes_of(const wrench_effort_image& values) {
    image bytes{};
    REQUIRE(wire::encode(values, bytes));
    return bytes;
}

} // namespace

TEST_CASE("Set Wrench Effort is translated to the image's bytes in a constant expression, and back") {
    STATIC_REQUIRE(command::image_size == 22);
    STATIC_REQUIRE(after(image{}, full_body) == full_image);
    STATIC_REQUIRE(body_of<command, 20>(full_image) == full_body);
    STATIC_REQUIRE(body_of<report, 20>(full_image) == full_body);
}

TEST_CASE("an absent element keeps the image's last value, and its presence bit is clear") {
    constexpr auto one = hex_literal<4>("0200 3412"); // y alone
    constexpr auto none = hex_literal<2>("0000");
    STATIC_REQUIRE(after(full_image, one) == hex_literal<22>("0200 0200 ff7f 3412 0000 0040 01c0 0020 00ff80 336699"));
    STATIC_REQUIRE(after(full_image, one, none) ==
                   hex_literal<22>("0300 0000 ff7f 3412 0000 0040 01c0 0020 00ff80 336699"));
    STATIC_REQUIRE(body_of<command, 4>(after(full_image, one)) == one);
}

TEST_CASE("a merged message keeps the presence bits of the previous one") {
    auto bytes = full_image;
    REQUIRE(command::to_image(from_hex("0200 3412"), bytes) == translate::errc::ok);
    REQUIRE(command::merge(from_hex("0108 7856 aa"), bytes) == translate::errc::ok);
    CHECK(to_hex(bytes) == hex_of("0300 0308 7856 3412 0000 0040 01c0 0020 00ff80 3366aa"));
    std::array<std::byte, 20> both{};
    const auto restored = command::from_image(bytes, both);
    REQUIRE(restored);
    CHECK(to_hex(*restored) == hex_of("0308 7856 3412 aa"));
}

TEST_CASE("the command counter skips 0 when it wraps around") {
    auto bytes = bytes_of({.command_count = 0xFFFE});
    for (const unsigned expected : {0xFFFFu, 1u, 2u}) {
        REQUIRE(command::to_image(full_body, bytes) == translate::errc::ok);
        CHECK(values_of(bytes).command_count == expected);
    }
}

TEST_CASE("the report's counter is set by the slave") {
    auto bytes = bytes_of({.command_count = 77});
    REQUIRE(report::to_image(full_body, bytes) == translate::errc::ok);
    CHECK(values_of(bytes).command_count == 77);
}

TEST_CASE("presence bits that stand for no field do not get into the image") {
    auto bytes = full_image;
    REQUIRE(command::to_image(from_hex("01f0 ff7f"), bytes) == translate::errc::ok);
    CHECK(values_of(bytes).presence_vector == 1);
    bytes = full_image;
    REQUIRE(command::merge(from_hex("01f0 ff7f"), bytes) == translate::errc::ok);
    CHECK(values_of(bytes).presence_vector == 0x0FFF);
}

TEST_CASE("a refused message changes no byte of the image") {
    const auto [body, error] = GENERATE(table<std::string, translate::errc>({
        {"", translate::errc::truncated},
        {"ff", translate::errc::truncated},
        {"0300 ff7f 01", translate::errc::truncated},
        {"0100 ff7f 00", translate::errc::wrong_size},
        {"0100 0080", translate::errc::out_of_range},      // -32768 is no effort
        {"2100 0000 0080", translate::errc::out_of_range}, // nor as the second element
    }));
    auto bytes = full_image;
    CHECK(command::to_image(from_hex(body), bytes) == error);
    CHECK(bytes == full_image);
    CHECK(command::merge(from_hex(body), bytes) == error);
    CHECK(bytes == full_image);
}

TEST_CASE("an image or a body that exceeds its buffer is refused") {
    std::array<std::byte, 21> short_image{};
    CHECK(command::to_image(full_body, short_image) == translate::errc::no_space);
    std::array<std::byte, 20> body{};
    CHECK(command::from_image(short_image, body).error() == translate::errc::truncated);
    CHECK(command::from_image(full_image, std::span{body}.first(19)).error() == translate::errc::no_space);
}

TEST_CASE("a body needs no more room than its message") {
    const auto bytes = bytes_of({.presence_vector = 0x0001, .propulsive_linear_effort_x = 0x1234});
    std::array<std::byte, 5> body{};
    body.fill(std::byte{0xA5});
    CHECK(command::from_image(bytes, std::span{body}.first(3)).error() == translate::errc::no_space);
    CHECK(body[0] == std::byte{0xA5}); // nothing was written
    CHECK(std::ranges::equal(*command::from_image(bytes, std::span{body}.first(4)), from_hex("0100 3412")));
    CHECK(body[4] == std::byte{0xA5});
}

TEST_CASE("a presence bit of the image without an element is refused") {
    std::array<std::byte, 20> body{};
    CHECK(command::from_image(bytes_of({.presence_vector = 0x1000}), body).error() == translate::errc::reserved_value);
}

// The rows that tables into packets have, in a table of a user's own.
namespace {

enum class gear : std::uint8_t { park, forward, reverse };
struct drive {
    gear direction{};
    double speed{};
    std::uint8_t lamps{};
};
struct speed_range {
    static constexpr double min = 0, max = 10;
};
struct drive_image {
    std::uint8_t sign{};
    std::uint8_t version{};
    std::uint16_t speed{};
    std::uint32_t lamps{};
};

} // namespace

template <> struct jauscat::wire::schema<drive> {
    using T = drive;
    using type = layout<field<&T::direction, enumeration<gear, u8>>, field<&T::speed, scaled<u16le, speed_range>>,
                        field<&T::lamps, u8>>;
};
template <> struct jauscat::wire::schema<drive_image> {
    using T = drive_image;
    using type = layout<bit_fields<u8, bit_field<&T::sign, 4>, bit_field<&T::version, 4>>, field<&T::speed, u16be>,
                        field<&T::lamps, u32le>>;
};

namespace {

using translate::at;
using drive_table = translate::image_table<
    drive, drive_image,
    translate::map_values<at<&drive::direction>, at<&drive_image::sign>, translate::value_pair<gear::park, 0>,
                          translate::value_pair<gear::forward, 1>, translate::value_pair<gear::reverse, 15>>,
    translate::constant<at<&drive_image::version>, 3>, translate::copy<at<&drive::speed>, at<&drive_image::speed>>,
    translate::copy<at<&drive::lamps>, at<&drive_image::lamps>>>;
using drive_translator = translate::image_translator<drive_table>;

} // namespace

TEST_CASE("a diagnosis names the field of the message that an image refuses") {
    const auto refused = [](const std::string& body) {
        auto bytes = full_image;
        const auto error = command::to_image(from_hex(body), bytes).error();
        return translate::diagnose_to_image<translation::set_wrench_effort_table>(error, from_hex(body), bytes);
    };
    using translate::errc;
    CHECK(refused("0100 ff7f") == translate::diagnosis{});
    CHECK(refused("") ==
          translate::diagnosis{.error = errc::truncated, .field = "presence_vector", .codec = wire::errc::truncated});
    CHECK(refused("0300 ff7f 01") == translate::diagnosis{.error = errc::truncated,
                                                          .field = "propulsive_linear_effort_y",
                                                          .codec = wire::errc::truncated});
    CHECK(refused("0100 ff7f 00") ==
          translate::diagnosis{.error = errc::wrong_size, .codec = wire::errc::trailing_bytes});
    CHECK(refused("0110 ff7f") == translate::diagnosis{}); // a bit without a field
    CHECK(refused("2100 0000 0080") == translate::diagnosis{.error = errc::out_of_range,
                                                            .field = "propulsive_rotational_effort_z",
                                                            .value = static_cast<std::uint64_t>(-32768),
                                                            .codec = wire::errc::out_of_range});
    const auto row = translate::diagnose_to_image<drive_table>(errc::reserved_value, from_hex("03 3412 81"),
                                                               std::array<std::byte, 7>{});
    CHECK(row == translate::diagnosis{.error = errc::reserved_value, .row = 0, .field = "direction", .value = 3});
}

TEST_CASE("a diagnosis names the field of the image that a message refuses") {
    const auto refused = [](const std::string& image) {
        std::array<std::byte, 4> body{};
        const auto error = drive_translator::from_image(from_hex(image), body).error();
        return translate::diagnose_from_image<drive_table>(error, from_hex(image));
    };
    using translate::errc;
    CHECK(refused("3f 12 34 81 00 00 00") == translate::diagnosis{});
    CHECK(refused("3f 12 34") == translate::diagnosis{.error = errc::truncated});
    CHECK(refused("4f 12 34 81 00 00 00") ==
          translate::diagnosis{.error = errc::wrong_packet, .row = 1, .field = "version", .value = 4});
    CHECK(refused("32 12 34 81 00 00 00") ==
          translate::diagnosis{.error = errc::reserved_value, .row = 0, .field = "sign", .value = 2});
    CHECK(refused("3f 12 34 81 01 00 00") ==
          translate::diagnosis{.error = errc::out_of_range, .row = 3, .field = "lamps", .value = 0x181});
    const auto bits = translate::diagnose_from_image<translation::set_wrench_effort_table>(
        errc::reserved_value, bytes_of({.presence_vector = 0x1000}));
    CHECK(bits.field == "presence_vector");
    CHECK(bits.value == 0x1000);
}

TEST_CASE("map_values, constant and copy work in an image as in a packet") {
    std::array<std::byte, 7> bytes{};
    REQUIRE(drive_translator::to_image(from_hex("02 3412 81"), bytes) == translate::errc::ok);
    CHECK(to_hex(bytes) == "3f 12 34 81 00 00 00");
    std::array<std::byte, 4> body{};
    REQUIRE(drive_translator::from_image(bytes, body));
    CHECK(to_hex(body) == "02 34 12 81");

    CHECK(drive_translator::to_image(from_hex("03 3412 81"), bytes) == translate::errc::reserved_value);
    CHECK(to_hex(bytes) == "3f 12 34 81 00 00 00");
    CHECK(drive_translator::from_image(from_hex("4f 12 34 81 00 00 00"), body).error() ==
          translate::errc::wrong_packet);
    CHECK(drive_translator::from_image(from_hex("32 12 34 81 00 00 00"), body).error() ==
          translate::errc::reserved_value);
    CHECK(drive_translator::from_image(from_hex("3f 12 34 81 01 00 00"), body).error() ==
          translate::errc::out_of_range);
}
