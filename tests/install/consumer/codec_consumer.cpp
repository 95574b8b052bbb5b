// The example of the README, as a program of its own.
#include <jauscat/wire/wire.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

struct gripper {
    double force{};
    std::optional<std::uint8_t> finger{};
};
struct newton {
    static constexpr double min = 0, max = 500;
    static constexpr std::string_view unit = "N";
};

template <> struct jauscat::wire::schema<gripper> {
    using T = gripper;
    using type = layout<field<&T::force, scaled<u16le, newton>>, presence<u8, field<&T::finger, u8>>>;
};

int main() {
    std::array<std::byte, 8> buffer{};
    const auto encoded = jauscat::wire::encode(gripper{.force = 500, .finger = 2}, buffer);
    gripper received{};
    const auto used = jauscat::wire::decode(received, *encoded);
    return used && encoded->size() == 4 && received.force == 500 && received.finger == 2 ? 0 : 1;
}
