// Takes one slave from any state to PRE-OP: station address, identity and mailbox from the SII, SyncManagers 0 and 1,
// state. Reads only the SII words it needs: 24 frames where a read gives 4 bytes, 18 where it gives 8.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/sii_read.hpp>
#include <jauscat/ethercat/master/slave_record.hpp>
#include <jauscat/ethercat/master/state_change.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace jauscat::ethercat {

/// State machine: `request` adds the datagrams of the present step, `reply` takes their return and moves on. Stays in
/// place while it runs.
class slave_bring_up {
  public:
    /// At most, of a request: bytes and datagrams.
    static constexpr std::size_t request_size() noexcept {
        return 2 * (datagram_overhead + wire::max_size<mailbox_managers>);
    }
    static constexpr std::size_t request_datagrams() noexcept { return 3; }

    slave_bring_up() noexcept = default;
    /// Of the slave at `position`, from 0, which gets the station address `station` if it is `expected`. Other slaves
    /// lose that address if it `may_be_taken`.
    slave_bring_up(std::uint16_t position, std::uint16_t station, const identity_check& expected,
                   bool may_be_taken) noexcept
        : may_be_taken_{may_be_taken}, expected_{expected}, change_{state_change::to_init(station)} {
        slave_.position = position;
        slave_.station = station;
    }

