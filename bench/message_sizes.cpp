// Every message with a function that encodes it, one that decodes it, and as many bytes as it takes in memory: nm lists
// their sizes (scripts/measure sizes).
#include <jauscat/schema/jaus/messages.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;

template <class Message> std::size_t encode_one(const Message& message, std::span<std::byte> out) {
    return wire::encode(message, out)->size();
}
template <class Message> std::size_t decode_one(Message& message, std::span<const std::byte> in, wire::arena& memory) {
    if constexpr (wire::needs_memory<Message>)
        return *wire::decode(message, in, memory);
    else
        return *wire::decode(message, in);
}
template <class Message> std::byte in_memory[sizeof(Message)];

using function = void (*)();
template <class... Messages> struct used {
    static function functions[2 * sizeof...(Messages)];
    static std::byte* objects[sizeof...(Messages)];
};
template <class... Messages>
function used<Messages...>::functions[] = {reinterpret_cast<function>(&encode_one<Messages>)...,
                                           reinterpret_cast<function>(&decode_one<Messages>)...};
template <class... Messages> std::byte* used<Messages...>::objects[] = {in_memory<Messages>...};

template <class... Messages> constexpr used<Messages...> all_of(jaus::message_list<Messages...>) { return {}; }
using all = decltype(all_of(jaus::messages{}));
[[gnu::used]] function* const functions = all::functions;
[[gnu::used]] std::byte** const objects = all::objects;
