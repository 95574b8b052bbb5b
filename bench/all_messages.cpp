// One translation unit that encodes and decodes every message: its compile time is one of the measures.
#include <jauscat/jauscat.hpp>

namespace {

template <class... Messages> bool all(jauscat::jaus::message_list<Messages...>, std::span<std::byte> bytes) {
    const auto one = [&]<class Message>(Message message) {
        const auto size = jauscat::wire::encode(message, bytes);
        return size && jauscat::wire::decode(message, bytes.first(size.size()));
    };
    return (one(Messages{}) && ...);
}

} // namespace

bool all_messages_encode(std::span<std::byte> bytes) { return all(jauscat::jaus::messages{}, bytes); }
