// Acknowledged messages: repeated until answered, delivered once.
#include "jaus/lossy_channel.hpp"
#include "support/catch.hpp"
#include "support/instant.hpp"
#include <jauscat/jaus/component/acknowledged_receiver.hpp>
#include <jauscat/jaus/component/acknowledged_sender.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <tuple>

namespace {

using namespace jauscat::test;
using namespace std::chrono_literals;
using support::instant;
namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
using jaus::ack_nak;
using jaus::delivered;
using jaus::message_outcome;
using jaus::received;
using jaus::send_errc;
using nanoseconds = std::chrono::nanoseconds;

constexpr jaus::address arm_address{1, 49, 2, 3}, ocu_address{1, 32, 1, 1}, other{1, 33, 1, 1};
constexpr jaus::header to_arm{.destination = arm_address, .source = ocu_address};

/// A sender with two places, and what it has heard.
struct ocu {
    std::array<jaus::awaited_message, 2> places{};
    std::array<std::byte, 2 * 20> copies{};
    jaus::acknowledged_sender commands{places, copies, {.retry = {.interval = 100ms, .attempts = 3}}};
    sent_messages sent{};
    std::vector<std::pair<std::uint16_t, delivered>> heard{}; // sequence number and outcome

    auto tell() {
        return [this](const jaus::awaited_message& m, delivered what) {
            heard.emplace_back(m.header.sequence_number, what);
        };
    }
    bool answer(std::uint16_t code, std::uint16_t number, ack_nak how, jaus::address from = arm_address,
                jaus::address to = ocu_address) {
        return commands.on_message(
            {.ack_nak = how, .command_code = code, .destination = to, .source = from, .sequence_number = number},
            tell());
    }
    void on_time(instant now) { commands.on_time(now, sent.sink(), tell()); }
};
using outcomes = std::vector<std::pair<std::uint16_t, delivered>>;

/// A receiver with eight places, and the delivered messages.
struct arm {
    std::array<jaus::acknowledged_message, 8> places{};
    jaus::acknowledged_receiver commands{arm_address, places, 1s};
    sent_messages sent{};
    int handed_on{};

    received hear(std::uint16_t code, std::uint16_t number, std::uint8_t body = 0, instant now = 0s,
                  message_outcome outcome = message_outcome::handled, jaus::address from = ocu_address,
                  ack_nak wish = ack_nak::request, jaus::address to = arm_address) {
        const jaus::header head{.ack_nak = wish,
                                .command_code = code,
                                .destination = to,
                                .source = from,
                                .data_size = 1,
                                .sequence_number = number};
        const std::byte bytes[]{std::byte{body}};
        return commands.on_message(head, bytes, now, sent.sink(), [&] { return ++handed_on, outcome; });
    }
    ack_nak answer(std::size_t i) {
        const auto head = sent.header(i);
        REQUIRE(head.data_size == 0);
        REQUIRE(head.source == arm_address);
        return head.ack_nak;
    }
};

} // namespace

TEST_CASE("a message requests acknowledgement and is not sent again once acknowledged") {
    ocu o;
    const auto sent = o.commands.send(to_arm, jaus::set_component_authority{7}, instant{1s}, o.sent.sink());
    REQUIRE(sent);
    REQUIRE(o.sent.size() == 1);
    REQUIRE(o.sent.header(0).ack_nak == ack_nak::request);
    REQUIRE(o.sent.header(0).sequence_number == *sent);
    REQUIRE(o.sent.body<jaus::set_component_authority>(0).authority_code == 7);
    REQUIRE(o.commands.waiting() == 1);
    REQUIRE(o.answer(0x0001, *sent, ack_nak::ack));
    REQUIRE(o.heard == outcomes{{*sent, delivered::acknowledged}});
    REQUIRE(o.commands.waiting() == 0);
    REQUIRE_FALSE(o.commands.next_event());
    o.on_time(instant{10s});
    REQUIRE(o.sent.size() == 1);
    REQUIRE_FALSE(o.answer(0x0001, *sent, ack_nak::ack)); // a second one is nobody's
    REQUIRE(o.heard.size() == 1);
}

TEST_CASE("a message that is forgotten is not sent again, and has no outcome") {
    ocu o;
    const auto sent = o.commands.send(to_arm, jaus::standby{}, instant{1s}, o.sent.sink());
    REQUIRE(sent);
    const auto head = o.sent.header(0);
    auto another = head;
    ++another.sequence_number;
    REQUIRE_FALSE(o.commands.forget(another));
    another = head;
    another.destination = other;
    REQUIRE_FALSE(o.commands.forget(another));
    REQUIRE(o.commands.forget(head));
    REQUIRE_FALSE(o.commands.forget(head));
    REQUIRE(o.commands.waiting() == 0);
    o.on_time(instant{10s});
    REQUIRE(o.sent.size() == 1);
    REQUIRE_FALSE(o.answer(0x0003, *sent, ack_nak::ack));
    REQUIRE(o.heard.empty());
}

TEST_CASE("a NAK is an outcome") {
    ocu o;
    REQUIRE(o.commands.send(to_arm, jaus::standby{}, instant{0s}, o.sent.sink()));
    REQUIRE(o.answer(0x0003, 1, ack_nak::nak));
    REQUIRE(o.heard == outcomes{{1, delivered::refused}});
}

