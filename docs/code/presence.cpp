// Step 4 of declare-a-message.md: fields that may be absent.
#include <jauscat/text/annotate.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <iostream>

// [declare]
struct millimetres {
    static constexpr double min = 0, max = 200;
    static constexpr std::string_view unit = "mm";
};

struct newtons {
    static constexpr double min = 0, max = 500;
    static constexpr std::string_view unit = "N";
};

struct set_gripper {
    std::uint8_t finger{};
    std::optional<double> opening{}; ///< millimetres, 0 to 200
    std::optional<double> force{};   ///< newtons, 0 to 500

    // clang-format off
    struct schema : jauscat::wire::items {
        using T = set_gripper;
        using type = layout<
            field<&T::finger, u8>,
            presence<u8,
                field<&T::opening, scaled<u16le, millimetres>>, // bit 0
                field<&T::force, scaled<u16le, newtons>>>>;     // bit 1
    };
    // clang-format on
};
// [declare end]

int main() {
    // [use]
    std::array<std::byte, jauscat::wire::max_size<set_gripper>> buffer{};
    const auto bytes = jauscat::wire::encode(set_gripper{.finger = 1, .force = 120}, buffer);
    std::cout << jauscat::text::annotate<set_gripper>(*bytes);

    // A view reads one field out of the bytes, without decoding the others.
    const jauscat::wire::view<set_gripper> view{*bytes};
    if (!view) return std::cerr << describe(view.error()) << '\n', 1;
    std::cout << "opening " << (view.get<&set_gripper::opening>() ? "commanded" : "left as it is") << ", force "
              << view.get<&set_gripper::force>().value_or(0) << " N\n";
    // [use end]
}
