// Faults of a wire and of a slave: each ends in the right result or in its own error, never in a hang.
#include "ethercat/objects.hpp"
#include "support/catch.hpp"
#include "support/hex.hpp"
#include "support/instant.hpp"
#include "support/simulated_link.hpp"
#include <jauscat/ethercat/hilscher/packet_status.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/ethercat/slave/slave.hpp>

#include <array>
#include <functional>
#include <string>
#include <vector>

using namespace jauscat::ethercat;
using namespace std::chrono_literals;
using jauscat::test::from_hex;
using jauscat::test::simulated_link;
using jauscat::test::to_hex;
using support::instant;
namespace test = jauscat::test;
namespace wire = jauscat::wire;

namespace {

using bytes = std::vector<std::byte>;

// One slave with an application that can be stopped, a link and a master.
struct bench {
    test::objects objects{};
    slave device;
    bool works{true};
    simulated_link link{[this](std::span<std::byte> frame) {
        device.pass(frame);
        if (works) device.work();
    }};
    master_for<16> master;
    bytes data = from_hex("0102030405060708090a0b0c0d0e0f101112131415161718191a1b1c");

    explicit bench(const slave_description& description = {}, const master_config& config = {})
        : device{description, objects}, master{config} {
        objects.add(0x2002, 0, 1);
        objects.add(0x6926, 1, 28);
    }

    master_result<> bring_up() { return link.run(master, jauscat::ethercat::bring_up{0, 0x1001}).error(); }
    master_result<> download() { return link.run(master, jauscat::ethercat::download{0x1001, 0x6926, 1, data}); }
    master_result<std::size_t> upload(bytes& into) {
        return test::size_of(link.run(master, jauscat::ethercat::upload{0x1001, 0x6926, 1, into}));
    }
    [[nodiscard]] const bytes& stored() const { return objects.entries.at({0x6926, 1}).value; }

    // Calls f(datagram) for each datagram that comes back from `ado`; if it returns false the frame is lost.
    void on_way_back(std::uint16_t ado, const std::function<bool(const basic_datagram<std::byte>&)>& f) {
        link.on_way_back = [ado, f](bytes& frame) {
            mutable_frame_view view;
            REQUIRE(view.parse(frame));
            for (const auto datagram : view)
                if (datagram.header.ado == ado && !f(datagram)) {
                    frame.clear();
                    return;
                }
        };
    }
};

constexpr std::uint16_t mailbox_out = 0x1000, mailbox_in = 0x1600;

void set_counter(const basic_datagram<std::byte>& datagram, std::uint16_t counter) {
    REQUIRE(wire::encode(datagram_trailer{counter}, datagram.bytes.last(2)));
}
void put(const basic_datagram<std::byte>& datagram, std::string_view hex, std::size_t at = 0) {
    std::ranges::copy(from_hex(hex), datagram.data.subspan(at).begin());
}

// A message of its own in front of each one that the slave has for the master, which comes with the next read.
void put_before_answers(bench& b, std::string_view hex) {
    b.on_way_back(mailbox_in, [hex, held = bytes{}](const auto& d) mutable {
        if (d.working_counter != 0) {
            held.assign(d.data.begin(), d.data.end());
            std::ranges::fill(d.data, std::byte{});
            put(d, hex);
        } else if (!held.empty()) {
            std::ranges::copy(held, d.data.begin());
            set_counter(d, 1);
            held.clear();
        }
        return true;
    });
}

// The slave's answers come late, one with each read, or get lost.
struct answers_of {
    explicit answers_of(bench& b) {
        b.link.on_way_back = [this](bytes& frame) { pass(frame); };
    }

    unsigned requests{};   ///< that were written
    unsigned held_until{}; ///< no answer comes before so many were written
    bool are_lost{};
    /// The counter of an answer, by that of its request.
    std::function<unsigned(unsigned)> number = [](unsigned asked) { return asked; };

  private:
    void pass(bytes& frame) {
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto d : view) {
            if (d.header.ado == mailbox_out && d.working_counter != 0) ++requests;
            if (d.header.ado != mailbox_in) continue;
            if (d.working_counter != 0) take(d);
            const bool is_given = requests >= held_until && !held_.empty();
            set_counter(d, is_given ? 1 : 0);
            if (!is_given) continue;
            std::ranges::copy(held_.front(), d.data.begin());
            held_.erase(held_.begin());
        }
    }
    void take(const basic_datagram<std::byte>& d) {
        const auto asked = std::to_integer<unsigned>(d.data[5]) >> 4U;
        d.data[5] = static_cast<std::byte>(number(asked) << 4U | 3U);
        if (!are_lost) held_.emplace_back(d.data.begin(), d.data.end());
    }

    std::vector<bytes> held_{};
};

} // namespace

TEST_CASE("an empty ring has no slave, and a cut ring no replies") {
    master_for<16> m;
    simulated_link ring{std::span<slave>{}};
    REQUIRE(m.start(bring_up{0, 1}));
    CHECK(ring.run(m).error() == master_error{.code = master_errc::no_slave});
    simulated_link cut{std::span<slave>{}};
    cut.faults.lose = 100;
    REQUIRE(m.start(bring_up{0, 1}));
    CHECK(cut.run(m).error() == master_error{.code = master_errc::no_reply});
    CHECK(m.statistics().sent == 1 + 10);
    CHECK(cut.now == instant{10 * 20ms});
}

