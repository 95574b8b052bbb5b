// A message into the process image and out of it, against code written by hand for the same two layouts.
#include "pair.hpp"
#include <jauscat/schema/translation/wrench_effort_image.hpp>
#include <jauscat/translate/image_translator.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>

namespace {

namespace translation = jauscat::translation;
using bytes = std::vector<std::byte>;
using command = jauscat::translate::image_translator<translation::set_wrench_effort_table>;
using report = jauscat::translate::image_translator<translation::report_wrench_effort_table>;
using image = std::array<std::byte, command::image_size>;

constexpr std::size_t item_count = 1024, elements = 12, wide_elements = 6;

// What a programmer writes who has the message's 12 elements and the image's 22 bytes on a sheet of paper. The message
// is looked through before anything is written.
[[gnu::noinline]] bool forth_by_hand(std::span<const std::byte> body, std::span<std::byte> out) {
    if (body.size() < 2 || out.size() < 22) return false;
    std::uint16_t presence, count;
    std::memcpy(&presence, body.data(), 2);
    presence &= 0x0FFF; // the other bits are ignored
    const std::byte* const end = body.data() + body.size();
    const std::byte* in = body.data() + 2;
    std::int16_t wide[6];
    std::uint8_t narrow[6];
    std::byte* const efforts = out.data() + 4;
    std::memcpy(wide, efforts, 12);
    std::memcpy(narrow, efforts + 12, 6);
#pragma GCC unroll 6
    for (unsigned i = 0; i != 6; ++i) {
        if ((presence >> i & 1) == 0) continue;
        if (end - in < 2) return false;
        std::memcpy(&wide[i], in, 2);
        if (wide[i] == -32768) return false;
        in += 2;
    }
#pragma GCC unroll 6
    for (unsigned i = 0; i != 6; ++i) {
        if ((presence >> (6 + i) & 1) == 0) continue;
        if (end == in) return false;
        std::memcpy(&narrow[i], in, 1);
        in += 1;
    }
    if (in != end) return false;
    std::memcpy(&count, out.data(), 2);
    if (++count == 0) count = 1;
    std::memcpy(out.data(), &count, 2);
    std::memcpy(out.data() + 2, &presence, 2);
    std::memcpy(efforts, wide, 12);
    std::memcpy(efforts + 12, narrow, 6);
    return true;
}
[[gnu::noinline]] std::size_t back_by_hand(std::span<const std::byte> in, std::span<std::byte> body) {
    if (in.size() < 22) return 0;
    std::uint16_t presence;
    std::memcpy(&presence, in.data() + 2, 2);
    if ((presence & 0xF000) != 0) return 0;
    const std::size_t size = 2 + 2 * static_cast<std::size_t>(__builtin_popcount(presence & 0x3Fu)) +
                             static_cast<std::size_t>(__builtin_popcount(presence & 0xFC0u));
    if (body.size() < size) return 0;
    std::byte* out = body.data();
    std::memcpy(out, &presence, 2);
    out += 2;
    const std::byte* const efforts = in.data() + 4;
#pragma GCC unroll 6
    for (unsigned i = 0; i != 6; ++i) {
        if ((presence >> i & 1) == 0) continue;
        std::memcpy(out, efforts + 2 * i, 2);
        out += 2;
    }
#pragma GCC unroll 6
    for (unsigned i = 0; i != 6; ++i) {
        if ((presence >> (6 + i) & 1) == 0) continue;
        std::memcpy(out, efforts + 12 + i, 1);
        out += 1;
    }
    return size;
}
[[gnu::noinline, gnu::flatten]] bool forth(std::span<const std::byte> body, std::span<std::byte> out) {
    return command::to_image(body, out).has_value();
}
[[gnu::noinline, gnu::flatten]] std::size_t back(std::span<const std::byte> in, std::span<std::byte> body) {
    return report::from_image(in, body)->size();
}

struct sample_set {
    std::vector<bytes> bodies{};
    std::vector<image> images{};
};

/// Both directions for commands whose presence vectors `next` gives. False when the sides differ.
bool add(const std::string& name, sample_set& set, auto next) {
    static image ours{}, by_hand{};
    static std::array<std::byte, 20> body{};
    std::mt19937 random{11};
    bool agree = true;
    for (std::size_t i = 0; i != item_count; ++i) {
        const auto presence = static_cast<std::uint16_t>(next(random) & 0x0FFF);
        bytes made(2);
        std::memcpy(made.data(), &presence, 2);
        for (unsigned bit = 0; bit != elements; ++bit) {
            if ((presence >> bit & 1) == 0) continue;
            for (unsigned n = bit < wide_elements ? 2 : 1; n != 0; --n)
                made.push_back(static_cast<std::byte>(random() % 0x7F)); // no -32768
        }
        agree = agree && forth(made, ours) && forth_by_hand(made, by_hand) && ours == by_hand;
        for (const auto way : {back, back_by_hand})
            agree =
                agree && way(ours, body) == made.size() && std::ranges::equal(std::span{body}.first(made.size()), made);
        set.bodies.push_back(std::move(made));
        set.images.push_back(ours);
    }
    const bytes illegal{std::byte{1}, std::byte{0}, std::byte{0}, std::byte{0x80}};
    agree = agree && !forth(illegal, ours) && !forth_by_hand(illegal, by_hand) && ours == by_hand;
    const std::span bodies{set.bodies};
    const std::span images{set.images};
    const auto into_image = [](auto way) { return [way](const bytes& b) { return way(b, ours); }; };
    const auto into_body = [](auto way) { return [way](const image& i) { return way(i, body); }; };
    bench::pair(name + ", to image", bodies, into_image(forth), bodies, into_image(forth_by_hand));
    bench::pair(name + ", to message", images, into_body(back), images, into_body(back_by_hand));
    return agree;
}

} // namespace

bool bench::add_image_benchmarks() {
    static sample_set sets[3];
    return add("process image, all 12 efforts", sets[0], [](auto&) { return 0x0FFFu; }) &&
           add("process image, one effort", sets[1], [](auto& random) { return 1u << random() % elements; }) &&
           add("process image, random efforts", sets[2], [](auto& random) { return random(); });
}
