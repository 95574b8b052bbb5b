// From reset to the board's loop: the vector table, initialised data, zeroed data. There are no constructors to run:
// the linker script refuses a program that has any.
#include <algorithm>
#include <array>
#include <cstdint>

// Placed by the linker script.
extern "C" {
extern std::uint32_t stack_top[], data_begin[], data_end[], data_image[], zero_begin[], zero_end[];
void on_jaus_byte() noexcept;
void on_millisecond() noexcept;
[[noreturn]] void run_board() noexcept;
}

extern "C" [[noreturn]] void on_reset() noexcept {
    std::copy(data_image, data_image + (data_end - data_begin), data_begin);
    std::fill(zero_begin, zero_end, 0u);
    run_board();
}

namespace {

[[noreturn]] void on_fault() noexcept {
    for (;;) {}
}

using handler = void (*)() noexcept;
struct vector_table {
    std::uint32_t* stack{};
    std::array<handler, 15> system{};
    std::array<handler, 1> device{};
};

// ARMv7-M and ARMv6-M, exception numbers 1 to 16.
[[gnu::section(".vectors"), gnu::used]] const vector_table vectors{
    .stack = stack_top,
    .system = {&on_reset, &on_fault, &on_fault, &on_fault, &on_fault, &on_fault, nullptr, nullptr, nullptr, nullptr,
               &on_fault, &on_fault, nullptr, &on_fault, &on_millisecond},
    .device = {&on_jaus_byte}};

} // namespace