TEST_CASE("loss of a slave's address during bring-up is detected at every step") {
    for (int when = 1; when != 24; ++when) {
        bench b;
        int frames = 0;
        b.link.on_way_back = [&](bytes&) {
            if (++frames == when) b.device.power_on();
        };
        const auto result = b.bring_up();
        INFO("after frame " << when);
        if (when == 1)
            CHECK(result); // it had no address yet
        else if (when == 2)
            CHECK(result == master_error{.code = master_errc::wrong_station, .station = 0x1001});
        else
            CHECK(result == master_error{.code = master_errc::working_counter});
        CHECK(b.master.slaves().size() == (when == 1 ? 1 : 0));
    }
}

TEST_CASE("the alias of another slave equal to the address is detected") {
    bench b{{.station_alias = 0x1001}};
    int frames = 0;
    b.link.on_way_back = [&](bytes&) {
        if (++frames != 2) return;
        // The addressed slave is removed, one with that alias remains.
        b.device.power_on();
        bytes frame(max_frame_size);
        frame_builder builder{frame};
        builder.add(command::apwr, 0, 0x0100, std::span<const std::byte>{from_hex("00000001")});
        b.device.process(*builder.finish());
    };
    CHECK(b.bring_up().error() == master_error{.code = master_errc::wrong_station, .station = 0x1001});
}

TEST_CASE("an SII that stays busy or fails is reported, and a slow one is waited for") {
    bench busy;
    busy.on_way_back(0x0500, [&](const auto&) {
        busy.works = false;
        return true;
    });
    CHECK(busy.bring_up().error() == master_error{.code = master_errc::sii_busy});

    bench slow;
    int polls = 0;
    slow.link.on_way_back = [&](bytes& frame) {
        frame_view view;
        REQUIRE(view.parse(frame));
        const auto d = *view.begin();
        if (d.header.ado == 0x0500) slow.works = d.header.more == false; // stops when the SII is assigned
        if (d.header.ado == 0x0502 && d.header.cmd == command::fprd && ++polls % 4 == 3) slow.device.work();
    };
    CHECK(slow.bring_up());
    CHECK(slow.master.statistics().sent == 24 + 7 * 3);

    bench failing;
    failing.on_way_back(0x0502, [](const auto& d) {
        if (d.header.cmd == command::fprd) put(d, "0020");
        return true;
    });
    CHECK(failing.bring_up().error() == master_error{.code = master_errc::sii_error, .sii_word = 8});
}

TEST_CASE("after a failed SII read the slave's application has the SII again") {
    const auto owner = [](bench& b) {
        bytes frame(max_frame_size);
        frame_builder builder{frame};
        builder.read(0x1001, esc_registers::sii_owner);
        b.device.process(*builder.finish());
        frame_view view;
        REQUIRE(view.parse(frame));
        return to_hex((*view.begin()).data);
    };
    const auto fail = [](bench& b) {
        b.on_way_back(0x0502, [](const auto& d) {
            if (d.header.cmd == command::fprd) put(d, "0020");
            return true;
        });
    };
    const master_error failed{.code = master_errc::sii_error, .sii_word = 8};
    bench b;
    fail(b);
    CHECK(b.bring_up().error() == failed);
    CHECK(owner(b) == "01");
    b.link.on_way_back = {};
    const bring_up foreign{0, 0x1001, {.product = 99}};
    CHECK(b.link.run(b.master, foreign).error().code == master_errc::wrong_identity);
    CHECK(owner(b) == "01");

    REQUIRE(b.bring_up());
    fail(b);
    CHECK(b.link.run(b.master, identify{0x1001}).error() ==
          master_error{.code = master_errc::sii_error, .sii_word = 4});
    CHECK(owner(b) == "01");
    CHECK(b.link.run(b.master, configure{0x1001}).error().code == master_errc::sii_error);
    CHECK(owner(b) == "01");
    // It is gone before it gets the SII: the first error counts.
    b.on_way_back(0x0502, [&](const auto& d) {
        if (d.header.cmd != command::fprd) return true;
        put(d, "0020");
        b.device.power_on();
        return true;
    });
    CHECK(b.link.run(b.master, configure{0x1001}).error().code == master_errc::sii_error);
}

TEST_CASE("a slave with an unusable mailbox is refused, and one without CoE gets no SDO") {
    CHECK(bench{{.mailbox_out_size = 0}}.bring_up().error() == master_error{.code = master_errc::no_mailbox});
    CHECK(bench{{.mailbox_in_size = 1487}}.bring_up().error() == master_error{.code = master_errc::no_mailbox});
    bench b;
    b.on_way_back(0x0502, [](const auto& d) {
        if (d.header.cmd == command::fprd && d.data[2] == std::byte{0x1C}) put(d, "0800", 6);
        return true;
    });
    REQUIRE(b.bring_up());
    CHECK(b.download().error() == master_error{.code = master_errc::no_coe});
}

