// The messages of one transfer or question through a slave's mailbox, the aborts before and after them, and what the
// slave is asked after a request that was given up.
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
    /// A transfer that was given up before is aborted first. After a request that was given up the slave is asked for
    /// its identity: it answers in order, so that no late answer comes after this one. Counters do not tell which
    /// answer is late: many slaves number their messages themselves.
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
            exchange_.request(frame, *slave_, own_);
    }
    progress reply(replies datagrams, time_point now, const master_config& config) noexcept {
        const auto& datagram = datagrams.front();
        if (part_ == part::wait) return slave_->is_lent ? progress::wait : start_first();
        const auto next = part_ == part::protocol ? exchange_.reply(datagram, now, config, *slave_, protocol_)
                                                  : exchange_.reply(datagram, now, config, *slave_, own_);
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
            if (part_ == part::protocol && has_asked() && protocol_.is_open())
                slave_->unfinished = protocol_.abort_message();
        return part_ == part::abort ? result_.error() : why;
    }
    /// The slave has taken a message, or may have.
    [[nodiscard]] bool has_asked() const noexcept { return is_asked_ || exchange_.has_asked(); }

  private:
    static constexpr bool is_transfer = std::same_as<Protocol, sdo_transfer>;
    enum class part : std::uint8_t {
        wait,          // until the mailbox is not lent any more
        abort_earlier, // a transfer given up before stands in the way of this one
        question,      // whose answer comes after those of requests that were given up
        protocol,
        abort, // the transfer has failed, and the slave is told so
    };

    progress start_first() noexcept {
        return start(slave_->unfinished           ? part::abort_earlier
                     : slave_->awaits_late_answer ? part::question
                                                  : part::protocol);
    }
    // The next message of the protocol, or one of the session's own.
    progress start(part what) noexcept {
        part_ = what;
        exchange_ = mailbox_exchange{*slave_};
        if (what == part::question)
            own_ = identity_question(slave_->last_counter);
        else if (what != part::protocol)
            own_ = sdo_transfer::abort(*slave_->unfinished);
        return progress::send;
    }
    // Of one of the four entries, so that a late answer to a question that was given up is told apart, too.
    static sdo_transfer identity_question(std::uint8_t counter) noexcept {
        constexpr std::uint16_t identity_object = 0x1018;
        return sdo_transfer::upload(identity_object, static_cast<std::uint8_t>(1 + counter % 4), {});
    }

    progress message_complete() noexcept {
        const auto& message = exchange_.result();
        auto& unfinished = slave_->unfinished;
        if (part_ == part::protocol) {
            is_asked_ = true;
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
        if (part_ == part::question) {
            // Any answer will do.
            if (own_.is_open() && !slave_->awaits_late_answer) unfinished = own_.abort_message();
            if (!slave_->awaits_late_answer) return start_first();
            result_ = message;
            return progress::done;
        }
        if (message) unfinished.reset();
        if (part_ == part::abort) return progress::done;
        if (message) return start_first();
        result_ = message;
        return progress::done;
    }

    slave_record* slave_{};
    part part_{};
    bool is_asked_{}; // the first message of the protocol has its answer, or has failed
    mailbox_exchange exchange_{};
    Protocol protocol_{};
    sdo_transfer own_{}; // an abort or the question
    master_result<std::size_t> result_{std::size_t{0}};
};

} // namespace jauscat::ethercat
