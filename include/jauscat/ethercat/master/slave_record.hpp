// Record of a slave that the master has brought up.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/coe.hpp>
#include <jauscat/schema/ethercat/sii.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::ethercat {

/// The last emergencies of a slave, the oldest first.
class emergency_log {
  public:
    static constexpr std::size_t capacity = 5;

    /// Stores `emergency`; if the memory is full, the oldest one is dropped.
    JAUSCAT_CONSTEXPR void note(const coe_emergency& emergency) noexcept;
    constexpr void clear() noexcept { *this = {}; }

    /// The emergencies that were kept, oldest first.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::span<const coe_emergency> kept() const noexcept;
    /// Emergencies have been dropped since the last `clear`.
    [[nodiscard]] constexpr bool overflow() const noexcept { return overflow_; }

  private:
    std::array<coe_emergency, capacity> kept_{};
    std::size_t count_{};
    bool overflow_{};
};

/// Required identity of a slave; parts that are not given are not checked.
struct identity_check {
    std::optional<std::uint32_t> vendor{};
    std::optional<std::uint32_t> product{};
    std::optional<std::uint32_t> revision{};
    std::optional<std::uint32_t> serial{};

    /// Whether the identity has every value that is given.
    [[nodiscard]] JAUSCAT_CONSTEXPR bool accepts(const sii_identity& found) const noexcept;
};

/// A slave's place in the logical address space. Its outputs come first, its inputs follow.
struct process_place {
    std::uint32_t output_address{};
    std::uint32_t input_address{};
    std::uint16_t output_size{};    ///< bytes; 0: none
    std::uint16_t input_size{};     ///< bytes; 0: none
    std::uint8_t output_managers{}; ///< SyncManagers with outputs
    std::uint8_t input_managers{};  ///< SyncManagers with inputs
    bool no_lrw{};                  ///< the slave cannot read and write in one datagram

    [[nodiscard]] constexpr std::size_t size() const noexcept { return std::size_t{output_size} + input_size; }
    /// Address behind it; 0 where there are no process data.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::uint32_t end() const noexcept;

    friend constexpr bool operator==(const process_place&, const process_place&) = default;
};

/// How long a slave may take, in place of the times of master_config, as the file of its vendor says (ESI: Info). 0:
/// those of master_config.
struct slave_timeouts {
    using milliseconds = std::chrono::duration<std::uint16_t, std::milli>;

    milliseconds pre_op{};          ///< from INIT to PRE-OP
    milliseconds safe_op_op{};      ///< from PRE-OP to SAFE-OP, and from there to OP
    milliseconds back_to_init{};    ///< to INIT or PRE-OP
    milliseconds back_to_safe_op{}; ///< from OP to SAFE-OP
    milliseconds mailbox{};         ///< one request and its answer

    friend constexpr bool operator==(const slave_timeouts&, const slave_timeouts&) = default;
};

struct slave_record {
    static constexpr std::uint16_t no_position = 0xFFFF;

    std::uint16_t position{}; ///< in the ring, from 0; no_position: `locate_slaves` has not found it
    std::uint16_t station{};  ///< configured station address
    std::uint16_t alias{};    ///< configured station alias, register 0012h; 0: none
    sii_identity identity{};
    sii_mailbox mailbox{};        ///< sizes 0: the slave has none
    process_place process_data{}; ///< after `configure`
    /// Without outputs for so long, the slave leaves OP: set by `configure`; 0: not yet since it was brought up.
    std::chrono::nanoseconds watchdog{};
    al_status al{};                  ///< as the last `check` has found it; state 0: it failed
    bool reply_waiting{};            ///< at the last `check` its reply mailbox was full: collect its emergencies
    std::uint8_t last_counter{};     ///< of the last mailbox request; 0: none yet
    std::uint32_t last_reply_mark{}; ///< of the last mailbox message received: distinguishes it from the next one
    bool awaits_late_answer{};       ///< a request was abandoned: its answer may still arrive
    bool drained{};                  ///< no old message waits in the reply mailbox
    bool is_lent{};                  ///< another master uses the mailbox: transfers of this one wait
    /// Pending abort of a cancelled segmented transfer; sent before the next transfer.
    std::optional<sdo_abort> unfinished{};
    slave_timeouts timeouts{};   ///< `master::set_timeouts`
    emergency_log emergencies{}; ///< since it was brought up, or since they were cleared

    /// Takes over how the mailbox was left by the master to which it was lent.
    JAUSCAT_CONSTEXPR void return_mailbox(const slave_record& from) noexcept;
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/master/impl/slave_record.ipp>
#endif
