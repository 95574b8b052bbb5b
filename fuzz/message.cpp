// Bodies of any message: decode, raw, encode and (for some messages) diagnose agree with each other.
#include "support/canonical.hpp"
#include "support/messages.hpp"
#include <jauscat/wire/wire.hpp>

using namespace fuzz;
namespace wire = jauscat::wire;

namespace {

// What took `size` bytes of the arena needs no more than that; with less it is refused for that reason alone.
template <class T> void check_memory(std::span<const std::byte> body, std::size_t size) {
    byte_vector memory(size);
    for (const std::size_t given : {size, size / 2}) {
        wire::arena arena{std::span{memory}.first(given)};
        T message{};
        const wire::errc error = wire::decode(message, body, arena).error();
        check(error == wire::errc::ok || (given != size && error == wire::errc::arena_full),
              "lists take what the arena says");
    }
}

template <class T> [[gnu::noinline]] void check_body(std::span<const std::byte> body) {
    wire::arena& memory = fresh_arena();
    T message{};
    const auto decoded = wire::decode(message, body, memory);
    const std::size_t used = memory.used();
    if (decoded.error() == wire::errc::arena_full) return;
    wire::raw<T> raw{};
    const auto raw_decoded = wire::decode(raw, body, memory);
    if (raw_decoded.error() == wire::errc::arena_full) return;
    check(!decoded || raw_decoded, "what decodes has a raw");
    check(decoded.error() == wire::errc::ok || decoded.error() == wire::errc::out_of_range ||
              raw_decoded.error() == decoded.error(),
          "message and raw are refused for the same reason");
    if (!raw_decoded) return;
    const auto expected = canonical<T>(body);
    check(encoded(raw) == expected, "a raw encodes to the bytes it was decoded from");
    if (!decoded) return;

    check(*decoded == body.size(), "decode uses the whole body");
    check(encoded(message) == expected, "a message encodes to the bytes it was decoded from");
    if constexpr (wire::needs_memory<T>) check_memory<T>(body, used);
    if (expected && !expected->empty()) {
        byte_vector short_by_one(expected->size() - 1);
        check(wire::encode(message, short_by_one).error() == wire::errc::no_space, "one byte too few is no space");
    }
}

template <class T> [[gnu::noinline]] void check_diagnosis(std::span<const std::byte> body) {
    T message{};
    const wire::errc error = wire::decode(message, body, fresh_arena()).error();
    if (error == wire::errc::arena_full) return;
    const wire::diagnosis why = wire::diagnose<T>(body);
    check(why.error == error, "diagnose names the error of decode");
    if (error == wire::errc::ok) {
        check((wire::diagnose(message).error == wire::errc::ok) == encoded(message).has_value(),
              "diagnose finds something where encode does");
        return;
    }
    check(why.offset <= body.size(), "a diagnosis lies within the body");
    check(why.available == body.size() - why.offset, "a diagnosis counts what is left");
    if (why.error == wire::errc::trailing_bytes) return;
    check(!why.field.empty(), "a diagnosis names the field");
    check((why.error == wire::errc::truncated) == (why.needed > why.available),
          "only a truncated field needs more bytes");
}

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    with_body(input, jauscat::jaus::messages{}, []<class T>(std::span<const std::byte> body) { check_body<T>(body); });
    with_body(input, one_of_each_kind{}, []<class T>(std::span<const std::byte> body) { check_diagnosis<T>(body); });
}
