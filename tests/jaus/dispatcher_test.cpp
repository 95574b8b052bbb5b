// From a message to its handler: which one is called, with what, and which are not.
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/random_message.hpp"
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/schema/jaus/catalog.hpp>
#include <jauscat/schema/jaus/communications.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <memory>

using namespace jauscat;
using namespace jauscat::test;
using jaus::dispatched;

namespace {

constexpr jaus::header header_of(std::uint16_t code) { return {.command_code = code, .sequence_number = 34}; }

/// Set Emergency with code 5, and the start of it.
constexpr auto emergency = hex_literal<2>("0500");
constexpr auto half_an_emergency = hex_literal<1>("05");
constexpr jaus::set_emergency emergency_code_5{.emergency_code = wire::bit_set<jaus::set_emergency_code>::from_bits(5)};

/// What handlers were called with.
struct record {
    int typed = 0, unknown = 0, malformed = 0, acknowledgement = 0;
    friend bool operator==(const record&, const record&) = default;
};
auto recording(record& r) {
    return jaus::dispatcher{jaus::on<jaus::set_emergency>([&](const auto&, const auto&) { ++r.typed; }),
                            jaus::on_unknown([&](const auto&, auto) { ++r.unknown; }),
                            jaus::on_malformed([&](const auto&, auto, auto) { ++r.malformed; }),
                            jaus::on_acknowledgement([&](const auto&) { ++r.acknowledgement; })};
}

template <class... Messages> struct message_list {};
using all_messages = message_list<jaus::set_component_authority, jaus::set_emergency, jaus::clear_emergency,
                                  jaus::query_component_status, jaus::report_component_status,
                                  jaus::report_heartbeat_pulse, jaus::set_wrench_effort, jaus::set_travel_speed,
                                  jaus::query_global_pose, jaus::query_wrench_effort, jaus::query_travel_speed,
                                  jaus::report_global_pose, jaus::report_wrench_effort, jaus::report_travel_speed>;

/// Handlers for all messages; each writes down its code and what the decoded message encodes to again.
template <class... Messages>
auto handle_all(message_list<Messages...>, std::vector<std::uint16_t>& codes, std::vector<std::byte>& body) {
    return jaus::dispatcher{jaus::on<Messages>([&](const jaus::header& head, const Messages& message) {
        codes.push_back(jaus::command_code_of<Messages>);
        CHECK(head.command_code == jaus::command_code_of<Messages>);
        body.resize(wire::encoded_size(message));
        CHECK(wire::encode(message, body));
    })...};
}

} // namespace

TEST_CASE("each message reaches the handler of its type and no other") {
    std::vector<std::uint16_t> called;
    std::vector<std::byte> body;
    auto dispatch = handle_all(all_messages{}, called, body);

    support::generator g{158};
    const auto send = [&]<class T>(T message) {
        std::array<std::byte, 64> out{};
        const auto bytes = jaus::make_message(header_of(0), message, out);
        REQUIRE(bytes);
        called.clear();
        // Not by split: the source is left out here.
        CHECK(dispatch(header_of(jaus::command_code_of<T>), bytes->subspan(16)) == dispatched::handled);
        CHECK(called == std::vector{jaus::command_code_of<T>});
        CHECK(to_hex(body) == to_hex(bytes->subspan(16)));
    };
    [&]<class... Messages>(message_list<Messages...>) {
        for (int i = 0; i != 50; ++i) (send(support::random_message<Messages>(g)), ...);
    }(all_messages{});
}

TEST_CASE("a handler sees the header as received and the decoded message") {
    jaus::header seen{};
    jaus::set_emergency message{};
    jaus::dispatcher dispatch{jaus::on<jaus::set_emergency>([&](const jaus::header& head, const auto& m) {
        seen = head;
        message = m;
    })};
    const auto head = header_of(0x0006);
    CHECK(dispatch(head, emergency) == dispatched::handled);
    CHECK(seen == head);
    CHECK(message == emergency_code_5);
}

TEST_CASE("every code without a handler is unknown") {
    record r{};
    auto dispatch = recording(r);
    int unknown = 0;
    for (unsigned code = 0; code != 0x10000; ++code)
        unknown += dispatch(header_of(static_cast<std::uint16_t>(code)), emergency) == dispatched::unknown;
    CHECK(unknown == 0xFFFF);
    CHECK(r == record{.typed = 1, .unknown = 0xFFFF});
}

TEST_CASE("the handler of unknown messages gets header and body") {
    std::uint16_t code = 0;
    std::string body;
    jaus::dispatcher dispatch{jaus::on_unknown([&](const jaus::header& head, std::span<const std::byte> bytes) {
        code = head.command_code;
        body = to_hex(bytes);
    })};
    CHECK(dispatch(header_of(0xD123), emergency) == dispatched::unknown);
    CHECK(code == 0xD123);
    CHECK(body == "05 00");
}

TEST_CASE("a body that does not decode is passed to the handler of malformed messages, never to that of its type") {
    record r{};
    auto dispatch = recording(r);
    CHECK(dispatch(header_of(0x0006), half_an_emergency) == dispatched::malformed);
    CHECK(dispatch(header_of(0x0006), {}) == dispatched::malformed);
    CHECK(dispatch(header_of(0x0006), hex_literal<3>("050000")) == dispatched::malformed);
    CHECK(r == record{.malformed = 3});
}

