// The fields of a message as one flat object of JSON.
#pragma once
#include <jauscat/catalogue/any_message.hpp>

#include <nlohmann/json.hpp>

namespace jauscat::net::live {

using json = nlohmann::ordered_json;

/// Values and units by the paths of the fields, `joint.0.joint_position`: numbers scaled, enumerations and flags by
/// their names, bytes in hex.
struct flat_fields {
    json values = json::object();
    json units = json::object();
};

[[nodiscard]] flat_fields flatten(const catalogue::any_message& message);

} // namespace jauscat::net::live
