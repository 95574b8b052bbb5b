// Encode and decode of JAUS messages against code written by hand.
#include "hand_written.hpp"
#include "pair.hpp"
#include "support/random_message.hpp"
#include <jauscat/wire/wire.hpp>

#include <limits>
#include <vector>

namespace {

namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;

/// Many more than a branch predictor learns by heart.
constexpr std::size_t item_count = 4096;

/// The bytes of a message and their number.
template <std::size_t Size> struct packet {
    std::array<std::byte, Size> bytes{};
    std::size_t size{};
    [[nodiscard]] std::span<const std::byte> span() const noexcept { return std::span{bytes}.first(size); }
    friend bool operator==(const packet&, const packet&) = default;
};

// One call into either side. Out of line: a caller in another file sees no more.
template <class Message, std::size_t Size>
[[gnu::noinline]] std::size_t jauscat_encode(const Message& message, std::array<std::byte, Size>& out) {
    return wire::encode(message, out)->size();
}
template <class Message> [[gnu::noinline]] std::size_t jauscat_decode(Message& message, std::span<const std::byte> in) {
    return *wire::decode(message, in);
}
template <class Message, std::size_t Size>
[[gnu::noinline]] std::size_t hand_written_encode(const Message& message, std::array<std::byte, Size>& out) {
    return hand_written::encode(message, out);
}
template <class Message>
[[gnu::noinline]] std::size_t hand_written_decode(Message& message, std::span<const std::byte> in) {
    return hand_written::decode(message, in);
}

/// Both sides' form of the messages of one pair of benchmarks, and their bytes. Kept for the whole run.
template <class Ours, class Theirs> struct data_set {
    static constexpr std::size_t size = wire::max_size<Ours>;
    std::vector<Ours> ours{};
    std::vector<Theirs> theirs{};
    std::vector<packet<size>> packets{};
};

/// Adds encode and decode of random messages. False when one side writes or reads other than the other does.
template <class T, class Ours, class Theirs> bool add(const std::string& name, double present) {
    static data_set<Ours, Theirs> sets[2]; // messages with all fields, and with some
    auto& set = sets[present < 1];
    support::generator random{1};
    bool agree = true;
    for (std::size_t i = 0; i != item_count; ++i) {
        packet<data_set<Ours, Theirs>::size> packet{}, again{};
        packet.size = wire::encode(support::random_message<T>(random, {.present = present}), packet.bytes)->size();
        Ours ours{};
        Theirs theirs{};
        agree = agree && jauscat_decode(ours, packet.span()) == packet.size;
        agree = agree && hand_written_decode(theirs, packet.span()) == packet.size;
        if constexpr (std::is_same_v<Ours, Theirs>) agree = agree && ours == theirs;
        again.size = hand_written_encode(theirs, again.bytes);
        agree = agree && again == packet;
        agree = agree && jauscat_encode(ours, again.bytes) == packet.size && again == packet;
        set.ours.push_back(ours);
        set.theirs.push_back(theirs);
        set.packets.push_back(packet);
    }
    static std::array<std::byte, data_set<Ours, Theirs>::size> out;
    static Ours our_value;
    static Theirs their_value;
    bench::pair(
        name + ", encode", std::span{set.ours}, [](const Ours& message) { return jauscat_encode(message, out); },
        std::span{set.theirs}, [](const Theirs& message) { return hand_written_encode(message, out); });
    bench::pair(
        name + ", decode", std::span{set.packets}, [](const auto& p) { return jauscat_decode(our_value, p.span()); },
        std::span{set.packets}, [](const auto& p) { return hand_written_decode(their_value, p.span()); });
    return agree;
}

/// Both sides take and refuse the same messages.
bool refuse_alike() {
    constexpr auto nan = std::numeric_limits<double>::quiet_NaN();
    std::array<std::byte, 30> out{};
    const auto encode_alike = [&out](const auto& message) {
        return wire::encode(message, out)->size() == 0 && hand_written::encode(message, out) == 0;
    };
    const auto decode_alike = [](auto message, std::initializer_list<int> values, std::size_t taken = 0) {
        std::vector<std::byte> in;
        for (const int value : values) in.push_back(static_cast<std::byte>(value));
        return *wire::decode(message, in) == taken && hand_written::decode(message, in) == taken;
    };
    using effort = jaus::set_wrench_effort;
    return encode_alike(effort{.propulsive_linear_effort_x = 100.1}) &&
           encode_alike(effort{.propulsive_rotational_effort_z = nan}) &&
           encode_alike(effort{.resistive_linear_effort_x = -0.1}) &&
           encode_alike(jaus::report_global_pose{.latitude = 90.1}) &&
           encode_alike(jaus::report_global_pose{.time_stamp = jaus::time_stamp{.seconds = 64}}) &&
           encode_alike(jaus::header{.priority = 16}) && encode_alike(jaus::header{.data_size = 4096}) &&
           decode_alike(effort{}, {0}) && decode_alike(effort{}, {1, 0, 0}) && decode_alike(effort{}, {0, 0, 0}) &&
           decode_alike(effort{}, {0, 0x10}, 2) && decode_alike(effort{}, {1, 0, 0, 0x80}) &&
           decode_alike(jaus::report_global_pose{}, {1, 0, 0, 0, 0, 0x80}) &&
           decode_alike(jaus::report_global_pose{}, {0, 0, 0}) && decode_alike(jaus::header{}, {0, 0, 0});
}

} // namespace

bool bench::add_codec_benchmarks() {
    using effort = jaus::set_wrench_effort;
    using pose = jaus::report_global_pose;
    bool agree = refuse_alike();
    agree &= add<effort, effort, effort>("Set Wrench Effort, all fields", 1);
    agree &= add<effort, effort, effort>("Set Wrench Effort, half the fields", 0.5);
    agree &= add<effort, wire::raw<effort>, hand_written::raw_wrench_effort>("Set Wrench Effort raw, all fields", 1);
    agree &= add<effort, wire::raw<effort>, hand_written::raw_wrench_effort>("Set Wrench Effort raw, half", 0.5);
    agree &= add<pose, pose, pose>("Report Global Pose, all fields", 1);
    agree &= add<pose, pose, pose>("Report Global Pose, half the fields", 0.5);
    agree &= add<jaus::header, jaus::header, jaus::header>("header", 1);
    return agree;
}
