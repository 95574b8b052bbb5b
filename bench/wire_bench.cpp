// Measures a master and a slave on a pair of virtual Ethernet interfaces, jc0 and jc1: see scripts/measure wire.
#include "support/program.hpp"
#include "wire/bare_socket.hpp"
#include "wire/commands.hpp"
#include "wire/report.hpp"
#include "wire/slave_end.hpp"

#include <functional>

namespace {

using namespace wire_bench;
using jauscat::net::raw_link;
using std::chrono::microseconds, std::chrono::seconds;

constexpr const char* help =
    R"(wire_bench: a master on jc0 and a slave, a thread of its own, on jc1: scripts/measure wire runs it.
)";

/// Remembers the frames that go out. Models the link concept over another link.
class recording_link {
  public:
    explicit recording_link(raw_link& link) : link_{link} {}
    bool send(std::span<const std::byte> frame) {
        frames.emplace_back(frame.begin(), frame.end());
        return link_.send(frame);
    }
    std::size_t receive(std::span<std::byte> buffer, nanoseconds timeout) { return link_.receive(buffer, timeout); }

    std::vector<std::vector<std::byte>> frames{};

  private:
    raw_link& link_;
};

class bench {
  public:
    explicit bench(const boost::program_options::variables_map& values)
        : count_{values["count"].as<unsigned>()},
          seconds_{values["seconds"].as<unsigned>()},
          busy_poll_{values["busy-poll"].as<unsigned>()},
          json_{values["json"].as<std::string>()} {
        if (!values["no-pin"].as<bool>() && std::thread::hardware_concurrency() > 1) other_processor_ = 1;
        if (other_processor_ == 1) pin(0);
    }

    int run() {
        print_head();
        floor();
        slave_ = std::make_unique<slave_end>(other_processor_, busy_poll_);
        link_.busy_poll(busy_poll_);
        bring_ups();
        datagrams();
        downloads();
        probe();
        commands_by_mailbox();
        go_to_op();
        for (const microseconds period : {microseconds{1000}, microseconds{250}})
            for (const microseconds spin : {microseconds{0}, microseconds{100}}) cycles(period, spin);
        if (!json_.empty() && !write_json(rows_, json_)) throw std::runtime_error{"cannot write " + json_};
        return example::success;
    }

  private:
    row& new_row(const std::string& name) { return rows_.emplace_back(row{.name = name}); }

    void work(const auto& job, const char* what) { check(jauscat::net::run(link_, master_, job), what); }
    template <class T> static void check(const ethercat::master_result<T>& result, const char* what) {
        if (!result) throw std::runtime_error{std::string{what} + ": " + std::string{describe(result.error())}};
    }

    /// What the system needs for a frame there and back, whoever sends it.
    void floor() {
        for (const auto& options : {socket_options{.name = "echo by hand, asleep while it waits"},
                                    socket_options{.name = "echo by hand, awake", .busy_poll = microseconds{200}}}) {
            auto& r = new_row(options.name);
            measure_echo(r, count_, options, other_processor_);
            print(r);
        }
    }

    void bring_ups() {
        auto& r = new_row("bring-up to PRE-OP");
        measure(r, 200, [&] {
            master_.reset();
            work(ethercat::bring_up{0, station}, "bring-up");
        });
        r.frames = static_cast<double>(master_.statistics().sent);
        print(r);
    }

    /// A register read by the master: one frame.
    void datagrams() {
        auto& r = new_row("one datagram (FPRD of 2 bytes)");
        std::array<std::byte, 2> data{};
        measure(r, count_,
                [&] { work(ethercat::exchange_datagram{ethercat::command::fprd, station, 0x0010, data}, "datagram"); });
        r.frames = 1;
        print(r);
    }

    void downloads() {
        auto& r = new_row("SDO download of 28 bytes");
        const std::array<std::byte, 28> data{};
        download(data); // looks once whether the mailbox is empty
        const auto before = master_.statistics().sent;
        std::uint64_t downloads = 0; // those that warm up, too
        measure(r, count_, [&] {
            download(data);
            ++downloads;
        });
        r.frames = static_cast<double>(master_.statistics().sent - before) / static_cast<double>(downloads);
        print(r);
    }
    void download(std::span<const std::byte> data) { work(ethercat::download{station, 0x2000, 1, data}, "download"); }

