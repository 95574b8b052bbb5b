// Default replies to queries that the application does not handle; peers repeat such queries until they are answered.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/component/answer.hpp>
#include <jauscat/jaus/component/core_messages.hpp>
#include <jauscat/jaus/component/described_component.hpp>
#include <jauscat/net/node/detail/attached_component.hpp>
#include <jauscat/net/node/detail/configured_identity.hpp>
#include <jauscat/net/node/detail/core_subscriptions.hpp>
#include <jauscat/net/node/detail/offered_messages.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace jauscat::net::detail {

/// Answers Query Identification with the name in the configuration, Query Services with the core service and the
/// component's own messages, and Query Heartbeat Pulse. Takes requests for service connections to the reports of the
/// core service, and for events of them. Sends no heartbeats.
class default_answers {
  public:
    /// `config` must outlive this. `more`: messages of the component in addition to the core service.
    default_answers(const jaus_config& config, const attached_component& component, offered_messages more)
        : component_{component},
          number_{"component " + std::to_string(component.self.component)},
          subscriptions_{component.self, jaus::bound<&default_answers::answer_query>(*this)},
          more_{std::move(more)} {
        more_.add(subscriptions_);
        memory_.resize(256 + (services_[0].input_message.size() + services_[0].output_message.size() +
                              more_.input.size() + more_.output.size()) *
                                 wire::max_size<jaus::supported_message>);
        services_[1] = {component.self.component, std::span<const jaus::supported_message>{more_.input},
                        std::span<const jaus::supported_message>{more_.output}};
        jaus::component_description description{.services = services_};
        description.name.identification = number_;
        description.name = identity_of(config, component.self, description.name);
        described_.emplace(component.self, description, jaus::heartbeat{.period = {}}, memory_);
    }
    default_answers(const default_answers&) = delete;
    default_answers& operator=(const default_answers&) = delete;

    jaus::message_outcome on_message(const jaus::header& head, std::span<const std::byte> body, time_point now,
                                     jaus::message_sink out) {
        const auto outcome = described_->on_message(head, body, now, out);
        return outcome == jaus::message_outcome::unhandled ? subscriptions_.on_message(head, body, now, out) : outcome;
    }
    [[nodiscard]] core_subscriptions& subscriptions() noexcept { return subscriptions_; }

  private:
    jaus::message_outcome answer_query(const jaus::header& head, std::span<const std::byte> body, time_point now,
                                       jaus::message_sink out) {
        const auto outcome = component_.answer_query(head, body, now, out);
        return outcome == jaus::message_outcome::unhandled ? described_->on_message(head, body, now, out) : outcome;
    }

    attached_component component_;
    std::string number_; ///< name of a component without a name in the configuration
    core_subscriptions subscriptions_;
    offered_messages more_; ///< listed in the second service
    std::array<jaus::offered_service, 2> services_{jaus::core_messages::service};
    std::vector<std::byte> memory_; ///< for the longest answer
    std::optional<jaus::described_component> described_{};
};

} // namespace jauscat::net::detail
