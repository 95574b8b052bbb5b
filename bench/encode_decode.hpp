// Encodes and decodes one message of each type: what the compiler is timed with.
#pragma once
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

namespace bench {

namespace wire = jauscat::wire;

template <class Message> bool one(std::span<std::byte> bytes, wire::arena& memory) {
    Message message{};
    const auto encoded = wire::encode(message, bytes);
    if constexpr (wire::needs_memory<Message>)
        return encoded && wire::decode(message, *encoded, memory);
    else
        return encoded && wire::decode(message, *encoded);
}

template <class... Messages> bool all(std::span<std::byte> bytes, wire::arena& memory) {
    return (one<Messages>(bytes, memory) && ...);
}

template <template <class...> class List, class... Messages>
bool all(List<Messages...>, std::span<std::byte> bytes, wire::arena& memory) {
    return all<Messages...>(bytes, memory);
}

} // namespace bench
