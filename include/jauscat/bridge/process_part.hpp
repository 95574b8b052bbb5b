// What a component does with the process data of its slaves, selected at run time.
#pragma once
#include <jauscat/base/result.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/bridge/pending_stops.hpp>
#include <jauscat/ethercat/master/jobs.hpp>
#include <jauscat/ethercat/master/slave_status.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/translate/table.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace jauscat::bridging {

/// Process data of one slave; of a slave that is lost they are empty.
struct slave_data {
    std::span<std::byte> outputs{};      ///< sent in each cycle; zeros when the slave comes to OP
    std::span<const std::byte> inputs{}; ///< of the last cycle in which they were exchanged: see `status`
    ethercat::slave_status status{};     ///< after the last cycle
};
/// The slaves of a component, in the order in which it was given them.
using slave_group = std::span<const slave_data>;

/// A drive that cannot move. `code` is the device's: for a CiA 402 drive its error code, object 603Fh; 0 where it has
/// none, or where that is not in the process data.
struct drive_fault {
    std::size_t slave{}; ///< index in the group
    std::uint16_t code{};
    std::string_view reason{}; ///< without a code: what the part has found; lives as long as the part
    friend constexpr bool operator==(const drive_fault&, const drive_fault&) = default;
};

/// The times of a component's slaves, by docs/safety.md.
struct process_times {
    duration period{};     ///< of the cycles, until `change_period`
    duration rest_limit{}; ///< the slaves have to be at rest within it; 0: without limit
    duration ramp_limit{}; ///< of that, for a ramp; 0: without limit
};

/// Carries the messages of one component by the process data of its slaves: commands into the outputs, queries from the
/// inputs. `image_part` does so by two image tables.
///
/// The ring calls `start` when all slaves are in OP, `step` once in each cycle, when its frame has returned or is lost,
/// and the other functions between the steps. Commands and stop orders have numbers that grow by at least 1; `executed`
/// is the last one that the slaves have executed. A command that is not executed in time is refused, and the actuator
/// brought to rest. When a slave is lost, the component goes to Failure and its other slaves are brought to rest;
/// `step` is still called for them, and `start` when all slaves are in OP again.
///
/// For the actuator to come to rest, a part guarantees:
/// - Outputs of zeros are rest: a slave that comes to OP has them.
/// - `stop` writes to all outputs at once what brings the slaves to rest; until the next `command` no function writes
///   anything that moves. `command` is not called while a stop order waits for its execution.
/// - `executed` does not reach the number of a stop order before inputs later than the order prove that each slave
///   obeys it.
/// - No function allocates, throws or blocks: they are called between two frames.
class process_part {
  public:
    virtual ~process_part() = default;

    /// Objects of a slave of the group that have to be right before its process data are set up: in PRE-OP they are
    /// written where they differ, and read back: up to 64 bytes each. Those that the slave does not have are passed
    /// over. The same for each call with these arguments; valid until the next call.
    [[nodiscard]] virtual std::span<const ethercat::init_command> start_up([[maybe_unused]] std::size_t slave,
                                                                           [[maybe_unused]] duration period) {
        return {};
    }
    /// Objects that the part has in the process data of a slave of the group: they get their places when these are set
    /// up. A list for each slave, which stays until then; the same objects for each call.
    [[nodiscard]] virtual std::span<ethercat::process_object> objects([[maybe_unused]] std::size_t slave) { return {}; }
    /// They have their places. An error, wrong_mapping, when the part cannot work with these: the slave does not come
    /// to OP.
    [[nodiscard]] virtual ethercat::master_error check_objects([[maybe_unused]] std::size_t slave) { return {}; }
    /// The times that the component has to keep, before each `start`; a bridge asks when it is given the part, too.
    /// Returns why the part cannot keep them, as a sentence that lives as long as the part: the component then stays in
    /// Failure, and a bridge throws it. Empty: it can.
    [[nodiscard]] virtual std::string_view use_times([[maybe_unused]] const process_times& times) { return {}; }
    /// All slaves are in OP with current inputs; the cycles have this period until `change_period`. What was before
    /// does not count: no command or stop order waits. Error: the data are not as this part needs them; a slave is then
    /// brought up anew.
    [[nodiscard]] virtual result<void, translate::errc> start(slave_group slaves, duration period) = 0;
    /// The cycles have this period from now on: another user of the bus has begun or ended.
    virtual void change_period([[maybe_unused]] duration period) {}
    /// Whether messages of this code, commands or queries, go by process data.
    [[nodiscard]] virtual bool takes(std::uint16_t command_code) const = 0;
    /// Whether the slave, which is then the only one, has JAUS objects: what this part does not take goes by mailbox,
    /// and so do Set and Clear Emergency, after `stop`. If not, all else is refused, and `stop` serves for emergencies.
    [[nodiscard]] virtual bool uses_mailbox() const = 0;

    /// Executes a command that it takes, at once or in the next steps; returns its number. Errors, with unchanged
    /// outputs: as the translation has them.
    [[nodiscard]] virtual result<std::uint32_t, translate::errc>
    command(const jaus::header& head, std::span<const std::byte> body, slave_group slaves, time_point now) = 0;
    /// Whether `command` merges the next command with the one before, which the slaves have not executed.
    [[nodiscard]] virtual bool merges_next([[maybe_unused]] slave_group slaves) const { return false; }
    /// Commands wait until the slaves can execute them, as until brakes are open: the time for their execution begins
    /// when this has ended. The part bounds it.
    [[nodiscard]] virtual bool is_preparing() const { return false; }
    /// Brings the slaves that are not lost to rest; returns the number of this order. `what` is rest or emergency.
    virtual std::uint32_t stop(stop_order what, slave_group slaves) = 0;
    /// The number of the last command or stop order that all slaves have executed; of a stop order, all that are not
    /// lost.
    [[nodiscard]] virtual std::uint32_t executed(slave_group slaves) const = 0;
    /// The last stop order has not been executed in time. Whether later inputs show that all slaves obey it and have
    /// become slower by a quarter or more since the order, or since this was asked last: they then get that time again.
    /// Others are taken out of OP, so that they stop by themselves.
    [[nodiscard]] virtual bool is_braking([[maybe_unused]] slave_group slaves) { return false; }
    /// Writes the message that answers a query which it takes, from current inputs, to `out`, and returns it.
    [[nodiscard]] virtual result<std::span<std::byte>, translate::errc> answer(const jaus::header& query,
                                                                               std::span<const std::byte> body,
                                                                               slave_group slaves,
                                                                               std::span<std::byte> out) const = 0;

    /// Once in each cycle. While it returns a fault, the component is in Failure and at rest.
    virtual std::optional<drive_fault> step(slave_group slaves, time_point now) = 0;
    /// Writes all faults that are there after the last step to `out`, and returns how many, for a part whose drives can
    /// have several. `step` returns one of them.
    [[nodiscard]] virtual std::size_t faults([[maybe_unused]] std::span<drive_fault> out) const { return 0; }
    /// The component has got Reset: faults are to be acknowledged.
    virtual void reset() = 0;
};

} // namespace jauscat::bridging
