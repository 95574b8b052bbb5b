// firmware.md: JAUS messages from a serial line, in the integers of the wire. Nothing here is allocated, thrown, or
// computed in floating point.
//     docs_uart
// [includes]
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/jaus/message/stream_framer.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/wire/raw.hpp>

#include <array>
#include <cstdio>

using namespace std::chrono_literals;
namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
// [includes end]

// The board's part of it. Here it prints.
void send(std::span<const std::byte> bytes) { std::printf("sends %zu bytes\n", bytes.size()); }
void set_motor(std::int16_t effort) { std::printf("motor at %d of 32767\n", effort); }

// [node]
using command = wire::raw<jaus::set_wrench_effort>; // optional integers instead of optional doubles

constinit std::array<std::byte, jaus::header_size + 64> message_buffer{}; // for the longest accepted message
constinit jaus::stream_framer framer{message_buffer, 20ms};               // 20 ms of silence end an incomplete message

void on_message(std::span<const std::byte> bytes) {
    const auto message = jaus::split(bytes);
    if (!message) return;
    jaus::dispatcher handlers{jaus::on<command>([](const jaus::header&, const command& commanded) {
        if (const auto effort = commanded.get<&jaus::set_wrench_effort::propulsive_linear_effort_x>())
            set_motor(*effort);
    })};
    const bool done = handlers(message.header, message.body) == jaus::dispatched::handled;
    if (message.header.ack_nak != jaus::ack_nak::request) return;
    std::array<std::byte, jaus::header_size> answer{};
    const auto how = done ? jaus::ack_nak::ack : jaus::ack_nak::nak;
    if (const auto made = jaus::make_acknowledgement(message.header, how, answer)) send(answer);
}

/// Called by the main loop with the received bytes, and every few milliseconds without any.
void on_bytes(std::span<const std::byte> bytes, jauscat::time_point now) { framer.on_bytes(bytes, now, on_message); }
// [node end]

int main() {
    // Noise, then a Set Wrench Effort that asks for an acknowledgement, in two parts.
    constexpr std::array<unsigned char, 23> line{0xff, 0x00, 0x37, 0x16, 0x02, 0x05, 0x04, 1,    33,   2,    2,   1,
                                                 32,   1,    1,    4,    0x00, 0x22, 0x00, 0x01, 0x00, 0x00, 0x40};
    const auto bytes = std::as_bytes(std::span{line});
    on_bytes(bytes.first(9), jauscat::time_point{0ms});
    on_bytes(bytes.subspan(9), jauscat::time_point{1ms});
}
