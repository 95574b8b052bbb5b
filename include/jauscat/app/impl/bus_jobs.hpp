// The jobs of a bus: what it has the master do, one after the other.
#pragma once
#include <jauscat/app/impl/bus_state.hpp>

#include <cstdint>
#include <memory>

namespace jauscat {
inline namespace JAUSCAT_WAY {
namespace app {

/// An operation whose outcome nobody waits for.
struct unheard final : operation<> {
    void deliver(error_code) override {}
};

/// Slaves that a bus looks for whose options name them.
enum class find_scope : std::uint8_t {
    changes, ///< those that have come, gone or moved
    once,    ///< all, unless they are known
    all,
};

/// Finds all slaves, also where one is in OP if it `takes_over`.
[[nodiscard]] JAUSCAT_DECL std::unique_ptr<bus_job> make_start_job(operation_ptr<> done, bool takes_over);
/// Finds the slaves of a bus whose options name them; `takes_over` counts where it clears them.
[[nodiscard]] JAUSCAT_DECL std::unique_ptr<bus_job> make_find_job(find_scope what, operation_ptr<> done,
                                                                  bool takes_over = true);
/// Looks at the state of a slave, collects its emergencies, and brings it up again after it was reset.
[[nodiscard]] JAUSCAT_DECL std::unique_ptr<bus_job> make_look_job(std::uint16_t station);
/// Takes a slave to a state, and configures its process data before SAFE-OP.
[[nodiscard]] JAUSCAT_DECL std::unique_ptr<bus_job> make_change_job(const slave_choice& which, ethercat::al_state goal,
                                                                    operation_ptr<> done);
[[nodiscard]] JAUSCAT_DECL std::unique_ptr<bus_job> make_change_job(std::uint16_t station, ethercat::al_state goal,
                                                                    operation_ptr<> done);

} // namespace app
} // namespace JAUSCAT_WAY
} // namespace jauscat
