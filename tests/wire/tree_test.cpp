// Trees as flat lists, depth first.
#include "list_checks.hpp"

using samples::forest;
using samples::node;

namespace {

// 1 - 2 - 3
//   - 4
constexpr std::array<node, 4> four{{{1, 2}, {2, 1}, {3, 0}, {4, 0}}};
constexpr auto four_bytes = bytes(1, 2, 2, 1, 3, 0, 4, 0, 9);
constexpr std::array<node, 1> root{{{1, 0}}};

} // namespace

TEST_CASE("the nodes of a tree are encoded depth first") {
    both_ways([] { return encodes_to(forest{.tree = four, .tail = 9}, four_bytes); });
    require_coding(forest{.tree = four, .tail = 9}, four_bytes);
    require_coding(forest{.tree = root, .tail = 9}, bytes(1, 0, 9));
    require_exact_length<forest>(four_bytes);
}

TEST_CASE("inconsistent numbers of children do not encode") {
    both_ways([] { return encode_error(forest{}) == errc::count_mismatch; });
    both_ways([] {
        constexpr std::array<node, 1> childless{{{1, 1}}};
        return encode_error(forest{.tree = childless}) == errc::count_mismatch;
    });
    both_ways([] {
        constexpr std::array<node, 2> two_roots{{{1, 0}, {2, 0}}};
        return encode_error(forest{.tree = two_roots}) == errc::count_mismatch;
    });
    constexpr std::array<node, 2> two_roots{{{1, 0}, {2, 0}}};
    const auto why = wire::diagnose(forest{.tree = two_roots});
    CHECK(why.parent() == wire::diagnosis_step{.name = "tree", .element = 1});
}

TEST_CASE("a tree with more levels than its layout allows is too deep") {
    constexpr std::array<node, 4> deep{{{1, 1}, {2, 1}, {3, 1}, {4, 0}}};
    CHECK(encode_error(forest{.tree = deep}) == errc::too_deep);
    constexpr auto in = bytes(1, 1, 2, 1, 3, 1, 4, 0, 9);
    CHECK(decode_error_in_arena<forest>(in) == errc::too_deep);
    const auto why = wire::diagnose<forest>(in);
    CHECK(why.parent() == wire::diagnosis_step{.name = "tree", .element = 3});
}

TEST_CASE("a tree is decoded into the arena") {
    wire::arena none{{}};
    forest found{};
    CHECK(wire::decode(found, four_bytes, none).error() == errc::arena_full);
}

TEST_CASE("a view iterates over the nodes") {
    both_ways([] {
        const wire::view<forest> view{four_bytes};
        std::uint32_t ids = 0;
        for (const auto each : view.get<&forest::tree>()) ids = ids * 10 + each.get<&node::id>();
        return view && view.get<&forest::tree>().size() == 4 && ids == 1234 && view.get<&forest::tail>() == 9;
    });
}

TEST_CASE("a walk has its depth and its end") {
    both_ways([] {
        wire::tree_walk<2> walk;
        const bool first = walk.depth() == 0 && walk.pass(2) && walk.depth() == 1;
        const bool second = walk.pass(0) && !walk.complete() && walk.pass(0) && walk.complete();
        wire::tree_walk<1> flat;
        return first && second && flat.pass(1) && !flat.pass(0);
    });
}
