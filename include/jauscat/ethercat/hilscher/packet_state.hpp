// Packets that ask for the state of the bus and set it.
#pragma once

#include <jauscat/base/compilation.hpp>
#include <jauscat/ethercat/hilscher/packet_service.hpp>
#include <jauscat/schema/ethercat/al_state.hpp>
#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/schema/ethercat/hilscher_state.hpp>

#include <array>

namespace jauscat::ethercat {

/// The lowest state of all slaves in the ring, read at once.
class packet_get_state : public packet_service<hilscher::get_state_request, hilscher::get_state_confirmation> {
  public:
    JAUSCAT_FUNCTION service_step begin(master& m, const packet_io&) noexcept;
    JAUSCAT_FUNCTION service_answer answer(confirmation& out, const master&, const packet_io&) const noexcept;

  private:
    std::array<std::byte, wire::max_size<al_status>> read_{};
};

/// Takes every slave of the bus to a state: those that are in INIT or were lost are brought up, those above it go down
/// at once, and all the others go up together, one state after the other. A slave that refuses ends it. A bus of more
/// than `capacity` slaves is refused (coe_no_resource).
class packet_set_state : public packet_service<hilscher::set_state_request, hilscher::set_state_confirmation> {
  public:
    static constexpr bool one_job = false;
    static constexpr std::size_t capacity = 256; ///< slaves
    JAUSCAT_FUNCTION service_step begin(master& m, const packet_io& io) noexcept;

    JAUSCAT_FUNCTION service_step next(master& m, const packet_io& io) noexcept;

    static service_answer answer(confirmation&, const master&, const packet_io&) noexcept { return {}; }

  private:
    enum class stage : std::uint8_t { clear, look, bring_up, lower, configure, safe_op, op };
    struct participant {
        std::uint16_t position{};
        std::uint16_t station{};
        al_state state{}; ///< 0: the slave is lost, or was never brought up
        bool error{};

        JAUSCAT_FUNCTION void enter(al_state next, bool with_error = false) noexcept;
    };

    // A slave's reasons for refusing a state have statuses of their own, but their numbering is not documented.
    [[nodiscard]] JAUSCAT_FUNCTION static hilscher::packet_status status_of(const master_error& error) noexcept;

    // Starts the next job that is due.
    JAUSCAT_FUNCTION service_step advance(master& m, const packet_io& io) noexcept;

    [[nodiscard]] JAUSCAT_FUNCTION bool is_due(const master& m, const packet_io& io,
                                               const participant& member) const noexcept;

    // Configured slaves keep their order.
    [[nodiscard]] JAUSCAT_FUNCTION identity_check identity_of(const packet_io& io,
                                                              const participant& member) const noexcept;
    [[nodiscard]] JAUSCAT_FUNCTION bool is_known(const master& m, const packet_io& io,
                                                 const participant& member) const noexcept;

    JAUSCAT_FUNCTION master_result<> start(master& m, const packet_io& io, const participant& slave) noexcept;

    al_state goal_{};

    std::array<participant, capacity> bus_{};
    std::size_t count_{};
    stage stage_{};
    std::size_t place_{};
    std::array<std::byte, wire::max_size<al_status>> read_{};
};

} // namespace jauscat::ethercat

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/ethercat/hilscher/impl/packet_state.ipp>
#endif
