// Map from JAUS addresses with wildcards to values; constant-time lookup, the most specific entry wins.
#pragma once
#include <jauscat/schema/jaus/header.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::jaus {

/// A place in the memory of an address_map.
template <class Value> struct address_place {
    jaus::address address{}; ///< of the entry; a level of 0 matches every ID of that level
    bool taken{};            ///< whether there is an entry
    Value value{};           ///< the caller's
};

/// Result of an insertion.
enum class inserted : std::uint8_t {
    ok,
    full,      ///< no place is left; see address_map::capacity
    duplicate, ///< there is an entry with exactly this address, which is not changed
};

/// Finds the entry for an address. An entry's level of 0 matches every ID of that level, 255 is an ID like others. Of
/// several entries that cover an address, the one that names the higher level is found: 1.2.0.0 before 1.0.33.0 before
/// 1.0.0.0 before 0.0.0.0. A look-up costs one probe for each pattern of named levels that is in use, at most 16,
/// whatever the number of entries. Memory is the caller's: open addressing, at most three quarters full, so that a
/// probe seldom sees more than a few places. Not safe for several threads.
///
///     std::array<jaus::address_place<int>, 64> places{};
///     jaus::address_map<int> routes{places};
///     routes.insert({.node = 2, .subsystem = 1}, 7);
///     const auto* to = routes.find({.instance = 1, .component = 33, .node = 2, .subsystem = 1}); // to->value == 7
template <class Value> class address_map {
  public:
    /// A place in the caller's memory.
    using place = address_place<Value>;

    /// Uses the largest power of two of `places`, which it empties and which must outlive it.
    constexpr explicit address_map(std::span<place> places) noexcept
        : places_{places.first(places.size() < 2 ? 0 : std::bit_floor(places.size()))},
          shift_{static_cast<unsigned>(std::countl_zero(std::uint64_t{places_.size() - 1}))} {
        clear();
    }

    /// Maximum number of entries: three quarters of the places.
    [[nodiscard]] constexpr std::size_t capacity() const noexcept {
        return places_.size() - std::max(places_.size() / 4, std::min<std::size_t>(places_.size(), 1));
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }

    /// Puts a value under an address that is not there yet.
    [[nodiscard]] constexpr inserted insert(const address& entry, const Value& value) noexcept {
        if (exactly(entry) != nullptr) return inserted::duplicate;
        if (size_ == capacity()) return inserted::full;
        std::size_t at = home(key_of(entry));
        while (places_[at].taken) at = after(at);
        places_[at] = {entry, true, value};
        ++size_;
        if (uses_[rank_of(entry)]++ == 0) note_patterns();
        return inserted::ok;
    }

    /// The most specific entry that covers `wanted`, or nullptr. Valid until the next insert, erase or clear.
    [[nodiscard]] constexpr place* find(const address& wanted) const noexcept {
        const std::uint32_t key = key_of(wanted);
        for (const std::uint32_t pattern : std::span{patterns_}.first(pattern_count_))
            if (place* const found = probe(key & pattern)) return found;
        return nullptr;
    }

    /// The entry with exactly this address, or nullptr.
    [[nodiscard]] constexpr place* exactly(const address& entry) const noexcept {
        return uses_[rank_of(entry)] == 0 ? nullptr : probe(key_of(entry));
    }

    /// Removes the entry with exactly this address; false if there is none. Moves others.
    constexpr bool erase(const address& entry) noexcept {
        place* const found = exactly(entry);
        if (found == nullptr) return false;
        if (--uses_[rank_of(entry)] == 0) note_patterns();
        --size_;
        // Entries after the gap that would no longer be reached from their home are moved into the gap.
        std::size_t gap = static_cast<std::size_t>(found - places_.data());
        for (std::size_t at = after(gap); places_[at].taken; at = after(at)) {
            if (distance(home(key_of(places_[at].address)), at) < distance(gap, at)) continue;
            places_[gap] = places_[at];
            gap = at;
        }
        places_[gap] = {};
        return true;
    }

    constexpr void clear() noexcept {
        std::ranges::fill(places_, place{});
        uses_ = {};
        pattern_count_ = 0;
        size_ = 0;
    }

    /// All places, used or not, in no order, to iterate over the entries.
    [[nodiscard]] constexpr std::span<place> places() const noexcept { return places_; }

    /// The maximum number of probes to find an entry by its own address; 0 without entries. For tests and logs.
    [[nodiscard]] constexpr std::size_t longest_probe() const noexcept {
        std::size_t longest = 0;
        for (std::size_t at = 0; at != places_.size(); ++at)
            if (places_[at].taken) longest = std::max(longest, distance(home(key_of(places_[at].address)), at) + 1);
        return longest;
    }

  private:
    static constexpr std::uint32_t key_of(const address& a) noexcept { return std::bit_cast<std::uint32_t>(a); }
    // One bit a level, the subsystem's the highest, set where the entry names an ID.
    static constexpr std::size_t rank_of(const address& a) noexcept {
        return (a.subsystem != 0 ? 8U : 0U) + (a.node != 0 ? 4U : 0U) + (a.component != 0 ? 2U : 0U) +
               (a.instance != 0 ? 1U : 0U);
    }
    static constexpr std::uint32_t pattern_of(std::size_t rank) noexcept {
        const auto level = [rank](std::size_t bit) { return static_cast<std::uint8_t>((rank & bit) != 0 ? 0xFF : 0); };
        return key_of({.instance = level(1), .component = level(2), .node = level(4), .subsystem = level(8)});
    }
    constexpr void note_patterns() noexcept {
        pattern_count_ = 0;
        for (std::size_t rank = uses_.size(); rank-- != 0;)
            if (uses_[rank] != 0) patterns_[pattern_count_++] = pattern_of(rank);
    }

    // Multiples of 2^64 / golden ratio spread numbers that follow each other evenly over the highest bits: here those
    // of neighbouring nodes and subsystems, with which tables are full.
    [[nodiscard]] constexpr std::size_t home(std::uint32_t key) const noexcept {
        return static_cast<std::size_t>((std::rotl(key, 16) * 0x9E3779B97F4A7C15U) >> shift_);
    }
    [[nodiscard]] constexpr std::size_t after(std::size_t at) const noexcept { return (at + 1) & (places_.size() - 1); }
    [[nodiscard]] constexpr std::size_t distance(std::size_t from, std::size_t to) const noexcept {
        return (to - from) & (places_.size() - 1);
    }
    // There is always a free place, at which this ends. Called only when there are entries.
    [[nodiscard]] constexpr place* probe(std::uint32_t key) const noexcept {
        for (std::size_t at = home(key); places_[at].taken; at = after(at))
            if (key_of(places_[at].address) == key) return &places_[at];
        return nullptr;
    }

    std::span<place> places_;
    unsigned shift_; // leaves the bits that number the places
    std::size_t size_{};
    std::array<std::uint32_t, 16> uses_{};     // entries of each rank
    std::array<std::uint32_t, 16> patterns_{}; // masks of the ranks in use, the most specific first
    std::size_t pattern_count_{};
};

} // namespace jauscat::jaus