TEST_CASE("a refused state is reported with the slave's reason") {
    bench b{{.mailbox_in_offset = 0x2F80}}; // beyond the slave's memory
    const auto result = b.bring_up();
    CHECK(result == master_error{.code = master_errc::al_error, .al_status = al_status_code{0x16}});
    CHECK(describe_reason(result.error()) == "invalid mailbox configuration for PRE-OP");
}

TEST_CASE("a slave that does not leave a state is abandoned after the state's timeout") {
    bench b{{}, {.state_timeout = 300ms}};
    int frames = 0;
    b.link.on_way_back = [&](bytes&) { b.works = ++frames < 22; };
    CHECK(b.bring_up().error() == master_error{.code = master_errc::state_timeout, .state = al_state::init});
    CHECK(b.link.now > instant{300ms});
    CHECK(b.link.now < instant{310ms});

    bench stubborn{{}, {.state_timeout = 300ms}}; // an error that no acknowledgement clears
    stubborn.on_way_back(0x0130, [](const auto& d) {
        put(d, "1100 0000 5100");
        return true;
    });
    CHECK(stubborn.bring_up().error() ==
          master_error{.code = master_errc::al_error, .al_status = al_status_code{0x51}});
}

TEST_CASE("a slave that does not serve its mailbox is abandoned, with the direction that failed") {
    bench b;
    REQUIRE(b.bring_up());
    b.works = false;
    CHECK(b.download().error() == master_error{.code = master_errc::mailbox_timeout});
    CHECK(b.link.now > instant{1s});
    CHECK(b.download().error() == master_error{.code = master_errc::mailbox_full});
    // The abandoned download is answered at last; the next one does not take that answer for its own.
    b.works = true;
    b.data[0] = std::byte{0x77};
    REQUIRE(b.download());
    CHECK(b.stored() == b.data);
    CHECK(b.objects.writes == 2);
}

TEST_CASE("a late answer to an abandoned request is not used for the next request") {
    bench b;
    REQUIRE(b.bring_up());
    b.works = false;
    CHECK(b.download().error() == master_error{.code = master_errc::mailbox_timeout});
    // The slave wakes up between the drain of its reply mailbox and the next request.
    b.on_way_back(mailbox_in, [&](const auto&) {
        b.works = true;
        b.device.work();
        return true;
    });
    b.objects.entries[{0x6926, 1}].write_abort = abort_code::read_only;
    CHECK(b.download().error().code == master_errc::sdo_abort);
}

TEST_CASE("a late answer is not used for the next request either if the slave numbers its messages independently") {
    for (unsigned wake_up = 1; wake_up != 8; ++wake_up)
        for (unsigned shift = 1; shift != 7; ++shift) {
            bench b;
            REQUIRE(b.bring_up());
            b.works = false;
            CHECK(b.download().error() == master_error{.code = master_errc::mailbox_timeout});
            unsigned frames = 0;
            b.link.on_way_back = [&](bytes& frame) {
                mutable_frame_view view;
                REQUIRE(view.parse(frame));
                for (const auto datagram : view) {
                    if (datagram.header.ado != mailbox_in || datagram.working_counter == 0) continue;
                    const auto old = std::to_integer<unsigned>(datagram.data[5]);
                    datagram.data[5] = static_cast<std::byte>((old & 0x0FU) | (((old >> 4U) + shift) % 7 + 1) << 4U);
                }
                if (++frames != wake_up) return;
                b.works = true;
                b.device.work(); // executes the first one, and the next one will be refused
                b.objects.entries[{0x6926, 1}].write_abort = abort_code::read_only;
            };
            INFO("it wakes up after frame " << wake_up << ", and counts " << shift << " ahead");
            CHECK_FALSE(b.download());
        }
}

TEST_CASE(
    "after a request that was given up the next one gets its own answer, however the slave numbers its messages") {
    for (const bool counts_itself : {true, false})
        for (unsigned ahead = 0; ahead != 7; ++ahead)
            for (const bool is_lost : {true, false}) {
                bench b{{}, {.mailbox_timeout = 20ms}};
                REQUIRE(b.bring_up());
                unsigned own = ahead;
                answers_of slave{b};
                slave.number = [&](unsigned asked) {
                    own = (counts_itself ? own : asked + ahead - 1) % 7 + 1;
                    return own;
                };
                REQUIRE(b.download());
                slave.are_lost = is_lost;
                slave.held_until = slave.requests + 2;
                CHECK(b.download().error() == master_error{.code = master_errc::mailbox_timeout});
                slave.are_lost = false;
                INFO((counts_itself ? "it counts itself, " : "it counts as the master does, ")
                     << ahead << " ahead; the answer is " << (is_lost ? "lost" : "late"));
                if (is_lost) {
                    CHECK(b.download());
                } else {
                    b.objects.entries[{0x6926, 1}].write_abort = abort_code::read_only;
                    CHECK(b.download().error().code == master_errc::sdo_abort);
                }
            }
}

