// The frames of a cycle: how the process image is cut, and what is left when some of them are lost.
#include "support/catch.hpp"
#include "support/instant.hpp"
#include <jauscat/ethercat/frame_view.hpp>
#include <jauscat/ethercat/master/process_data.hpp>

#include <algorithm>
#include <random>
#include <vector>

using namespace jauscat::ethercat;
using namespace std::chrono_literals;
using support::instant;
namespace wire = jauscat::wire;

namespace {

using bytes = std::vector<std::byte>;

/// Slaves with places one behind the other, under the stations 1, 2 ...
struct bus {
    std::vector<slave_record> slaves{};
    std::uint32_t end{};

    bus& add(std::size_t outputs, std::size_t inputs, bool no_lrw = false, bool has_mailbox = true) {
        slave_record slave{.position = static_cast<std::uint16_t>(slaves.size()),
                           .station = static_cast<std::uint16_t>(slaves.size() + 1)};
        slave.mailbox.send_size = has_mailbox ? 128 : 0;
        slave.process_data = {.output_address = end,
                              .input_address = end + static_cast<std::uint32_t>(outputs),
                              .output_size = static_cast<std::uint16_t>(outputs),
                              .input_size = static_cast<std::uint16_t>(inputs),
                              .no_lrw = no_lrw};
        end += static_cast<std::uint32_t>(outputs + inputs);
        slaves.push_back(slave);
        return *this;
    }
};

/// The states of all slaves of the ring, or-ed, and their number beyond those of the bus.
struct ring_answer {
    std::byte all{8};
    unsigned others{};
};

/// What the slaves do: the inputs are replaced by `value`, the counters count, all are in OP.
void pass(const bus& b, bytes& frame, std::byte value, std::uint32_t base = 0, const ring_answer& ring = {}) {
    mutable_frame_view view;
    REQUIRE(view.parse(frame));
    for (const auto datagram : view) {
        const auto cmd = datagram.header.cmd;
        unsigned counter = 0;
        if (cmd == command::fprd) {
            counter = 1;
            if (datagram.header.ado == esc_registers::al_status.address) datagram.data[0] = std::byte{8};
        }
        if (cmd == command::brd) {
            counter = static_cast<unsigned>(b.slaves.size()) + ring.others;
            datagram.data[0] = ring.all;
        }
        const auto start = (std::uint32_t{datagram.header.ado} << 16 | datagram.header.adp) - base;
        for (const auto& slave : b.slaves) {
            if (cmd == command::fprd || cmd == command::brd || cmd == command::nop) break;
            const auto& place = slave.process_data;
            if (place.size() == 0) continue;
            const bool is_inside = place.output_address >= start && place.end() <= start + datagram.header.length;
            const bool is_outside = place.end() <= start || place.output_address >= start + datagram.header.length;
            REQUIRE(is_inside != is_outside); // no slave's data cross a datagram
            if (is_outside) continue;
            REQUIRE_FALSE((place.no_lrw && cmd == command::lrw));
            if (cmd != command::lrd && place.output_size != 0) counter += cmd == command::lrw ? 2 : 1;
            if (cmd == command::lwr || place.input_size == 0) continue;
            counter += 1;
            std::ranges::fill(datagram.data.subspan(place.input_address - start, place.input_size), value);
        }
        REQUIRE(wire::encode(datagram_trailer{static_cast<std::uint16_t>(counter)},
                             datagram.bytes.last(wire::max_size<datagram_trailer>)));
    }
}

/// Memory as large as a bus needs it.
struct cyclic_data {
    std::vector<process_slot> slots;
    std::vector<std::byte> memory;
    process_data data;

    explicit cyclic_data(const bus& b, const process_options& options = {})
        : slots(b.slaves.size()), memory(b.end), data{slots, memory} {
        data.set_slaves(b.slaves, options);
    }
    std::vector<bytes> cycle(jauscat::time_point now = instant{0ms}) {
        std::vector<bytes> frames;
        data.begin_cycle();
        bytes frame(max_frame_size);
        while (const auto size = data.next_frame(frame, now))
            frames.emplace_back(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size));
        return frames;
    }
    void take(const bus& b, bytes& frame, std::byte value) {
        pass(b, frame, value);
        REQUIRE(data.on_frame(frame));
    }
};

