// Real values carried as scaled integers, by the formula of JAUS RA 3.3 part 3 (and of SAE AS5684):
//   real = raw * scale + bias
//   unsigned, n bits: scale = (max - min) / (2^n - 1), bias = min
//   signed, n bits:   scale = (max - min) / (2^n - 2), bias = (max + min) / 2; the raw value -2^(n-1) is never legal
#pragma once
#include <jauscat/wire/scalar.hpp>

#include <limits>

namespace jauscat::wire {

/// A named real interval: `static constexpr double min, max` and `static constexpr std::string_view unit`.
/// A type, because clang before 18 takes no floating-point template arguments.
template <class R>
concept real_range = requires {
    { R::min } -> std::convertible_to<double>;
    { R::max } -> std::convertible_to<double>;
};

/// A real value in the interval `Range`, carried by the integer codec `Raw`. Storing rounds to nearest, ties up, and
/// refuses a value outside the interval or NaN (`out_of_range`); loading refuses a signed raw minimum.
/// Every legal raw value of 8, 16 and 32 bits survives load and store; a double cannot hold every 64-bit one.
template <codec Raw, real_range Range> struct scaled {
    using raw_codec = Raw;
    using raw_type = typename Raw::value_type;
    using range_type = Range;
    using value_type = double;
    static constexpr std::size_t size = Raw::size;
    static_assert(std::integral<raw_type>, "scaled: the carrier must be an integer codec");
    static_assert(Range::min < Range::max, "scaled: the range is empty (min must be below max)");
    // Its width times the steps of the carrier must be a double.
    static_assert(Range::max / 1e288 - Range::min / 1e288 < 1, "scaled: the range is wider than 1e288");

    static constexpr raw_type top = std::numeric_limits<raw_type>::max();
    static constexpr raw_type bottom = static_cast<raw_type>(std::is_signed_v<raw_type> ? -top : 0);

    /// The real value of a legal raw value.
    JAUSCAT_INLINE static constexpr double to_real(raw_type raw) noexcept {
        const double centred = static_cast<double>(raw) * scale;
        if constexpr (bias == 0)
            return centred; // x + 0.0 is not a no-op for the optimiser: it turns -0.0 into 0.0
        else
            return centred + bias;
    }

    /// The raw value nearest to a real value that lies within `lowest` and `highest`.
    // Multiplied before it is divided: a precomputed reciprocal misses ties (50 % on 8 bits is 127.5 and must give
    // 128). Counted from the lower end, so that truncation is rounding and no libm is needed.
    JAUSCAT_INLINE static constexpr raw_type to_raw(double real) noexcept {
        const double count = (real - Range::min) * steps / (Range::max - Range::min) + 0.5;
        if constexpr (sizeof(raw_type) == 8) {
            if (count >= steps) return top;  // 2^64 - 1 is not a double; the next one does not fit the integer
            if (!(count > 0)) return bottom; // `lowest` is many steps below the range: a step is less than its rounding
        }
        using counter = std::conditional_t<(sizeof(raw_type) < 4), std::int32_t,
                                           std::conditional_t<sizeof(raw_type) == 4, std::int64_t, std::uint64_t>>;
        return static_cast<raw_type>(static_cast<counter>(count) + static_cast<counter>(bottom));
    }

    JAUSCAT_INLINE static constexpr errc store(std::byte* out, double real) noexcept {
        return smaller_when_called ? called_store(out, real) : inlined_store(out, real);
    }
    JAUSCAT_INLINE static constexpr errc load(const std::byte* in, double& real) noexcept {
        return smaller_when_called ? called_load(in, real) : inlined_load(in, real);
    }

  private:
    // Optimised for speed, each field has the conversion in place. Optimised for size (-Os, firmware), all fields of a
    // type share one function: where floating point is software, the conversion is a dozen calls.
#ifdef __OPTIMIZE_SIZE__
    static constexpr bool smaller_when_called = true;
#else
    static constexpr bool smaller_when_called = false;
#endif
    JAUSCAT_INLINE static constexpr errc inlined_store(std::byte* out, double real) noexcept {
        if (!(real >= lowest && real <= highest)) return errc::out_of_range; // NaN fails both
        return Raw::store(out, to_raw(real));
    }
    JAUSCAT_INLINE static constexpr errc inlined_load(const std::byte* in, double& real) noexcept {
        raw_type raw{};
        Raw::load(in, raw);
        if constexpr (std::is_signed_v<raw_type>) {
            if (raw == std::numeric_limits<raw_type>::min()) return errc::out_of_range;
        }
        real = to_real(raw);
        return errc::ok;
    }
    [[gnu::noinline]] static constexpr errc called_store(std::byte* out, double real) noexcept {
        return inlined_store(out, real);
    }
    [[gnu::noinline]] static constexpr errc called_load(const std::byte* in, double& real) noexcept {
        return inlined_load(in, real);
    }

    static constexpr double steps = static_cast<double>(top) - static_cast<double>(bottom);
    static constexpr double scale = (Range::max - Range::min) / steps;
    static constexpr double bias = std::is_signed_v<raw_type> ? (Range::min + Range::max) / 2 : Range::min;

  public:
    /// The limits a real value may have: the range, widened by what rounding adds to the decoded ends.
    static constexpr double lowest = to_real(bottom) < Range::min ? to_real(bottom) : Range::min;
    static constexpr double highest = to_real(top) > Range::max ? to_real(top) : Range::max;
};

} // namespace jauscat::wire