TEST_CASE("each of several requests that were given up one after the other is awaited") {
    bench b{{}, {.mailbox_timeout = 20ms}};
    REQUIRE(b.bring_up());
    answers_of slave{b};
    slave.number = [](unsigned) { return 1u; };
    slave.held_until = 4;
    for (int i = 0; i != 3; ++i) CHECK(b.download().error() == master_error{.code = master_errc::mailbox_timeout});
    CHECK(b.objects.writes == 1);
    b.objects.entries[{0x6926, 1}].write_abort = abort_code::read_only;
    CHECK(b.download().error().code == master_errc::sdo_abort);
}

TEST_CASE("a full mailbox is polled, and the request is sent when it is empty") {
    bench b;
    REQUIRE(b.bring_up());
    REQUIRE(b.download());
    // A foreign request keeps the mailbox full for a while.
    bytes frame(max_frame_size);
    frame_builder builder{frame};
    const auto mail = builder.add(command::fpwr, 0x1001, mailbox_out, std::size_t{256});
    std::ranges::copy(from_hex("0a00 0000 00 73 0020 40 0220 00 00000000"), mail.begin());
    b.works = false;
    b.device.pass(*builder.finish());
    int polls = 0;
    b.on_way_back(0x0805, [&](const auto&) {
        b.works = ++polls > 10;
        return true;
    });
    REQUIRE(b.download());
    CHECK(polls > 10);
    CHECK(b.objects.writes == 2);
}

namespace {

// A foreign request keeps the slave's mailbox full until its application works.
void fill_mailbox(bench& b) {
    b.works = false;
    bytes frame(max_frame_size);
    frame_builder builder{frame};
    const auto mail = builder.add(command::fpwr, 0x1001, mailbox_out, std::size_t{256});
    std::ranges::copy(from_hex("0a00 0000 00 73 0020 40 0220 00 00000000"), mail.begin());
    b.device.pass(*builder.finish());
}

// One frame there and back. False if there is none to send.
bool exchange_frame(bench& b) {
    bytes frame(max_frame_size);
    frame.resize(b.master.next_frame(frame, b.link.now));
    if (frame.empty()) return false;
    b.device.pass(frame);
    if (b.works) b.device.work();
    return b.master.on_frame(frame, b.link.now);
}

} // namespace

TEST_CASE("a transfer that waits for room in the slave's mailbox is withdrawn without a trace") {
    for (unsigned frames = 1; frames != 12; ++frames) {
        bench b;
        REQUIRE(b.bring_up());
        REQUIRE(b.download());
        const auto counter = b.master.slaves()[0].last_counter;
        fill_mailbox(b);
        REQUIRE(b.master.start(download{0x1001, 0x6926, 1, b.data}));
        for (unsigned i = 0; i != frames; ++i) {
            b.link.now = std::max(b.link.now, *b.master.next_event());
            REQUIRE(exchange_frame(b));
        }
        INFO("after " << frames << " frames");
        CHECK(b.master.withdraw(master_errc::timeout));
        CHECK(b.master.idle());
        CHECK(b.master.error() == master_error{.code = master_errc::timeout});
        CHECK(b.master.slaves()[0].last_counter == counter);
        CHECK_FALSE(b.master.slaves()[0].awaits_late_answer);
        CHECK_FALSE(b.master.withdraw(master_errc::timeout));
        b.works = true;
        b.device.work(); // answers the foreign request
        CHECK(b.objects.writes == 1);
        b.data[0] = std::byte{0x77};
        REQUIRE(b.download());
        CHECK(b.stored() == b.data);
        CHECK(b.objects.writes == 2);
    }
}

TEST_CASE("a transfer that the slave has taken, or may have taken, is not withdrawn") {
    bench b;
    REQUIRE(b.bring_up());
    REQUIRE(b.download());
    bytes frame(max_frame_size);
    const auto start = [&] {
        REQUIRE(b.master.start(download{0x1001, 0x6926, 1, b.data}));
        frame.assign(max_frame_size, std::byte{});
        frame.resize(b.master.next_frame(frame, b.link.now));
    };
    start();
    CHECK_FALSE(b.master.withdraw(master_errc::timeout)); // a frame is under way
    b.device.process(frame);
    REQUIRE(b.master.on_frame(frame, b.link.now));
    CHECK_FALSE(b.master.withdraw(master_errc::timeout)); // the slave has taken it
    while (!b.master.idle()) REQUIRE(exchange_frame(b));
    CHECK(b.master.error() == master_error{});

    fill_mailbox(b);
    start();
    b.link.now += 20ms;
    b.master.on_time(b.link.now);
    CHECK_FALSE(b.master.withdraw(master_errc::timeout)); // its frame is lost
    b.works = true;
    b.device.work();
    while (!b.master.idle()) {
        b.link.now = std::max(b.link.now, b.master.next_event().value_or(b.link.now));
        exchange_frame(b);
        b.master.on_time(b.link.now);
    }
    CHECK(b.master.error() == master_error{});
    CHECK(b.objects.writes == 3);
}

