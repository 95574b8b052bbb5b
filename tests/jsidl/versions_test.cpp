// Versions 1.0 and 1.1 of core and mobility side by side: a decoder is told which of them a peer speaks.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include <jauscat/schema/sae/versions.hpp>
#include <jauscat/wire/wire.hpp>

namespace sae = jauscat::sae;
namespace wire = jauscat::wire;
using sae::service_version;

namespace {

struct vector_seen {
    bool has_speed{};
    bool has_z{};
    std::size_t size{};
};

/// SetLocalVector of a peer; empty where the bytes are none.
std::optional<vector_seen> decode(service_version version, std::string_view hex) {
    const auto bytes = jauscat::test::from_hex(hex);
    std::optional<vector_seen> seen;
    const bool is_known = sae::with_message(sae::mobility::messages{}, version, 0x0408, [&]<class Message>() {
        if constexpr (requires(Message value) { value.speed, value.z, value.heading; }) {
            Message value{};
            const auto used = wire::decode(value, bytes);
            if (!used) return;
            seen = {.has_speed = true, .has_z = value.z.has_value(), .size = *used};
            if constexpr (requires { value.speed.has_value(); }) seen->has_speed = value.speed.has_value();
        }
    });
    CHECK(is_known);
    return seen;
}

} // namespace

TEST_CASE("bit 0 of SetLocalVector is the speed in version 1.0, and the altitude in 1.1") {
    const auto old_peer = decode(service_version::v1_0, "0804 01 ffff");
    REQUIRE(old_peer);
    CHECK(old_peer->has_speed);
    CHECK_FALSE(old_peer->has_z);
    CHECK_FALSE(decode(service_version::v1_1, "0804 01 ffff")); // four bytes of altitude are missing
    const auto new_peer = decode(service_version::v1_1, "0804 01 ffff 00000000");
    REQUIRE(new_peer);
    CHECK(new_peer->has_z);
    const auto nothing = decode(service_version::v1_0, "0804 00");
    REQUIRE(nothing);
    CHECK_FALSE(nothing->has_speed);
}

TEST_CASE("version 1.0 of core lacks lists, command events, event timeouts and service lists") {
    for (const int each : {0x041A, 0x441C, 0x2B04, 0x4B04, 0x01F6, 0x21F2, 0x41F2, 0x41F6}) {
        const auto code = static_cast<std::uint16_t>(each);
        INFO(code);
        CHECK_FALSE(sae::with_message(sae::core::messages{}, service_version::v1_0, code, []<class>() {}));
        CHECK(sae::with_message(sae::core::messages{}, service_version::v1_1, code, []<class>() {}));
    }
    CHECK(sae::with_message(sae::core::messages{}, service_version::v1_0, 0x2002,
                            []<class Message>() { CHECK(std::is_same_v<Message, sae::core::query_status>); }));
    CHECK_FALSE(sae::with_message(sae::core::messages{}, service_version::v1_1, 0x9999, []<class>() {}));
}
