// Takes one slave from any state to PRE-OP: station address, identity and mailbox from the SII, SyncManagers 0 and 1,
// state. Reads only the SII words it needs: 24 frames where a read gives 4 bytes, 18 where it gives 8.
#pragma once

#include <jauscat/base/compilation.hpp>
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
    JAUSCAT_FUNCTION slave_bring_up(std::uint16_t position, std::uint16_t station, const identity_check& expected,
                                    bool may_be_taken, const slave_timeouts& timeouts) noexcept;

    /// The record of the slave; complete when the bring-up is done without error.
    [[nodiscard]] const slave_record& slave() const noexcept { return slave_; }
    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }

    JAUSCAT_FUNCTION void request(frame_builder& frame) noexcept;

    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;

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

    JAUSCAT_FUNCTION void assign(frame_builder& frame) const noexcept;
    JAUSCAT_FUNCTION progress go(step next) noexcept;
    JAUSCAT_FUNCTION progress read(step next, std::uint32_t word, std::span<std::byte> into) noexcept;
    JAUSCAT_FUNCTION progress fail(const master_error& error) noexcept;

    // Fails once the slave's application has the SII again.
    JAUSCAT_FUNCTION progress give_back(const master_error& why) noexcept;
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
    JAUSCAT_FUNCTION progress verified(const datagram_view& datagram) noexcept;

    JAUSCAT_FUNCTION progress identified() noexcept;

    JAUSCAT_FUNCTION progress mailbox_read() noexcept;

    [[nodiscard]] JAUSCAT_FUNCTION mailbox_managers managers() const noexcept;

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

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/slave_bring_up.ipp>
#endif
