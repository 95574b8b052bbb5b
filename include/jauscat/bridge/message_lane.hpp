// Carries one message to a slave's mailbox and its answer back, beside the lanes of other slaves.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/bridge/any_exchange.hpp>
#include <jauscat/bridge/order_queue.hpp>
#include <jauscat/bridge/pending_stops.hpp>
#include <jauscat/bridge/slave_front.hpp>
#include <jauscat/ethercat/hilscher/packet_job.hpp>
#include <jauscat/ethercat/master/master.hpp>
#include <jauscat/schema/jaus/communications.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace jauscat::bridging {

/// A master with one frame under way and buffers for one message; about 16 KiB. The ring's own: the slave that it
/// serves, or has served last, has this lane until another slave takes it.
class message_lane {
  public:
    enum class purpose : std::uint8_t { order, stop, keep_alive, emergencies };
    /// What it carries.
    struct task {
        slave_front* front{};
        purpose what{};
        component* unit{};
        stop_order stop{}; ///< of a stop
        order message{};   ///< of an order: its header
    };
    /// How that has ended.
    struct outcome {
        bool is_done{};
        bool was_withdrawn{};                ///< the slave has got nothing of it
        std::span<const std::byte> report{}; ///< of a query
        ethercat::master_error error{};
    };

    message_lane() noexcept = default;
    message_lane(const message_lane&) = delete;
    message_lane& operator=(const message_lane&) = delete;

    [[nodiscard]] ethercat::master& master() noexcept { return master_; }
    [[nodiscard]] const ethercat::master& master() const noexcept { return master_; }
    [[nodiscard]] const slave_front* front() const noexcept { return task_.front; }
    [[nodiscard]] const task& current() const noexcept { return task_; }
    [[nodiscard]] bool is_busy() const noexcept { return is_busy_; }
    /// What it carries has come to its end: see `take_outcome`.
    [[nodiscard]] bool has_ended() const noexcept { return is_busy_ && outcome_.has_value(); }
    /// Buffer for the message to carry.
    [[nodiscard]] std::span<std::byte> message() noexcept { return message_; }

    /// Carries the `size` bytes in `message()`. `owner` knows the slave. It is not busy.
    JAUSCAT_FUNCTION void begin(const task& what, std::size_t size, ethercat::master& owner,
                                const ethercat::packet_options& options);
    /// After frames and time. Returns whether it has ended.
    JAUSCAT_FUNCTION bool advance();
    /// Gives it up: its error is then `timeout`.
    void cancel() noexcept { master_.cancel(ethercat::master_errc::timeout); }
    /// Returns the mailbox to `owner`. The report is valid until the next `begin`.
    JAUSCAT_FUNCTION outcome take_outcome(ethercat::master& owner);
    /// The slave is removed, whatever is carried.
    JAUSCAT_FUNCTION void drop(ethercat::master& owner);

  private:
    [[nodiscard]] any_exchange& exchange() const noexcept { return task_.front->exchange(); }

    // A request packet is executed by the master; any other step ends the exchange.
    JAUSCAT_FUNCTION void take_step(const exchange_step& step);
    JAUSCAT_FUNCTION void confirm();
    // An order that is not to be sent any more, unless the slave has taken it or may have.
    JAUSCAT_FUNCTION void withdraw();
    JAUSCAT_FUNCTION void end(const exchange_step& step, const ethercat::master_error& error);
    JAUSCAT_FUNCTION void tell(std::span<const std::byte> packet) const;

    static constexpr std::size_t message_size = jaus::header_size + jaus::max_body_size;

    ethercat::slave_memory<1> slave_{};
    ethercat::master master_{slave_};
    task task_{};
    bool is_busy_{};
    ethercat::packet_options options_{};
    std::optional<ethercat::packet_job> job_{};
    std::optional<outcome> outcome_{};
    std::array<std::byte, message_size> message_{};
    std::array<std::byte, std::max(any_exchange::buffer_size, message_size)> packet_{};
    std::array<std::byte, ethercat::packet_job::confirmation_size> confirmation_{};
};

} // namespace jauscat::bridging

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/bridge/impl/message_lane.ipp>
#endif