    /// The two frames of such a download, made before, by hand: what the slave and the system need for it.
    void probe() {
        const std::array<std::byte, 28> data{};
        recording_link recorder{link_};
        check(jauscat::net::run(recorder, master_, ethercat::download{station, 0x2000, 1, data}), "download");
        auto& frames = recorder.frames;
        if (frames.size() != 2) throw std::runtime_error{"a download took other than two frames"};
        const bare_socket socket{"jc0", {.busy_poll = busy_poll_}};
        std::array<std::byte, 1600> back{};
        constexpr std::size_t index_at = 17, mailbox_counter_at = 26 + 5, low_byte_of_counter_at = 26 + 256;
        unsigned counter = master_.find(station)->last_counter;
        auto& r = new_row("the two frames of that download, by hand");
        measure(r, count_, [&] {
            counter = counter % 7 + 1;
            frames[0][mailbox_counter_at] = static_cast<std::byte>(counter << 4 | 3);
            for (auto& frame : frames) {
                frame[index_at] = static_cast<std::byte>(std::to_integer<unsigned>(frame[index_at]) + 1);
                do {
                    socket.send(frame);
                    if (socket.receive(back) == 0) throw std::runtime_error{"probe: a frame was lost"};
                } while (back[low_byte_of_counter_at] == std::byte{}); // not answered yet
            }
        });
        r.frames = 2;
        print(r);
        master_.reset(); // the slave's mailbox counters have moved on
        work(ethercat::bring_up{0, station}, "bring-up");
    }

    void commands_by_mailbox() {
        auto& r = new_row("JAUS datagram to actuator, by mailbox");
        warn(command_by_mailbox(r, commands_, link_, master_, *slave_));
        print(r);
    }

    void go_to_op() {
        work(ethercat::configure{station}, "configuration");
        work(ethercat::change_state{station, ethercat::al_state::safe_op}, "SAFE-OP");
        data_.set_slaves(master_.slaves());
        runner start{link_, data_, master_};
        check(start.run_job(
                  ethercat::change_state{station, ethercat::al_state::op}, seconds{2}, [] {}, [](const auto&) {}),
              "OP");
    }

    void cycles(microseconds period, microseconds spin) {
        const auto name = "cycle of " + std::to_string(period.count()) + " us" + (spin.count() != 0 ? ", awake" : "");
        runner cycles{link_, data_, master_, {.period = period, .spin = spin}};
        auto& late = new_row(name + ": late");
        auto& round_trip = new_row(name + ": round trip");
        const auto before = data_.statistics();
        const auto cpu = cpu_time();
        const auto end = std::chrono::steady_clock::now() + seconds_;
        while (std::chrono::steady_clock::now() < end) {
            const auto report = cycles.run([] {});
            late.times.add(report.late);
            if (report.back) round_trip.times.add(report.round_trip);
        }
        late.cpu = round_trip.cpu =
            (cpu_time() - cpu) / std::max<std::int64_t>(1, static_cast<std::int64_t>(late.times.count()));
        round_trip.frames = 1;
        print(late);
        print(round_trip);
        const auto& after = data_.statistics();
        std::fprintf(stderr, "%s: %llu lost, %llu incomplete, %llu left out\n", name.c_str(),
                     static_cast<unsigned long long>(after.lost - before.lost),
                     static_cast<unsigned long long>(after.incomplete - before.incomplete),
                     static_cast<unsigned long long>(cycles.overruns()));
        if (spin.count() != 0) return; // two processors awake leave none to the operator's program
        auto& r = new_row("JAUS datagram to actuator, by " + name);
        warn(command_by_cycle(r, commands_, cycles, data_, *master_.find(station), *slave_));
        print(r);
    }

    static void warn(unsigned lost) {
        if (lost != 0) std::fprintf(stderr, "%u commands did not arrive\n", lost);
    }

    using runner = jauscat::net::cycle_runner<raw_link>;
    static constexpr unsigned commands_ = 1000;

    unsigned count_;
    seconds seconds_;
    microseconds busy_poll_;
    std::string json_;
    int other_processor_ = -1;
    std::deque<row> rows_{};
    std::unique_ptr<slave_end> slave_{};
    raw_link link_{"jc0"};
    ethercat::master_for<16> master_{};
    ethercat::process_data_for<1, 64> data_{};
};

} // namespace

int main(int argc, char** argv) {
    return example::run("wire_bench", [&] {
        namespace po = boost::program_options;
        po::options_description options;
        // clang-format off
        options.add_options()
            ("count", po::value<unsigned>()->default_value(10000), "how often each exchange is measured")
            ("seconds", po::value<unsigned>()->default_value(10), "how long each cycle is measured")
            ("busy-poll", po::value<unsigned>()->default_value(50), "microseconds that both links poll before they sleep")
            ("no-pin", po::bool_switch(), "leave it to the system which processor runs master and slave, instead of one each")
            ("socket-options", po::bool_switch(), "compare the options of a packet socket instead")
            ("json", po::value<std::string>()->default_value(""), "file for all results and their histograms");
        // clang-format on
        const auto values = example::parse(argc, argv, options, help);
        if (!values["socket-options"].as<bool>()) return bench{values}.run();
        const int other = values["no-pin"].as<bool>() || std::thread::hardware_concurrency() < 2 ? -1 : 1;
        if (other == 1) pin(0);
        compare_options(values["count"].as<unsigned>(), other);
        return int{example::success};
    });
}
