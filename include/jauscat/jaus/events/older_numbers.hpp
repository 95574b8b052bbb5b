// Tells late reports from those of a provider that counts anew.
#pragma once
#include <cstdint>

namespace jauscat::jaus {

/// Sequence numbers that are not newer than the last one. They are of late reports, however late, and of copies, unless
/// - the provider has confirmed the request again after a silence, and the number is 0 or 1 and more than 32 behind: it
///   was restarted;
/// - eight follow each other without a newer one after such a confirmation, or 32 without: the first ones were lost, or
///   as many as the width of the number cannot tell.
struct older_numbers {
    /// The provider may have been restarted. Numbers that followed each other before still count: a connection is stale
    /// again, and confirmed again, after three of them.
    constexpr void may_begin_anew() noexcept { is_doubted = true; }
    /// A late report is behind by this at most, or the width of its number tells nothing.
    static constexpr unsigned most_late = 32;
    /// Takes the next number that is not newer, by `behind` older than the last one. True: the provider counts from it.
    [[nodiscard]] constexpr bool begins_anew(std::uint16_t number, unsigned behind) noexcept {
        if (is_doubted && number <= 1 && behind > most_late) return true;
        run = run != 0 && number == last + 1 ? run + 1 : 1;
        last = number;
        return run >= (is_doubted ? 8 : 32);
    }

    std::uint16_t last{}; ///< of them
    unsigned run{};       ///< of numbers that follow each other
    bool is_doubted{};    ///< whether the provider goes on counting
};

} // namespace jauscat::jaus
