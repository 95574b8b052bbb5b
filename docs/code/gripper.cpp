// The sample of the README: a message of one's own, encoded and decoded.
//     docs_gripper
#include <jauscat/text/hex.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <cstdint>
#include <iostream>
#include <optional>
#include <span>
#include <string_view>

// clang-format off
struct newton {
    static constexpr double min = 0, max = 500;
    static constexpr std::string_view unit = "N";
};

struct gripper {
    double force{};
    std::optional<std::uint8_t> finger{};

    struct schema : jauscat::wire::items {
        using type = layout<
            field<&gripper::force, scaled<u16le, newton>>,
            presence<u8, field<&gripper::finger, u8>>>;
    };
};
// clang-format on

int main() {
    std::array<std::byte, 8> buffer{};
    // The bytes, or an error.
    const auto bytes = jauscat::wire::encode(gripper{.force = 120, .finger = 2}, buffer);
    gripper received{};
    if (!jauscat::wire::decode(received, *bytes)) return 1;
    // 70 3d 01 02: 119.997 N
    std::cout << jauscat::text::hex(*bytes) << ": " << received.force << " N\n";
}
