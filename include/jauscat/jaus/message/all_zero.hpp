// A message with all its fields, and zeros in them: what an actuator at rest reports.
#pragma once
#include <jauscat/wire/visit.hpp>

namespace jauscat::jaus {

/// All optional fields are present. A list is empty.
template <wire::message Message> [[nodiscard]] constexpr Message all_zero() noexcept {
    Message message{};
    wire::visit(message, [](auto, auto& member) {
        if constexpr (requires { member.emplace(); })
            member.emplace();
        else
            member = {};
    });
    return message;
}

} // namespace jauscat::jaus
