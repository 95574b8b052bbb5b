// expect: hook: the function returns another type than the hook
#include <jauscat/jaus/events/service_connections.hpp>

namespace jaus = jauscat::jaus;

constexpr auto fill = [](std::uint16_t, std::uint32_t, std::span<std::byte>) { return true; };
jaus::service_connections<1> connections{{}, {}, fill, {}};
