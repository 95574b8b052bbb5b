// Packets of a card's API, executed on a ring whose slaves' answers may be changed: every request packet is confirmed,
// in the room that there is, and after a bounded number of frames.
#include "support/objects.hpp"
#include "support/timed_master.hpp"
#include <jauscat/ethercat/hilscher/packet_job.hpp>
#include <jauscat/ethercat/slave/slave.hpp>
#include <jauscat/ethercat/slave/standard_objects.hpp>

#include <array>

using namespace fuzz;
using namespace jauscat;
using namespace jauscat::ethercat;

namespace {

using fuzz::check; // not the master's job

/// An input is a row of packets: options, 16 bits of size, the packet, then a step for each of some frames.
class session {
  public:
    explicit session(std::span<const std::byte> input) : in_{input} {}

    void run() {
        for (int packets = 0; packets != 20 && !in_.empty(); ++packets) execute();
    }

  private:
    static constexpr std::array<bus_slave, 2> bus{bus_slave{0, 1}, bus_slave{1, 2}};

    void execute() {
        const auto options = in_.take();
        const byte_vector request = in_.take_bytes(in_.take<wire::u16le>() % 1700);
        steps_ = in_.take() % 64;
        byte_vector confirmation((options & 4) != 0 ? in_.take() : packet_job::confirmation_size + 4);
        packet_options how{.check_header = (options & 2) != 0};
        if ((options & 1) != 0) how.slaves = bus;

        packet_job job{request, confirmation, how};
        int jobs = 0;
        for (bool runs = job.start(master_); runs; runs = job.next(master_)) {
            check(++jobs < 200, "a packet is executed in some jobs");
            drive();
        }
        const auto size = job.finish(master_);
        hilscher::packet_header asked{}, answer{};
        const bool is_packet = static_cast<bool>(wire::decode_prefix(asked, request));
        check(size <= confirmation.size() && size <= packet_job::confirmation_size, "a confirmation fits");
        if (size == 0) {
            check(!is_packet || (static_cast<std::uint32_t>(asked.ul_cmd) & 1u) != 0 || confirmation.size() < 52,
                  "a request packet is confirmed");
            return;
        }
        check(is_packet && static_cast<bool>(wire::decode_prefix(answer, confirmation)), "it has a header");
        check(static_cast<std::uint32_t>(answer.ul_cmd) == static_cast<std::uint32_t>(asked.ul_cmd) + 1 &&
                  answer.ul_len == size - 40 && answer.ul_id == asked.ul_id && answer.ul_src == asked.ul_src,
              "it is the request's");
    }

    void drive() {
        timed_.run([this](byte_vector& frame) {
            for (auto& each : slaves_) each.process(frame);
            if (disturb(frame)) master_.on_frame(frame, timed_.now);
        });
    }

    // False where the frame is lost.
    bool disturb(byte_vector& frame) {
        if (steps_ == 0) return true;
        --steps_;
        const auto step = in_.take();
        for (int left = step % 8; left > 1; --left)
            frame[in_.take<wire::u16le>() % frame.size()] = std::byte{in_.take()};
        return step % 8 != 1;
    }

    input_reader in_;
    unsigned steps_{}; // frames that the input still has something to say of
    objects own_{};
    slave_description first_ = description(0), second_ = description(2);
    standard_objects dictionaries_[2]{{first_, own_}, {second_, own_}};
    byte_vector memory_ = byte_vector(1020); // of the largest object
    std::array<slave, 2> slaves_{slave{first_, dictionaries_[0], {.transfer_memory = memory_}},
                                 slave{second_, dictionaries_[1]}};
    timed_master timed_{};
    master& master_{timed_.master};
};

} // namespace

void fuzz::run(std::span<const std::byte> input) { session{input}.run(); }
