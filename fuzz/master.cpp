// A master on a link that loses, forges and changes frames: what is not the reply changes nothing, and each job ends.
#include "support/objects.hpp"
#include "support/steps.hpp"
#include "support/timed_master.hpp"
#include <jauscat/ethercat/master/process_data.hpp>
#include <jauscat/ethercat/slave/slave.hpp>

#include <tuple>

using namespace fuzz;
using namespace jauscat;
using namespace jauscat::ethercat;

namespace {

using fuzz::check; // not the master's job

/// What happens to a frame.
enum class fate : std::uint8_t { processed, lost, changed, answered, preceded, count };

class session {
  public:
    explicit session(std::span<const std::byte> input) : in_{input} {}

    void run() {
        job([&] { return master_.start(bring_up{0, station}); });
        const auto size = std::size_t{in_.take()};
        const byte_vector data(size);
        byte_vector into(size);
        const auto index = in_.take<wire::u16le>();
        const auto subindex = in_.take();
        for (int i = 0; i != 3 && !in_.empty(); ++i) {
            job([&] { return master_.start(download{station, index, subindex, data}); });
            job([&] { return master_.start(upload{station, index, subindex, into}); });
            check(master_.result<upload>().value_or({}).size() <= into.size(), "an upload fits its buffer");
        }
        for (int i = 0; i != 4 && !in_.empty(); ++i) any_job(into);
    }

  private:
    void any_job(byte_vector& into) {
        const auto fits = [&](std::size_t size) { check(size <= into.size(), "an answer fits its buffer"); };
        switch (in_.take() % 9) {
        case 0:
            job([&] { return master_.start(scan{}); });
            job([&] { return master_.start(bring_up{0, station, {.vendor = description(0).vendor}}); });
            break;
        case 1: job([&] { return master_.start(configure{station}); }); break;
        case 2:
            job([&] { return master_.start(change_state{station, static_cast<al_state>(1u << in_.take() % 4)}); });
            break;
        case 3:
            job([&] { return master_.start(list_objects{station, object_list_type::all, into}); });
            fits(master_.result<list_objects>().value_or({}).bytes().size());
            break;
        case 4:
            job([&] { return master_.start(describe_entry{station, 0x1018, in_.take(), 7, into}); });
            fits(master_.result<describe_entry>().value_or({}).bytes.size());
            break;
        case 5: job([&] { return master_.start(collect_emergencies{station}); }); break;
        case 6:
            job([&] { return master_.start(upload{station, 0x1018, 0, into, {.complete_access = true}}); });
            fits(master_.result<upload>().value_or({}).size());
            break;
        case 7: job([&] { return master_.start(jauscat::ethercat::check{station}); }); break;
        default: cycles();
        }
    }

    // Forged process data never leave a slave's place.
    void cycles() {
        process_data_for<4, 4096> data{master_.slaves(), {.watch_slaves = in_.take() % 2 != 0}};
        byte_vector frame(max_frame_size);
        for (int i = 0; i != 4; ++i) {
            data.begin_cycle();
            const auto size = data.next_frame(frame, now_);
            if (size == 0) return;
            byte_vector back(frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size));
            device_.process(back);
            for (auto left = in_.take() % 4; left != 0; --left)
                back[in_.take<wire::u16le>() % back.size()] = std::byte{in_.take()};
            static_cast<void>(data.on_frame(back));
        }
        for (const auto& slave : master_.slaves())
            check(data.outputs(slave).size() == slave.process_data.output_size &&
                      data.inputs(slave).size() == slave.process_data.input_size,
                  "a slave's place is whole");
    }

    static constexpr std::uint16_t station = 2;

    void job(auto&& start) {
        const bool clean = in_.empty();
        check(static_cast<bool>(start()), "an idle master takes a job");
        check(master_.idle() || !start(), "a busy master takes no job");
        timed_.run([this](byte_vector& frame) {
            frame_view view;
            check(static_cast<bool>(view.parse(frame)), "a master sends frames that parse");
            travel(std::move(frame));
        });
        check(!master_.next_event(), "an idle master waits for nothing");
        if (clean) check(master_.error().code != master_errc::no_reply, "on a good link replies come");
    }

    void travel(byte_vector frame) {
        switch (static_cast<fate>(in_.take() % static_cast<unsigned>(fate::count))) {
        case fate::lost: return;
        case fate::changed:
            device_.process(frame);
            for (auto left = in_.take() % 8; left != 0; --left)
                frame[in_.take<wire::u16le>() % frame.size()] = std::byte{in_.take()};
            arrive(frame);
            return;
        case fate::answered: // by a slave that says anything
            answer(frame);
            check(arrive(frame), "a reply is taken");
            return;
        case fate::preceded:
            if (const auto other = next_frame(in_); !other.empty()) arrive(other);
            [[fallthrough]];
        default: device_.process(frame); arrive(frame);
        }
    }

    void answer(byte_vector& frame) {
        mutable_frame_view view;
        static_cast<void>(view.parse(frame));
        for (const auto datagram : view) {
            std::ranges::copy(in_.take_bytes(datagram.data.size()), datagram.data.begin());
            static_cast<void>(
                wire::encode(datagram_trailer{in_.take()}, datagram.bytes.last(wire::max_size<datagram_trailer>)));
        }
    }

    bool arrive(std::span<const std::byte> frame) {
        const auto was = master_.statistics();
        const auto before = std::tuple{master_.idle(), master_.next_event(), master_.error(), master_.slaves().size()};
        const bool taken = master_.on_frame(frame, now_);
        const auto& is = master_.statistics();
        check(is.received == was.received + taken && is.ignored == was.ignored + !taken, "a frame is taken or ignored");
        if (!taken)
            check(before ==
                          std::tuple{master_.idle(), master_.next_event(), master_.error(), master_.slaves().size()} &&
                      is.lost == was.lost,
                  "what is not the reply changes nothing");
        return taken;
    }

    input_reader in_;
    objects source_{};
    byte_vector memory_ = byte_vector(1020); // of the largest object
    slave device_{description(0), object_dictionary{source_}, {.transfer_memory = memory_}};
    timed_master timed_{};
    master& master_{timed_.master};
    time_point& now_{timed_.now};
};

} // namespace

void fuzz::run(std::span<const std::byte> input) { session{input}.run(); }
