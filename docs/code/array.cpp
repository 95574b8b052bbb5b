// Step 5 of declare-a-message.md: a fixed number of elements.
#include <jauscat/text/annotate.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <iostream>

// [declare]
struct newtons {
    static constexpr double min = 0, max = 500;
    static constexpr std::string_view unit = "N";
};

struct joint {
    std::int16_t position{};
    std::uint8_t temperature{};

    // clang-format off
    struct schema : jauscat::wire::items {
        using T = joint;
        using type = layout<
            field<&T::position, i16le>,
            field<&T::temperature, u8>>;
    };
    // clang-format on
};

struct report_gripper {
    std::array<double, 3> force{};               ///< newtons, of each finger
    std::optional<std::array<joint, 2>> wrist{}; ///< records

    // clang-format off
    struct schema : jauscat::wire::items {
        using T = report_gripper;
        using type = layout<
            array<&T::force, scaled<u8, newtons>>,
            presence<u8, array<&T::wrist>>>;
    };
    // clang-format on
};
// [declare end]

int main() {
    // [use]
    std::array<std::byte, jauscat::wire::max_size<report_gripper>> buffer{};
    const report_gripper report{.force = {100, 250, 0}, .wrist = std::array{joint{-90, 31}, joint{45, 33}}};
    const auto written = jauscat::wire::encode(report, buffer);
    if (!written) return std::cerr << describe(written.error()) << '\n', 1;
    std::cout << jauscat::text::annotate<report_gripper>(*written);

    const jauscat::wire::view<report_gripper> view{*written};
    if (!view) return std::cerr << describe(view.error()) << '\n', 1;
    const auto force = view.get<&report_gripper::force>(); // empty if a raw value is not legal
    const auto wrist = view.get<&report_gripper::wrist>(); // empty if it is absent
    if (force && wrist)
        std::cout << "finger 2: " << (*force)[1] << " N, second joint: " << (*wrist)[1].get<&joint::position>() << '\n';
    // [use end]
}
