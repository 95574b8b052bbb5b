// The messages of one transfer or question through a slave's mailbox, and the aborts before and after them.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/mailbox_exchange.hpp>
#include <jauscat/ethercat/master/sdo_transfer.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace jauscat::ethercat {

/// State machine: `request` adds the datagram of the present step, `reply` takes its return, `lost` its absence. The
/// slave's record stays in place while it runs.
template <mailbox_protocol Protocol> class mailbox_session {
  public:
    /// A transfer that was given up before is aborted first.
    void begin(slave_record& slave, const Protocol& protocol) noexcept {
        slave_ = &slave;
        protocol_ = protocol;
        if constexpr (is_transfer) protocol_.use_mailbox(slave.mailbox.receive_size);
        if (!slave.is_lent) start_first();
    }

    /// Bytes that the protocol has received.
    [[nodiscard]] const master_result<std::size_t>& result() const noexcept { return result_; }

    /// At most, of a request: bytes and datagrams.
    [[nodiscard]] std::size_t request_size() const noexcept {
        return datagram_overhead + std::max(slave_->mailbox.receive_size, slave_->mailbox.send_size);
    }
    [[nodiscard]] static constexpr std::size_t request_datagrams() noexcept { return 1; }

    void request(frame_builder& frame) noexcept {
        if (part_ == part::wait)
            frame.read(slave_->station, sync_manager_handshake_of(0)); // changes nothing
        else if (part_ == part::protocol)
            exchange_.request(frame, *slave_, protocol_);
        else
            exchange_.request(frame, *slave_, abort_);
    }
    progress reply(replies datagrams, time_point now, const master_config& config) noexcept {
        const auto& datagram = datagrams.front();
        if (part_ == part::wait) return slave_->is_lent ? progress::wait : start_first();
        const auto next = part_ == part::protocol ? exchange_.reply(datagram, now, config, *slave_, protocol_)
                                                  : exchange_.reply(datagram, now, config, *slave_, abort_);
        return next == progress::done ? message_complete() : next;
    }
    [[nodiscard]] bool was_refused() const noexcept { return exchange_.was_refused(); }
    [[nodiscard]] bool is_repeatable() const noexcept { return part_ == part::wait || exchange_.is_repeatable(); }
    void lost() noexcept {
        if (part_ != part::wait) exchange_.lost(*slave_);
    }
    /// Gives up. A transfer that the slave has open is aborted before the next one. Returns how the session has ended.
    master_error cancel(const master_error& why) noexcept {
        if (part_ == part::wait) return why;
        exchange_.abandon(*slave_);
        if constexpr (is_transfer)
            if (part_ == part::protocol && protocol_.is_open()) slave_->unfinished = protocol_.abort_message();
        return part_ == part::abort ? result_.error() : why;
    }

  private:
    static constexpr bool is_transfer = std::same_as<Protocol, sdo_transfer>;
    enum class part : std::uint8_t {
        wait,          // until the mailbox is not lent any more
        abort_earlier, // a transfer given up before stands in the way of this one
        protocol,
        abort, // the transfer has failed, and the slave is told so
    };

    progress start_first() noexcept { return start(slave_->unfinished ? part::abort_earlier : part::protocol); }
    // The next message of the protocol, or an abort.
    progress start(part what) noexcept {
        part_ = what;
        if (what != part::protocol) abort_ = sdo_transfer::abort(*slave_->unfinished);
        exchange_ = mailbox_exchange{*slave_};
        return progress::send;
    }

    progress message_complete() noexcept {
        const auto& message = exchange_.result();
        auto& unfinished = slave_->unfinished;
        if (part_ == part::protocol) {
            if constexpr (is_transfer)
                if (message && !protocol_.finished()) return start(part::protocol);
            result_ = message;
            if constexpr (is_transfer) {
                if (!protocol_.is_open()) return progress::done;
                unfinished = protocol_.abort_message();
                // To a slave that is not reachable, or whose mailbox is full, the abort is sent before the next
                // transfer.
                const auto why = message.error().code;
                const bool is_reachable = why != master_errc::working_counter && why != master_errc::mailbox_full;
                if (is_reachable) return start(part::abort);
            }
            return progress::done;
        }
        if (message) unfinished.reset();
        if (part_ == part::abort) return progress::done;
        if (message) return start(part::protocol);
        result_ = message;
        return progress::done;
    }

    slave_record* slave_{};
    part part_{};
    mailbox_exchange exchange_{};
    Protocol protocol_{};
    sdo_transfer abort_{};
    master_result<std::size_t> result_{std::size_t{0}};
};

} // namespace jauscat::ethercat