bool has(std::span<const std::byte> data, std::byte value) {
    return std::ranges::all_of(data, [&](std::byte each) { return each == value; });
}

} // namespace

TEST_CASE("a cycle has as many frames as the process data need, and one working counter for each datagram") {
    bus b;
    for (int i = 0; i != 256; ++i) b.add(8, 8);
    cyclic_data plain{b};
    CHECK(plain.data.frame_count() == 3); // 4096 bytes, 92 slaves of 16 bytes in a frame
    auto frames = plain.cycle();
    REQUIRE(frames.size() == 3);
    CHECK(frames[0].size() == 16 + 12 + 92 * 16);
    for (auto& frame : frames) {
        pass(b, frame, std::byte{7});
        CHECK_FALSE(plain.data.is_complete());
        REQUIRE(plain.data.on_frame(frame));
    }
    CHECK(plain.data.is_complete());
    CHECK(plain.data.working_counter() == 256 * 3);
    CHECK(plain.data.statistics().sent == 1);
    CHECK(plain.data.statistics().complete == 1);
    CHECK(plain.data.statistics().frames == 3);
    for (const auto& slave : b.slaves) CHECK(has(plain.data.inputs(slave), std::byte{7}));

    cyclic_data watched{b, {.watch_slaves = true}};
    CHECK(watched.data.frame_count() == 11); // 61 bytes for each slave, 24 slaves in a frame
}

TEST_CASE("a lost frame makes only the inputs of its slaves old") {
    bus b;
    for (int i = 0; i != 100; ++i) b.add(20, 20);
    for (const bool watches : {false, true}) {
        cyclic_data c{b, {.watch_slaves = watches}};
        const auto count = c.data.frame_count();
        REQUIRE(count >= 3);
        for (std::size_t lost = 0; lost != count; ++lost) {
            for (auto& frame : c.cycle(instant{10ms})) c.take(b, frame, std::byte{1});
            auto frames = c.cycle(instant{20ms});
            std::ranges::reverse(frames); // frames may come back in any order
            for (std::size_t i = 0; i != count; ++i)
                if (i != lost) c.take(b, frames[i], std::byte{2});
            CHECK(c.data.waits());
            std::size_t old = 0;
            for (const auto& slave : b.slaves) {
                const bool is_old = has(c.data.inputs(slave), std::byte{1});
                old += is_old;
                CHECK((is_old || has(c.data.inputs(slave), std::byte{2})));
                if (watches) CHECK(c.data.status(slave).last_inputs == (is_old ? instant{10ms} : instant{20ms}));
            }
            CHECK(old > 0);
            CHECK(old < 50);
            const auto next = c.cycle(instant{30ms});
            CHECK(c.data.statistics().lost == 2 * lost + 1);
            CHECK(c.data.statistics().lost_frames == lost * (count + 1) + 1);
            CHECK_FALSE(c.data.is_complete());
            CHECK(c.data.on_frame(frames[lost])); // late: known, and not used
            for (const auto& slave : b.slaves) CHECK_FALSE(has(c.data.inputs(slave), std::byte{}));
        }
    }
}

TEST_CASE("a wrong working counter of one frame does not make the inputs of another old") {
    bus b;
    for (int i = 0; i != 4; ++i) b.add(500, 500);
    cyclic_data c{b};
    auto frames = c.cycle();
    REQUIRE(frames.size() == 4);
    for (std::size_t i = 0; i != 4; ++i) {
        pass(b, frames[i], std::byte{3});
        if (i == 1) frames[i][frames[i].size() - 2] = std::byte{2}; // the slave has not read
        REQUIRE(c.data.on_frame(frames[i]));
    }
    CHECK_FALSE(c.data.is_complete());
    CHECK(c.data.statistics().incomplete == 1);
    for (std::size_t i = 0; i != 4; ++i) CHECK(has(c.data.inputs(b.slaves[i]), i == 1 ? std::byte{} : std::byte{3}));
}

