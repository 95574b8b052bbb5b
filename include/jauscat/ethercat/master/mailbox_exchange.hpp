// Writes one request to a slave's mailbox and reads the reply, if any: counter, mailbox full, polling, lost frames.
// Reading the reply mailbox is the poll: a working counter of 0 means that it is empty. With a fast slave an exchange
// takes two frames.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/reply_kind.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// A protocol whose messages go through a mailbox: sdo_transfer, sdo_information.
template <class T>
concept mailbox_protocol = requires(T& protocol, std::span<std::byte> out, std::span<const std::byte> message) {
    protocol.size();
    protocol.encode(out);
    { protocol.expects_answer() } -> std::same_as<bool>;
    { protocol.take(message) } -> std::same_as<reply_kind>;
    protocol.unexpected();
    protocol.result();
};

/// State machine: `request` adds the datagram of the present step, `reply` takes its return, `lost` its absence.
class mailbox_exchange {
  public:
    mailbox_exchange() noexcept = default;
    /// Starts a message with the slave's next counter.
    JAUSCAT_FUNCTION explicit mailbox_exchange(slave_record& slave) noexcept;

    /// Sends nothing: takes what waits in the slave's mailbox, and keeps its emergencies.
    JAUSCAT_FUNCTION static mailbox_exchange collect() noexcept;

    /// Bytes that the protocol has received.
    [[nodiscard]] const master_result<std::size_t>& result() const noexcept { return result_; }
    /// The request of the present step changes nothing if the slave gets it twice.
    [[nodiscard]] JAUSCAT_FUNCTION bool is_repeatable() const noexcept;

    /// The slave has not executed the last frame: the mailbox was full, or empty. Where a network copies frames, it may
    /// have executed another copy before, which comes back later.
    [[nodiscard]] bool was_refused() const noexcept { return was_refused_; }

    void request(frame_builder& frame, const slave_record& slave, const mailbox_protocol auto& protocol) noexcept {
        asked_ = step_;
        was_refused_ = false;
        is_writing_ = step_ == step::write;
        switch (step_) {
        case step::drain:
        case step::collect:
        case step::read:
            frame.add(command::fprd, slave.station, slave.mailbox.send_offset, std::size_t{slave.mailbox.send_size});
            break;
        case step::write: {
            const auto out =
                frame.add(command::fpwr, slave.station, slave.mailbox.receive_offset, slave.mailbox.receive_size);
            if (out.empty()) return;
            const mailbox_header header{.length = static_cast<std::uint16_t>(protocol.size()),
                                        .type = mailbox_type::coe,
                                        .counter = slave.last_counter};
            protocol.encode(out.subspan(wire::encode(header, out)->size()));
            break;
        }
        case step::look_taken:
        case step::look_room: frame.read(slave.station, sync_manager_handshake_of(0)); break;
        case step::look:
        case step::wait_repeat: frame.read(slave.station, sync_manager_handshake_of(1)); break;
        case step::ask_repeat:
            frame.write(slave.station, sync_manager_activate_of(1), {.enable = true, .repeat_request = repeat_});
            break;
        }
    }

    progress reply(const datagram_view& datagram, time_point now, const master_config& config, slave_record& slave,
                   mailbox_protocol auto& protocol) noexcept {
        if (was_refused_) step_ = asked_; // another copy
        is_writing_ = false;
        const auto next = advance(datagram, slave, protocol);
        if (was_refused_ && asked_ == step::write && config.frames_may_be_copied) unsure_ = true; // a copy may be taken
        const auto own = std::chrono::nanoseconds{slave.timeouts.mailbox};
        const auto limit = own.count() != 0 ? own : config.mailbox_timeout;
        if (next == progress::done || !timeout_.expired(now, limit)) return next;
        if (!accepted_) return fail({.code = master_errc::mailbox_full}, slave);
        if (const auto specifier = protocol.unexpected())
            return fail({.code = master_errc::unexpected_reply, .specifier = *specifier}, slave);
        return fail({.code = master_errc::mailbox_timeout}, slave);
    }

    /// The reply to the last request did not come. What was asked is asked again, except a read: the slave may have
    /// given its message away and has to be asked for it again.
    JAUSCAT_FUNCTION void lost(slave_record& slave) noexcept;

    /// The request is given up; its answer may still come and is not to be taken for another's.
    JAUSCAT_FUNCTION void abandon(slave_record& slave) const noexcept;

    /// The slave has taken the request, or may have: a write is under way, or its reply was lost.
    [[nodiscard]] bool has_asked() const noexcept { return accepted_ || unsure_ || is_writing_; }

  private:
    enum class step : std::uint8_t {
        look_taken,  // a request was given up: has the slave taken it? Its answer has to come before the next request
        drain,       // empties the reply mailbox before the first request
        collect,     // empties it, and that is all
        write,       // posts the request
        look_room,   // it was refused: is the mailbox full?
        read,        // fetches the reply, or what keeps a slave from taking the request
        look,        // a read was lost: how does the repeat request stand?
        ask_repeat,  // toggles it
        wait_repeat, // until the slave has toggled its acknowledgement
    };

