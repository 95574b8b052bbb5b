// Step 2 of declare-a-message.md: real values in integers.
#include <jauscat/text/annotate.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <iostream>

// [declare]
struct millimetres {
    static constexpr double min = 0, max = 200;
    static constexpr std::string_view unit = "mm";
};

struct report_gripper {
    std::uint8_t finger{};
    double opening{}; ///< millimetres, 0 to 200

    struct schema : jauscat::wire::items {
        using T = report_gripper;
        using type = layout<field<&T::finger, u8>, field<&T::opening, scaled<u16le, millimetres>>>;
    };
};
// [declare end]

int main() {
    // [use]
    std::array<std::byte, 3> buffer{};
    report_gripper report{.finger = 2, .opening = 80};
    auto encoded = jauscat::wire::encode(report, buffer);
    std::cout << jauscat::text::annotate<report_gripper>(*encoded);

    report.opening = 250; // refused: values are not limited silently
    encoded = jauscat::wire::encode(report, buffer);
    std::cout << "250 mm: " << describe(encoded.error()) << '\n';

    jauscat::wire::clamp(report); // limits all values to their ranges
    encoded = jauscat::wire::encode(report, buffer);
    std::cout << "clamped: " << report.opening << " mm, " << describe(encoded.error()) << '\n';
    // [use end]
}
