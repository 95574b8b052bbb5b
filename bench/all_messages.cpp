// One translation unit that encodes and decodes every message: its compile time is one of the measures.
#include "encode_decode.hpp"
#include <jauscat/schema/jaus/messages.hpp>

namespace jaus = jauscat::jaus;

template <class... Messages>
bool encode_and_decode(jaus::message_list<Messages...>, std::span<std::byte> bytes, jauscat::wire::arena& memory) {
    return bench::all<Messages...>(bytes, memory);
}
bool all_messages(std::span<std::byte> bytes, jauscat::wire::arena& memory) {
    return encode_and_decode(jaus::messages{}, bytes, memory);
}
