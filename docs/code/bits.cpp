// Step 3 of declare-a-message.md: several members in one integer.
#include <jauscat/text/annotate.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <iostream>

// [declare]
enum class grip_mode : std::uint8_t { idle = 0, opening = 1, closing = 2, holding = 3 };

struct report_gripper {
    grip_mode mode{};
    bool object_seen{};
    std::uint8_t temperature_class{}; ///< 0 to 7

    // clang-format off
    struct schema : jauscat::wire::items {
        using T = report_gripper;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::mode, 2>,              // the least significant bits
                bit_field<&T::object_seen, 1>,
                bit_field<&T::temperature_class, 3>,
                reserved<2>>>;
    };
    // clang-format on
};
// [declare end]

int main() {
    // [use]
    std::array<std::byte, 1> buffer{};
    const report_gripper report{.mode = grip_mode::holding, .object_seen = true, .temperature_class = 5};
    const auto encoded = jauscat::wire::encode(report, buffer);
    std::cout << jauscat::text::annotate<report_gripper>(*encoded);
    // [use end]
}