    /// The record of the slave; complete when the bring-up is done without error.
    [[nodiscard]] const slave_record& slave() const noexcept { return slave_; }
    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }

    void request(frame_builder& frame) noexcept {
        const auto station = slave_.station;
        switch (step_) {
        case step::count: frame.add(command::brd, 0, esc_registers::type.address, std::size_t{1}); break;
        case step::assign: assign(frame); break;
        case step::clear: // an alias that equals the address, too; then this slave alone gets it
            frame.add(command::fpwr, station, esc_registers::dl_control.address + alias_byte, std::size_t{1});
            frame.write(station, esc_registers::station_address, {});
            assign(frame);
            break;
        case step::verify: frame.read(station, esc_registers::station_address); break;
        case step::take_sii: ethercat::take_sii(frame, station); break;
        case step::read_identity:
        case step::read_mailbox: sii_.request(frame, station); break;
        case step::configure: // a SyncManager can be changed only while it is off
            frame.write(station, esc_registers::mailbox_managers, {});
            frame.write(station, esc_registers::mailbox_managers, managers());
            break;
        case step::give_sii: ethercat::give_sii(frame, station); break;
        case step::to_init:
        case step::to_pre_op: change_.request(frame); break;
        }
    }

    progress reply(replies datagrams, time_point now, const master_config& config) noexcept {
        if (failure_ != master_error{}) return fail(failure_); // the SII is given back
        const auto counter = datagrams.front().working_counter;
        switch (step_) {
        case step::count:
            return counter > slave_.position ? go(step::assign)
                                             : fail({.code = master_errc::no_slave, .slaves = counter});
        case step::assign:
            return counter == 1 ? go(step::verify) : fail({.code = master_errc::no_slave, .slaves = counter});
        case step::to_init:
        case step::to_pre_op: return finish(change_, change_.reply(datagrams, now, config));
        case step::verify:
            if (counter == 0) return fail({.code = master_errc::wrong_station, .station = slave_.station});
            // An earlier master has left the address at another slave. Where it stays there, it is reported.
            if (counter > 1 && std::exchange(may_be_taken_, false)) return go(step::clear);
            break;
        case step::clear:
            if (datagrams.back().working_counter != 1) return fail({.code = master_errc::no_slave});
            return go(step::verify);
        default: break;
        }
        if (result_ = executed_by_one(datagrams); !result_) return progress::done;
        switch (step_) {
        case step::verify: return verified(datagrams.front());
        case step::take_sii: return read(step::read_identity, sii_words::identity, identity_);
        case step::read_identity:
        case step::read_mailbox: return finish(sii_, sii_.reply(datagrams.front(), now, config));
        case step::configure: return go(step::give_sii);
        default: break; // give_sii
        }
        change_ = state_change::step_up(slave_.station, al_state::init);
        return go(step::to_pre_op);
    }

  private:
    enum class step : std::uint8_t {
        count,
        assign,
        clear, // several slaves have the address
        verify,
        to_init,
        take_sii,
        read_identity,
        read_mailbox,
        configure,
        give_sii,
        to_pre_op,
    };

    static constexpr std::uint16_t alias_byte = 3; // of DL control: whether the alias counts as an address

    void assign(frame_builder& frame) const noexcept {
        const auto position = static_cast<std::uint16_t>(-slave_.position);
        frame.add(command::apwr, position, esc_registers::station_address.address, esc_word{slave_.station});
    }
    progress go(step next) noexcept {
        step_ = next;
        return progress::send;
    }
    progress read(step next, std::uint32_t word, std::span<std::byte> into) noexcept {
        sii_ = sii_read{word, into};
        return go(next);
    }
    progress fail(const master_error& error) noexcept {
        result_ = error;
        return progress::done;
    }

    // Fails once the slave's application has the SII again.
    progress give_back(const master_error& why) noexcept {
        failure_ = why;
        return go(step::give_sii);
    }
    [[nodiscard]] bool has_sii() const noexcept { return step_ == step::read_identity || step_ == step::read_mailbox; }

    // Handles the progress of a part.
    progress finish(const auto& part, progress after) noexcept {
        if (after != progress::done) return after;
        if (!part.result()) return has_sii() ? give_back(part.result().error()) : fail(part.result().error());
        switch (step_) {
        case step::to_init: return go(step::take_sii);
        case step::read_identity: return identified();
        case step::read_mailbox: return mailbox_read();
        default: return progress::done; // to_pre_op
        }
    }

    // Another slave's alias may equal our address: it then answers in our slave's place.
    progress verified(const datagram_view& datagram) noexcept {
        const auto address = datagram.value(esc_registers::station_address);
        return address.value == slave_.station ? go(step::to_init)
                                               : fail({.code = master_errc::wrong_station, .station = slave_.station});
    }

    progress identified() noexcept {
        static_cast<void>(wire::decode(slave_.identity, identity_));
        if (!expected_.accepts(slave_.identity))
            return give_back({.code = master_errc::wrong_identity, .product = slave_.identity.product});
        return read(step::read_mailbox, sii_words::mailbox, mailbox_);
    }

    progress mailbox_read() noexcept {
        auto& mailbox = slave_.mailbox;
        static_cast<void>(wire::decode(mailbox, mailbox_));
        if (mailbox.receive_size == 0 && mailbox.send_size == 0) return go(step::give_sii); // a slave without one
        const auto usable = [](std::uint16_t size) { return size >= min_mailbox_size && size <= max_mailbox_size; };
        if (!usable(mailbox.receive_size) || !usable(mailbox.send_size))
            return give_back({.code = master_errc::no_mailbox});
        return go(step::configure);
    }

    [[nodiscard]] mailbox_managers managers() const noexcept {
        return {.out = {.start = slave_.mailbox.receive_offset,
                        .length = slave_.mailbox.receive_size,
                        .mode = sync_manager_mode::mailbox,
                        .direction = sync_manager_direction::master_writes,
                        .pdi_interrupt = true,
                        .enable = true},
                .in = {.start = slave_.mailbox.send_offset,
                       .length = slave_.mailbox.send_size,
                       .mode = sync_manager_mode::mailbox,
                       .direction = sync_manager_direction::master_reads,
                       .pdi_interrupt = true,
                       .enable = true}};
    }

    step step_{};
    bool may_be_taken_{};
    identity_check expected_{};
    sii_read sii_{};
    state_change change_{};
    std::array<std::byte, wire::max_size<sii_identity>> identity_{};
    std::array<std::byte, wire::max_size<sii_mailbox>> mailbox_{};
    slave_record slave_{};
    master_error failure_{}; // after which the SII is to be given back
    master_result<> result_{};
};

} // namespace jauscat::ethercat
