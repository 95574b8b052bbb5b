// The core set of SAE in the forms that a catalogue does not have: raw integers and views.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/paths.hpp"
#include <jauscat/schema/sae/core.hpp>
#include <jauscat/schema/sae/message_id.hpp>
#include <jauscat/wire/wire.hpp>

#include <fstream>
#include <nlohmann/json.hpp>

namespace {

namespace jaus = jauscat::jaus;
namespace sae = jauscat::sae;
namespace wire = jauscat::wire;
using jauscat::test::to_hex;
using payload = std::vector<std::byte>;

/// Decodes to raw integers, encodes them again, and has a view of each size.
template <wire::message T> void check_raw_and_view(const payload& bytes) {
    std::vector<std::byte> lists(4096 + 16 * bytes.size());
    wire::arena memory{lists};
    wire::raw<T> raw{};
    REQUIRE(wire::decode(raw, bytes, memory));
    payload again(wire::encoded_size(raw));
    REQUIRE(wire::encode(raw, again));
    REQUIRE(to_hex(again) == to_hex(bytes));
    REQUIRE(wire::view<T>{bytes}.error() == wire::errc::ok);
    for (std::size_t size = 0; size != bytes.size(); ++size)
        REQUIRE(wire::view<T>{std::span{bytes}.first(size)}.error() != wire::errc::ok);
}

template <class... Messages> bool check(const payload& bytes, jaus::message_list<Messages...>) {
    const auto id = sae::message_id_of(bytes);
    return (... || (Messages::schema::message_id == id && (check_raw_and_view<Messages>(bytes), true)));
}

} // namespace

TEST_CASE("every golden message of the core set comes back as raw integers, and has a view") {
    std::size_t count = 0;
    std::ifstream file{support::test_data("sae_vectors.jsonl")};
    for (std::string line; std::getline(file, line);) {
        const auto vector = nlohmann::json::parse(line);
        if (!vector.at("service").get<std::string>().starts_with("urn:jaus:jss:core:")) continue;
        const auto hex = vector.at("hex").get<std::string>();
        INFO(vector.at("message").get<std::string>() << ' ' << hex);
        REQUIRE(check(jauscat::test::from_hex(hex), sae::core::messages{}));
        ++count;
    }
    CHECK(count == 182);
}