TEST_CASE("a message without an answer is repeated unchanged, and abandoned after all attempts") {
    ocu o;
    REQUIRE(o.commands.send(to_arm, jaus::standby{}, instant{1s}, o.sent.sink()));
    REQUIRE(o.commands.next_event() == instant{1100ms});
    o.on_time(instant{1100ms - 1ns});
    REQUIRE(o.sent.size() == 1);
    o.on_time(instant{1100ms});
    REQUIRE(o.sent.size() == 2);
    REQUIRE(o.commands.next_event() == instant{1200ms});
    o.on_time(instant{1250ms}); // late: the next timeout counts from here
    REQUIRE(o.commands.next_event() == instant{1350ms});
    REQUIRE(o.sent.size() == 3);
    REQUIRE(o.sent[1] == o.sent[0]);
    REQUIRE(o.sent[2] == o.sent[0]);
    REQUIRE(o.heard.empty());
    o.on_time(instant{1350ms});
    REQUIRE(o.sent.size() == 3);
    REQUIRE(o.heard == outcomes{{1, delivered::timed_out}});
    REQUIRE_FALSE(o.commands.next_event());
    REQUIRE_FALSE(o.answer(0x0003, 1, ack_nak::ack));
}

// Its receiver may have forgotten it by then, and would obey it a second time.
TEST_CASE("a message due for repetition while its program was suspended is abandoned") {
    ocu o;
    REQUIRE(o.commands.send(to_arm, jaus::standby{}, instant{1s}, o.sent.sink()));
    o.on_time(instant{1100ms});
    REQUIRE(o.sent.size() == 2);
    o.on_time(instant{1300ms - 1ns}); // late, and soon enough
    REQUIRE(o.sent.size() == 3);
    REQUIRE(o.commands.send(to_arm, jaus::resume{}, instant{2s}, o.sent.sink()));
    o.on_time(instant{2300ms}); // suspended
    REQUIRE(o.sent.size() == 4);
    REQUIRE(o.heard == outcomes{{1, delivered::timed_out}, {2, delivered::timed_out}});
    REQUIRE_FALSE(o.answer(0x0004, 2, ack_nak::ack)); // it lay in the socket
}

TEST_CASE("an acknowledgement counts only with the code, number, sender and addressee of the message") {
    ocu o;
    REQUIRE(o.commands.send(to_arm, jaus::standby{}, instant{0s}, o.sent.sink()));
    REQUIRE_FALSE(o.answer(0x0004, 1, ack_nak::ack));
    REQUIRE_FALSE(o.answer(0x0003, 2, ack_nak::ack));
    REQUIRE_FALSE(o.answer(0x0003, 1, ack_nak::ack, other));
    REQUIRE_FALSE(o.answer(0x0003, 1, ack_nak::ack, arm_address, other));
    REQUIRE_FALSE(o.answer(0x0003, 1, ack_nak::none));
    REQUIRE_FALSE(o.answer(0x0003, 1, ack_nak::request));
    REQUIRE(o.heard.empty());
    REQUIRE(o.answer(0x0003, 1, ack_nak::ack));
}

TEST_CASE("as many messages as places can wait") {
    ocu o;
    REQUIRE(o.commands.send(to_arm, jaus::standby{}, instant{0s}, o.sent.sink()));
    REQUIRE(o.commands.send(to_arm, jaus::resume{}, instant{50ms}, o.sent.sink()).value_or(0) == 2);
    REQUIRE(o.commands.send(to_arm, jaus::resume{}, instant{50ms}, o.sent.sink()).error().code ==
            send_errc::no_capacity);
    REQUIRE(o.sent.size() == 2);
    REQUIRE(o.commands.next_event() == instant{100ms});
    REQUIRE(o.answer(0x0003, 1, ack_nak::ack));
    REQUIRE(o.commands.next_event() == instant{150ms});
    REQUIRE(o.commands.send(to_arm, jaus::resume{}, instant{50ms}, o.sent.sink()).value_or(0) == 3);
}

TEST_CASE("messages that cannot be acknowledged, or do not fit, are not sent") {
    ocu o;
    const auto send = [&](const jaus::header& head, const auto& body) {
        return o.commands.send(head, body, instant{0s}, o.sent.sink()).error();
    };
    const auto no_message = [](jaus::errc why) {
        return jaus::send_error{.code = send_errc::invalid_message, .message = why};
    };
    REQUIRE(send({.destination = {255, 49, 2, 3}, .source = ocu_address}, jaus::standby{}) ==
            jaus::send_error{send_errc::not_one_address});
    REQUIRE(send({.destination = {1, 49, 0, 3}, .source = ocu_address}, jaus::standby{}) ==
            jaus::send_error{send_errc::not_one_address});
    REQUIRE(send({.priority = 16, .destination = arm_address}, jaus::standby{}) ==
            no_message(jaus::errc::invalid_header));
    REQUIRE(send(to_arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = 101}) ==
            jaus::send_error{.code = send_errc::not_encodable, .body = wire::errc::out_of_range});
    REQUIRE(describe(send(to_arm, jaus::set_wrench_effort{.propulsive_linear_effort_x = 101})) ==
            wire::describe(wire::errc::out_of_range));
    REQUIRE(send(to_arm, jaus::report_component_control{}) ==
            jaus::send_error{send_errc::too_large}); // 21 bytes, a place has 20
    const auto large = message(to_arm, jaus::report_component_control{});
    REQUIRE(o.commands.send(large, instant{0s}, o.sent.sink()).error().code == send_errc::too_large);
    REQUIRE(o.commands.send(std::span{large}.first(15), instant{0s}, o.sent.sink()).error() ==
            no_message(jaus::errc::truncated));
    REQUIRE(describe(no_message(jaus::errc::truncated)) == describe(jaus::errc::truncated));
    REQUIRE(o.commands.send(std::span{large}.first(20), instant{0s}, o.sent.sink()).error() ==
            no_message(jaus::errc::wrong_size));
    const auto part = message({.destination = arm_address, .data_flag = jaus::data_flag::first}, jaus::standby{});
    REQUIRE(o.commands.send(part, instant{0s}, o.sent.sink()).error().code == send_errc::too_large);
    REQUIRE(o.sent.empty());
    REQUIRE(o.commands.waiting() == 0);
    REQUIRE(jaus::acknowledged_sender{{}, {}}.send(to_arm, jaus::standby{}, instant{0s}, o.sent.sink()).error().code ==
            send_errc::no_capacity);
}

