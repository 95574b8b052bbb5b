// Translation under both tables against code written by hand, and against copying the same bytes.
#include "hand_written_translator.hpp"
#include "pair.hpp"
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/translate/translator.hpp>

#include <algorithm>
#include <random>
#include <vector>

namespace {

namespace jaus = jauscat::jaus;
namespace translation = jauscat::translation;
using bytes = std::vector<std::byte>;
using in_bytes = std::span<const std::byte>;
using out_bytes = std::span<std::byte>;

constexpr std::size_t item_count = 1024;

// Both ways of a table, ours and by hand. Out of line, and nothing below them is: both sides cost one call.
template <class Table> struct ours {
    using translator = jauscat::translate::translator<Table>;
    [[gnu::noinline, gnu::flatten]] static std::size_t forth(in_bytes message, out_bytes packet) {
        return translator::to_packet(message, packet)->size();
    }
    [[gnu::noinline, gnu::flatten]] static std::size_t back(in_bytes packet, out_bytes message) {
        return translator::from_packet(packet, message)->size();
    }
};
struct seed : ours<translation::seed_table> {
    [[gnu::noinline, gnu::flatten]] static std::size_t forth_by_small_look_up(in_bytes message, out_bytes packet) {
        return hand_written::translate_forth<hand_written::detail::small_look_up>(message, packet);
    }
    [[gnu::noinline, gnu::flatten]] static std::size_t forth_by_hand(in_bytes message, out_bytes packet) {
        return hand_written::translate_forth(message, packet);
    }
    [[gnu::noinline, gnu::flatten]] static std::size_t back_by_hand(in_bytes packet, out_bytes message) {
        return hand_written::translate_back(packet, message);
    }
};
struct self_contained : ours<translation::self_contained_table> {
    [[gnu::noinline, gnu::flatten]] static std::size_t forth_by_small_look_up(in_bytes message, out_bytes packet) {
        return hand_written::self_contained::translate_forth<hand_written::detail::small_look_up>(message, packet);
    }
    [[gnu::noinline, gnu::flatten]] static std::size_t forth_by_hand(in_bytes message, out_bytes packet) {
        return hand_written::self_contained::translate_forth(message, packet);
    }
    [[gnu::noinline, gnu::flatten]] static std::size_t back_by_hand(in_bytes packet, out_bytes message) {
        return hand_written::self_contained::translate_back(packet, message);
    }
};
[[gnu::noinline]] std::size_t copy(in_bytes from, out_bytes to) {
    std::memcpy(to.data(), from.data(), from.size());
    return from.size();
}

struct message_set {
    std::vector<bytes> messages{}, packets{};
};

/// Adds both directions for messages of any code with a body of `body_size` bytes. False when the sides differ.
template <class Table> bool add(const std::string& name, message_set& set, std::size_t body_size) {
    using translator = typename Table::translator;
    static std::array<std::byte, translator::max_packet_size> packet, other_packet;
    static std::array<std::byte, translator::max_packet_size> message; // copied packets fit too
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
        const auto size = Table::forth(made, packet);
        agree = agree && size != 0 && size == Table::forth_by_hand(made, other_packet) &&
                std::ranges::equal(std::span{packet}.first(size), std::span{other_packet}.first(size));
        for (const auto back : {Table::back, Table::back_by_hand})
            agree = agree && back(std::span{packet}.first(size), message) == made.size() &&
                    std::ranges::equal(std::span{message}.first(made.size()), made);
        set.packets.emplace_back(packet.begin(), packet.begin() + static_cast<std::ptrdiff_t>(size));
        set.messages.push_back(std::move(made));
    }
    const auto into_packet = [](auto way) { return [way](const bytes& m) { return way(m, packet); }; };
    const auto into_message = [](auto way) { return [way](const bytes& p) { return way(p, message); }; };
    const std::span messages{set.messages}, packets{set.packets};
    bench::pair(name + ", to packet", messages, into_packet(Table::forth), messages, into_packet(Table::forth_by_hand));
    bench::pair(name + ", to packet (500-byte look-up)", messages, into_packet(Table::forth), messages,
                into_packet(Table::forth_by_small_look_up));
    bench::pair(name + ", to message", packets, into_message(Table::back), packets, into_message(Table::back_by_hand));
    bench::pair(name + ", to packet (memcpy)", messages, into_packet(Table::forth), messages, into_packet(copy));
    bench::pair(name + ", to message (memcpy)", packets, into_message(Table::back), packets, into_message(copy));
    return agree;
}

template <class Table> bool add_sizes(const std::string& table) {
    static message_set sets[3];
    return add<Table>(table + ", no body", sets[0], 0) &&
           add<Table>(table + ", Set Wrench Effort's 20 bytes", sets[1], 20) &&
           add<Table>(table + ", largest body", sets[2], Table::translator::max_body);
}

} // namespace

bool bench::add_translate_benchmarks() {
    return add_sizes<seed>("seed table") && add_sizes<self_contained>("self-contained table");
}
