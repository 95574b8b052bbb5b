// Any frames through an emulated slave: what does not parse changes nothing, and the rest only what it may.
#include "support/described_objects.hpp"
#include "support/steps.hpp"
#include <jauscat/ethercat/slave/slave.hpp>

#include <array>
#include <chrono>
#include <type_traits>

using namespace fuzz;
using namespace jauscat;
using namespace jauscat::ethercat;

namespace {

static_assert(std::is_trivially_copyable_v<slave>); // its bytes are its state

bool same_state(const slave& a, const slave& b) {
    return std::ranges::equal(std::as_bytes(std::span{&a, 1}), std::as_bytes(std::span{&b, 1}));
}

bool only_writes(command cmd) {
    return cmd == command::apwr || cmd == command::fpwr || cmd == command::bwr || cmd == command::lwr;
}
bool is_logical(command cmd) { return cmd == command::lrd || cmd == command::lwr || cmd == command::lrw; }
bool does_nothing(command cmd) { return cmd == command::nop || cmd > command::frmw; }

void check_datagram(const datagram_view& sent, const datagram_view& back) {
    check(back.header.cmd == sent.header.cmd && back.header.index == sent.header.index &&
              back.header.ado == sent.header.ado && back.header.length == sent.header.length &&
              back.header.more == sent.header.more,
          "a slave leaves the header alone");
    const auto moved = static_cast<std::uint16_t>(back.header.adp - sent.header.adp);
    const auto counted = static_cast<std::uint16_t>(back.working_counter - sent.working_counter);
    check(moved <= 1 && counted <= 3, "a slave counts itself once");
    const bool same_data = std::ranges::equal(back.data, sent.data);
    if (counted == 0) check(same_data, "a datagram that is not executed keeps its data");
    if (only_writes(sent.header.cmd)) check(same_data, "a write keeps its data");
    if (does_nothing(sent.header.cmd)) check(counted == 0, "a command that says nothing does nothing");
    if (does_nothing(sent.header.cmd) || is_logical(sent.header.cmd)) check(moved == 0, "they have no position");
}

void check_frame(slave& device, byte_vector frame) {
    const byte_vector sent = frame;
    frame_view before, after;
    const bool parses = static_cast<bool>(before.parse(sent));
    const slave unchanged = device;
    device.process(frame);
    if (!parses) {
        check(frame == sent, "a frame that does not parse passes untouched");
        check(same_state(device, unchanged), "a frame that does not parse changes no state");
        return;
    }
    check(static_cast<bool>(after.parse(frame)), "a frame that parses comes back as one");
    auto back = after.begin();
    for (const auto datagram : before) check_datagram(datagram, *back++);
    check(back == after.end(), "a frame keeps its datagrams");
    const auto state = device.state();
    check(state == al_state::init || state == al_state::pre_op || state == al_state::safe_op || state == al_state::op,
          "a slave is in one of its states");
}

} // namespace

void fuzz::run(std::span<const std::byte> input) {
    input_reader in{input};
    objects plain;
    described_objects described;
    byte_vector memory(1020); // of the largest object
    constexpr std::array outputs{pdo_entry{0x7000, 1, 32, 7, "value"}, pdo_entry{0x7000, 2, 3, 5, "mode"}};
    constexpr std::array inputs{pdo_entry{0x6000, 1, 64, 0x1B, "value"}};
    constexpr std::array refused{refused_object{0x2002, 1, abort_code::hardware}};
    const auto options = in.take();
    auto what = description(options);
    if ((options & 8) != 0) what.outputs = outputs, what.inputs = inputs;
    coe_options rules{.transfer_memory = memory};
    if ((options & 16) != 0) rules.refused = refused, rules.subindex_0_rule = rules.state_rule = true;
    if ((options & 32) != 0) rules.answer_delay = 2;
    slave device{what, (options & 64) != 0 ? object_dictionary{described} : object_dictionary{plain}, rules};
    plain.on_access =
        described.on_access = [&] { check(device.state() != al_state::init, "a slave in INIT has no mailbox"); };
    jauscat::time_point now{};
    for (int step = 0; step != max_steps && !in.empty(); ++step)
        if (auto frame = next_frame(in); !frame.empty()) {
            check_frame(device, std::move(frame));
            device.on_time(now += std::chrono::milliseconds{30});
            if (device.take_outputs()) check(device.state() == al_state::op, "outputs count in OP only");
        }
}
