#include "support/catch.hpp"
#include <jauscat/base/result.hpp>

#include <memory>
#include <string>

namespace {

using jauscat::result;

enum class errc { ok, empty };
struct read_error {
    errc code{};
    int at{};
    friend constexpr bool operator==(const read_error&, const read_error&) = default;
};

} // namespace

TEST_CASE("a result holds a value or an error") {
    constexpr result<int, read_error> seven{7};
    STATIC_REQUIRE(seven);
    STATIC_REQUIRE(*seven == 7);
    STATIC_REQUIRE(seven.error() == read_error{});

    constexpr result<int, read_error> none{read_error{errc::empty, 3}};
    STATIC_REQUIRE(!none);
    STATIC_REQUIRE(none.error().code == errc::empty);
    STATIC_REQUIRE(none.error().at == 3);
    STATIC_REQUIRE(none.value_or(5) == 5);
    STATIC_REQUIRE(seven.value_or(5) == 7);
    STATIC_REQUIRE(seven != none);

    STATIC_REQUIRE(result<int, errc>{7, errc::ok} == result<int, errc>{7});
    STATIC_REQUIRE(result<int, errc>{7, errc::empty}.error() == errc::empty);
}

TEST_CASE("a result without a value holds success or an error") {
    constexpr result<void, errc> done;
    STATIC_REQUIRE(done);
    STATIC_REQUIRE(done.error() == errc::ok);
    STATIC_REQUIRE(!result<void, errc>{errc::empty});
}

TEST_CASE("the value of a result can be moved out") {
    result<std::unique_ptr<std::string>, errc> text{std::make_unique<std::string>("abc")};
    REQUIRE(text);
    CHECK(text->get()->size() == 3);
    const auto taken = *std::move(text);
    CHECK(*taken == "abc");
}
