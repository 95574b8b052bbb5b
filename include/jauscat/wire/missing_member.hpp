// Names the member of a struct that its layout leaves out, in the compiler's error.
#pragma once
#include <jauscat/wire/item.hpp>

#include <tuple>

namespace jauscat::wire::detail {

/// A value that is declared only: the addresses of its members tell them apart.
template <class T> struct declared_value {
    const T value;
};
template <class T> extern const declared_value<T> declared;
/// A member of a declared value; the compiler spells its name.
template <class Member> struct member_place {
    Member at;
};
template <auto Member> struct missing_from_layout {
    static_assert(sizeof(Member) == 0, "layout: a member of the message is missing from its layout");
};

inline constexpr std::size_t most_named_members = 16;
/// Pointers to the members of a struct that has `Count`, up to `most_named_members`.
template <std::size_t Count> constexpr auto places_in(const auto& value) {
    if constexpr (Count == 1) {
        const auto& [a] = value;
        return std::tuple{&a};
    } else if constexpr (Count == 2) {
        const auto& [a, b] = value;
        return std::tuple{&a, &b};
    } else if constexpr (Count == 3) {
        const auto& [a, b, c] = value;
        return std::tuple{&a, &b, &c};
    } else if constexpr (Count == 4) {
        const auto& [a, b, c, d] = value;
        return std::tuple{&a, &b, &c, &d};
    } else if constexpr (Count == 5) {
        const auto& [a, b, c, d, e] = value;
        return std::tuple{&a, &b, &c, &d, &e};
    } else if constexpr (Count == 6) {
        const auto& [a, b, c, d, e, f] = value;
        return std::tuple{&a, &b, &c, &d, &e, &f};
    } else if constexpr (Count == 7) {
        const auto& [a, b, c, d, e, f, g] = value;
        return std::tuple{&a, &b, &c, &d, &e, &f, &g};
    } else if constexpr (Count == 8) {
        const auto& [a, b, c, d, e, f, g, h] = value;
        return std::tuple{&a, &b, &c, &d, &e, &f, &g, &h};
    } else if constexpr (Count == 9) {
        const auto& [a, b, c, d, e, f, g, h, i] = value;
        return std::tuple{&a, &b, &c, &d, &e, &f, &g, &h, &i};
    } else if constexpr (Count == 10) {
        const auto& [a, b, c, d, e, f, g, h, i, j] = value;
        return std::tuple{&a, &b, &c, &d, &e, &f, &g, &h, &i, &j};
    } else if constexpr (Count == 11) {
        const auto& [a, b, c, d, e, f, g, h, i, j, k] = value;
        return std::tuple{&a, &b, &c, &d, &e, &f, &g, &h, &i, &j, &k};
    } else if constexpr (Count == 12) {
        const auto& [a, b, c, d, e, f, g, h, i, j, k, l] = value;
        return std::tuple{&a, &b, &c, &d, &e, &f, &g, &h, &i, &j, &k, &l};
    } else if constexpr (Count == 13) {
        const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m] = value;
        return std::tuple{&a, &b, &c, &d, &e, &f, &g, &h, &i, &j, &k, &l, &m};
    } else if constexpr (Count == 14) {
        const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = value;
        return std::tuple{&a, &b, &c, &d, &e, &f, &g, &h, &i, &j, &k, &l, &m, &n};
    } else if constexpr (Count == 15) {
        const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o] = value;
        return std::tuple{&a, &b, &c, &d, &e, &f, &g, &h, &i, &j, &k, &l, &m, &n, &o};
    } else if constexpr (Count == 16) {
        const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p] = value;
        return std::tuple{&a, &b, &c, &d, &e, &f, &g, &h, &i, &j, &k, &l, &m, &n, &o, &p};
    }
}

/// `unnamed` is true if the struct `T` has more members than `Listed`, and too many to name the missing one.
template <class T, class Listed, bool Missing> struct missing_member {
    static constexpr bool unnamed = false;
};
template <class T, auto... Listed> struct missing_member<T, key_list<Listed...>, true> {
  private:
    static constexpr std::size_t count = []<std::size_t... More>(std::index_sequence<More...>) {
        return sizeof...(Listed) + 1 + (std::size_t{has_more_members_than<T, sizeof...(Listed) + 1 + More>} + ... + 0);
    }(std::make_index_sequence<most_named_members>{});
    // Refuses to compile if the member is missing.
    template <std::size_t I>
    static constexpr bool named = [] {
        constexpr auto at = std::get<I>(places_in<count>(declared<T>.value));
        if constexpr (((static_cast<const void*>(&(declared<T>.value.*Listed)) == at) || ...))
            return false;
        else
            return sizeof(missing_from_layout<member_place<decltype(at)>{at}>) != 0;
    }();

  public:
    static constexpr bool unnamed = [] {
        if constexpr (count > most_named_members)
            return true;
        else
            return []<std::size_t... I>(std::index_sequence<I...>) {
                return !(named<I> || ...);
            }(std::make_index_sequence<count>{});
    }();
};

} // namespace jauscat::wire::detail
