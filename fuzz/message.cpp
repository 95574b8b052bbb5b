// Bodies of any message: decode, raw, encode and diagnose agree with each other.
#include "support/canonical.hpp"
#include "support/messages.hpp"
#include <jauscat/wire/wire.hpp>

using namespace fuzz;
namespace wire = jauscat::wire;

namespace {

void check_diagnosis(const wire::diagnosis& why, wire::errc error, std::size_t size) {
    check(why.error == error, "diagnose names the error of decode");
    check(why.offset <= size, "a diagnosis lies within the body");
    if (error == wire::errc::ok) return;
    check(why.available == size - why.offset, "a diagnosis counts what is left");
    if (error == wire::errc::trailing_bytes) return;
    check(!why.field.empty(), "a diagnosis names the field");
    check((error == wire::errc::truncated) == (why.needed > why.available), "only a truncated field needs more bytes");
}

template <class T> void check_body(std::span<const std::byte> body) {
    T message{};
    const wire::result decoded = wire::decode(message, body);
    check_diagnosis(wire::diagnose<T>(body), decoded.error(), body.size());

    wire::raw<T> raw{};
    const wire::result raw_decoded = wire::decode(raw, body);
    check(!decoded || raw_decoded, "what decodes has a raw");
    check(decoded.error() == wire::errc::ok || decoded.error() == wire::errc::out_of_range ||
              raw_decoded.error() == decoded.error(),
          "message and raw are refused for the same reason");
    if (raw_decoded) check(encoded(raw) == canonical<T>(body), "a raw encodes to the bytes it was decoded from");
    if (!decoded) return;

    check(decoded.size() == body.size(), "decode uses the whole body");
    bytes again = encoded(message);
    check(again == canonical<T>(body), "a message encodes to the bytes it was decoded from");
    check(wire::diagnose(message).error == wire::errc::ok, "diagnose finds nothing where encode finds nothing");
    if (!again.empty()) {
        again.pop_back();
        check(wire::encode(message, again).error() == wire::errc::no_space, "one byte too few is no space");
    }
}

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    with_body(input, []<class T>(std::span<const std::byte> body) { check_body<T>(body); });
}
