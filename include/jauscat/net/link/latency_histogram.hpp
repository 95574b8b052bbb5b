// Histogram of durations. The width of a bucket is 1/64 of its value, or 1 ns, so that nanoseconds and seconds fit one
// table of fixed size, and adding costs a few instructions.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <ostream>

namespace jauscat::net {

/// Times from 0 to 137 s (2^37 ns); longer ones are counted as the longest, negative ones as 0. 16 KiB, without
/// allocation. Quantiles are exact below 128 ns, and above at most 1/64 too high.
class latency_histogram {
  public:
    using nanoseconds = std::chrono::nanoseconds;

    /// Counts one time; a negative one as 0.
    void add(nanoseconds time) noexcept {
        time = std::max(time, nanoseconds{});
        ++buckets_[std::min(bucket_of(static_cast<std::uint64_t>(time.count())), buckets_.size() - 1)];
        ++count_;
        min_ = std::min(min_, time);
        max_ = std::max(max_, time);
    }

    /// Number of times.
    [[nodiscard]] std::uint64_t count() const noexcept { return count_; }
    /// The shortest and the longest time, exact; 0 if there is none.
    [[nodiscard]] nanoseconds min() const noexcept { return count_ == 0 ? nanoseconds{} : min_; }
    [[nodiscard]] nanoseconds max() const noexcept { return max_; }

    /// Quantile for `q` from 0 to 1: `quantile(0.5)` is the median. 0 if there is no time.
    [[nodiscard]] nanoseconds quantile(double q) const noexcept {
        const auto wanted = std::max(std::ceil(q * static_cast<double>(count_)), 1.0);
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i != buckets_.size(); ++i) {
            sum += buckets_[i];
            if (static_cast<double>(sum) >= wanted)
                return i + 1 == buckets_.size() ? max() : std::clamp(first_of(i + 1) - nanoseconds{1}, min(), max());
        }
        return max();
    }

    /// Calls `visit(from, below, count)` for each bucket that is not empty, shortest time first.
    template <class Visitor> void for_each_bucket(Visitor visit) const { for_each_group(1, visit); }

    /// Prints one line for each range of times, 8 ranges for each octave: its lower bound in microseconds, the count,
    /// and a bar of at most `width` characters. The lengths of the bars are logarithmic, because rare times matter
    /// here.
    void print(std::ostream& out, std::size_t width = 50) const {
        constexpr std::size_t group = buckets_per_octave / 8;
        std::uint64_t most = 0;
        for_each_group(group, [&](nanoseconds, nanoseconds, std::uint64_t n) { most = std::max(most, n); });
        const auto length = [&](std::uint64_t n) {
            const double share = std::log(static_cast<double>(n) + 1) / std::log(static_cast<double>(most) + 1);
            return static_cast<std::size_t>(std::lround(share * static_cast<double>(width)));
        };
        const auto format = out.flags();
        const auto precision = out.precision();
        nanoseconds expected{-1};
        for_each_group(group, [&](nanoseconds from, nanoseconds below, std::uint64_t n) {
            if (expected >= nanoseconds{} && from != expected) out << "          ...\n";
            expected = below;
            out << std::fixed << std::setprecision(2) << std::setw(10) << static_cast<double>(from.count()) / 1000
                << " us " << std::setw(9) << n << ' ';
            for (std::size_t i = length(n); i != 0; --i) out << '#';
            out << '\n';
        });
        out.flags(format);
        out.precision(precision);
    }

  private:
    static constexpr std::size_t octave_bits = 6, buckets_per_octave = std::size_t{1} << octave_bits;
    static constexpr std::size_t longest_bits = 37; ///< bits of the longest time with a bucket of its own

    /// Below 128 ns each time has a bucket; above, the 7 highest bits select it.
    static constexpr std::size_t bucket_of(std::uint64_t time) noexcept {
        if (time < 2 * buckets_per_octave) return static_cast<std::size_t>(time);
        const auto shift = static_cast<std::size_t>(std::bit_width(time)) - (octave_bits + 1);
        return shift * buckets_per_octave + static_cast<std::size_t>(time >> shift);
    }
    static constexpr nanoseconds first_of(std::size_t bucket) noexcept {
        if (bucket < 2 * buckets_per_octave) return nanoseconds{bucket};
        const auto shift = bucket / buckets_per_octave - 1;
        return nanoseconds{(bucket % buckets_per_octave + buckets_per_octave) << shift};
    }

    template <class Visitor> void for_each_group(std::size_t size, Visitor visit) const {
        for (std::size_t i = 0; i < buckets_.size(); i += size) {
            std::uint64_t sum = 0;
            for (std::size_t j = i; j != i + size; ++j) sum += buckets_[j];
            if (sum != 0) visit(first_of(i), first_of(i + size), sum);
        }
    }

    std::array<std::uint64_t, (longest_bits - octave_bits + 1) * buckets_per_octave> buckets_{};
    std::uint64_t count_{};
    nanoseconds min_{nanoseconds::max()};
    nanoseconds max_{};
};

} // namespace jauscat::net
