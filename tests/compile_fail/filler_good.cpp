// expect: no error
#include <jauscat/jaus/events/events.hpp>
#include <jauscat/jaus/events/service_connections.hpp>

namespace jaus = jauscat::jaus;

constexpr auto fill = [](std::uint16_t, std::uint32_t, std::span<std::byte>) -> std::optional<std::size_t> {
    return 0;
};
constexpr auto fill_event = [](std::uint16_t, std::span<const std::byte>,
                               std::span<std::byte>) -> std::optional<std::size_t> { return 0; };
constexpr auto judge = [](const jaus::header&, const jaus::create_service_connection&) {
    return jaus::service_connection_response::connection_refused;
};
constexpr auto judge_event = [](const jaus::header&, std::uint16_t) {
    return jaus::event_response::connection_refused;
};
jaus::service_connections<1> connections{{}, {}, fill, {}, judge};
jaus::events<1> events{{}, {}, fill_event, {}, judge_event};
