// expect: hook: the function must outlive the component: give it a name
#include <jauscat/jaus/events/service_connections.hpp>

namespace jaus = jauscat::jaus;

jaus::service_connections<1> connections{
    {}, {}, [](std::uint16_t, std::uint32_t, std::span<std::byte>) -> std::optional<std::size_t> { return 0; }, {}};
