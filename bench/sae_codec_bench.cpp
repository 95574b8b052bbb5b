// Encode and decode of SAE messages against code written by hand.
#include "hand_written_sae.hpp"
#include "pair.hpp"
#include "support/random_message.hpp"
#include <jauscat/wire/wire.hpp>

#include <memory_resource>

namespace {

namespace wire = jauscat::wire;
using bytes = std::vector<std::byte>;

std::array<std::byte, 65536> out;
std::array<std::byte, 65536> lists;

template <class Message> [[gnu::noinline]] std::size_t jauscat_encode(const Message& message, std::span<std::byte> to) {
    return wire::encode(message, to)->size();
}
template <class Message>
[[gnu::noinline]] std::size_t jauscat_decode(Message& message, std::span<const std::byte> in, wire::arena& memory) {
    if constexpr (wire::needs_memory<Message>)
        return *wire::decode(message, in, memory);
    else
        return *wire::decode(message, in);
}
template <class Message>
[[gnu::noinline]] std::size_t hand_written_encode(const Message& message, std::span<std::byte> to) {
    return hand_written::by_sae::encode(message, to);
}
template <class Message>
[[gnu::noinline]] std::size_t hand_written_decode(Message& message, std::span<const std::byte> in,
                                                  wire::arena& memory) {
    return hand_written::by_sae::decode(message, in, memory);
}

/// Adds both directions for random messages. False when the sides differ.
template <class Message> bool add(const std::string& name, double present = 1) {
    constexpr std::size_t item_count = 1024;
    static std::pmr::monotonic_buffer_resource elements;
    static std::vector<Message> messages;
    static std::vector<bytes> encoded;
    static Message value;
    support::generator random{1};
    bool agree = true;
    for (std::size_t i = 0; i != item_count; ++i) {
        messages.push_back(support::random_message<Message>(random, elements, {.present = present, .exact = true}));
        const Message& message = messages.back();
        const auto size = jauscat_encode(message, out);
        encoded.emplace_back(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size));
        agree = agree && size != 0 && hand_written_encode(message, out) == size &&
                std::equal(encoded.back().begin(), encoded.back().end(), out.begin());
        for (const auto way : {jauscat_decode<Message>, hand_written_decode<Message>}) {
            wire::arena memory{lists};
            Message read{};
            agree = agree && way(read, encoded.back(), memory) == size && read == message;
        }
    }
    const auto encoding = [](auto way) { return [way](const Message& message) { return way(message, out); }; };
    const auto decoding = [](auto way) {
        return [way](const bytes& in) {
            wire::arena memory{lists};
            return way(value, in, memory);
        };
    };
    bench::pair(name + ", encode", std::span{messages}, encoding(jauscat_encode<Message>), std::span{messages},
                encoding(hand_written_encode<Message>));
    bench::pair(name + ", decode", std::span{encoded}, decoding(jauscat_decode<Message>), std::span{encoded},
                decoding(hand_written_decode<Message>));
    if (!agree) std::fprintf(stderr, "%s:\n", name.c_str());
    return agree;
}

} // namespace

bool bench::add_sae_codec_benchmarks() {
    using namespace jauscat::sae;
    return add<core::report_status>("SAE Report Status, plain") &&
           add<mobility::set_wrench_effort>("SAE Set Wrench Effort, presence vector", 0.5) &&
           add<core::query_services>("SAE Query Services, list of lists") &&
           add<core::query_events>("SAE Query Events, variant") &&
           add<manipulator::report_joint_force_torques>("SAE Report Joint Force Torques, selected numbers") &&
           add<environment_sensing::image_frame>("SAE Image Frame, blob");
}
