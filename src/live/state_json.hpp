// The state of nodes and buses as JSON.
#pragma once
#include <jauscat/net/live/live_state.hpp>

#include <nlohmann/json.hpp>
#include <span>

namespace jauscat::net::live {

[[nodiscard]] nlohmann::ordered_json to_json(const live_system& of);
[[nodiscard]] nlohmann::ordered_json to_json(const live_component& of);
[[nodiscard]] nlohmann::ordered_json to_json(const live_bus& of);

} // namespace jauscat::net::live
