// Step 5 of declare-a-message.md: any number of elements.
#include <jauscat/text/annotate.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <iostream>

// [declare]
struct newtons {
    static constexpr double min = 0, max = 500;
    static constexpr std::string_view unit = "N";
};

struct grasp {
    std::uint8_t object{}; ///< number of the object
    std::uint16_t milliseconds{};
    friend constexpr bool operator==(const grasp&, const grasp&) = default;

    // clang-format off
    struct schema : jauscat::wire::items {
        using T = grasp;
        using type = layout<
            field<&T::object, u8>,
            field<&T::milliseconds, u16le>>;
    };
    // clang-format on
};

struct report_gripper {
    jauscat::wire::inline_list<double, 4> force{}; ///< newtons, of each finger; held in the message
    jauscat::wire::list<grasp> history{};          ///< held in memory of the caller

    // clang-format off
    struct schema : jauscat::wire::items {
        using T = report_gripper;
        using type = layout<
            repeated<&T::force, count<"number_of_fingers", u8>, element<"force", scaled<u8, newtons>>>,
            repeated<&T::history, count<"number_of_grasps", u8>>>;
    };
    // clang-format on
};
// [declare end]

int main() {
    // [use]
    const std::array<grasp, 2> grasps{grasp{.object = 7, .milliseconds = 850}, {.object = 9, .milliseconds = 1200}};
    std::array<std::byte, 32> buffer{};
    const auto bytes = jauscat::wire::encode(report_gripper{.force = {100, 250}, .history = grasps}, buffer);
    std::cout << jauscat::text::annotate<report_gripper>(*bytes);

    // The list's elements are decoded into memory of the caller, which must outlive the message.
    std::array<std::byte, 256> memory{};
    jauscat::wire::arena arena{memory};
    report_gripper received{};
    if (const auto used = jauscat::wire::decode(received, *bytes, arena); !used)
        return std::cerr << describe(used.error()) << '\n', 1;
    for (const grasp& each : received.history)
        std::cout << "object " << int{each.object} << ": " << each.milliseconds << " ms\n";
    // [use end]
}
