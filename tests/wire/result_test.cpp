// The packed size and the error texts.
#include "both_ways.hpp"

#include <set>

using wire::errc;

TEST_CASE("a packed size takes four bytes") { STATIC_REQUIRE(sizeof(wire::packed_size<errc>) == 4); }

TEST_CASE("a packed size is a size or an error") {
    both_ways([] {
        const wire::packed_size<errc> size{std::size_t{0xFFFFFF}};
        return size && size.size() == 0xFFFFFF && size.error() == errc::ok;
    });
    both_ways([] {
        const wire::packed_size<errc> nothing{std::size_t{0}};
        return nothing && nothing.size() == 0;
    });
    both_ways([] {
        const wire::packed_size<errc> failed{errc::no_space};
        return !failed && failed.error() == errc::no_space && failed.size() == 0;
    });
}

TEST_CASE("another layer's errors fit into a packed size") {
    enum class other : std::uint8_t { ok, lost = 255 };
    const wire::packed_size<other> lost{other::lost};
    REQUIRE(!lost);
    REQUIRE(lost.error() == other::lost);
    REQUIRE(wire::packed_size<other>{std::size_t{3}}.size() == 3);
}

TEST_CASE("a packed size gives the bytes written") {
    both_ways([] {
        std::array<std::byte, 4> out{};
        const auto written = wire::packed_size<errc>{std::size_t{3}}.of(out);
        const auto none = wire::packed_size<errc>{errc::no_space}.of(out);
        return written && written->data() == out.data() && written->size() == 3 && !none &&
               none.error() == errc::no_space && none->empty();
    });
}

TEST_CASE("each codec error has a distinct text") {
    std::set<std::string_view> lines;
    for (unsigned code = 0; code <= static_cast<unsigned>(errc::unknown_presence_bit); ++code) {
        const auto line = wire::describe(static_cast<errc>(code));
        REQUIRE(!line.empty());
        REQUIRE(line != wire::describe(static_cast<errc>(0xFF)));
        REQUIRE(lines.insert(line).second);
    }
}