TEST_CASE("a complete message is sent with a sequence number of the sender's") {
    ocu o;
    const auto ready =
        message({.priority = 9, .destination = arm_address, .source = ocu_address, .sequence_number = 50},
                jaus::set_component_authority{3});
    REQUIRE(o.commands.send(ready, instant{0s}, o.sent.sink()).value_or(0) == 1);
    REQUIRE(o.commands.send(ready, instant{0s}, o.sent.sink()).value_or(0) == 2);
    REQUIRE(o.sent.header(1).sequence_number == 2);
    REQUIRE(o.sent.header(1).priority == 9);
    REQUIRE(o.sent.header(1).ack_nak == ack_nak::request);
    REQUIRE(o.sent.body<jaus::set_component_authority>(1).authority_code == 3);
}

TEST_CASE("a restarted program begins with another number, so that its first message is not a repeat") {
    arm a;
    for (const std::uint16_t first : {std::uint16_t{1}, std::uint16_t{40000}, std::uint16_t{0xFFFE}}) {
        std::array<jaus::awaited_message, 2> places{};
        std::array<std::byte, 2 * 20> copies{};
        jaus::acknowledged_sender commands{places, copies, {.first_number = first}};
        sent_messages sent{};
        REQUIRE(commands.send(to_arm, jaus::release_component_control{}, instant{0s}, sent.sink()).value_or(0) ==
                first);
        REQUIRE(a.hear(0x000E, first) == received::handed_on);
        REQUIRE(a.hear(0x000E, first) == received::repeated);
        REQUIRE(commands.send(to_arm, jaus::standby{}, instant{0s}, sent.sink()).value_or(0) ==
                static_cast<std::uint16_t>(first + 1));
    }
    REQUIRE(a.handed_on == 3);
}

TEST_CASE("numbers wrap around and skip those in use") {
    ocu o;
    REQUIRE(o.commands.send(to_arm, jaus::standby{}, instant{0s}, o.sent.sink()).value_or(0) == 1);
    for (unsigned n = 2; n <= 0xFFFF; ++n) {
        REQUIRE(o.commands.send(to_arm, jaus::standby{}, instant{0s}, o.sent.sink()).value_or(0) == n);
        REQUIRE(o.answer(0x0003, static_cast<std::uint16_t>(n), ack_nak::ack));
        o.sent.clear();
    }
    // 0 is the number of those that do not count.
    REQUIRE(o.commands.send(to_arm, jaus::standby{}, instant{0s}, o.sent.sink()).value_or(0) == 2);
}

TEST_CASE("the outcome handler may send the next message in the freed place") {
    ocu o;
    REQUIRE(o.commands.send(to_arm, jaus::standby{}, instant{0s}, o.sent.sink()));
    REQUIRE(o.commands.send(to_arm, jaus::standby{}, instant{0s}, o.sent.sink()));
    int next = 0;
    const auto send_next = [&](const jaus::awaited_message&, delivered) {
        next += static_cast<bool>(o.commands.send(to_arm, jaus::resume{}, instant{1s}, o.sent.sink()));
    };
    REQUIRE(o.commands.on_message({.ack_nak = ack_nak::ack,
                                   .command_code = 3,
                                   .destination = ocu_address,
                                   .source = arm_address,
                                   .sequence_number = 1},
                                  send_next));
    REQUIRE(next == 1);
    for (const auto now : {1000ms, 1100ms, 1200ms, 1300ms}) o.commands.on_time(instant{now}, o.sent.sink(), send_next);
    REQUIRE(next == 4); // the second one had waited for a second: it was given up at once
    REQUIRE(o.commands.waiting() == 2);
}

TEST_CASE("an executed message is acknowledged, a refused one gets a NAK") {
    arm a;
    REQUIRE(a.hear(0x0001, 5) == received::handed_on);
    REQUIRE(a.hear(0x0001, 6, 0, 0s, message_outcome::refused) == received::handed_on);
    REQUIRE(a.hear(0x0001, 7, 0, 0s, message_outcome::malformed) == received::handed_on);
    REQUIRE(a.hear(0x0001, 8, 0, 0s, message_outcome::unhandled) == received::handed_on);
    REQUIRE(a.sent.size() == 4);
    REQUIRE(a.answer(0) == ack_nak::ack);
    REQUIRE(a.sent.header(0).sequence_number == 5);
    REQUIRE(a.sent.header(0).command_code == 0x0001);
    REQUIRE(a.sent.header(0).destination == ocu_address);
    for (const std::size_t i : {1u, 2u, 3u}) REQUIRE(a.answer(i) == ack_nak::nak);
}

