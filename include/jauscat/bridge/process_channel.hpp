// The process data of a component's slaves, and the commands in their outputs that are not executed yet.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/bridge/process_part.hpp>
#include <jauscat/bridge/slave_front.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace jauscat::bridging {

/// Slaves that one component can have.
inline constexpr std::size_t group_capacity = 32;

/// Between the ring and the process_part of a component.
class process_channel {
  public:
    using bytes = std::span<const std::byte>;
    /// Commands that wait for their execution.
    static constexpr std::size_t capacity = 16;

    enum class outcome : std::uint8_t {
        executed,
        superseded, ///< a later command was executed: whether this one was is not known
        late,       ///< it was not executed in time
    };
    /// A command that does not wait any more.
    struct ended {
        jaus::header header{};
        outcome how{};
        std::optional<stop_order> stop{};
    };

    /// The part and the fronts, 1 to group_capacity, must outlive this.
    JAUSCAT_FUNCTION process_channel(process_part& part, std::span<slave_front* const> slaves) noexcept;

    [[nodiscard]] process_part& part() const noexcept { return part_; }
    [[nodiscard]] std::span<slave_front* const> fronts() const noexcept { return std::span{fronts_}.first(count_); }
    /// Whether all of its slaves are in OP, and the part has begun.
    [[nodiscard]] bool is_started() const noexcept { return is_started_; }
    /// Whether the part has ever begun: it needs its steps.
    [[nodiscard]] bool has_begun() const noexcept { return has_begun_; }
    /// Whether messages of this kind go by process data.
    [[nodiscard]] JAUSCAT_FUNCTION bool takes(const jaus::header& head) const;
    /// Whether a slave is left to bring to rest.
    [[nodiscard]] JAUSCAT_FUNCTION bool has_slaves() noexcept;
    /// The ages of all inputs are at most `limit`.
    [[nodiscard]] JAUSCAT_FUNCTION bool has_inputs_within(duration limit, time_point now) const noexcept;

    [[nodiscard]] JAUSCAT_FUNCTION result<void, translate::errc> start(const process_times& times);
    /// A slave was lost: until the next start the part works without it, also where it is back before others are.
    JAUSCAT_FUNCTION void leave_out(const slave_front& lost) noexcept;
    /// The first of its slaves was lost. No command waits any more; `refused(const jaus::header&)` gets those that did.
    void end(auto&& refused) {
        is_started_ = false;
        drop(refused);
    }
    /// No stop order waits any more either.
    void drop(auto&& refused) {
        has_rest_outputs_ = false;
        const auto all = waiting_;
        for (const waiting& each : std::span{all}.first(std::exchange(waiting_count_, 0)))
            if (!each.stop) refused(each.header);
    }
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<drive_fault> step(time_point now);
    /// All of them; see process_part::faults.
    [[nodiscard]] std::size_t faults(std::span<drive_fault> out) const {
        return misfit_.empty() ? std::min(part_.faults(out), out.size()) : 0;
    }
    void reset() { part_.reset(); }

    /// Whether a command of another sender waits for its execution.
    [[nodiscard]] JAUSCAT_FUNCTION bool has_command_of_others(const jaus::address& sender) const noexcept;
    /// Where as many wait as there is place for, the first of them: the next command supersedes it.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<jaus::header> make_room() noexcept;
    /// Where the part prepares the last command, the first that has waited for its time: the last one supersedes it.
    /// Commands that follow each other faster than the part prepares would keep it waiting.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<jaus::header> drop_overdue(time_point now);
    /// There is room, and no stop order waits.
    [[nodiscard]] JAUSCAT_FUNCTION result<std::uint32_t, translate::errc> command(const jaus::header& head, bytes body,
                                                                                  duration limit, time_point now);
    /// See process_part::merges_next.
    [[nodiscard]] bool merges_next() { return part_.merges_next(slaves()); }
    /// The outputs are at rest, and no command follows: to be repeated where the slaves are to confirm it.
    [[nodiscard]] bool has_rest_outputs() const noexcept { return has_rest_outputs_; }
    /// A stop order that waits for its execution.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<stop_order> waiting_stop() const noexcept;
    /// Replaces all that waits; `refused(const jaus::header&)` gets the commands. Without a limit no execution is
    /// waited for. Returns its number.
    std::uint32_t stop(stop_order what, std::optional<duration> limit, time_point now, auto&& refused) {
        drop(refused);
        const auto number = part_.stop(what, slaves());
        has_rest_outputs_ = true;
        if (limit) waiting_[waiting_count_++] = {{}, number, *limit, deadline{now, *limit}, {}, what};
        return number;
    }
    /// The next command that has come to an end. A later command in the same outputs may have arrived before the slave
    /// read them: only the last one is known to be executed.
    [[nodiscard]] JAUSCAT_FUNCTION std::optional<ended> next_ended(time_point now);
    [[nodiscard]] JAUSCAT_FUNCTION result<std::span<std::byte>, translate::errc>
    answer(const jaus::header& query, bytes body, std::span<std::byte> out);

  private:
    struct waiting {
        jaus::header header{};
        std::uint32_t number{};
        duration limit{};
        deadline until{};       // while the part prepares, from now on
        deadline asked_until{}; // from when it was taken on
        std::optional<stop_order> stop{};
    };

    // Numbers go round.
    [[nodiscard]] static constexpr bool has_reached(std::uint32_t wanted, std::uint32_t last) noexcept {
        return last - wanted <= UINT32_MAX / 2;
    }
    [[nodiscard]] JAUSCAT_FUNCTION slave_group slaves() noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION jaus::header drop_first() noexcept;

    process_part& part_;
    std::array<slave_front*, group_capacity> fronts_{};
    std::array<slave_data, group_capacity> data_{};
    std::array<bool, group_capacity> is_absent_{}; // it was lost since the last start
    std::size_t count_{};
    std::array<waiting, capacity> waiting_{};
    std::size_t waiting_count_{};
    bool is_started_{}, has_begun_{};
    std::string_view misfit_{}; // why the part cannot keep the times
    bool has_rest_outputs_{};   // no command after a stop order is in them
};

} // namespace jauscat::bridging

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/bridge/impl/process_channel.ipp>
#endif
