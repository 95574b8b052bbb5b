// expect: hook: the function returns another type than the hook
#include <jauscat/jaus/events/events.hpp>

namespace jaus = jauscat::jaus;

constexpr auto fill = [](std::uint16_t, std::span<const std::byte>, std::span<std::byte>) -> std::size_t { return 0; };
jaus::events<1> events{{}, {}, fill, {}};
