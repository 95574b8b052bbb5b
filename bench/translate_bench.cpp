// Translation under the seed table against code written by hand.
#include "hand_written_translator.hpp"
#include "pair.hpp"
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/translate/translator.hpp>

#include <algorithm>
#include <random>
#include <vector>

namespace {

namespace jaus = jauscat::jaus;
using translator = jauscat::translate::translator<jauscat::translation::seed_table>;
using bytes = std::vector<std::byte>;

constexpr std::size_t item_count = 1024;

// Out of line, and nothing below them is: both sides cost one call.
[[gnu::noinline, gnu::flatten]] std::size_t jauscat_forth(std::span<const std::byte> message,
                                                          std::span<std::byte> packet) {
    return translator::forth(message, packet).size();
}
[[gnu::noinline, gnu::flatten]] std::size_t jauscat_back(std::span<const std::byte> packet,
                                                         std::span<std::byte> message) {
    return translator::back(packet, message).size();
}
[[gnu::noinline, gnu::flatten]] std::size_t hand_written_forth(std::span<const std::byte> message,
                                                               std::span<std::byte> packet) {
    return hand_written::translate_forth(message, packet);
}
[[gnu::noinline, gnu::flatten]] std::size_t hand_written_back(std::span<const std::byte> packet,
                                                              std::span<std::byte> message) {
    return hand_written::translate_back(packet, message);
}

/// Adds both directions for messages of any code with a body of `body_size` bytes. False when the two sides differ.
bool add(const std::string& name, std::vector<bytes>& messages, std::vector<bytes>& packets, std::size_t body_size) {
    static std::array<std::byte, translator::max_packet_size> packet, other_packet;
    static std::array<std::byte, translator::max_message_size> message;
    std::mt19937 random{7};
    const auto octet = [&] { return static_cast<std::uint8_t>(1 + random() % 254); };
    bool agree = true;
    for (std::size_t i = 0; i != item_count; ++i) {
        bytes made(16 + body_size);
        std::ranges::generate(made, [&] { return static_cast<std::byte>(random()); });
        const jaus::header head{.command_code = jaus::catalog[random() % jaus::catalog.size()].command_code,
                                .destination = {octet(), octet(), octet(), octet()},
                                .source = {octet(), octet(), octet(), octet()},
                                .data_size = static_cast<std::uint16_t>(body_size),
                                .sequence_number = static_cast<std::uint16_t>(random())};
        agree = agree && jauscat::wire::encode(head, made);
        const auto size = jauscat_forth(made, packet);
        agree = agree && size == hand_written_forth(made, other_packet) &&
                std::ranges::equal(std::span{packet}.first(size), std::span{other_packet}.first(size));
        for (const auto back : {jauscat_back, hand_written_back})
            agree = agree && back(std::span{packet}.first(size), message) == made.size() &&
                    std::ranges::equal(std::span{message}.first(made.size()), made);
        packets.emplace_back(packet.begin(), packet.begin() + static_cast<std::ptrdiff_t>(size));
        messages.push_back(std::move(made));
    }
    bench::pair(
        name + ", forth", std::span{messages}, [](const bytes& m) { return jauscat_forth(m, packet); },
        std::span{messages}, [](const bytes& m) { return hand_written_forth(m, packet); });
    bench::pair(
        name + ", back", std::span{packets}, [](const bytes& p) { return jauscat_back(p, message); },
        std::span{packets}, [](const bytes& p) { return hand_written_back(p, message); });
    return agree;
}

} // namespace

bool bench::add_translate_benchmarks() {
    static std::vector<bytes> messages[3], packets[3];
    return add("translate, no body", messages[0], packets[0], 0) &&
           add("translate, Set Wrench Effort's 20 bytes", messages[1], packets[1], 20) &&
           add("translate, largest body", messages[2], packets[2], translator::max_body);
}
