// expect: hook: the function has other parameters than the hook
#include <jauscat/jaus/events/events.hpp>

namespace jaus = jauscat::jaus;

constexpr auto fill = [](std::uint16_t, std::span<const std::byte>,
                         std::span<std::byte>) -> std::optional<std::size_t> { return 0; };
constexpr auto judge = [](const jaus::header&) { return jaus::event_response::successful; };
jaus::events<1> events{{}, {}, fill, {}, judge};
