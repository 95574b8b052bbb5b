// Options of a bus, and the choice of a slave.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/ethercat/master/clock_record.hpp>
#include <jauscat/ethercat/master/process_object.hpp>
#include <jauscat/net/config/slave_entry.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace jauscat {
inline namespace JAUSCAT_WAY {

/// A problem of a link.
enum class link_fault : std::uint8_t {
    no_frames,     ///< frames do not pass
    second_master, ///< frames of another master are on the link
    broken_ring,   ///< frames return marked as circulating: a cable between two slaves is out
};
/// A frame of a link, for a trace.
struct passing_frame {
    std::span<const std::byte> bytes{};
    bool is_sent{};       ///< not received
    bool is_keep_alive{}; ///< a bridge's Report Heartbeat Pulse to a slave, or its reply
};

/// All options have defaults.
struct bus_options {
    /// The slaves that are expected, by name: those of a configuration file, `config.me().ethercat->slaves`, or of the
    /// program. Another slave in the place of one is refused. Without any, all slaves are taken as they are found.
    std::vector<net::slave_entry> slaves{};
    /// Of an operation, once it has begun; longer for a slave with timeouts of its own (net::slave_entry).
    duration timeout{std::chrono::seconds{5}};
    duration start_timeout{std::chrono::seconds{30}}; ///< of async_start
    /// Each slave's state is read so often, and its emergencies are collected. 0: never. Slaves of a bridge are watched
    /// as its options say.
    duration check_interval{std::chrono::milliseconds{100}};
    duration frame_timeout{std::chrono::milliseconds{20}}; ///< a frame that is not back by now is lost and repeated
    unsigned frame_retries{9};                             ///< of one frame
    /// The link may deliver frames twice, as an IP network may. Makes transfers slow.
    bool frames_may_be_copied{};
    /// `async_start` resets slaves also where one is in OP, which another master may control.
    bool takes_over{};
    /// Before an object is written, 0 is written to subindex 0: for slaves that abort with 06010003h otherwise.
    bool clear_subindex_0{};
    /// The bus works in a thread of its own, so that handlers of the program do not delay it. They still run where the
    /// io_context does.
    bool thread{};
    int priority{};     ///< of that thread: SCHED_FIFO, 1 to 99, which takes CAP_SYS_NICE or an rtprio limit; 0: none
    std::string name{}; ///< in front of lines of the log; empty: the name of the link
    /// Gets a line when a slave is lost, returns or reports an emergency, and for each problem of the link. By default
    /// they are written to standard error.
    std::function<void(std::string_view line)> log{};
    /// Gets the problems of the link besides the log; called by the io_context, and may stop the bus.
    std::function<void(link_fault what, std::string_view line)> on_fault{};
    /// Gets all frames, for a trace; in the thread of the bus if it has one. Must not use the bus.
    std::function<void(const passing_frame& frame)> on_frame{};
};

/// Process data of a slave that the application exchanges itself. 0 stands for the default.
struct operate_options {
    /// Of the cycles, more than 0, at most 3.25 s. The process data of a bus have the shortest period of all its users.
    duration period{std::chrono::milliseconds{1}};
    /// A slave without outputs for so long leaves OP by itself: 2 periods to 6.5 s. Default: 100 ms or 4 periods.
    duration watchdog{};
    /// A slave that has not exchanged process data in OP for so long is lost: 2 periods or more. Default: 50 ms or 2
    /// periods.
    duration timeout{};
    /// SYNC signals of its distributed clock, each period if its `sync0_cycle` is 0; by default those of its entry in
    /// bus_options::slaves. It reaches OP once its clock and the cycles follow the reference clock, which takes some
    /// seconds. The error is `not_synchronized` if they do not.
    std::optional<ethercat::sync_settings> sync{};
    /// Get their places in the process data before the slave is in OP. They stay in place until it has left OP.
    std::span<ethercat::process_object> objects{};
};

/// The distributed clocks of a bus.
struct bus_clocks {
    std::uint16_t reference{}; ///< station address of the slave with the reference clock; 0: none is left
    duration error{};          ///< of the cycles, by the reference clock: moving average; above 0: they are late
    bool is_locked{};          ///< the cycles follow the reference clock
};

/// Of the cycles since the bus was started.
struct bus_statistics {
    /// Microseconds: upper bounds of `late_cycles`.
    static constexpr std::array<unsigned, 10> late_limits{1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};

    std::uint64_t cycles{};          ///< begun
    std::uint64_t incomplete{};      ///< all frames have returned, and not every slave has taken part
    std::uint64_t lost{};            ///< a frame at least did not return before the next cycle
    std::uint16_t working_counter{}; ///< sum over the frames of the last cycle that has returned
    std::uint16_t expected_working_counter{};
    duration round_trip{}; ///< of the last cycle that has returned, from its beginning to its last frame
    duration longest_round_trip{};
    duration late{}; ///< the beginning of the last cycle, after it was due
    duration longest_late{};
    std::uint64_t foreign_frames{}; ///< of another master
    duration period{};              ///< of the cycles; 0: there are none
    /// Cycles that began so late after they were due: up to each limit, and the rest.
    std::array<std::uint64_t, late_limits.size() + 1> late_cycles{};
    std::optional<bus_clocks> clocks{}; ///< nothing: no slave has SYNC signals
};

/// Identity of a slave, object 1018h; what is not given is not compared.
struct required_identity {
    std::optional<std::uint32_t> vendor{};
    std::optional<std::uint32_t> product{};
    std::optional<std::uint32_t> revision{};
    std::optional<std::uint32_t> serial{};

    friend bool operator==(const required_identity&, const required_identity&) = default;
};

/// A device name of up to 127 characters. It is no std::string, because g++ 12 destroys a temporary twice that holds
/// one in a co_await expression: `co_await bus.slave({.name = "drive"}).async_state()`.
class device_name {
  public:
    constexpr device_name() noexcept = default;
    /// Throws `std::length_error` for a longer name.
    constexpr device_name(std::string_view text) : size_{text.size()} {
        if (text.size() > text_.size()) throw std::length_error{"a device name has up to 127 characters"};
        std::ranges::copy(text, text_.begin());
    }
    constexpr device_name(const char* text) : device_name{std::string_view{text}} {}
    device_name(const std::string& text) : device_name{std::string_view{text}} {}

    [[nodiscard]] constexpr std::string_view view() const noexcept { return {text_.data(), size_}; }
    [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
    friend constexpr bool operator==(const device_name&, const device_name&) = default;

  private:
    std::array<char, 127> text_{};
    std::size_t size_{};
};

/// A slave by its position, alias, name or identity: it is as all that is given requires.
struct slave_choice {
    std::optional<std::uint16_t> position{}; ///< in the ring, from 0
    std::optional<std::uint16_t> alias{};    ///< configured station alias, 1 to 65535
    device_name name{};                      ///< in bus_options::slaves, or else the device name, of slave_info::name
    required_identity identity{};

    friend bool operator==(const slave_choice&, const slave_choice&) = default;
};

/// What a bus knows of a slave.
struct slave_info {
    std::uint16_t position{};      ///< in the ring, from 0
    std::uint16_t station{};       ///< station address
    std::uint16_t alias{};         ///< configured station alias; 0: none
    std::string configured_name{}; ///< in bus_options::slaves; empty: none
    std::string name{};            ///< object 1008h, or in the SII; empty: it has none
    std::uint32_t vendor{};
    std::uint32_t product{};
    std::uint32_t revision{};
    std::uint32_t serial{};
    bool has_objects{}; ///< it has a CoE mailbox
    bool is_served{};   ///< by a bridge, or in OP by `async_operate`
    bool is_lost{};     ///< it does not answer
};

/// State of a slave.
struct slave_status {
    slave_info info{};
    std::optional<ethercat::al_state> state{};  ///< as it was seen last; nothing: it was not, or it does not answer
    std::optional<ethercat::al_state> wanted{}; ///< by a bridge or an operation
    std::string problem{};                      ///< why it is not in that state; empty: nothing is known to be wrong
    bool is_in_service{};                       ///< a bridge or an operation uses it, and it takes part
    bool is_at_rest{};                          ///< no stop order waits for its confirmation
};

} // namespace JAUSCAT_WAY
} // namespace jauscat
