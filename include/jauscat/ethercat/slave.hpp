// An emulated EtherCAT slave: a slave controller and the application behind it (states, SII, mailbox, CoE, process
// data). Follows the standard rather than one master's habits, so that any master can bring it up.
#pragma once

#include <jauscat/ethercat/esc.hpp>
#include <jauscat/ethercat/object_dictionary.hpp>
#include <jauscat/ethercat/sii_image.hpp>
#include <jauscat/ethercat/slave_coe.hpp>
#include <jauscat/ethercat/slave_process_data.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/mailbox.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace jauscat::ethercat {

/// A slave with a CoE mailbox and, if its description has any, process data.
class slave {
  public:
    /// `objects`, what `description` refers to, and the memory in `options` must outlive the slave.
    slave(const slave_description& description, object_dictionary objects, const coe_options& options = {}) noexcept
        : description_{description},
          coe_{objects, options},
          sii_{make_sii_image(description)},
          process_data_{description} {
        power_on();
    }

    /// Restarts as after power-on: the station address is gone, the state is INIT.
    void power_on() noexcept {
        esc_.reset();
        esc_.store(esc_registers::station_alias, esc_word{description_.station_alias});
        esc_.store(esc_registers::sii_control, sii_request{.eight_byte_reads = description_.eight_byte_sii_reads,
                                                           .two_address_bytes = sii_.size() > 2048});
        forget_mailbox();
        coe_.power_on();
        process_data_.power_on(esc_);
    }
    /// Whether another slave is connected behind this one, for masters that look at the wiring. Kept at power-on.
    void set_downstream(bool connected) noexcept { esc_.set_downstream(connected); }

    /// A frame passes: it is changed in place, then the application works.
    void process(std::span<std::byte> frame) noexcept {
        pass(frame);
        work();
    }

    /// The controller's part of `process`: the application does not get to run.
    void pass(std::span<std::byte> frame) noexcept { esc_.pass(frame); }

    /// The application's part of `process`: states, SII, process data and mailbox.
    void work() noexcept {
        if (esc_.take_al_control()) change_state();
        if (esc_.take_sii_command()) access_sii();
        process_data_.work(esc_, state());
        if (state() != al_state::init) serve_mailbox();
    }

    /// The SyncManager watchdog: a slave in OP that has a master's outputs no longer goes to SAFE-OP with an error
    /// (001Bh). To be called every few milliseconds; a host that never does has no watchdog. Time is any that does not
    /// go back.
    void on_time(std::chrono::nanoseconds now) noexcept {
        if (state() != al_state::op || !process_data_.expired(esc_, now)) return;
        const al_status lost{.state = al_state::safe_op, .error = true, .code = al_status_code::sync_manager_watchdog};
        esc_.store(esc_registers::al_status, lost);
    }

    /// The outputs that are in force: what a master wrote last in OP. What is safe without a master, the application
    /// knows: see `state`.
    [[nodiscard]] std::span<const std::byte> outputs() const noexcept { return process_data_.outputs(); }
    /// True once after each write of the outputs in OP.
    bool take_outputs() noexcept { return process_data_.take_outputs(); }
    /// What a master reads from SAFE-OP on; the application writes it.
    [[nodiscard]] std::span<std::byte> inputs() noexcept {
        return esc_.bytes(process_memory::inputs, description_.input_size());
    }

    [[nodiscard]] al_state state() const noexcept { return esc_.load<al_status>(esc_registers::al_status).state; }
    /// 0 until a master has given one.
    [[nodiscard]] std::uint16_t station_address() const noexcept {
        return esc_.load<esc_word>(esc_registers::station_address).value;
    }

  private:
    static constexpr auto mailbox_out = manager_numbers::mailbox_out, mailbox_in = manager_numbers::mailbox_in;

    void change_state() noexcept {
        const auto control = esc_.load<al_control>(esc_registers::al_control);
        auto status = esc_.load<al_status>(esc_registers::al_status);
        if (status.error && !control.acknowledge && control.state > status.state) return;
        const bool from_init = status.state == al_state::init;
        status.error = false;
        status.code = refusal(status.state, control.state);
        if (status.code == al_status_code::none) {
            status.state = control.state;
        } else {
            status.error = true;
        }
        if (from_init || status.state == al_state::init) forget_mailbox();
        esc_.store(esc_registers::al_status, status);
        process_data_.enter(esc_, status.state);
    }