TEST_CASE("a repeat gets the same answer and is not delivered") {
    arm a;
    a.hear(0x0001, 5, 1);
    REQUIRE(a.hear(0x0001, 5, 1, 500ms, message_outcome::refused) == received::repeated);
    REQUIRE(a.answer(1) == ack_nak::ack);
    a.hear(0x0001, 6, 1, 500ms, message_outcome::refused);
    REQUIRE(a.hear(0x0001, 6, 1, 600ms) == received::repeated);
    REQUIRE(a.answer(3) == ack_nak::nak);
    REQUIRE(a.handed_on == 2);
}

TEST_CASE("a message with another source, code, number or body is not a repeat") {
    arm a;
    a.hear(0x0001, 5, 1);
    REQUIRE(a.hear(0x0002, 5, 1) == received::handed_on);
    REQUIRE(a.hear(0x0001, 6, 1) == received::handed_on);
    REQUIRE(a.hear(0x0001, 5, 2) == received::handed_on);
    REQUIRE(a.hear(0x0001, 5, 1, 0s, message_outcome::handled, other) == received::handed_on);
    REQUIRE(a.handed_on == 5);
}

TEST_CASE("a message is remembered for a limited time") {
    arm a;
    a.hear(0x0001, 5);
    REQUIRE(a.hear(0x0001, 5, 0, 1s - 1ns) == received::repeated);
    REQUIRE(a.hear(0x0001, 5, 0, 1s) == received::handed_on);
}

TEST_CASE("an unlimited memory or timeout never expires") {
    arm a;
    a.commands = {arm_address, a.places, nanoseconds::max()};
    a.hear(0x0001, 5, 0, 1s);
    REQUIRE(a.hear(0x0001, 5, 0, 1000h) == received::repeated);
    ocu o;
    o.commands = {o.places, o.copies, {.retry = {.interval = nanoseconds::max(), .attempts = 4}}};
    REQUIRE(o.commands.send(to_arm, jaus::standby{}, instant{1s}, o.sent.sink()));
    o.on_time(instant{1000h});
    REQUIRE(o.sent.size() == 1);
}

TEST_CASE("of a sender that numbers all messages 0, only two equal messages in a row are a repeat") {
    arm a;
    REQUIRE(a.hear(0x0003, 0) == received::handed_on);
    REQUIRE(a.hear(0x0003, 0) == received::repeated);
    REQUIRE(a.hear(0x0004, 0) == received::handed_on);
    REQUIRE(a.hear(0x0003, 0, 0, 0s, message_outcome::handled, other) == received::handed_on);
    REQUIRE(a.hear(0x0003, 0) == received::handed_on);
    REQUIRE(a.hear(0x0003, 0, 0, 0s, message_outcome::handled, other) == received::handed_on);
    REQUIRE(a.hear(0x0003, 0, 0, 0s, message_outcome::handled, other) == received::repeated);
    for (std::uint8_t body = 0; body != 100; ++body) // one place is enough for them
        REQUIRE(a.hear(0x0405, 0, body) == received::handed_on);
    REQUIRE(a.handed_on == 105);
}

TEST_CASE("of a sender that numbers all messages 0, any command in between makes the next one new") {
    arm a;
    const auto plain = [&](std::uint16_t code, std::uint16_t number = 0) {
        return a.hear(code, number, 0, 0s, message_outcome::handled, ocu_address, ack_nak::none);
    };
    REQUIRE(a.hear(0x0003, 0) == received::handed_on);
    plain(0x0004); // Resume without acknowledgement
    REQUIRE(a.hear(0x0003, 0) == received::handed_on);
    REQUIRE(a.hear(0x0003, 0) == received::repeated);
    plain(0x2000); // a query or a report changes nothing
    plain(0x2002);
    plain(0x4202);
    plain(0x5FFF);
    a.hear(0x2002, 0);
    REQUIRE(a.hear(0x0003, 0) == received::repeated);
    plain(0xD001);
    REQUIRE(a.hear(0x0003, 0) == received::handed_on);
    a.hear(0x0004, 0, 0, 0s, message_outcome::handled, ocu_address, ack_nak::request, {255, 255, 2, 3}); // to all
    REQUIRE(a.hear(0x0003, 0) == received::handed_on);
    for (int i = 0; i != 3; ++i) { // Set and Clear Emergency, both acknowledged
        REQUIRE(a.hear(0x0006, 0) == received::handed_on);
        REQUIRE(a.hear(0x0007, 0) == received::handed_on);
        REQUIRE(a.hear(0x0007, 0) == received::repeated);
    }
}

TEST_CASE("of a sender that numbers all messages 0, an action caused by another sender makes the next message new") {
    arm a;
    const auto another = [&](std::uint16_t code, message_outcome outcome, ack_nak wish = ack_nak::none) {
        return a.hear(code, 7, 0, 0s, outcome, other, wish);
    };
    REQUIRE(a.hear(0x0405, 0) == received::handed_on); // efforts 0
    REQUIRE(a.hear(0x0405, 0) == received::repeated);
    another(0x0405, message_outcome::refused); // it has no control
    another(0x2002, message_outcome::handled); // a query
    REQUIRE(a.hear(0x0405, 0) == received::repeated);
    another(0x0405, message_outcome::handled);
    REQUIRE(a.hear(0x0405, 0) == received::handed_on);
    REQUIRE(a.hear(0x0405, 0) == received::repeated);
    another(0x0006, message_outcome::handled, ack_nak::request);
    REQUIRE(a.hear(0x0405, 0) == received::handed_on);
    a.commands.on_change(); // it has failed
    REQUIRE(a.hear(0x0405, 0) == received::handed_on);
    REQUIRE(a.hear(0x0405, 0) == received::repeated);
    REQUIRE(a.handed_on == 8);
}

