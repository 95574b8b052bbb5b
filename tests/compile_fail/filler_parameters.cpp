// expect: hook: the function has other parameters than the hook
#include <jauscat/jaus/events/service_connections.hpp>

namespace jaus = jauscat::jaus;

constexpr auto fill = [](std::uint16_t, std::span<std::byte>) -> std::optional<std::size_t> { return 0; };
jaus::service_connections<1> connections{{}, {}, fill, {}};