TEST_CASE("slaves that stay keep outputs, inputs and status, and those that come begin with zeros") {
    bus b;
    for (int i = 0; i != 3; ++i) b.add(4, 4);
    cyclic_data c{b, {.watch_slaves = true}};
    for (const auto& slave : b.slaves) std::ranges::fill(c.data.outputs(slave), std::byte{0x55});
    for (auto& frame : c.cycle(instant{10ms})) c.take(b, frame, std::byte{9});
    const std::vector<slave_record> two{b.slaves[2], b.slaves[0]};
    REQUIRE(c.data.set_slaves(two, {.watch_slaves = true}));
    REQUIRE(c.data.set_slaves(b.slaves, {.watch_slaves = true}));
    for (std::size_t i = 0; i != 3; ++i) {
        const bool stayed = i != 1;
        CHECK(has(c.data.outputs(b.slaves[i]), stayed ? std::byte{0x55} : std::byte{}));
        CHECK(has(c.data.inputs(b.slaves[i]), stayed ? std::byte{9} : std::byte{}));
        CHECK((c.data.status(b.slaves[i]).condition == slave_condition::running) == stayed);
    }
    CHECK(c.data.statistics().sent == 1);
}

TEST_CASE("the states of slaves that all run are read together, and each alone once one does not run") {
    bus b;
    for (int i = 0; i != 40; ++i) b.add(8, 8, false, i != 7);
    b.add(0, 0); // without process data
    cyclic_data c{b, {.watch_slaves = true, .watch_together = true}};
    jauscat::time_point now = instant{10ms};
    const auto cycle = [&](std::byte value, const ring_answer& ring = {}) {
        now += 1ms;
        auto frames = c.cycle(now);
        for (auto& frame : frames) {
            pass(b, frame, value, 0, ring);
            REQUIRE(c.data.on_frame(frame));
        }
        return frames;
    };
    const auto all_are_new = [&](std::byte value) {
        return std::ranges::all_of(b.slaves, [&](const slave_record& slave) {
            const auto& status = c.data.status(slave);
            return status.condition == slave_condition::running && status.last_frame == now &&
                   status.last_running == now && status.last_inputs == now && has(c.data.inputs(slave), value);
        });
    };
    const auto until_together = [&] {
        for (int i = 0; i != 10; ++i) {
            CHECK(cycle(std::byte{1}).size() == 2);
            CHECK(all_are_new(std::byte{1}));
        }
        CHECK(cycle(std::byte{2}).size() == 1);
        CHECK(all_are_new(std::byte{2}));
    };
    until_together();
    CHECK(c.data.ring().slaves == 41);

    std::vector<unsigned> asked(b.slaves.size() + 1);
    for (int i = 0; i != 82; ++i) // 21 of the 41 each
        for (auto& frame : cycle(std::byte{3})) {
            frame_view view;
            REQUIRE(view.parse(frame));
            for (const auto datagram : view)
                if (datagram.header.cmd == command::fprd && datagram.header.ado == esc_registers::al_status.address)
                    ++asked[datagram.header.adp];
        }
    for (const auto& slave : b.slaves) CHECK(asked[slave.station] == 42);

    const auto each_again = [&] {
        // What they were is not known in this cycle, and their inputs are those of the one before.
        for (const auto& slave : b.slaves) {
            if (slave.process_data.size() != 0) CHECK(c.data.status(slave).last_frame == now - 1ms);
            CHECK(has(c.data.inputs(slave), std::byte{3}));
        }
        until_together();
        cycle(std::byte{3});
    };
    cycle(std::byte{3});
    SECTION("one leaves OP") {
        cycle(std::byte{4}, {.all = std::byte{0x0C}});
        each_again();
    }
    SECTION("one has an error") {
        cycle(std::byte{4}, {.all = std::byte{0x18}});
        each_again();
    }
    SECTION("one comes") {
        cycle(std::byte{4}, {.others = 1});
        each_again();
    }
    SECTION("one does not exchange its data") {
        now += 1ms;
        auto frames = c.cycle(now);
        REQUIRE(frames.size() == 1);
        pass(b, frames[0], std::byte{4});
        frames[0][16 + 10 + 40 * 16] = std::byte{117}; // of 120
        REQUIRE(c.data.on_frame(frames[0]));
        each_again();
    }
    SECTION("a polled one does not answer for its state") {
        now += 1ms;
        auto frames = c.cycle(now);
        pass(b, frames[0], std::byte{4});
        frames[0][frames[0].size() - process_plan::watch_size(true) + process_plan::watch_size(false) - 2] =
            std::byte{};
        REQUIRE(c.data.on_frame(frames[0]));
        each_again();
    }
    SECTION("a polled one does not answer for its mailbox") {
        now += 1ms;
        auto frames = c.cycle(now);
        pass(b, frames[0], std::byte{3});
        frames[0][frames[0].size() - 2] = std::byte{}; // the last datagram's counter: its mailbox
        REQUIRE(c.data.on_frame(frames[0]));
        CHECK(all_are_new(std::byte{3}));
        CHECK(cycle(std::byte{3}).size() == 1);
    }
    SECTION("the AL status of a polled one is no state") {
        now += 1ms;
        auto frames = c.cycle(now);
        pass(b, frames[0], std::byte{4});
        frames[0][frames[0].size() - process_plan::watch_size(true) + 10] = std::byte{};
        REQUIRE(c.data.on_frame(frames[0]));
        each_again();
    }
    SECTION("a frame is lost") {
        now += 1ms;
        CHECK(c.cycle(now).size() == 1);
        each_again();
    }
}

