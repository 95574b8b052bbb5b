// Reads by what a slave can be recognised: identity and alias in the SII, alias in force, explicit device
// identification.
#pragma once

#include <jauscat/base/compilation.hpp>
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

    JAUSCAT_FUNCTION void request(frame_builder& frame) const noexcept;

    JAUSCAT_FUNCTION progress reply(replies datagrams, time_point now, const master_config& config) noexcept;

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

    JAUSCAT_FUNCTION progress go(step next) noexcept;
    JAUSCAT_FUNCTION progress fail(const master_error& error) noexcept;
    // Fails once the slave's application has the SII again.
    JAUSCAT_FUNCTION progress give_back(const master_error& why) noexcept;
    JAUSCAT_FUNCTION progress read(step next, std::uint32_t word, std::span<std::byte> into) noexcept;
    JAUSCAT_FUNCTION progress sii_reply(const datagram_view& datagram, time_point now,
                                        const master_config& config) noexcept;

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

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/slave_identification.ipp>
#endif
