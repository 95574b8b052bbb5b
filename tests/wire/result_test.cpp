// The result type and the error texts.
#include "both_ways.hpp"

#include <set>

using wire::errc;

TEST_CASE("a result takes four bytes") { STATIC_REQUIRE(sizeof(wire::result) == 4); }

TEST_CASE("a result carries a size or an error") {
    both_ways([] {
        const wire::result size{std::size_t{0xFFFFFF}};
        return size && size.size() == 0xFFFFFF && size.error() == errc::ok;
    });
    both_ways([] {
        const wire::result nothing{std::size_t{0}};
        return nothing && nothing.size() == 0;
    });
    both_ways([] {
        const wire::result failed{errc::no_space};
        return !failed && failed.error() == errc::no_space && failed.size() == 0;
    });
}

TEST_CASE("another layer's errors fit into a result of its own") {
    enum class other : std::uint8_t { ok, lost = 255 };
    const wire::basic_result<other> lost{other::lost};
    REQUIRE(!lost);
    REQUIRE(lost.error() == other::lost);
    REQUIRE(wire::basic_result<other>{std::size_t{3}}.size() == 3);
}

TEST_CASE("each error has a line of text of its own") {
    std::set<std::string_view> lines;
    for (unsigned code = 0; code <= static_cast<unsigned>(errc::unknown_presence_bit); ++code) {
        const auto line = wire::describe(static_cast<errc>(code));
        REQUIRE(!line.empty());
        REQUIRE(line != wire::describe(static_cast<errc>(0xFF)));
        REQUIRE(lines.insert(line).second);
    }
}