TEST_CASE("a possible repeat of an executed message numbered 0 gets no NAK") {
    arm a;
    REQUIRE(a.hear(0x0405, 0) == received::handed_on);
    a.commands.on_change();
    for (int i = 0; i != 2; ++i) {
        a.sent.clear();
        REQUIRE(a.hear(0x0405, 0, 0, 0s, message_outcome::refused) == received::handed_on);
        REQUIRE(a.sent.size() == 0);
    }
    REQUIRE(a.hear(0x0405, 0) == received::handed_on);
    REQUIRE(a.answer(0) == ack_nak::ack);
    REQUIRE(a.hear(0x0405, 0, 1, 0s, message_outcome::refused) == received::handed_on); // another body
    REQUIRE(a.answer(1) == ack_nak::nak);
    REQUIRE(a.hear(0x0405, 0, 1, 0s) == received::repeated);
    REQUIRE(a.hear(0x0405, 0, 0, 5s, message_outcome::refused) == received::handed_on); // forgotten
    REQUIRE(a.answer(3) == ack_nak::nak);
}

TEST_CASE("a possible repeat numbered 0 that was not answered is remembered, so that the next one gets no NAK either") {
    arm a; // remembers for a second
    REQUIRE(a.hear(0x0405, 0) == received::handed_on);
    a.commands.on_change();
    a.sent.clear();
    for (const auto now : {900ms, 1500ms})
        REQUIRE(a.hear(0x0405, 0, 0, now, message_outcome::refused) == received::handed_on);
    REQUIRE(a.sent.size() == 0);
}

TEST_CASE("a refused repeat of a pending message numbered 0 gets no NAK") {
    arm a;
    REQUIRE(a.hear(0x0405, 0, 1, 0s, message_outcome::deferred) == received::handed_on);
    REQUIRE(a.hear(0x0004, 0) == received::handed_on); // a command in between: the next one may be new
    REQUIRE(a.answer(0) == ack_nak::ack);
    for (int i = 0; i != 2; ++i) REQUIRE(a.hear(0x0405, 0, 1, 0s, message_outcome::refused) == received::handed_on);
    REQUIRE(a.sent.size() == 1);
    const jaus::header pending{
        .ack_nak = ack_nak::request, .command_code = 0x0405, .destination = arm_address, .source = ocu_address};
    REQUIRE(a.commands.finish(pending, true, instant{0s}, a.sent.sink()));
    REQUIRE(a.answer(1) == ack_nak::ack);
}

TEST_CASE("a restarted program that then numbers all messages 0 is recognised") {
    arm a;
    const auto begun_anew = GENERATE(0ms, 500ms);                    // all of it may have waited in the socket
    const auto number = GENERATE(as<std::uint16_t>{}, 4711, 0xFF80); // also one that 0 may follow soon
    REQUIRE(a.hear(0x0405, number) == received::handed_on);
    REQUIRE(a.hear(0x0004, 0, 0, begun_anew) == received::handed_on);
    a.hear(0x0006, 0, 0, begun_anew + 100ms); // not remembered
    REQUIRE(a.hear(0x0004, 0, 0, begun_anew + 200ms) == received::handed_on);
}

TEST_CASE("a restarted program that numbers several commands 0 is treated as not counting, whatever came before") {
    arm a;
    REQUIRE(a.hear(0x0405, 0xFF80) == received::handed_on); // 0 may follow soon
    REQUIRE(a.hear(0x0405, 0) == received::handed_on);
    REQUIRE(a.hear(0x0004, 0) == received::handed_on);
    a.commands.on_change(); // another unit has got control
    REQUIRE(a.hear(0x0004, 0) == received::handed_on);
}

TEST_CASE("a counting sender may send plain messages numbered 0 in between") {
    arm a;
    REQUIRE(a.hear(0x0003, 0xFFFF) == received::handed_on);
    REQUIRE(a.hear(0x0004, 0) == received::handed_on); // around
    a.hear(0x0405, 0, 0, 0s, message_outcome::handled, ocu_address, ack_nak::none);
    REQUIRE(a.hear(0x0004, 0) == received::repeated);
    REQUIRE(a.hear(0x0003, 0xFFFF) == received::repeated);
    REQUIRE(a.hear(0x0003, 0) == received::handed_on); // 0 for another message: the others may still be repeated
    REQUIRE(a.hear(0x0003, 0xFFFF) == received::repeated);
}

TEST_CASE("a program restarted with the same numbers is obeyed as soon as that is detectable") {
    arm a;
    for (const std::uint16_t number : {std::uint16_t{7}, std::uint16_t{8}, std::uint16_t{9}})
        REQUIRE(a.hear(0x0405, number, 1) == received::handed_on);
    REQUIRE(a.hear(0x0405, 7, 1) == received::repeated);  // may be a late copy: it must not move anything again
    REQUIRE(a.hear(0x0405, 8, 2) == received::handed_on); // another message with a known number: it has begun anew
    REQUIRE(a.hear(0x0405, 9, 1) == received::handed_on);
    REQUIRE(a.hear(0x0405, 9, 1) == received::repeated);
    REQUIRE(a.hear(0x0405, 8, 2) == received::repeated);
    REQUIRE(a.handed_on == 5);
}