    progress advance(const datagram_view& datagram, slave_record& slave, mailbox_protocol auto& protocol) noexcept {
        const bool executed = datagram.working_counter != 0;
        was_refused_ = !executed && (step_ == step::read || step_ == step::write || step_ == step::drain);
        switch (step_) {
        case step::drain:
        case step::collect:
            if (executed) {
                const auto before = slave.last_reply_mark;
                const auto reply = open(datagram.data, slave);
                if (!repeated_ || slave.last_reply_mark != before) note_emergency(reply, slave);
                return progress::send;
            }
            if (!may_write_) {
                step_ = step::look_taken;
                return progress::wait;
            }
            slave.drained = true;
            return step_ == step::collect ? progress::done : go(step::write);
        case step::write:
            accepted_ = executed;
            if (executed && !protocol.expects_answer()) return progress::done;
            return go(executed ? step::read : step::look_room);
        case step::read:
            if (executed) return take(datagram.data, slave, protocol);
            if (!accepted_) step_ = step::write;
            return progress::wait;
        case step::ask_repeat:
            return executed ? go(step::wait_repeat) : fail({.code = master_errc::working_counter}, slave);
        case step::look_taken:
        case step::look_room:
        case step::look:
        case step::wait_repeat: break;
        }
        if (!executed) return fail({.code = master_errc::working_counter}, slave);
        const auto mailbox = datagram.value(sync_manager_handshake_of(0)); // of 0 or 1
        // A slave may hold a request back because its reply mailbox is full.
        if (step_ == step::look_taken) {
            may_write_ = !mailbox.full;
            return go(step::drain);
        }
        if (step_ == step::look_room) return go(mailbox.full ? step::read : step::write);
        if (step_ == step::wait_repeat) return mailbox.repeat_acknowledge == repeat_ ? go(resume_) : progress::wait;
        // Even if there is a message: it may be the next one already. An older one that comes again is passed over.
        repeat_ = !mailbox.repeat_request;
        repeated_ = true;
        return go(step::ask_repeat);
    }

    static constexpr std::uint8_t after(std::uint8_t counter) noexcept {
        return static_cast<std::uint8_t>(counter % 7 + 1);
    }
    JAUSCAT_FUNCTION progress go(step next) noexcept;

    JAUSCAT_FUNCTION progress fail(const master_error& error, slave_record& slave) noexcept;

    struct envelope {
        mailbox_header header{};
        std::span<const std::byte> message{}; // empty where its length is not true
    };

    // A message from the reply mailbox.
    JAUSCAT_FUNCTION static envelope open(std::span<const std::byte> data, slave_record& slave) noexcept;

    // Counter, length and the bytes in which messages differ that follow each other: fragments have the same counter.
    JAUSCAT_FUNCTION static std::uint32_t mark_of(const envelope& reply) noexcept;

    JAUSCAT_FUNCTION static void note_emergency(const envelope& reply, slave_record& slave) noexcept;

    // A message in the reply mailbox: the answer, or something to pass over.
    progress take(std::span<const std::byte> data, slave_record& slave, mailbox_protocol auto& protocol) noexcept {
        const auto before = slave.last_reply_mark;
        const auto reply = open(data, slave);
        const auto& header = reply.header;
        if (header.counter != 0 && repeated_ && slave.last_reply_mark == before) return progress::send;
        note_emergency(reply, slave);
        if (!accepted_ && !unsure_) return progress::send; // nothing was asked yet

        if (header.type == mailbox_type::error) {
            mailbox_error_reply error{};
            if (!wire::decode_prefix(error, reply.message)) return progress::send;
            return fail({.code = master_errc::mailbox_error, .mailbox = error.code}, slave);
        }
        const auto meaning = header.type == mailbox_type::coe ? protocol.take(reply.message) : reply_kind::unrelated;
        if (meaning == reply_kind::unrelated) return progress::send;
        slave.awaits_late_answer = false; // a slave answers in order: what was given up cannot come any more
        timeout_.renew();
        if (meaning == reply_kind::fragment) return progress::send;
        result_ = protocol.result(); // ok where another request follows
        return progress::done;
    }

    step step_{};
    step resume_{};                 // the read that was lost
    std::uint8_t counter_before_{}; // of the slave's last request
    bool asks_{true};
    bool may_write_{true}; // no request that was given up waits in the slave's mailbox
    bool accepted_{};      // the slave has taken the request
    bool is_writing_{};    // the request is under way
    bool unsure_{};        // the slave may have taken it: the reply to a write was lost
    bool repeat_{};        // the repeat request bit that was sent
    step asked_{};         // the step of the last frame
    bool was_refused_{};   // it came back without being executed
    bool repeated_{};      // a repeat was asked for: the message before may come again
    timeout timeout_{};
    master_result<std::size_t> result_{std::size_t{0}};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/mailbox_exchange.ipp>
#endif