    // ETG.1000.6, table 106: one step up at a time, any step down.
    [[nodiscard]] al_status_code refusal(al_state from, al_state to) noexcept {
        switch (to) {
        case al_state::init: return al_status_code::none;
        case al_state::boot: return al_status_code::boot_not_supported;
        case al_state::pre_op:
            if (from != al_state::init) return al_status_code::none;
            return mailbox_is_configured() ? al_status_code::none : al_status_code::mailbox_pre_op;
        case al_state::safe_op:
            if (from == al_state::init) return al_status_code::invalid_state_change;
            return process_data_.refusal(esc_);
        case al_state::op:
            if (from != al_state::safe_op && from != al_state::op) return al_status_code::invalid_state_change;
            return process_data_.refusal(esc_);
        }
        return al_status_code::unknown_state;
    }

    [[nodiscard]] bool mailbox_is_configured() noexcept {
        const auto matches = [this](const sync_manager& sm, std::uint16_t start, std::uint16_t length,
                                    sync_manager_direction direction) {
            return sm.enable && sm.mode == sync_manager_mode::mailbox && sm.direction == direction &&
                   sm.start == start && sm.length == length && esc_.area(sm).size() >= min_mailbox_size;
        };
        return matches(esc_.manager(mailbox_out), description_.mailbox_out_offset, description_.mailbox_out_size,
                       sync_manager_direction::master_writes) &&
               matches(esc_.manager(mailbox_in), description_.mailbox_in_offset, description_.mailbox_in_size,
                       sync_manager_direction::master_reads);
    }

    void access_sii() noexcept {
        auto access = esc_.load<sii_access>(esc_registers::sii_control);
        access.request.busy = false;
        if (access.request.cmd == sii_command::read) {
            const std::size_t count = description_.eight_byte_sii_reads ? 8 : 4;
            for (std::size_t i = 0; i != count; ++i) {
                const std::size_t at = std::size_t{access.request.address} * 2 + i;
                access.data[i] = at < sii_.size() ? sii_[at] : std::byte{0xFF};
            }
        } else {
            access.request.command_error = true; // this memory is read only
        }
        access.request.cmd = sii_command::clear;
        esc_.store(esc_registers::sii_control, access);
    }

    void forget_mailbox() noexcept {
        last_counter_ = 0;
        replied_ = false;
        coe_.forget_transfer();
        for (const auto n : {mailbox_out, mailbox_in})
            if (esc_.manager(n).full) esc_.set_full(n, false);
    }

    void serve_mailbox() noexcept {
        const auto in = esc_.manager(mailbox_in);
        if (in.repeat_request != in.repeat_acknowledge) {
            if (replied_) esc_.set_full(mailbox_in, true); // the last message still stands in the memory
            esc_.acknowledge_repeat(mailbox_in);
        }
        const auto out = esc_.manager(mailbox_out);
        if (!out.full || esc_.manager(mailbox_in).full) return; // an answer needs room first
        // Checked on the way to PRE-OP, but a master may have changed the SyncManagers since: it then gets silence.
        if (mailbox_is_configured()) answer(esc_.area(out), esc_.area(in));
        esc_.set_full(mailbox_out, false);
    }

    void answer(std::span<const std::byte> request, std::span<std::byte> reply) noexcept {
        mailbox_header header{};
        const auto used = wire::decode_prefix(header, request);
        if (header.counter != 0 && header.counter == last_counter_) return; // the master repeats itself
        last_counter_ = header.counter;
        if (header.type == mailbox_type::error) return;

        const auto body = request.subspan(used.size());
        const auto room = reply.subspan(used.size());
        coe_answer answer{};
        if (header.length > body.size()) {
            answer.error = mailbox_error_code::invalid_size;
        } else if (header.type != mailbox_type::coe) {
            answer.error = mailbox_error_code::unsupported_protocol;
        } else {
            answer = coe_.answer(body.first(header.length), room);
        }
        if (answer.error != mailbox_error_code::none) {
            header.type = mailbox_type::error;
            answer.size = wire::encode(mailbox_error_reply{1, answer.error}, room).size();
        }
        if (answer.size == 0) return;
        header.length = static_cast<std::uint16_t>(answer.size);
        header.address = 0;
        static_cast<void>(wire::encode(header, reply));
        replied_ = true;
        esc_.set_full(mailbox_in, true);
    }

    slave_description description_;
    coe_server coe_;
    sii_image sii_;
    slave_process_data process_data_;
    esc esc_{};
    std::uint8_t last_counter_{};
    bool replied_{}; // the memory of the reply mailbox holds a message of ours
};

} // namespace jauscat::ethercat