TEST_CASE("a restarted program's command that was lost at first is executed, although one of the run before is equal") {
    arm a;
    REQUIRE(a.hear(0x0405, 7, 1, 0ms) == received::handed_on);
    REQUIRE(a.hear(0x0405, 8, 1, 10ms) == received::handed_on);
    REQUIRE(a.hear(0x0405, 8, 2, 100ms) == received::handed_on); // it has restarted, and its 7 was lost
    REQUIRE(a.hear(0x0405, 7, 1, 150ms) == received::handed_on);
    REQUIRE(a.hear(0x0405, 7, 1, 160ms) == received::repeated);
    REQUIRE(a.handed_on == 4);
}

TEST_CASE("what a restarted program has sent since is not forgotten when it is known to have restarted") {
    arm a;
    const auto number = GENERATE(as<std::uint16_t>{}, 10, 2); // also after 1, the first number of a program
    const auto before = static_cast<std::uint16_t>(number - 1), after = static_cast<std::uint16_t>(number + 1);
    REQUIRE(a.hear(0x0405, number, 1, 0ms) == received::handed_on);
    REQUIRE(a.hear(0x0405, after, 1, 10ms) == received::handed_on);
    REQUIRE(a.hear(0x0405, before, 2, 100ms) == received::handed_on); // it has restarted
    REQUIRE(a.hear(0x0005, number, 0, 120ms) == received::handed_on); // which shows from now on
    REQUIRE(a.hear(0x0405, before, 2, 155ms) == received::repeated);  // a copy that was late
    REQUIRE(a.hear(0x0405, after, 1, 160ms) == received::handed_on);
}

TEST_CASE("a repeated Set Emergency and a repeated query are executed again") {
    arm a;
    for (const std::uint16_t code : {std::uint16_t{0x0006}, std::uint16_t{0x2002}})
        for (int i = 0; i != 20; ++i) REQUIRE(a.hear(code, 5) == received::handed_on);
    REQUIRE(a.handed_on == 40);
    REQUIRE(a.sent.size() == 40);
    REQUIRE(a.hear(0x0006, 5, 0, 0s, message_outcome::malformed) == received::handed_on);
    REQUIRE(a.answer(40) == ack_nak::nak);
}

TEST_CASE("every message without acknowledgement request is delivered") {
    arm a;
    for (int i = 0; i != 20; ++i)
        REQUIRE(a.hear(0x0001, 5, 0, 0s, message_outcome::handled, ocu_address, ack_nak::none) == received::handed_on);
    REQUIRE(a.handed_on == 20);
    REQUIRE(a.sent.empty());
}

TEST_CASE("a broadcast is delivered and not acknowledged") {
    arm a;
    REQUIRE(a.hear(0x0001, 5, 0, 0s, message_outcome::handled, ocu_address, ack_nak::request, {255, 255, 2, 3}) ==
            received::handed_on);
    REQUIRE(a.handed_on == 1);
    REQUIRE(a.sent.empty());
}

TEST_CASE("one source cannot occupy all places, all sources together can, Set Emergency is exempt") {
    arm a;
    for (std::uint16_t i = 0; i != 4; ++i) REQUIRE(a.hear(0x0001, i) == received::handed_on);
    REQUIRE(a.hear(0x0001, 4) == received::no_capacity);
    REQUIRE(a.hear(0x0001, 3) == received::repeated); // what is known is answered all the same
    for (std::uint16_t i = 0; i != 4; ++i)
        REQUIRE(a.hear(0x0001, i, 0, 0s, message_outcome::handled, other) == received::handed_on);
    REQUIRE(a.hear(0x0001, 0, 0, 0s, message_outcome::handled, {1, 40, 1, 1}) == received::no_capacity);
    a.sent.clear();
    REQUIRE(a.hear(0x0006, 9) == received::handed_on);
    REQUIRE(a.answer(0) == ack_nak::ack);
    REQUIRE(a.handed_on == 9);
    REQUIRE(a.hear(0x0001, 4, 0, 1s) == received::handed_on);
}

