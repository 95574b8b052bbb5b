// What a fuzz target is made of: `run` is the target, `check` states a property, `input_reader` takes an input apart.
#pragma once
#include <jauscat/wire/arena.hpp>
#include <jauscat/wire/scalar.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

namespace fuzz {

using byte_vector = std::vector<std::byte>;

/// One execution. Each target defines it.
void run(std::span<const std::byte> input);

/// States what must hold. libFuzzer keeps the input for which it does not.
inline void check(bool holds, const char* sentence) {
    if (holds) return;
    std::fprintf(stderr, "this does not hold: %s\n", sentence);
    std::abort();
}

/// A copy in memory of exactly its size, so that the address sanitizer sees the first byte behind it.
inline byte_vector copy_of(std::span<const std::byte> from) { return {from.begin(), from.end()}; }

/// Memory for the lists of one execution: far more than most inputs can ask for.
inline jauscat::wire::arena& fresh_arena() {
    alignas(std::max_align_t) static std::array<std::byte, std::size_t{1} << 20> memory;
    static jauscat::wire::arena arena{memory};
    arena.reset();
    return arena;
}

/// Takes values off the front of an input. Where it has ended, they are zero.
class input_reader {
  public:
    explicit input_reader(std::span<const std::byte> input) : rest_{input} {}

    [[nodiscard]] bool empty() const { return rest_.empty(); }
    [[nodiscard]] std::span<const std::byte> rest() const { return rest_; }

    template <jauscat::wire::codec Codec = jauscat::wire::u8> typename Codec::value_type take() {
        const byte_vector image = take_bytes(Codec::size);
        typename Codec::value_type value{};
        static_cast<void>(Codec::load(image.data(), value));
        return value;
    }
    byte_vector take_bytes(std::size_t size) {
        const auto here = rest_.first(std::min(size, rest_.size()));
        rest_ = rest_.subspan(here.size());
        byte_vector taken = copy_of(here);
        taken.resize(size);
        return taken;
    }

  private:
    std::span<const std::byte> rest_;
};

} // namespace fuzz
