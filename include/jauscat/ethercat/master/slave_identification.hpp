// Reads by what a slave can be recognised: identity and alias in the SII, alias in force, explicit device
// identification.
#pragma once

#include <jauscat/ethercat/frame_builder.hpp>
#include <jauscat/ethercat/master/activity.hpp>
#include <jauscat/ethercat/master/sii_read.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// By what a slave can be recognised.
struct slave_identity {
    sii_identity identity{};
    std::uint16_t alias{};        ///< register 0012h: in force since power-on; 0: none
    std::uint16_t stored_alias{}; ///< SII word 4: in force after the next power-on; 0: none
    /// Explicit device identification, such as a selector switch; none where the slave has none, or it was not asked.
    std::optional<std::uint16_t> device_id{};
};

/// State machine: `request` adds the datagrams of the present step, `reply` takes their return. Stays in place while it
/// runs, in any state of the slave, which does not change.
class slave_identification {
  public:
    /// At most, of a request: bytes and datagrams.
    static constexpr std::size_t request_size() noexcept {
        return 2 * datagram_overhead + wire::max_size<esc_word> + wire::max_size<al_status>;
    }
    static constexpr std::size_t request_datagrams() noexcept { return 2; }

    slave_identification() noexcept = default;
    slave_identification(std::uint16_t station, bool wants_device_id) noexcept
        : station_{station}, wants_device_id_{wants_device_id} {}

    [[nodiscard]] const slave_identity& value() const noexcept { return found_; }
    [[nodiscard]] const master_result<>& result() const noexcept { return result_; }

    void request(frame_builder& frame) const noexcept {
        switch (step_) {
        case step::read_registers:
            frame.read(station_, esc_registers::station_alias);
            frame.read(station_, esc_registers::al_status);
            break;
        case step::take_sii: ethercat::take_sii(frame, station_); break;
        case step::read_alias:
        case step::read_identity: sii_.request(frame, station_); break;
        case step::give_sii: ethercat::give_sii(frame, station_); break;
        case step::ask_id:
            frame.write(station_, esc_registers::al_control, {.state = state_, .request_device_id = true});
            break;
        case step::wait_id: frame.read(station_, esc_registers::al_status); break;
        case step::end_id: frame.write(station_, esc_registers::al_control, {.state = state_});
        }
    }

    progress reply(replies datagrams, time_point now, const master_config& config) noexcept {
        if (failure_ != master_error{}) return fail(failure_); // the SII is given back
        if (result_ = executed_by_one(datagrams); !result_) return progress::done;
        switch (step_) {
        case step::read_registers: {
            found_.alias = datagrams[0].value(esc_registers::station_alias).value;
            const auto status = datagrams[1].value(esc_registers::al_status);
            state_ = status.state;
            // With an error its code is in the place of the identification.
            wants_device_id_ = wants_device_id_ && !status.error && is_known(state_);
            return go(step::take_sii);
        }
        case step::take_sii: return read(step::read_alias, sii_words::station_alias, std::span{alias_});
        case step::read_alias:
        case step::read_identity: return sii_reply(datagrams.front(), now, config);
        case step::give_sii: return wants_device_id_ ? go(step::ask_id) : progress::done;
        case step::ask_id: return go(step::wait_id);
        case step::wait_id: {
            const auto status = datagrams.front().value(esc_registers::al_status);
            if (status.device_id_loaded && !status.error)
                found_.device_id = static_cast<std::uint16_t>(status.code);
            else if (!status.error && !timeout_.expired(now, config.sii_timeout))
                return progress::wait;
            return go(step::end_id);
        }
        default: return progress::done; // end_id
        }
    }

  private:
    enum class step : std::uint8_t {
        read_registers,
        take_sii,
        read_alias,
        read_identity,
        give_sii,
        ask_id,
        wait_id,
        end_id,
    };

    progress go(step next) noexcept {
        step_ = next;
        return progress::send;
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
    progress read(step next, std::uint32_t word, std::span<std::byte> into) noexcept {
        sii_ = sii_read{word, into};
        return go(next);
    }
    progress sii_reply(const datagram_view& datagram, time_point now, const master_config& config) noexcept {
        const auto after = sii_.reply(datagram, now, config);
        if (after != progress::done) return after;
        if (!sii_.result()) return give_back(sii_.result().error());
        if (step_ == step::read_alias) {
            esc_word alias{};
            static_cast<void>(wire::decode_prefix(alias, alias_));
            found_.stored_alias = alias.value;
            return read(step::read_identity, sii_words::identity, std::span{identity_});
        }
        static_cast<void>(wire::decode(found_.identity, identity_));
        return go(step::give_sii);
    }

    std::uint16_t station_{};
    bool wants_device_id_{};
    al_state state_{};
    step step_{};
    sii_read sii_{};
    timeout timeout_{};
    std::array<std::byte, wire::max_size<esc_word>> alias_{};
    std::array<std::byte, wire::max_size<sii_identity>> identity_{};
    slave_identity found_{};
    master_error failure_{}; // after which the SII is to be given back
    master_result<> result_{};
};

} // namespace jauscat::ethercat
