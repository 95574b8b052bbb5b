// Tells late reports from those of a provider that counts anew.
#pragma once
#include <cstdint>

namespace jauscat::jaus {

/// Sequence numbers that are not newer than the last one. They are of late reports, however late, and of copies, unless
/// - the provider has confirmed the request again after a silence, and the number is 0 or 1: it was restarted;
/// - eight follow each other without a newer one after such a confirmation, or 32 without: the first ones were lost, or
///   as many as the width of the number cannot tell.
struct older_numbers {
    /// The provider may have been restarted.
    constexpr void may_begin_anew() noexcept { *this = {.is_doubted = true}; }
    /// Takes the next number that is not newer. True: the provider counts from it.
    [[nodiscard]] constexpr bool begins_anew(std::uint16_t number) noexcept {
        if (is_doubted && number <= 1) return true;
        run = run != 0 && number == last + 1 ? run + 1 : 1;
        last = number;
        return run >= (is_doubted ? 8 : 32);
    }

    std::uint16_t last{}; ///< of them
    unsigned run{};       ///< of numbers that follow each other
    bool is_doubted{};    ///< whether the provider goes on counting
};

} // namespace jauscat::jaus
