// One translation unit that encodes and decodes every message: its compile time is one of the measures.
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

namespace {

namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;

template <class Message> bool one(std::span<std::byte> bytes, wire::arena& memory) {
    Message message{};
    const wire::result size = wire::encode(message, bytes);
    if constexpr (wire::needs_memory<Message>)
        return size && wire::decode(message, bytes.first(size.size()), memory);
    else
        return size && wire::decode(message, bytes.first(size.size()));
}

template <class... Messages>
bool all(jaus::message_list<Messages...>, std::span<std::byte> bytes, wire::arena& memory) {
    return (one<Messages>(bytes, memory) && ...);
}

} // namespace

bool all_messages_encode(std::span<std::byte> bytes, wire::arena& memory) {
    return all(jaus::messages{}, bytes, memory);
}
