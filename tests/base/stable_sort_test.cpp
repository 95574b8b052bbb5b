#include "support/catch.hpp"
#include <jauscat/base/stable_sort.hpp>

#include <array>
#include <utility>
#include <vector>

namespace {

using pair = std::pair<int, char>;

constexpr bool sorts() {
    std::array<pair, 5> all{{{2, 'a'}, {1, 'b'}, {2, 'c'}, {0, 'd'}, {1, 'e'}}};
    jauscat::stable_sort(all, &pair::first);
    return all == std::array<pair, 5>{{{0, 'd'}, {1, 'b'}, {1, 'e'}, {2, 'a'}, {2, 'c'}}};
}

} // namespace

TEST_CASE("equal elements keep their order") {
    STATIC_REQUIRE(sorts());
    std::vector<pair> none;
    jauscat::stable_sort(none, &pair::first);
    CHECK(none.empty());
}
