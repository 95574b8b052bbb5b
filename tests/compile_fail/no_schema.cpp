#include "small_message.hpp"
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/net/node/node_machine.hpp>

#ifdef ANSWER
// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
const auto sent = jauscat::jaus::answer(jauscat::jaus::header{}, jauscat::jaus::address{}, small_message{},
                                        [](std::span<const std::byte>) {});
#endif

#ifdef ARRAY
// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
struct around {
    std::array<small_message, 2> message{};
};

template <> struct jauscat::wire::schema<around> {
    using type = layout<array<&around::message>>;
};

static_assert(size_of_wrong<around> != 0);
#endif

#ifdef DECODE
// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
small_message message{};
const std::array<std::byte, 8> in{};
const auto used = jauscat::wire::decode(message, in);
#endif

#ifdef DIAGNOSE
// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
const std::array<std::byte, 8> in{};
const auto why = jauscat::wire::diagnose<small_message>(in);
#endif

#ifdef ENCODE
// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
std::array<std::byte, 8> out{};
const auto written = jauscat::wire::encode(small_message{}, out);
#endif

#ifdef NESTED
// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
struct around {
    small_message message{};
};

template <> struct jauscat::wire::schema<around> {
    using type = layout<nested<&around::message>>;
};

static_assert(size_of_wrong<around> != 0);
#endif

#ifdef NODE_SEND
// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
auto send(jauscat::net::node_machine& node) {
    return node.send(jauscat::jaus::header{}, small_message{}, jauscat::time_point{});
}
#endif

#ifdef RAW
// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
jauscat::wire::raw<small_message> raw{};
#endif

#ifdef VIEW
// expect: the type has no schema: give it a struct schema with its layout as type, or specialise jauscat::wire::schema
// for it
const std::array<std::byte, 8> in{};
const jauscat::wire::view<small_message> view{in};
#endif
