// Default replies to queries that the application does not handle; peers repeat such queries until they are answered.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/component/core_messages.hpp>
#include <jauscat/jaus/component/described_component.hpp>
#include <jauscat/net/node/detail/configured_identity.hpp>
#include <jauscat/net/node/detail/offered_messages.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/event.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace jauscat::net::detail {

/// Answers Query Identification with the name in the configuration, Query Services with the core service and the
/// component's own messages, and Query Heartbeat Pulse. Refuses requests for service connections and events. Sends no
/// heartbeats.
class default_answers {
  public:
    /// `config` must outlive this. `more`: messages of the component in addition to the core service.
    default_answers(const jaus_config& config, const jaus::address& self, offered_messages more)
        : self_{self},
          number_{"component " + std::to_string(self.component)},
          more_{std::move(more)},
          memory_(256 + (services_[0].input_message.size() + services_[0].output_message.size() + more_.input.size() +
                         more_.output.size()) *
                            wire::max_size<jaus::supported_message>) {
        services_[1] = {self.component, std::span<const jaus::supported_message>{more_.input},
                        std::span<const jaus::supported_message>{more_.output}};
        const bool has_more = !more_.input.empty() || !more_.output.empty();
        jaus::component_description description{.services = std::span{services_}.first(has_more ? 2 : 1)};
        description.name.identification = number_;
        description.name = identity_of(config, self, description.name);
        described_.emplace(self, description, jaus::heartbeat{.period = {}}, memory_);
    }
    default_answers(const default_answers&) = delete;
    default_answers& operator=(const default_answers&) = delete;

    jaus::message_outcome on_message(const jaus::header& head, std::span<const std::byte> body, time_point now,
                                     jaus::message_sink out) noexcept {
        using jaus::message_outcome;
        if (head.command_code == jaus::command_code_of<jaus::create_service_connection>)
            return jaus::decode_for<jaus::create_service_connection>(body, [&](const auto& request) {
                using enum jaus::service_connection_response;
                static_cast<void>(jaus::answer(
                    head, self_,
                    jaus::confirm_service_connection{.command_code = request.command_code,
                                                     .response_code = component_does_not_support_service_connections},
                    out));
                return message_outcome::refused;
            });
        if (head.command_code == jaus::command_code_of<jaus::create_event>)
            return jaus::decode_for<jaus::create_event>(body, [&](const auto& request) {
                static_cast<void>(jaus::answer(
                    head, self_,
                    jaus::reject_event_request{.local_request_id = request.local_request_id,
                                               .response_code = jaus::event_response::message_not_supported,
                                               .error_message = "no events"},
                    memory_, out));
                return message_outcome::refused;
            });
        return described_->on_message(head, body, now, out);
    }

  private:
    jaus::address self_;
    std::string number_;    ///< name of a component without a name in the configuration
    offered_messages more_; ///< listed in the second service
    std::array<jaus::offered_service, 2> services_{jaus::core_messages::service};
    std::vector<std::byte> memory_; ///< for the longest answer
    std::optional<jaus::described_component> described_{};
};

} // namespace jauscat::net::detail