TEST_CASE("a late answer is not used for the next request although others were withdrawn in between") {
    for (int withdrawn = 0; withdrawn != 8; ++withdrawn) { // more than there are counters
        bench b{{}, {.mailbox_timeout = 20ms}};
        REQUIRE(b.bring_up());
        b.works = false;
        CHECK(b.download().error() == master_error{.code = master_errc::mailbox_timeout});
        for (int i = 0; i != withdrawn; ++i) {
            REQUIRE(b.master.start(download{0x1001, 0x6926, 1, b.data}));
            REQUIRE(exchange_frame(b));
            REQUIRE(b.master.withdraw(master_errc::timeout));
        }
        CHECK(b.master.slaves()[0].awaits_late_answer);
        INFO(withdrawn << " were withdrawn");
        answers_of slave{b};
        slave.held_until = 1;
        b.works = true;
        b.device.work();
        b.objects.entries[{0x6926, 1}].write_abort = abort_code::read_only;
        CHECK(b.download().error().code == master_errc::sdo_abort);
    }
}

TEST_CASE("a slow slave is polled by the mailbox read itself") {
    bench b;
    REQUIRE(b.bring_up());
    REQUIRE(b.download());
    int polls = 0;
    b.on_way_back(mailbox_in, [&](const auto&) {
        b.works = ++polls > 6;
        return true;
    });
    b.works = false;
    const auto before = b.master.statistics().sent;
    REQUIRE(b.download());
    CHECK(b.master.statistics().sent - before == 1 + 9);
}

TEST_CASE("a mailbox error ends the request with its code") {
    bench b;
    REQUIRE(b.bring_up());
    b.on_way_back(mailbox_in, [](const auto& d) {
        if (d.working_counter != 0) put(d, "0400 0000 00 00 0100 0900");
        return true;
    });
    const auto result = b.download();
    CHECK(result == master_error{.code = master_errc::mailbox_error, .mailbox = mailbox_error_code{9}});
    CHECK(describe_reason(result.error()) == "the mailbox service is still at work: retry, or restart the slave");
    b.link.on_way_back = {};
    CHECK(b.download());
}

TEST_CASE("an abort is recognised by its specifier, whatever the other bits of the command") {
    for (const char* command : {"80", "83", "81", "9f"}) {
        bench b;
        REQUIRE(b.bring_up());
        b.on_way_back(mailbox_in, [&](const auto& d) {
            if (d.working_counter != 0) put(d, std::string{"0030 "} + command + " 2669 01 22000008", 6);
            return true;
        });
        CHECK(b.download().error() == master_error{.code = master_errc::sdo_abort, .abort = abort_code{0x08000022}});
    }
}

TEST_CASE("an abort without a code, or truncated, is an abort") {
    for (const char* abort : {"0a00 0000 00 53 0020 80 2669 01 00000000", "0800 0000 00 53 0020 80 2669 01 0000",
                              "0600 0000 00 53 0020 80 2669 01", "0300 0000 00 53 0020 80"}) {
        bench b;
        REQUIRE(b.bring_up());
        b.on_way_back(mailbox_in, [&](const auto& d) {
            if (d.working_counter != 0) put(d, abort);
            return true;
        });
        INFO(abort);
        const auto result = b.download();
        CHECK(result == master_error{.code = master_errc::sdo_abort});
        CHECK(describe_reason(result.error()) == "the slave gave no abort code");
        CHECK(jauscat::hilscher::status_of(result.error()) == jauscat::hilscher::packet_status::sdo_abort_unknown);
    }
}

TEST_CASE("messages that are not answers are ignored") {
    // Each comes before the real answer: another object's, another subindex's, an old upload's, too short, too long for
    // the mailbox, another protocol, SDO information.
    for (const char* hex : {"0a00 0000 00 53 0030 60 2769 01 00000000", "0a00 0000 00 53 0030 60 2669 02 00000000",
                            "0a00 0000 00 53 0030 4f 2669 01 00000000", "0300 0000 00 53 0030 60",
                            "fb00 0000 00 53 0030 60 2669 01 00000000", "0a00 0000 00 52 0030 60 2669 01 00000000",
                            "0a00 0000 00 53 0080 60 2669 01 00000000", "0000 0000 00 53"}) {
        bench b;
        REQUIRE(b.bring_up());
        put_before_answers(b, hex);
        INFO(hex);
        CHECK(b.download());
        CHECK(b.master.statistics().sent == 24 + 1 + 3);
    }
}

TEST_CASE("an emergency during a transfer is kept and does not disturb the transfer") {
    bench b;
    REQUIRE(b.bring_up());
    put_before_answers(b, "0a00 0000 00 33 0010 3042 08 0102030405");
    CHECK(b.download());
    const auto emergencies = b.master.slaves()[0].emergencies.kept();
    REQUIRE(emergencies.size() == 1);
    CHECK(emergencies[0].error_code == 0x4230);
    CHECK(emergencies[0].error_register == 8);
    CHECK(to_hex(emergencies[0].data) == "01 02 03 04 05");
    b.link.on_way_back = {};
    CHECK(b.download());
    CHECK(b.master.slaves()[0].emergencies.kept().size() == 1);
    b.master.clear_emergencies(0x1001);
    CHECK(b.master.slaves()[0].emergencies.kept().empty());
}