TEST_CASE("a deferred message is acknowledged when it is finished, and its repeats before that are dropped") {
    arm a;
    const auto finish = [&](std::uint16_t number, bool executed, instant now) {
        return a.commands.finish({.ack_nak = ack_nak::request,
                                  .command_code = 0x0405,
                                  .destination = arm_address,
                                  .source = ocu_address,
                                  .data_size = 1,
                                  .sequence_number = number},
                                 executed, now, a.sent.sink());
    };
    REQUIRE(a.hear(0x0405, 5, 1, 0s, message_outcome::deferred) == received::handed_on);
    REQUIRE(a.hear(0x0405, 6, 1, 0s, message_outcome::deferred) == received::handed_on);
    for (const auto now : {0s, 1s, 3600s}) REQUIRE(a.hear(0x0405, 5, 1, now) == received::pending);
    REQUIRE(a.sent.empty());
    REQUIRE(finish(5, true, instant{3600s}));
    REQUIRE(a.sent.size() == 1);
    REQUIRE(a.sent[0] == from_hex("36 02 05 04 01 20 01 01 01 31 02 03 00 00 05 00"));
    REQUIRE(finish(6, false, instant{3600s}));
    REQUIRE(a.sent[1] == from_hex("26 02 05 04 01 20 01 01 01 31 02 03 00 00 06 00"));
    REQUIRE_FALSE(finish(5, false, instant{3600s})); // once
    REQUIRE_FALSE(finish(7, true, instant{3600s}));
    REQUIRE(a.sent.size() == 2);
    // The answer is remembered from then on.
    REQUIRE(a.hear(0x0405, 5, 1, 3601s - 1ns) == received::repeated);
    REQUIRE(a.sent[2] == a.sent[0]);
    REQUIRE(a.hear(0x0405, 6, 1, 3601s - 1ns) == received::repeated);
    REQUIRE(a.sent[3] == a.sent[1]);
    REQUIRE(a.hear(0x0405, 5, 1, 3601s) == received::handed_on);
    REQUIRE(a.handed_on == 3);
}

TEST_CASE("of two senders whose pending messages have one number, the one that is named is finished") {
    arm a;
    REQUIRE(a.hear(0x0405, 5, 1, 0s, message_outcome::deferred) == received::handed_on);
    REQUIRE(a.hear(0x0405, 5, 1, 0s, message_outcome::deferred, other) == received::handed_on);
    const jaus::header head{.ack_nak = ack_nak::request,
                            .command_code = 0x0405,
                            .destination = arm_address,
                            .source = other,
                            .sequence_number = 5};
    REQUIRE(a.commands.finish(head, true, instant{0s}, a.sent.sink()));
    CHECK(a.hear(0x0405, 5, 1, 0s, message_outcome::handled, other) == received::repeated);
    CHECK(a.hear(0x0405, 5, 1) == received::pending);
}

TEST_CASE("pending messages keep their places, so there are at most as many as places") {
    arm a;
    for (std::uint16_t i = 0; i != 4; ++i)
        REQUIRE(a.hear(0x0405, i, 0, 0s, message_outcome::deferred) == received::handed_on);
    REQUIRE(a.hear(0x0405, 9, 0, 3600s) == received::no_capacity);
    const jaus::header first{
        .ack_nak = ack_nak::request, .command_code = 0x0405, .destination = arm_address, .source = ocu_address};
    REQUIRE(a.commands.finish(first, true, instant{3600s}, a.sent.sink()));
    REQUIRE(a.hear(0x0405, 9, 0, 3600s) == received::no_capacity); // remembered now
    REQUIRE(a.hear(0x0405, 9, 0, 3601s) == received::handed_on);
    for (std::uint16_t i = 1; i != 4; ++i) REQUIRE(a.hear(0x0405, i, 0, 7200s) == received::pending);
}

TEST_CASE("a message that is never remembered may be deferred: it is delivered and answered each time") {
    arm a;
    const jaus::header stop{
        .ack_nak = ack_nak::request, .command_code = 0x0006, .destination = arm_address, .source = ocu_address};
    for (int i = 0; i != 20; ++i) REQUIRE(a.hear(0x0006, 0, 1, 0s, message_outcome::deferred) == received::handed_on);
    REQUIRE(a.sent.empty());
    for (int i = 0; i != 20; ++i) REQUIRE(a.commands.finish(stop, true, instant{0s}, a.sent.sink()));
    REQUIRE(a.sent.size() == 20);
    REQUIRE(a.sent[19] == from_hex("36 02 06 00 01 20 01 01 01 31 02 03 00 00 00 00"));
}

TEST_CASE("a deferred message without acknowledgement request, or to a broadcast address, is not acknowledged") {
    arm a;
    jaus::header head{.command_code = 0x0405, .destination = arm_address, .source = ocu_address};
    REQUIRE(a.hear(0x0405, 0, 0, 0s, message_outcome::deferred, ocu_address, ack_nak::none) == received::handed_on);
    REQUIRE_FALSE(a.commands.finish(head, true, instant{0s}, a.sent.sink()));
    head.ack_nak = ack_nak::request;
    head.destination = {255, 255, 2, 3};
    REQUIRE(a.hear(0x0405, 0, 0, 0s, message_outcome::deferred, ocu_address, ack_nak::request, head.destination) ==
            received::handed_on);
    REQUIRE_FALSE(a.commands.finish(head, true, instant{0s}, a.sent.sink()));
    REQUIRE(a.sent.empty());
}

TEST_CASE("a handler may finish its message at once") {
    arm a;
    const jaus::header head{.ack_nak = ack_nak::request,
                            .command_code = 0x0405,
                            .destination = arm_address,
                            .source = ocu_address,
                            .sequence_number = 3};
    const auto hear = [&] {
        return a.commands.on_message(head, {}, instant{0s}, a.sent.sink(), [&] {
            REQUIRE(a.commands.finish(head, true, instant{0s}, a.sent.sink()));
            return message_outcome::deferred;
        });
    };
    REQUIRE(hear() == received::handed_on);
    REQUIRE(hear() == received::repeated);
    REQUIRE(a.sent.size() == 2);
    REQUIRE(a.answer(1) == ack_nak::ack);
}

