// The board: an ARM MPS2 with the AN385 image (Cortex-M3, 25 MHz). Two serial lines, a millisecond clock, and the loop
// that feeds the node. ARM DAI 0385; CMSDK APB UART: ARM DDI 0479.
#include "node.hpp"

#include <array>
#include <cstdint>

namespace {

struct uart_registers {
    volatile std::uint32_t data, state, control, interrupts, baud_divider;
};
struct systick_registers {
    volatile std::uint32_t control, reload, current;
};

constexpr std::uint32_t transmitter_full = 1;                                         // state
constexpr std::uint32_t transmit_enable = 1, receive_enable = 2, receive_signals = 8; // control
constexpr std::uint32_t receive_interrupt = 2; // interrupts, cleared by writing 1
constexpr std::uint32_t clock_hz = 25'000'000, baud_rate = 115'200;

// NVIC: writing a bit turns an interrupt on or off. Bit 0 is the receiver of the first line.
volatile std::uint32_t& interrupts_on() noexcept { return *reinterpret_cast<volatile std::uint32_t*>(0xE000'E100); }
volatile std::uint32_t& interrupts_off() noexcept { return *reinterpret_cast<volatile std::uint32_t*>(0xE000'E180); }
constexpr std::uint32_t jaus_receiver = 1;

uart_registers& uart(firmware::line which) noexcept {
    return *reinterpret_cast<uart_registers*>(which == firmware::line::jaus ? 0x4000'4000 : 0x4000'5000);
}

// Shared by the interrupt handlers and the loop. The counts say how many bytes have gone in and out of the ring so far.
volatile std::uint32_t milliseconds, received_count, taken_count;
std::array<volatile std::byte, 256> ring;

jauscat::time_point now() noexcept { return jauscat::time_point{std::chrono::milliseconds{milliseconds}}; }

/// Moves what has arrived since the last call into `out`.
std::span<const std::byte> take_received(std::span<std::byte> out) noexcept {
    std::size_t size = 0;
    while (taken_count != received_count && size != out.size()) {
        out[size++] = ring[taken_count % ring.size()];
        taken_count = taken_count + 1;
    }
    interrupts_on() = jaus_receiver;
    return out.first(size);
}

void start() noexcept {
    for (const auto which : {firmware::line::jaus, firmware::line::card}) {
        uart(which).baud_divider = clock_hz / baud_rate;
        uart(which).control = transmit_enable;
    }
    uart(firmware::line::jaus).control = transmit_enable | receive_enable | receive_signals;
    interrupts_on() = jaus_receiver;
    auto& clock = *reinterpret_cast<systick_registers*>(0xE000'E010);
    clock.reload = clock_hz / 1000 - 1;
    clock.current = 0;
    clock.control = 7; // processor clock, interrupt, on
}

} // namespace

void firmware::send(line to, std::span<const std::byte> bytes) noexcept {
    for (const std::byte byte : bytes) {
        while ((uart(to).state & transmitter_full) != 0) {}
        uart(to).data = static_cast<std::uint32_t>(byte);
    }
}

// A byte that does not fit the ring remains in the receiver until the loop has read the ring and enables interrupts
// again.
extern "C" void on_jaus_byte() noexcept {
    if (received_count - taken_count == ring.size()) {
        interrupts_off() = jaus_receiver;
        return;
    }
    auto& line = uart(firmware::line::jaus);
    line.interrupts = receive_interrupt;
    ring[received_count % ring.size()] = static_cast<std::byte>(line.data);
    received_count = received_count + 1;
}

extern "C" void on_millisecond() noexcept { milliseconds = milliseconds + 1; }

extern "C" [[noreturn]] void run_board() noexcept {
    start();
    for (;;) {
        std::array<std::byte, 32> buffer;
        if (const auto bytes = take_received(buffer); !bytes.empty()) {
            firmware::on_bytes(bytes, now());
        } else {
            firmware::on_time(now());
            asm volatile("wfi"); // until an interrupt: a byte, or the next millisecond
        }
    }
}
