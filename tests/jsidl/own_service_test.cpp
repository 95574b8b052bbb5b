// A service of a user's own: its headers are written by jauscat_add_jsidl, and carry a message.
#include <jauscat/wire/wire.hpp>

#include <acme/survey.hpp>
#include <array>
#include <cstdio>

namespace survey = acme::survey;
namespace wire = jauscat::wire;

static_assert(survey::set_sonar::schema::message_id == 0xD001 && survey::set_sonar::schema::is_command);
static_assert(survey::services::sonar::parent_uri == "urn:jaus:jss:core:Management");
static_assert(decltype(survey::report_echoes::echo_list)::capacity == 40);

namespace {

const std::array raw{std::byte{7}};

survey::report_echoes sample() {
    survey::report_echoes made{};
    made.head_rec = {
        .state = {.gain = 5, .locked = 1}, .position = {1, 2, 3}, .serial = "S7", .title = "echo", .raw = raw};
    if (!made.echo_list.resize(3)) return {};
    made.echo_list[1] = {.value = survey::point_rec{.distance = 9}};
    survey::points points{};
    if (!points.elements.push_back({.distance = 4})) return {};
    made.echo_list[2] = {.value = points};
    return made;
}

} // namespace

int main() {
    constexpr std::array<unsigned char, 40> expected{
        2,   0xD0, 0x85, 0,   0, 0x80, 0x3F, 0, 0, 0, 0x40, 0, 0, 0x40, 0x40, 'S', '7', 0, 0, 4,
        'e', 'c',  'h',  'o', 1, 0,    7,    0, 0, 0, 0,    0, 3, 0,    0,    1,   9,   2, 1, 4};
    constexpr std::size_t size = 40;
    const auto message = sample();
    std::array<std::byte, 100> out{};
    const auto written = wire::encode(message, out);
    if (!written || written->size() != size) return std::printf("%zu bytes\n", written->size()), 1;
    for (std::size_t i = 0; i != size; ++i)
        if (static_cast<unsigned char>(out[i]) != expected[i]) return std::printf("byte %zu\n", i), 1;
    survey::report_echoes back{};
    if (!wire::decode(back, *written) || back != message) return std::puts("decoding gives another message"), 1;

    const survey::set_sonar command{.mode = survey::mode::value_2d_scan_fast,
                                    .range = survey::range{.index = survey::range_form::far, .value = 10000}};
    constexpr std::array<unsigned char, 9> coded{1, 0xD0, 0x04, 1, 2, 0xFF, 0xFF, 0xFF, 0xFF};
    const auto sent = wire::encode(command, out);
    if (!sent || sent->size() != coded.size()) return std::puts("the command has another size"), 1;
    for (std::size_t i = 0; i != coded.size(); ++i)
        if (static_cast<unsigned char>(out[i]) != coded[i]) return std::printf("command, byte %zu\n", i), 1;
}