TEST_CASE("slaves whose states are read together may be in several frames, in any order") {
    bus b;
    for (int i = 0; i != 80; ++i) b.add(8, 8, false, true);
    cyclic_data c{b, {.watch_slaves = true, .watch_together = true}};
    jauscat::time_point now = instant{10ms};
    const auto cycle = [&](std::byte value, bool in_order = true) {
        now += 1ms;
        auto frames = c.cycle(now);
        for (auto& frame : frames) {
            pass(b, frame, value);
            mutable_frame_view view;
            REQUIRE(view.parse(frame));
            for (auto datagram : view) // mail waits at all that are asked
                if (datagram.header.ado == sync_manager_handshake_of(1).address)
                    datagram.data[0] = std::byte{8}, datagram.data[1] = std::byte{1};
        }
        if (!in_order) std::ranges::reverse(frames);
        for (auto& frame : frames) REQUIRE(c.data.on_frame(frame));
        return frames.size();
    };
    const auto waiting = [&] {
        return std::ranges::count_if(b.slaves, [&](const auto& slave) { return c.data.status(slave).reply_waiting; });
    };
    for (int i = 0; i != 10; ++i) {
        CHECK(cycle(std::byte{1}) == 4);
        CHECK(waiting() == 80);
    }
    for (int i = 0; i != 30; ++i) {
        CHECK(cycle(std::byte{2}) == 2);
        CHECK(waiting() == 40); // of the last frame, too
    }
    for (const auto& slave : b.slaves) CHECK(has(c.data.inputs(slave), std::byte{2}));
    CHECK(cycle(std::byte{3}, false) == 2); // that the others run is not known when they come
    CHECK(has(c.data.inputs(b.slaves.back()), std::byte{2}));
    CHECK(cycle(std::byte{3}, false) == 4);
    CHECK(has(c.data.inputs(b.slaves.back()), std::byte{3}));
}

TEST_CASE("slaves whose polls do not fit into one frame are polled in every cycle") {
    bus b;
    for (int i = 0; i != 100; ++i) b.add(8, 8, false, true);
    cyclic_data c{b, {.watch_slaves = true, .watch_together = true}};
    for (int i = 0; i != 30; ++i) {
        auto frames = c.cycle(instant{10ms});
        CHECK(frames.size() == 5);
        for (auto& frame : frames) {
            pass(b, frame, std::byte{1});
            REQUIRE(c.data.on_frame(frame));
        }
    }
}

