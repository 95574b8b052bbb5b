// expect: hook: the function returns another type than the hook
#include <jauscat/jaus/events/service_connections.hpp>

namespace jaus = jauscat::jaus;

constexpr auto fill = [](std::uint16_t, std::uint32_t, std::span<std::byte>) -> std::optional<std::size_t> {
    return 0;
};
constexpr auto judge = [](const jaus::header&, const jaus::create_service_connection&) { return true; };
jaus::service_connections<1> connections{{}, {}, fill, {}, judge};
