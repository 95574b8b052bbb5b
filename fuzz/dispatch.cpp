// Whole datagrams: header, framing, dispatch and text. What does not decode reaches no handler.
#include "support/canonical.hpp"
#include "support/messages.hpp"
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/jaus/message/framing.hpp>
#include <jauscat/text/jaus.hpp>

using namespace fuzz;
using namespace jauscat;

namespace {

/// What the handlers saw.
struct record {
    int handled{}, unknown{}, malformed{}, acknowledged{};
    std::uint16_t code{};
    wire::errc error{};
    byte_vector again{}; ///< header and body, made again from what the handler got, if it may be sent
};

template <class T> struct take_message {
    record* seen;
    void operator()(const jaus::header& head, const T& message) const {
        ++seen->handled;
        seen->code = jaus::command_code_of<T>;
        byte_vector out(jaus::header_size + wire::encoded_size(message));
        const auto message_bytes = jaus::make_message(head, message, out);
        if (!message_bytes) return;
        check(message_bytes->size() == out.size(), "a message that was received can be made");
        seen->again = std::move(out);
    }
};

template <class... Messages>
jaus::dispatched dispatch(record& seen, const jaus::split_message& m, jaus::message_list<Messages...>) {
    jaus::dispatcher handlers{
        jaus::on<Messages>(take_message<Messages>{&seen})...,
        jaus::on_unknown([&](const jaus::header&, std::span<const std::byte>) { ++seen.unknown; }),
        jaus::on_malformed([&](const jaus::header&, std::span<const std::byte>, wire::errc error) {
            ++seen.malformed;
            seen.error = error;
        }),
        jaus::on_acknowledgement([&](const jaus::header&) { ++seen.acknowledged; })};
    return handlers(m.header, m.body, fresh_arena());
}

void check_dispatch(const jaus::split_message& m) {
    record seen;
    const auto what = dispatch(seen, m, one_of_each_kind{});
    check(seen.handled + seen.unknown + seen.malformed + seen.acknowledged == 1, "one handler is called");
    check((what == jaus::dispatched::handled) == (seen.handled == 1) &&
              (what == jaus::dispatched::unknown) == (seen.unknown == 1) &&
              (what == jaus::dispatched::malformed) == (seen.malformed == 1) &&
              (what == jaus::dispatched::acknowledgement) == (seen.acknowledged == 1),
          "the dispatcher says what it did");
    if (what == jaus::dispatched::acknowledgement) {
        check(jaus::is_acknowledgement(m.header) && m.body.empty(), "an acknowledgement has no body");
        return;
    }
    bool known = false;
    with_message(m.header.command_code, one_of_each_kind{}, [&]<class T>() {
        known = true;
        T message{};
        const auto decoded = wire::decode(message, m.body, fresh_arena());
        check(static_cast<bool>(decoded) == (seen.handled == 1), "a handler gets exactly what decodes");
        check(decoded || decoded.error() == seen.error, "the malformed handler gets the error of decode");
        if (!decoded) return;
        check(seen.code == m.header.command_code, "a handler gets its own message");
        auto head = m.header;
        const auto body = canonical<T>(m.body); // may be shorter: an open presence vector drops bytes
        byte_vector expected;
        if (body) {
            head.data_size = static_cast<std::uint16_t>(body->size());
            expected = encoded(head).value();
            expected.insert(expected.end(), body->begin(), body->end());
        }
        check(seen.again == expected, "a message made again has the same bytes");
    });
    check(known == (seen.unknown == 0), "only an unknown command code is called unknown");
}

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    const auto framed = jaus::remove_framing(input);
    const jaus::message_prefix prefix{framed.how, framed.message.size()};
    check(std::ranges::equal(input.first(prefix.bytes().size()), prefix.bytes()), "the prefix is that of the framing");
    check(framed.message.size() + prefix.bytes().size() + framed.rest.size() == input.size(), "only that is taken off");
    for (auto part = framed; !part.rest.empty() && !part.message.empty();) {
        const auto before = part.rest.size();
        part = jaus::next_message(part);
        check(part.message.empty() || part.rest.size() + part.message.size() + 4 == before, "no byte is lost");
    }
    const byte_vector message = copy_of(framed.message);
    const auto m = jaus::split(message);
    check(!text::annotate_message(message, one_of_each_kind{}).empty(), "there is a text for any bytes");
    if (message.size() < jaus::header_size) {
        check(m.error == jaus::errc::truncated, "what is shorter than a header is truncated");
        return;
    }
    jaus::header head{};
    check(static_cast<bool>(wire::decode_prefix(head, std::span{message})), "any 16 bytes are a header");
    check(encoded(head) == copy_of(std::span{message}.first(jaus::header_size)), "a header keeps all its bits");
    if (!m) return;
    check(m.header == head && m.body.size() == head.data_size, "split gives the header and its body");
    check_dispatch(m);
}