TEST_CASE("a slave that keeps answering something else is distinguished from a silent one") {
    bench b;
    REQUIRE(b.bring_up());
    b.on_way_back(mailbox_in, [&](const auto& d) {
        if (d.working_counter != 0) put(d, "4f", 8);
        return true;
    });
    CHECK(b.download().error() ==
          master_error{.code = master_errc::unexpected_reply, .specifier = sdo_specifier::upload_response});
}

TEST_CASE("an upload whose size and data differ is refused") {
    bench b;
    REQUIRE(b.bring_up());
    const auto upload_announced_as = [&](const char* size) {
        b.on_way_back(mailbox_in, [&](const auto& d) {
            if (d.working_counter != 0 && d.data[8] == std::byte{0x41}) put(d, size, 12);
            return true;
        });
        bytes into(64);
        return b.upload(into);
    };
    CHECK(upload_announced_as("1b000000") == master_result<std::size_t>{27}); // the message is filled up
    // More than was sent: the master requests the rest, which the slave does not have.
    CHECK(upload_announced_as("1d000000").error() ==
          master_error{.code = master_errc::sdo_abort, .abort = abort_code::command_specifier});
    CHECK(upload_announced_as("ffffffff").error() ==
          master_error{.code = master_errc::data_too_long, .bytes = 64, .found_bytes = 0xFFFFFFFF});
    CHECK(upload_announced_as("1c000000"));
}

TEST_CASE("any lost frame is repeated, and the object is written once") {
    // Frames 1 to 24 are the bring-up, then drain, write and read.
    for (int lost = 1; lost != 28; ++lost) {
        for (const bool on_way_out : {true, false}) {
            bench b;
            int frames = 0;
            simulated_link link{[&](std::span<std::byte> frame) {
                if (++frames == lost && on_way_out) return;
                b.device.process(frame);
            }};
            link.on_way_back = [&](bytes& frame) {
                if (frames == lost) frame.clear();
            };
            INFO("frame " << lost << (on_way_out ? " out" : " back"));
            REQUIRE(link.run(b.master, bring_up{0, 0x1001}));
            REQUIRE(link.run(b.master, download{0x1001, 0x6926, 1, b.data}));
            CHECK(b.stored() == b.data);
            CHECK(b.objects.writes == 1);
            CHECK(b.master.statistics().lost == 1);
            REQUIRE(link.run(b.master, download{0x1001, 0x6926, 1, b.data}));
            CHECK(b.objects.writes == 2);
        }
    }
}

TEST_CASE("late, duplicate and foreign replies change nothing") {
    bench b;
    REQUIRE(b.bring_up());
    bytes out(max_frame_size);
    REQUIRE(b.master.start(download{0x1001, 0x6926, 1, b.data}));
    const auto drain = b.master.next_frame(out, b.link.now);
    bytes reply(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(drain));
    b.device.process(reply);
    const auto refused = [&](std::size_t at, std::byte value) {
        auto foreign = reply;
        REQUIRE(foreign[at] != value);
        foreign[at] = value;
        return !b.master.on_frame(foreign, b.link.now);
    };
    CHECK(refused(12, std::byte{0x08})); // EtherType
    CHECK(refused(16, std::byte{1}));    // command
    CHECK(refused(17, std::byte{0}));    // index
    CHECK(refused(18, std::byte{2}));    // station
    CHECK(refused(20, std::byte{1}));    // offset
    CHECK(refused(23, std::byte{2}));    // length
    CHECK_FALSE(b.master.on_frame(bytes(3), b.link.now));
    CHECK(b.master.on_frame(reply, b.link.now));
    CHECK_FALSE(b.master.on_frame(reply, b.link.now)); // doubled
    CHECK(b.master.statistics().ignored == 8);

    const auto write = b.master.next_frame(out, b.link.now);
    bytes late(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(write));
    b.device.process(late);
    b.link.now += 20ms;
    b.master.on_time(b.link.now); // abandoned, and requested again under another index
    REQUIRE(b.master.next_frame(out, b.link.now) == write);
    CHECK_FALSE(b.master.on_frame(late, b.link.now));
}

TEST_CASE("a VLAN tag added by a switch is accepted") {
    bench b;
    b.link.on_way_back = [](bytes& frame) {
        const auto tag = from_hex("8100 2005");
        frame.insert(frame.begin() + 12, tag.begin(), tag.end());
    };
    REQUIRE(b.bring_up());
    CHECK(b.download());
}

TEST_CASE("a slave reset is detected, and the slave can be brought up again") {
    bench b;
    REQUIRE(b.bring_up());
    REQUIRE(b.download());
    b.device.power_on();
    CHECK(b.download().error() == master_error{.code = master_errc::working_counter});
    REQUIRE(b.bring_up());
    CHECK(b.download());
    CHECK(b.objects.writes == 2);
}

TEST_CASE("a slave that numbers its own messages is supported") {
    bench b;
    REQUIRE(b.bring_up());
    unsigned own = 3;
    b.on_way_back(mailbox_in, [&](const auto& d) {
        if (d.working_counter == 0) return true;
        own = own % 7 + 1;
        d.data[5] = static_cast<std::byte>(own << 4 | 3);
        return true;
    });
    for (int i = 0; i != 20; ++i) REQUIRE(b.download());
    CHECK(b.objects.writes == 20);
}

