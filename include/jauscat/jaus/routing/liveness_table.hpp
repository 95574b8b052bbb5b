// Liveness of components.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/jaus/routing/address_map.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace jauscat::jaus {

/// When a component was heard of.
struct sign_of_life {
    time_point last_heard_at{};
    time_point gone_at{}; ///< when it is lost unless it is heard again; max: never
};

/// Result of a message from a component.
enum class heard : std::uint8_t {
    known,       ///< was there already
    appeared,    ///< is new
    no_capacity, ///< is new and not remembered: the table is full, or its subsystem has its share
};

/// The components that are alive, each until its timeout after its last message. A flood of new addresses displaces no
/// entry, and of one subsystem it leaves a quarter of the table to others, see peer_share. Constant-time lookup.
class liveness_table {
  public:
    /// A place in the caller's memory.
    using place = address_place<sign_of_life>;

    /// `places` must outlive this; three quarters of a power of two of them can be used.
    constexpr explicit liveness_table(std::span<place> places) noexcept : map_{places} {}

    /// `who`, with an ID on each level, was heard at `now`. `timeout`: 0 or more.
    JAUSCAT_CONSTEXPR heard on_heard(const address& who, time_point now, duration timeout) noexcept;
    /// `who` is kept permanently, also without messages; false if the table is full.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool keep(const address& who) noexcept;

    /// Removes components whose timeout has expired; calls `gone(const address&)` for each.
    constexpr void on_time(time_point now, auto&& gone) {
        if (now < next_check_) return;
        next_check_ = time_point::max();
        remove_if(
            [&](const place& one) {
                if (one.value.gone_at <= now) return true;
                next_check_ = std::min(next_check_, one.value.gone_at);
                return false;
            },
            gone);
    }
    /// Time of the next call of on_time, not later than the next timeout.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<time_point> next_event() const noexcept;

    /// Removes the entries for which `unwanted(const place&)` is true, which may be called more than once for one;
    /// calls `gone(const address&)` for each.
    constexpr void remove_if(auto&& unwanted, auto&& gone) {
        const auto places = map_.places();
        for (std::size_t at = 0; at != places.size();) {
            if (!places[at].taken || !unwanted(std::as_const(places[at]))) {
                ++at;
                continue;
            }
            const address who = places[at].address;
            map_.erase(who); // may move another to this place
            --of_subsystem_[who.subsystem];
            gone(who);
        }
    }

    /// When the last message of `who` arrived, or nullptr.
    [[nodiscard]] JAUSCAT_CONSTEXPR const sign_of_life* find(const address& who) const noexcept;
    /// `use(const address&)` for everyone, in no order.
    constexpr void for_each(auto&& use) const {
        for (const place& one : map_.places())
            if (one.taken) use(one.address);
    }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return map_.size(); }
    [[nodiscard]] constexpr std::size_t capacity() const noexcept { return map_.capacity(); }

  private:
    address_map<sign_of_life> map_;
    std::array<std::uint32_t, 256> of_subsystem_{}; ///< components alive
    time_point next_check_{time_point::max()};
};

} // namespace jauscat::jaus

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/jaus/routing/impl/liveness_table.ipp>
#endif
