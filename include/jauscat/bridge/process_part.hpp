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

namespace jauscat::bridging {

/// Process data of one slave; of a slave that is lost they are empty.
struct slave_data {
    std::span<std::byte> outputs{};      ///< sent in each cycle; zeros when the slave comes to OP
    std::span<const std::byte> inputs{}; ///< of the last cycle in which they were exchanged: see `status`
    ethercat::slave_status status{};     ///< after the last cycle
};
/// The slaves of a component, in the order in which it was given them.
using slave_group = std::span<const slave_data>;

/// A drive that cannot move. `code` is the device's: for a CiA 402 drive its error code, object 603Fh.
struct drive_fault {
    std::size_t slave{}; ///< index in the group
    std::uint16_t code{};
    friend constexpr bool operator==(const drive_fault&, const drive_fault&) = default;
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
    /// All slaves are in OP with current inputs; the cycles have this period, or a shorter one once another user of the
    /// bus needs it. What was before does not count: no command or stop order waits. Error: the data are not as this
    /// part needs them; a slave is then brought up anew.
    [[nodiscard]] virtual result<void, translate::errc> start(slave_group slaves, duration period) = 0;
    /// Whether messages of this code, commands or queries, go by process data.
    [[nodiscard]] virtual bool takes(std::uint16_t command_code) const = 0;
    /// Whether the slave, which is then the only one, has JAUS objects: what this part does not take goes by mailbox,
    /// and so do Set and Clear Emergency, after `stop`. If not, all else is refused, and `stop` serves for emergencies.
    [[nodiscard]] virtual bool uses_mailbox() const = 0;

    /// Executes a command that it takes, at once or in the next steps; returns its number. Errors, with unchanged
    /// outputs: as the translation has them.
    [[nodiscard]] virtual result<std::uint32_t, translate::errc>
    command(const jaus::header& head, std::span<const std::byte> body, slave_group slaves, time_point now) = 0;
    /// Brings the slaves that are not lost to rest; returns the number of this order. `what` is rest or emergency.
    virtual std::uint32_t stop(stop_order what, slave_group slaves) = 0;
    /// The number of the last command or stop order that all slaves have executed.
    [[nodiscard]] virtual std::uint32_t executed(slave_group slaves) const = 0;
    /// Writes the message that answers a query which it takes, from current inputs, to `out`, and returns it.
    [[nodiscard]] virtual result<std::span<std::byte>, translate::errc> answer(const jaus::header& query,
                                                                               std::span<const std::byte> body,
                                                                               slave_group slaves,
                                                                               std::span<std::byte> out) const = 0;

    /// Once in each cycle. While it returns a fault, the component is in Failure and at rest.
    virtual std::optional<drive_fault> step(slave_group slaves, time_point now) = 0;
    /// The component has got Reset: faults are to be acknowledged.
    virtual void reset() = 0;
};

} // namespace jauscat::bridging
