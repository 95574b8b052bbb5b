// The messages of SAE services, compiled once: link jauscat::catalogue_sae.
//
// The command code of such an entry is the message ID, and its body is the payload, from the message ID on.
#pragma once
#include <jauscat/catalogue/list.hpp>

namespace jauscat::catalogue {

/// Core services, AS5710: access control, management, events, lists, discovery, liveness.
[[nodiscard]] const list& sae_core_1_1();
/// Mobility services, AS6009.
[[nodiscard]] const list& sae_mobility_1_1();
/// The same of version 1.0: Set and Report Local Vector have other bytes.
[[nodiscard]] const list& sae_mobility_1_0();
/// Environment sensing services, AS6060.
[[nodiscard]] const list& sae_environment_sensing_2_0();
/// Manipulator services, AS6057.
[[nodiscard]] const list& sae_manipulator_2_0();
/// Services of unmanned ground vehicles, AS6091.
[[nodiscard]] const list& sae_ground_vehicle_1_0();
/// All of these, mobility by version 1.1.
[[nodiscard]] const list& sae();

} // namespace jauscat::catalogue