TEST_CASE("of a sender that numbers all messages 0, pending messages are finished in order") {
    arm a;
    const auto finish = [&](std::uint16_t code, bool executed) {
        return a.commands.finish(
            {.ack_nak = ack_nak::request, .command_code = code, .destination = arm_address, .source = ocu_address},
            executed, instant{3s}, a.sent.sink());
    };
    REQUIRE(a.hear(0x0405, 0, 1, 0s, message_outcome::deferred) == received::handed_on);
    REQUIRE(a.hear(0x0405, 0, 2, 1s, message_outcome::deferred) == received::handed_on);
    REQUIRE(a.hear(0x0405, 0, 2, 2s) == received::pending);
    REQUIRE(finish(0x0405, false)); // body 1
    REQUIRE(finish(0x0405, true));  // body 2
    REQUIRE_FALSE(finish(0x0405, true));
    REQUIRE(a.answer(0) == ack_nak::nak);
    REQUIRE(a.answer(1) == ack_nak::ack);
    REQUIRE(a.hear(0x0405, 0, 2, 3s) == received::repeated);
    // Standby, Resume, both pending: the next Standby is no repeat, whenever they are finished.
    REQUIRE(a.hear(0x0003, 0, 0, 3s, message_outcome::deferred) == received::handed_on);
    REQUIRE(a.hear(0x0004, 0, 0, 3s, message_outcome::deferred) == received::handed_on);
    REQUIRE(finish(0x0003, true));
    REQUIRE(finish(0x0004, true));
    REQUIRE(a.hear(0x0003, 0, 0, 3s, message_outcome::deferred) == received::handed_on);
}

TEST_CASE("over a channel that loses, duplicates and delays, a message is delivered at most once and has one outcome") {
    using key = std::tuple<std::uint8_t, std::uint8_t, std::uint16_t>; // sender, receiver, number
    struct fate {
        int taken{}, refused{};
        std::vector<delivered> outcomes{};
    };
    struct sender {
        jaus::address self;
        std::vector<jaus::awaited_message> places = std::vector<jaus::awaited_message>(16);
        std::vector<std::byte> copies = std::vector<std::byte>(16 * 32);
        jaus::acknowledged_sender commands{places, copies, {.retry = {.interval = 150ms, .attempts = 6}}};
        int left = 400;
    };
    struct receiver {
        jaus::address self;
        std::vector<jaus::acknowledged_message> places = std::vector<jaus::acknowledged_message>(2048);
        jaus::acknowledged_receiver commands{self, places, 2s};
    };
    const unsigned loss = GENERATE(0u, 1u, 30u, 70u, 100u);
    const unsigned seed = GENERATE(range(1u, 6u));
    CAPTURE(loss, seed);
    lossy_channel channel{seed};
    channel.faults = {.lose = loss, .duplicate = 20, .delay = 50};
    std::mt19937 random{seed};
    std::map<key, fate> fates;
    std::array<sender, 2> senders{{{ocu_address}, {other}}};
    std::array<receiver, 2> receivers{{{arm_address}, {{1, 50, 2, 3}}}};

    for (sender& s : senders) {
        const auto tell = [&](const jaus::awaited_message& m, delivered what) {
            fates[{m.header.source.component, m.header.destination.component, m.header.sequence_number}]
                .outcomes.push_back(what);
        };
        channel.listen(s.self, [&s, tell](const jaus::header& head, auto) { s.commands.on_message(head, tell); });
        channel.work([&, tell]() -> std::optional<jauscat::time_point> {
            s.commands.on_time(channel.now, channel.sink(), tell);
            while (s.left != 0) {
                const jaus::header head{.destination = receivers[random() % 2].self, .source = s.self};
                const auto sent =
                    random() % 2 == 0
                        ? s.commands.send(head, jaus::standby{}, channel.now, channel.sink())
                        : s.commands.send(head, jaus::set_component_authority{1}, channel.now, channel.sink());
                if (!sent) {
                    REQUIRE(sent.error().code == send_errc::no_capacity);
                    break;
                }
                --s.left;
                fates[{head.source.component, head.destination.component, *sent}];
            }
            return s.commands.next_event();
        });
    }
    for (receiver& r : receivers)
        channel.listen(r.self, [&](const jaus::header& head, std::span<const std::byte> body) {
            REQUIRE(r.commands.on_message(head, body, channel.now, channel.sink(), [&] {
                auto& fate = fates.at({head.source.component, head.destination.component, head.sequence_number});
                const bool takes = random() % 5 != 0;
                ++(takes ? fate.taken : fate.refused);
                return takes ? message_outcome::handled : message_outcome::refused;
            }) != received::no_capacity);
        });
    channel.run(1h);

    REQUIRE(fates.size() == 800);
    std::map<delivered, int> counts;
    for (const auto& [message, fate] : fates) {
        REQUIRE(fate.taken + fate.refused <= 1);
        REQUIRE(fate.outcomes.size() == 1);
        ++counts[fate.outcomes[0]];
        if (fate.outcomes[0] == delivered::acknowledged) REQUIRE(fate.taken == 1);
        if (fate.outcomes[0] == delivered::refused) REQUIRE(fate.refused == 1);
    }
    // Each of the two ways loses what it loses: a round trip, six times, is never there or now and then.
    if (loss <= 1) REQUIRE(counts[delivered::timed_out] == 0);
    if (loss == 30 || loss == 70) REQUIRE(counts[delivered::acknowledged] != 0);
    if (loss == 70) REQUIRE(counts[delivered::timed_out] != 0);
    if (loss == 100) REQUIRE(counts[delivered::timed_out] == 800);
}
