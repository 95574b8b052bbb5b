// The switch of mutants at run time. scripts/mutants copies this header into the tree that it mutates; no other code
// includes it.
#pragma once
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>

// With JAUSCAT_MUTANTS_NOT_CONSTANT a mutant in a constant expression does not compile: it could never be switched on.
#ifdef JAUSCAT_MUTANTS_NOT_CONSTANT
#    define JAUSCAT_MUTANT_FUNCTION inline
#else
#    define JAUSCAT_MUTANT_FUNCTION [[gnu::always_inline]] constexpr
#endif

namespace mutant_switch {

enum state : unsigned char { off, on, recorded, reached };

inline constexpr unsigned most = 1U << 16;
inline unsigned char states[most];
inline const char* record_file;

inline void write_record() {
    std::FILE* const file = std::fopen(record_file, "a");
    if (file == nullptr) return;
    for (unsigned i = 0; i != most; ++i)
        if (states[i] == reached) std::fprintf(file, "%u\n", i);
    std::fclose(file);
}

/// JAUSCAT_MUTANT=NUMBER switches one mutant on. JAUSCAT_MUTANT_RECORD=FILE switches none on, and appends the numbers
/// of those that the program has reached to FILE when it ends.
inline bool prepare() {
    if (const char* const number = std::getenv("JAUSCAT_MUTANT")) states[std::strtoul(number, nullptr, 10) % most] = on;
    record_file = std::getenv("JAUSCAT_MUTANT_RECORD");
    if (record_file != nullptr) {
        std::memset(states, recorded, sizeof states);
        std::atexit(write_record);
    }
    return true;
}

inline const bool is_prepared = prepare();

inline bool is_on(unsigned number) noexcept {
    if (states[number] == on) return true;
    states[number] = reached;
    return false;
}

JAUSCAT_MUTANT_FUNCTION bool is(unsigned number) noexcept {
    if (std::is_constant_evaluated()) return false;
    return states[number] != off && is_on(number);
}

} // namespace mutant_switch
