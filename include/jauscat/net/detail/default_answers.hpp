// What a component answers where its program does not: others ask each component, and go on asking until they know.
#pragma once

#include <jauscat/jaus/answer.hpp>
#include <jauscat/jaus/core_service.hpp>
#include <jauscat/jaus/described_component.hpp>
#include <jauscat/net/detail/configured_identity.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/event.hpp>

#include <array>
#include <chrono>
#include <optional>
#include <span>
#include <string>

namespace jauscat::net::detail {

/// Answers Query Identification with the name that the configuration has for the component, Query Services with the
/// core service, Query Heartbeat Pulse; and requests for service connections and events with a refusal. It sends no
/// heartbeats.
class default_answers {
  public:
    /// `config` must outlive this.
    default_answers(const jaus_config& config, const jaus::address& self)
        : self_{self}, number_{"component " + std::to_string(self.component)} {
        jaus::component_description description{.services = services};
        description.name.identification = number_;
        description.name = identity_of(config, self, description.name);
        described_.emplace(self, description, jaus::heartbeat{.period = {}}, memory_);
    }
    default_answers(const default_answers&) = delete;
    default_answers& operator=(const default_answers&) = delete;

    jaus::message_outcome on_message(const jaus::header& head, std::span<const std::byte> body,
                                     std::chrono::nanoseconds now, jaus::message_sink out) noexcept {
        using jaus::message_outcome;
        if (head.command_code == jaus::create_service_connection::command_code)
            return jaus::decode_for<jaus::create_service_connection>(body, [&](const auto& request) {
                using enum jaus::service_connection_response;
                jaus::answer(
                    head, self_,
                    jaus::confirm_service_connection{.command_code_ = request.command_code_,
                                                     .response_code = component_does_not_support_service_connections},
                    out);
                return message_outcome::refused;
            });
        if (head.command_code == jaus::create_event::command_code)
            return jaus::decode_for<jaus::create_event>(body, [&](const auto& request) {
                jaus::answer(head, self_,
                             jaus::reject_event_request{.local_request_id = request.local_request_id,
                                                        .response_code = jaus::event_response::message_not_supported,
                                                        .error_message = "no events"},
                             memory_, out);
                return message_outcome::refused;
            });
        return described_->on_message(head, body, now, out);
    }

  private:
    static constexpr std::array services{jaus::core_messages::service};

    jaus::address self_;
    std::string number_;                  ///< what a component is called that has no name
    std::array<std::byte, 256> memory_{}; ///< the longest answer has 178 bytes
    std::optional<jaus::described_component> described_{};
};

} // namespace jauscat::net::detail