TEST_CASE("the handler of malformed messages gets header, body and the reason") {
    std::vector<wire::errc> reasons;
    std::string body;
    jaus::dispatcher dispatch{
        jaus::on<jaus::set_wrench_effort>([](const auto&, const auto&) { FAIL("handed on"); }),
        jaus::on_malformed([&](const jaus::header& head, std::span<const std::byte> bytes, wire::errc reason) {
            CHECK(head.command_code == 0x0405);
            body = to_hex(bytes);
            reasons.push_back(reason);
        })};
    CHECK(dispatch(header_of(0x0405), hex_literal<3>("0100 ff")) == dispatched::malformed);
    CHECK(body == "01 00 ff");
    CHECK(dispatch(header_of(0x0405), hex_literal<5>("0100 ff7f 00")) == dispatched::malformed);
    CHECK(dispatch(header_of(0x0405), hex_literal<4>("0100 0080")) == dispatched::malformed);
    CHECK(reasons == std::vector{wire::errc::truncated, wire::errc::trailing_bytes, wire::errc::out_of_range});
}

TEST_CASE("acknowledgements of any code are passed to their handler, not to that of the type or of unknown codes") {
    for (const auto kind : {jaus::ack_nak::ack, jaus::ack_nak::nak}) {
        record r{};
        auto dispatch = recording(r);
        for (const auto& entry : jaus::catalog) {
            auto head = header_of(entry.command_code);
            head.ack_nak = kind;
            CHECK(dispatch(head, {}) == dispatched::acknowledgement);
        }
        CHECK(r == record{.acknowledgement = 158});
    }
}

TEST_CASE("a message that requests acknowledgement is dispatched as a message") {
    record r{};
    auto dispatch = recording(r);
    auto head = header_of(0x0006);
    head.ack_nak = jaus::ack_nak::request;
    CHECK(dispatch(head, emergency) == dispatched::handled);
    CHECK(dispatch(head, {}) == dispatched::malformed);
    CHECK(r == record{.typed = 1, .malformed = 1});
}

TEST_CASE("a message with a body is a message, also with the bits of an acknowledgement") {
    record r{};
    auto dispatch = recording(r);
    auto head = header_of(0x0006);
    head.ack_nak = jaus::ack_nak::ack;
    CHECK(dispatch(head, emergency) == dispatched::handled);
    CHECK(r == record{.typed = 1});
}

TEST_CASE("a dispatcher without handlers still distinguishes all outcomes") {
    jaus::dispatcher<> none{};
    CHECK(none(header_of(0x0006), emergency) == dispatched::unknown);
    auto head = header_of(0x0006);
    head.ack_nak = jaus::ack_nak::ack;
    CHECK(none(head, {}) == dispatched::acknowledgement);

    jaus::dispatcher only_typed{jaus::on<jaus::set_emergency>([](const auto&, const auto&) {})};
    CHECK(only_typed(header_of(0x0006), half_an_emergency) == dispatched::malformed);
    CHECK(only_typed(header_of(0x0007), emergency) == dispatched::unknown);
    CHECK(only_typed(head, {}) == dispatched::acknowledgement);
}

TEST_CASE("handlers may be move-only") {
    auto count = std::make_unique<int>(0);
    int& seen = *count;
    jaus::dispatcher dispatch{
        jaus::on<jaus::set_emergency>([count = std::move(count)](const auto&, const auto&) { ++*count; }),
        jaus::on_unknown([other = std::make_unique<int>(0)](const auto&, auto) { ++*other; })};
    CHECK(dispatch(header_of(0x0006), emergency) == dispatched::handled);
    CHECK(seen == 1);
    auto moved = std::move(dispatch);
    CHECK(moved(header_of(0x0006), emergency) == dispatched::handled);
    CHECK(seen == 2);
}

TEST_CASE("handlers may have state") {
    std::vector<int> seen;
    jaus::dispatcher dispatch{
        jaus::on<jaus::set_emergency>([&seen, n = 0](const auto&, const auto&) mutable { seen.push_back(++n); })};
    for (int i = 0; i != 3; ++i) CHECK(dispatch(header_of(0x0006), emergency) == dispatched::handled);
    CHECK(seen == std::vector{1, 2, 3});
}

TEST_CASE("handlers may come in any order") {
    record r{};
    jaus::dispatcher dispatch{jaus::on_unknown([&](const auto&, auto) { ++r.unknown; }),
                              jaus::on<jaus::set_wrench_effort>([](const auto&, const auto&) { FAIL("not this"); }),
                              jaus::on_malformed([&](const auto&, auto, auto) { ++r.malformed; }),
                              jaus::on<jaus::set_emergency>([&](const auto&, const auto&) { ++r.typed; })};
    CHECK(dispatch(header_of(0x0006), emergency) == dispatched::handled);
    CHECK(dispatch(header_of(0x0006), half_an_emergency) == dispatched::malformed);
    CHECK(dispatch(header_of(0x0001), emergency) == dispatched::unknown);
    CHECK(r == record{.typed = 1, .unknown = 1, .malformed = 1});
}

TEST_CASE("a message is dispatched in a constant expression") {
    constexpr auto seen = [] {
        jaus::set_emergency message{};
        jaus::dispatcher dispatch{
            jaus::on<jaus::set_emergency>([&](const jaus::header&, const auto& m) { message = m; })};
        const auto result = dispatch(header_of(0x0006), emergency);
        return std::pair{result, message};
    }();
    STATIC_REQUIRE(seen.first == dispatched::handled);
    STATIC_REQUIRE(seen.second == emergency_code_5);
}