TEST_CASE("a missing answer does not cost a slave that numbers its own messages another answer") {
    for (unsigned ahead = 0; ahead != 7; ++ahead) {
        bench b;
        REQUIRE(b.bring_up());
        unsigned own = ahead;
        bool answers = true;
        b.on_way_back(mailbox_in, [&](const auto& d) {
            if (d.working_counter == 0) return true;
            if (!answers) set_counter(d, 0);
            if (!answers) return true;
            own = own % 7 + 1;
            d.data[5] = static_cast<std::byte>(own << 4 | 3);
            return true;
        });
        INFO("it counts " << ahead << " ahead");
        for (unsigned round = 0; round != 7; ++round) {
            REQUIRE(b.download());
            answers = false;
            CHECK(b.download().error() == master_error{.code = master_errc::mailbox_timeout});
            answers = true;
            for (int i = 0; i != 9; ++i) REQUIRE(b.download());
        }
        CHECK(b.objects.writes == 7 * 11);
    }
}

TEST_CASE("the master accepts a job after a cancelled one") {
    bench b;
    REQUIRE(b.bring_up());
    REQUIRE(b.master.start(download{0x1001, 0x6926, 1, b.data}));
    b.master.cancel(master_errc::timeout);
    CHECK(b.master.idle());
    CHECK(b.master.error().code == master_errc::timeout);
    CHECK(b.download());
}

namespace {

// How `count` downloads and the uploads that check them ended. A value that is read is the one that was written, and no
// object is written twice.
struct tally {
    std::size_t done{}, failed{}, written_twice{};
};
tally try_downloads(bench& b, unsigned count) {
    tally result{};
    master_result<> up{master_error{.code = master_errc::no_reply}};
    bytes into(28);
    for (unsigned i = 0; i != count; ++i) {
        if (!up) up = b.bring_up();
        b.data[0] = static_cast<std::byte>(i);
        b.data[1] = static_cast<std::byte>(i >> 8);
        b.data[2] = static_cast<std::byte>(i >> 16);
        const auto writes = b.objects.writes;
        const auto download = up ? b.download() : up;
        const auto read = download ? b.upload(into) : master_result<std::size_t>{download.error()};
        result.written_twice += b.objects.writes > writes + 1;
        if (download && b.objects.writes == writes) FAIL("download " << i << " is said to be done, and is not");
        if (read && into != b.data) FAIL("download " << i << " reads back as another value");
        if (!read && read.error().code != master_errc::no_reply)
            FAIL("download " << i << ": " << describe(read.error()));
        ++(read ? result.done : result.failed);
    }
    return result;
}

} // namespace

