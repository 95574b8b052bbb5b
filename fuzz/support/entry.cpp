// Where libFuzzer calls a target.
#include "target.hpp"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::run(std::as_bytes(std::span{data, size}));
    return 0;
}
