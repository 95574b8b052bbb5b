// The golden wrench effort messages into the process image and back.
#include "image_samples.hpp"
#include "schema/vectors.hpp"

using namespace jauscat;
using namespace jauscat::test;

TEST_CASE("every golden Set Wrench Effort is translated to the image and back, byte for byte") {
    std::size_t seen = 0;
    image bytes{};
    wrench_effort_image expected{};
    for (const auto& vector : golden::vectors()) {
        if (vector.code != jaus::command_code_of<jaus::set_wrench_effort>) continue;
        const auto body = std::span{vector.bytes}.subspan(16);
        INFO("body " << to_hex(body));
        REQUIRE(command::to_image(body, bytes) == translate::errc::ok);
        ++seen;

        // The expectation comes from the vector's own names and numbers.
        expected.command_count = static_cast<std::uint16_t>(seen);
        expected.presence_vector =
            static_cast<std::uint16_t>(std::stoul(vector.object.at("presence_vector").get<std::string>(), nullptr, 16));
        std::size_t found = 0;
        wire::visit(expected, [&]<class Item>(Item item, auto& value) {
            for (const auto& [name, field] : vector.object.at("fields").items()) {
                if (golden::snake_case(name) != item.name()) continue;
                value = static_cast<typename Item::value_type>(field.at("raw").template get<int>());
                ++found;
            }
        });
        CHECK(found == vector.object.at("fields").size());
        CHECK(values_of(bytes) == expected);

        std::array<std::byte, 20> back{};
        const auto restored = command::from_image(bytes, back);
        REQUIRE(restored);
        CHECK(to_hex(*restored) == to_hex(body));
    }
    CHECK(seen > 2);
}

TEST_CASE("every golden Report Wrench Effort is restored from its image") {
    std::size_t seen = 0;
    for (const auto& vector : golden::vectors()) {
        if (vector.code != jaus::command_code_of<jaus::report_wrench_effort>) continue;
        const auto body = std::span{vector.bytes}.subspan(16);
        image bytes{};
        REQUIRE(report::to_image(body, bytes) == translate::errc::ok);
        std::array<std::byte, 20> back{};
        const auto restored = report::from_image(bytes, back);
        REQUIRE(restored);
        CHECK(to_hex(*restored) == to_hex(body));
        ++seen;
    }
    CHECK(seen > 2);
}
