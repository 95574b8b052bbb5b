// Takes one slave from any state to PRE-OP: station address, what the SII says of identity and mailbox, SyncManagers 0
// and 1, state. Reads only the SII words it needs: 24 frames where a read gives 4 bytes, 18 where it gives 8.
#pragma once

#include <jauscat/ethercat/activity.hpp>
#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace jauscat::ethercat {

/// State machine: `request` adds the datagrams of the present step, `reply` takes their return and moves on.
class bring_up {
  public:
    bring_up() noexcept = default;
    bring_up(std::uint16_t position, std::uint16_t station) noexcept {
        slave_.position = position;
        slave_.station = station;
    }

    [[nodiscard]] const slave_record& slave() const noexcept { return slave_; }
    [[nodiscard]] const outcome& result() const noexcept { return result_; }

    void request(frame_builder& frame) const noexcept {
        const auto station = slave_.station;
        const auto read = [&](esc_register r, std::size_t size) { frame.add(command::fprd, station, r.address, size); };
        const auto write = [&](esc_register r, const auto& value) {
            frame.add(command::fpwr, station, r.address, value);
        };
        switch (step_) {
        case step::count: frame.add(command::brd, 0, esc_registers::type.address, std::size_t{1}); break;
        case step::assign: {
            const auto position = static_cast<std::uint16_t>(-slave_.position);
            frame.add(command::apwr, position, esc_registers::station_address.address, esc_word{station});
            break;
        }
        case step::verify: read(esc_registers::station_address, 2); break;
        case step::request_init:
            write(esc_registers::al_control, al_control{.state = al_state::init, .acknowledge = true});
            break;
        case step::take_sii: // by force, then without
            write(esc_registers::sii_owner, sii_owner{.force = true});
            write(esc_registers::sii_owner, sii_owner{});
            break;
        case step::start_sii_read:
            write(esc_registers::sii_control, sii_request{.cmd = sii_command::read, .address = sii_word_});
            break;
        case step::finish_sii_read: read(esc_registers::sii_control, wire::max_size<sii_access>); break;
        case step::configure: // a SyncManager can be changed only while it is off
            write(esc_registers::sync_manager, mailbox_managers{});
            write(esc_registers::sync_manager, managers());
            break;
        case step::give_sii: write(esc_registers::sii_owner, sii_owner{.pdi = true}); break;
        case step::request_pre_op: write(esc_registers::al_control, al_control{.state = al_state::pre_op}); break;
        case step::wait_init:
        case step::wait_pre_op: read(esc_registers::al_status, wire::max_size<al_status>); break;
        }
    }

    progress reply(replies datagrams, time_point now, const master_config& config) noexcept {
        const unsigned counter = datagrams.front().working_counter;
        if (step_ == step::count) return counter > slave_.position ? next() : fail(master_errc::no_slave, counter);
        if (step_ == step::assign) return counter == 1 ? next() : fail(master_errc::no_slave, counter);
        if (step_ == step::verify && counter == 0) return fail(master_errc::wrong_station, slave_.station);
        for (const auto& datagram : datagrams) {
            if (datagram.working_counter > 1) return fail(master_errc::duplicate_station, datagram.working_counter);
            if (datagram.working_counter == 0) return fail(master_errc::working_counter, 0);
        }
        const auto data = datagrams.front().data;
        switch (step_) {
        case step::verify: return verified(data);
        case step::finish_sii_read: return sii_read(data, now, config);
        case step::wait_init:
        case step::wait_pre_op: return state_read(data, now, config);
        default: return next();
        }
    }

  private:
    enum class step : std::uint8_t {
        count,
        assign,
        verify,
        request_init,
        wait_init,
        take_sii,
        start_sii_read,
        finish_sii_read,
        configure,
        give_sii,
        request_pre_op,
        wait_pre_op,
    };

    progress next() noexcept {
        if (step_ == step::wait_pre_op) return progress::done;
        step_ = static_cast<step>(static_cast<std::uint8_t>(step_) + 1);
        patience_.renew();
        return progress::send;
    }

    progress fail(master_errc error, std::uint32_t detail = 0) noexcept {
        result_ = {.error = error, .detail = detail};
        return progress::done;
    }

    // Another slave's alias may equal our address: it then answers in our slave's place.
    progress verified(std::span<const std::byte> data) noexcept {
        esc_word address{};
        static_cast<void>(wire::decode(address, data));
        return address.value == slave_.station ? next() : fail(master_errc::wrong_station, slave_.station);
    }

    progress state_read(std::span<const std::byte> data, time_point now, const master_config& config) noexcept {
        al_status status{};
        static_cast<void>(wire::decode(status, data));
        const bool upward = step_ == step::wait_pre_op;
        if (!status.error && status.state == (upward ? al_state::pre_op : al_state::init)) return next();
        // On the way to INIT an old error may stand until the slave has seen the acknowledgement.
        const bool late = patience_.exhausted(now, config.state_timeout);
        if (status.error && (upward || late))
            return fail(master_errc::al_error, static_cast<std::uint32_t>(status.code));
        if (late) return fail(master_errc::state_timeout, static_cast<std::uint32_t>(status.state));
        return progress::wait;
    }

    progress sii_read(std::span<const std::byte> data, time_point now, const master_config& config) noexcept {
        sii_access access{};
        static_cast<void>(wire::decode(access, data));
        if (access.request.busy)
            return patience_.exhausted(now, config.sii_timeout) ? fail(master_errc::sii_busy) : progress::wait;
        if (access.request.command_error) return fail(master_errc::sii_error, sii_word_);

        const std::size_t at = (std::size_t{sii_word_} - sii_words::identity) * 2;
        const std::size_t count = access.request.eight_byte_reads ? 8 : 4;
        std::ranges::copy_n(access.data.begin(), static_cast<std::ptrdiff_t>(std::min(count, sii_.size() - at)),
                            sii_.begin() + static_cast<std::ptrdiff_t>(at));
        sii_word_ += static_cast<std::uint32_t>(count / 2);
        constexpr std::uint32_t identity_end = sii_words::identity + wire::max_size<sii_identity> / 2;
        if (sii_word_ == identity_end) sii_word_ = sii_words::mailbox;
        if (sii_word_ < sii_words::mailbox + wire::max_size<sii_mailbox> / 2) {
            step_ = step::start_sii_read;
            patience_.renew();
            return progress::send;
        }
        return sii_complete();
    }

    progress sii_complete() noexcept {
        const std::span<const std::byte> sii{sii_};
        static_cast<void>(wire::decode_prefix(slave_.identity, sii));
        static_cast<void>(
            wire::decode_prefix(slave_.mailbox, sii.subspan((sii_words::mailbox - sii_words::identity) * 2)));
        const auto usable = [](std::uint16_t size) { return size >= min_mailbox_size && size <= max_mailbox_size; };
        if (!usable(slave_.mailbox.receive_size) || !usable(slave_.mailbox.send_size))
            return fail(master_errc::no_mailbox);
        if (!slave_.mailbox.coe) return fail(master_errc::no_coe);
        return next();
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

    static constexpr std::size_t sii_bytes =
        (sii_words::mailbox - sii_words::identity) * 2 + wire::max_size<sii_mailbox>;

    step step_{};
    std::uint32_t sii_word_ = sii_words::identity; // to be read next
    std::array<std::byte, sii_bytes> sii_{};       // from the identity on
    patience patience_{};
    slave_record slave_{};
    outcome result_{};
};

} // namespace jauscat::ethercat