TEST_CASE("each of 100000 downloads over a bad link succeeds or ends in an error") {
    // A frame is abandoned after a third of its lifetime.
    bench b{{}, {.frame_timeout = 1ms, .frame_lifetime = 3ms}};
    b.link.faults = {.lose = 10, .duplicate = 10, .delay = 20};
    const auto result = try_downloads(b, 100'000);
    CHECK(result.done > 99'000);
    CHECK(result.written_twice == 0);
    CHECK(b.master.statistics().lost > 30'000);
    CHECK(b.master.statistics().ignored > 10'000);
    CHECK(b.master.statistics().foreign == 0);
}

TEST_CASE("a network that duplicates frames requires waiting for each frame's lifetime") {
    bench b{{}, {.frame_timeout = 1ms, .frame_lifetime = 3ms, .frames_may_be_copied = true}};
    b.link.faults = {.lose = 10, .duplicate = 10, .copy = 10, .delay = 20};
    const auto result = try_downloads(b, 10'000);
    CHECK(result.done > 9'900);
    CHECK(result.written_twice == 0);

    bench hasty{{}, {.frame_timeout = 1ms, .frame_lifetime = 3ms}};
    hasty.link.faults = {.copy = 10, .delay = 20};
    REQUIRE(hasty.bring_up());
    unsigned more = 0;
    for (unsigned i = 0; i != 2'000; ++i) {
        const auto writes = hasty.objects.writes;
        static_cast<void>(hasty.download()); // a late copy of a read may remove its answer
        more += hasty.objects.writes > writes + 1;
    }
    CHECK(more > 0); // a late copy of a message that is no longer the last one
}

TEST_CASE("an empty copy of a mailbox read that returns first does not lose the answer") {
    bench b{{}, {.frames_may_be_copied = true}};
    REQUIRE(b.bring_up());
    bytes out(max_frame_size);
    for (int i = 0; i != 3; ++i) {
        REQUIRE(b.master.start(download{0x1001, 0x6926, 1, b.data}));
        while (!b.master.idle()) {
            const auto size = b.master.next_frame(out, b.link.now);
            bytes first(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size));
            bytes second = first;
            if (size != 0) {
                b.device.process(first);
                b.device.process(second);
                static_cast<void>(b.master.on_frame(second, b.link.now));
                static_cast<void>(b.master.on_frame(first, b.link.now));
            }
            if (const auto next = b.master.next_event()) b.link.now = std::max(b.link.now, *next);
            b.master.on_time(b.link.now);
        }
        CHECK(b.master.error() == master_error{});
    }
    CHECK(b.objects.writes == 3);
}

TEST_CASE("a refused copy of a mailbox write that returns first, or alone, does not lose the answer") {
    for (const bool alone : {false, true}) {
        bench b{{}, {.frames_may_be_copied = true}};
        REQUIRE(b.bring_up());
        bytes out(max_frame_size);
        for (int i = 0; i != 3; ++i) {
            REQUIRE(b.master.start(download{0x1001, 0x6926, 1, b.data}));
            while (!b.master.idle()) {
                const auto size = b.master.next_frame(out, b.link.now);
                bytes first(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size));
                bytes second = first;
                if (size != 0) {
                    b.device.pass(first);
                    b.device.pass(second); // the application has not looked yet: its mailbox is full
                    b.device.work();
                    frame_view view;
                    REQUIRE(view.parse(first));
                    const bool is_write = (*view.begin()).header.cmd == command::fpwr;
                    if (is_write) static_cast<void>(b.master.on_frame(second, b.link.now));
                    if (!is_write || !alone) static_cast<void>(b.master.on_frame(first, b.link.now));
                }
                if (const auto next = b.master.next_event()) b.link.now = std::max(b.link.now, *next);
                b.master.on_time(b.link.now);
            }
            CHECK(b.master.error() == master_error{});
        }
        CHECK(b.objects.writes == 3);
    }
}

TEST_CASE("a retry is sent at once, and the next request waits until the lost frame cannot arrive") {
    bench b{{}, {.frame_timeout = 1ms, .frame_lifetime = 5ms}};
    REQUIRE(b.bring_up());
    REQUIRE(b.download());
    int writes = 0;
    b.on_way_back(mailbox_out, [&](const auto&) { return ++writes != 1; });
    const auto start = b.link.now;
    REQUIRE(b.download());
    CHECK(writes == 2);
    CHECK(b.link.now - start >= 5ms);
    CHECK(b.link.now - start < 6ms);
    CHECK(b.objects.writes == 2);
}

TEST_CASE("a broken ring is detected by the mark in returning frames") {
    bench b;
    REQUIRE(b.bring_up());
    CHECK(b.master.statistics().circulated == 0);
    b.link.on_way_back = [](bytes& frame) {
        mutable_frame_view view;
        REQUIRE(view.parse(frame));
        for (const auto datagram : view) {
            auto header = datagram.header;
            header.circulating = true;
            REQUIRE(wire::encode(header, datagram.bytes));
        }
    };
    CHECK(b.download());
    CHECK(b.master.statistics().circulated == 3);
}

TEST_CASE("a second master on the link is detected, and a late reply does not count as one") {
    bench b;
    REQUIRE(b.bring_up());
    CHECK(b.master.statistics().foreign == 0);
    // Frames of another master pass while a transfer runs.
    bytes other(max_frame_size);
    b.link.on_way_back = [&](bytes&) {
        frame_builder builder{other, 200};
        builder.add(command::brd, 0, 0x0130, std::size_t{2});
        CHECK_FALSE(b.master.on_frame(*builder.finish(), b.link.now));
    };
    CHECK(b.download());
    CHECK(b.master.statistics().foreign == b.master.statistics().ignored);
    CHECK(b.master.statistics().foreign > 0);
}

TEST_CASE("a frame that returns after hundreds of others does not count as another master's") {
    for (const bool soon : {true, false}) {
        bench b;
        REQUIRE(b.bring_up());
        bytes late(max_frame_size), value(2);
        REQUIRE(b.master.start(exchange_datagram{command::fprd, 0x1001, 0x0010, value}));
        late.resize(b.master.next_frame(late, b.link.now));
        b.master.cancel(master_errc::timeout);
        if (!soon) b.link.now += 11s;
        for (int i = 0; i != 200; ++i) REQUIRE(b.download());
        b.device.process(late);
        CHECK_FALSE(b.master.on_frame(late, b.link.now));
        CHECK(b.master.statistics().ignored == 1);
        CHECK(b.master.statistics().foreign == (soon ? 0 : 1));
        CHECK_FALSE(b.master.on_frame(late, b.link.now)); // one frame is missing, not two
        CHECK(b.master.statistics().foreign == (soon ? 1 : 2));
    }
}

TEST_CASE("the master survives 100000 corrupted frames") {
    bench b{{}, {.mailbox_timeout = 20ms}};
    b.link.faults = {.lose = 1, .duplicate = 5, .corrupt = 100};
    std::size_t jobs = 0, good = 0;
    while (b.master.statistics().sent < 100'000) {
        b.link.faults.corrupt = jobs % 4 == 0 ? 0 : 50;
        const auto result = jobs % 2 == 0 ? b.bring_up() : b.download();
        good += result ? 1 : 0;
        ++jobs;
        REQUIRE(b.master.idle());
    }
    CHECK(good > jobs / 8);
    CHECK(good < jobs);
}
