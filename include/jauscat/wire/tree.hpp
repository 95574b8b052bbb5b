// A tree as a flat list, depth first: each node has its number of children.
#pragma once
#include <jauscat/wire/list.hpp>
#include <jauscat/wire/nested.hpp>

namespace jauscat::wire {

/// Depth of a depth-first walk over nodes; `MaxDepth` levels, the root's included.
template <std::size_t MaxDepth> class tree_walk {
  public:
    /// Called for a node with `children`. False if it is deeper than allowed.
    [[nodiscard]] constexpr bool pass(std::size_t children) noexcept {
        if (depth_ == MaxDepth) return false;
        open_[depth_++] = children;
        while (depth_ != 0 && open_[depth_ - 1] == 0) --depth_;
        if (depth_ != 0) --open_[depth_ - 1];
        return true;
    }
    /// All children that were announced have been passed.
    [[nodiscard]] constexpr bool complete() const noexcept { return depth_ == 0; }
    /// Levels above the next node.
    [[nodiscard]] constexpr std::size_t depth() const noexcept { return depth_; }

  private:
    std::array<std::size_t, MaxDepth> open_{}; // children still to come, by level
    std::size_t depth_{};
};

template <class Item, class Outer> class list_view;

/// A tree of at least its root, of at most `MaxDepth` levels (`too_deep`), in a `list` of nodes, depth first.
/// `Children` is the node's member with the number of its children; inconsistent numbers give count_mismatch.
template <auto Member, auto Children, std::size_t MaxDepth> struct tree {
    static constexpr auto key = Member;
    using keys = key_list<Member>;
    using node = owner_t<Children>;
    using value_type = node;
    using inner_layout = layout_of<node>;
    using refers = references_of<inner_layout>;
    static constexpr std::size_t max_depth = MaxDepth;
    static constexpr bool optional = false;
    static constexpr bool contextual = true;
    static constexpr bool needs_memory = true;
    static constexpr bool checks_values = inner_layout::checks_values;
    static constexpr std::size_t min_size = inner_layout::min_size, max_size = unbounded;
    using raw_type = list<raw<node>>;
    static_assert(detail::has_type<Member, member_t<Member>, list<node>>, "tree: the member must be a list of nodes");

    static consteval std::string_view name() { return name_of<Member>(); }
    /// The number of a node's children.
    [[nodiscard]] static constexpr std::size_t children(const auto& one) noexcept { return member_of<Children>(one); }

    /// Calls `step(index, node)`, which returns an errc, for each node; returns its first error, or that of numbers of
    /// children which the nodes do not have.
    JAUSCAT_INLINE static constexpr errc for_each_node(const auto& nodes, auto&& step) noexcept {
        tree_walk<MaxDepth> walk;
        for (std::size_t i = 0; i != nodes.size(); ++i) {
            if (i != 0 && walk.complete()) return errc::count_mismatch;
            if (!walk.pass(children(nodes[i]))) return errc::too_deep;
            if (const errc error = step(i, nodes[i]); error != errc::ok) return error;
        }
        return nodes.empty() || !walk.complete() ? errc::count_mismatch : errc::ok;
    }

    JAUSCAT_INLINE static constexpr std::size_t size(const auto& object, const auto& here) noexcept {
        std::size_t total = 0;
        for (const auto& one : member_of<Member>(object)) total += inner_layout::size(one, object_scope{one, here});
        return total;
    }
    JAUSCAT_INLINE static constexpr out_cursor put(const auto& object, out_cursor c, const auto& here) noexcept {
        const errc error = for_each_node(member_of<Member>(object), [&](std::size_t, const auto& one) {
            c = inner_layout::put(one, c, object_scope{one, here});
            return c.error;
        });
        return {c.at, error};
    }
    JAUSCAT_INLINE static constexpr in_cursor get(auto& object, in_cursor c, const auto& here) noexcept {
        auto& nodes = member_of<Member>(object);
        using stored = typename std::remove_reference_t<decltype(nodes)>::value_type;
        std::size_t count = 0;
        const in_cursor end =
            walk_bytes(c, count, byte_scope<plain_root, plain_root>{c.at, c.at + min_size + c.slack, {}});
        if (end.at == nullptr) return end;
        const auto get_node = [&](std::size_t i, stored& one) {
            if (i != 0) c.slack -= inner_layout::min_size;
            c = inner_layout::get(one, c, object_scope{one, here});
        };
        if constexpr (discarding<decltype(here)>) {
            for (std::size_t i = 0; i != count && c.at != nullptr; ++i) {
                stored scratch{};
                get_node(i, scratch);
            }
        } else {
            stored* const first = root_of(here).memory.template allocate<stored>(count);
            if (first == nullptr) return in_cursor::failed(errc::arena_full);
            nodes = std::span<const stored>{first, count};
            for (std::size_t i = 0; i != count && c.at != nullptr; ++i) get_node(i, first[i]);
        }
        return c;
    }
    JAUSCAT_INLINE static constexpr in_cursor measure(in_cursor c, const auto& here) noexcept {
        std::size_t count = 0;
        return walk_bytes(c, count, here);
    }
    template <auto, reading> JAUSCAT_INLINE static constexpr auto read(const std::byte* in, const auto& here) noexcept {
        std::size_t count = 0;
        walk_bytes({in, unbounded}, count, here);
        return list_view<tree, std::remove_cvref_t<decltype(here)>>{in, count, here};
    }
    JAUSCAT_INLINE static constexpr void visit(auto& object, auto&& visitor) {
        visitor(tree{}, member_of<Member>(object));
    }

  private:
    // Iterates over all nodes and counts them. A node reads no enclosing members.
    static constexpr in_cursor walk_bytes(in_cursor c, std::size_t& count, const auto& here) noexcept {
        tree_walk<MaxDepth> walk;
        do {
            if (count != 0) {
                if (c.slack < inner_layout::min_size) return in_cursor::failed(errc::truncated);
                c.slack -= inner_layout::min_size;
            }
            const byte_scope<node, std::remove_cvref_t<decltype(here)>> inside{c.at, here.end, here};
            c = inner_layout::measure(c, inside);
            if (c.at == nullptr) return c;
            if (!walk.pass(inner_layout::template read<Children, reading::raw>(inside.bytes, inside)))
                return in_cursor::failed(errc::too_deep);
            ++count;
        } while (!walk.complete());
        return c;
    }
};

} // namespace jauscat::wire
