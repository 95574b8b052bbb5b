// Rate limits: token buckets, in a table of fixed size.
#pragma once

#include <jauscat/base/time.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace jauscat::net {

/// Average number of messages each second, and number at once.
struct rate {
    std::uint32_t per_second{}; ///< 0: no limit
    std::uint32_t burst{1};     ///< 0 counts as 1
    friend constexpr bool operator==(const rate&, const rate&) = default;
};

/// Holds up to `burst` tokens and gets `per_second` of them each second; a message takes one. It starts full. The times
/// are of a steady clock with any epoch.
class token_bucket {
  public:
    /// Takes a token for a message at `now`; false, without a change, if there is none.
    constexpr bool take(const rate& limit, time_point now) noexcept {
        if (limit.per_second == 0) return true;
        const auto interval = std::max(duration{std::chrono::seconds{1}} / limit.per_second, duration{1});
        const auto full_at = std::max(full_at_, now);
        if (full_at - now > interval * static_cast<std::int64_t>(std::max(limit.burst, 1U) - 1)) return false;
        full_at_ = full_at + interval;
        return true;
    }

    /// Fills it.
    [[nodiscard]] constexpr bool is_full(time_point now) const noexcept { return full_at_ <= now; }

  private:
    time_point full_at_{time_point::min()}; ///< when it has all its tokens again
};

/// Key of a bucket: 16 bytes, such as an IPv6 address.
using rate_key = std::array<std::uint64_t, 2>;

/// A bucket for each of many senders, in a table of `Places` (a power of two, at least 8). A sender is looked up in 8
/// places, independent of the number of senders. If all 8 are used by senders that are not idle, the sender shares one
/// bucket with all others in this situation, so that a flood of forged senders cannot evict existing ones. Removing an
/// idle sender changes nothing for it: its bucket is full.
template <std::size_t Places> class rate_limit {
    static_assert(Places >= 8 && (Places & (Places - 1)) == 0, "rate_limit: the places are a power of two, at least 8");

  public:
    /// `seed` is a random number, so that an attacker cannot choose senders that collide.
    constexpr explicit rate_limit(const rate& limit, std::uint64_t seed = 0) noexcept : limit_{limit}, seed_{seed} {}

    /// Whether a message of `sender` at `now` is within the limit; if so, it is counted.
    constexpr bool take(const rate_key& sender, time_point now) noexcept {
        const auto first = places_.begin() + static_cast<std::ptrdiff_t>(set_of(sender) * ways);
        const auto last = first + ways;
        auto found = std::find_if(first, last, [&](const place& p) { return p.sender == sender && p.used; });
        if (found == last) found = std::find_if(first, last, [&](const place& p) { return p.bucket.is_full(now); });
        if (found == last) {
            ++crowded_;
            return shared_.take(limit_, now);
        }
        if (!found->used || found->sender != sender) *found = {sender, {}, true};
        return found->bucket.take(limit_, now);
    }

    /// Messages of senders without a place of their own.
    [[nodiscard]] constexpr std::uint64_t crowded() const noexcept { return crowded_; }

  private:
    static constexpr std::ptrdiff_t ways = 8;

    struct place {
        rate_key sender{};
        token_bucket bucket{};
        bool used{};
    };

    [[nodiscard]] constexpr std::size_t set_of(const rate_key& sender) const noexcept {
        std::uint64_t mixed = seed_;
        for (const auto part : sender) {
            mixed = (mixed ^ part) * 0x9E3779B97F4A7C15U;
            mixed ^= mixed >> 32;
        }
        return static_cast<std::size_t>(mixed) & (Places / ways - 1);
    }

    rate limit_;
    std::uint64_t seed_;
    std::uint64_t crowded_{};
    token_bucket shared_{};
    std::array<place, Places> places_{};
};

} // namespace jauscat::net