TEST_CASE("the states of slaves of a ring with others that do not run are never read together") {
    bus b;
    for (int i = 0; i != 3; ++i) b.add(4, 4);
    cyclic_data c{b, {.watch_slaves = true, .watch_together = true}};
    for (int i = 0; i != 30; ++i)
        for (auto& frame : c.cycle(instant{10ms})) {
            CHECK(frame.size() == 16 + 3 * (20 + 18 + 15) + 18);
            pass(b, frame, std::byte{1}, 0, {.all = std::byte{0x0A}, .others = 1});
            REQUIRE(c.data.on_frame(frame));
        }
}

TEST_CASE("process data of a slave that are larger than a frame are refused") {
    CHECK(cyclic_data{bus{}.add(743, 743)}.data.fits());
    CHECK_FALSE(cyclic_data{bus{}.add(743, 744)}.data.fits());
    CHECK(cyclic_data{bus{}.add(737, 0, true)}.data.fits());
    CHECK_FALSE(cyclic_data{bus{}.add(738, 0, true)}.data.fits());
    CHECK(cyclic_data{bus{}.add(1453, 0), {.watch_slaves = true}}.data.fits());
    CHECK_FALSE(cyclic_data{bus{}.add(1454, 0), {.watch_slaves = true}}.data.fits());
    CHECK(cyclic_data{bus{}, {.watch_slaves = true}}.cycle().empty());
}

TEST_CASE("where the memory does not hold all process data, none are exchanged, and none can be written") {
    bus b;
    b.add(4, 4).add(4, 4);
    std::vector<process_slot> slots(2);
    bytes memory(b.end - 1);
    process_data data{slots, memory};
    CHECK_FALSE(data.set_slaves(b.slaves));
    CHECK(data.image().size == 0);
    for (const auto& slave : b.slaves) {
        CHECK(data.outputs(slave).empty());
        CHECK(data.inputs(slave).empty());
    }
}

TEST_CASE("any mixture of slaves is exchanged whole, each byte once, in frames that are as full as they can be") {
    std::mt19937 random{1};
    for (int round = 0; round != 300; ++round) {
        bus b;
        const auto count = 1 + random() % 80;
        const auto largest = 1u << random() % 10;
        for (std::size_t i = 0; i != count; ++i) {
            const bool no_lrw = random() % 5 == 0, is_empty = random() % 6 == 0;
            b.add(is_empty ? 0 : random() % (largest / 2 + 1), is_empty ? 0 : random() % (largest / 2 + 1), no_lrw,
                  random() % 2 != 0);
        }
        if (random() % 2 != 0) std::ranges::shuffle(b.slaves, random);
        const auto base = static_cast<std::uint32_t>(random());
        const process_options options{.watch_slaves = random() % 2 != 0, .logical_base = base};
        cyclic_data c{b, options};
        REQUIRE(c.data.fits());
        for (int cycle = 0; cycle != 260; cycle += 130) {
            const auto value = static_cast<std::byte>(cycle + 1);
            auto frames = c.cycle(instant{cycle * 1ms});
            CHECK(frames.size() == c.data.frame_count());
            for (auto& frame : frames) {
                CHECK(frame.size() <= max_frame_size);
                pass(b, frame, value, base);
                REQUIRE(c.data.on_frame(frame));
            }
            CHECK(c.data.waits() == false);
            if (!frames.empty()) CHECK(c.data.is_complete());
            CHECK(c.data.working_counter() == [&] {
                unsigned sum = 0; // an LWR is not counted
                for (const auto& s : b.slaves)
                    sum += (s.process_data.input_size != 0 ? 1u : 0u) +
                           (s.process_data.output_size != 0 && !s.process_data.no_lrw ? 2u : 0u);
                return sum;
            }());
            for (const auto& slave : b.slaves) {
                CHECK(has(c.data.inputs(slave), value));
                if (options.watch_slaves) CHECK(c.data.status(slave).condition == slave_condition::running);
            }
            // There is no room for another slave in any frame but the last.
            for (std::size_t i = 1; i < frames.size(); ++i)
                CHECK(frames[i - 1].size() + 2 * (largest + 12) + 33 > max_frame_size);
        }
    }
}
