// Step 1 of declare-a-message.md: whole numbers.
// [includes]
#include <jauscat/text/annotate.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <iostream>

// [includes end]

// [declare]
/// The report of a gripper.
struct report_gripper {
    std::uint8_t finger{};   ///< 1 is the first
    std::uint32_t strokes{}; ///< in its lifetime

    struct schema : jauscat::wire::items {
        using T = report_gripper;
        using type = layout<field<&T::finger, u8>, field<&T::strokes, u32le>>;
    };
};
// [declare end]

static_assert(jauscat::wire::max_size<report_gripper> == 5);

int main() {
    // [use]
    std::array<std::byte, jauscat::wire::max_size<report_gripper>> buffer{}; // 5 bytes: no padding on the wire
    const auto bytes = jauscat::wire::encode(report_gripper{.finger = 2, .strokes = 70000}, buffer);
    if (!bytes) return std::cerr << describe(bytes.error()) << '\n', 1;

    report_gripper received{};
    if (const auto used = jauscat::wire::decode(received, *bytes); !used)
        return std::cerr << describe(used.error()) << '\n', 1;

    std::cout << jauscat::text::annotate<report_gripper>(*bytes);
    // [use end]
    return received.strokes == 70000 ? 0 : 1;
}
