// Events of a node manager: of the core service, and Report Configuration, sent when components of the subsystem appear
// or disappear.
#pragma once

#include <jauscat/base/time.hpp>
#include <jauscat/jaus/routing/node_manager.hpp>
#include <jauscat/net/node/detail/core_subscriptions.hpp>

#include <array>

namespace jauscat::net::detail {

/// Node managers and communicators of other vendors create such an event when they have detected a node, and rely on
/// it.
class configuration_events {
    struct filler {
        const jaus::node_manager& manager;
        std::optional<std::size_t> operator()(std::uint16_t, std::span<const std::byte> query,
                                              std::span<std::byte> body) const noexcept {
            jaus::query_configuration wanted{jaus::query_field::subsystem_configuration};
            if (!query.empty() && !wire::decode(wanted, query)) return std::nullopt;
            return manager.configuration(wanted.query_field, body);
        }
    };
    static constexpr double max_per_second = 10; ///< limits the load of the receiver
    static constexpr auto code = jaus::command_code_of<jaus::report_configuration>;

    filler fill_;
    std::array<std::byte, jaus::max_body_size> report_{};

  public:
    /// `answer` answers the queries of the core service.
    configuration_events(const jaus::address& self, const jaus::node_manager& manager, jaus::query_answer answer)
        : fill_{manager},
          part{self, answer, jaus::eventful_report{.command_code = code, .max_rate = max_per_second}, fill_} {}
    configuration_events(const configuration_events&) = delete;
    configuration_events& operator=(const configuration_events&) = delete;

    /// Call when a component of the subsystem has appeared or disappeared.
    void changed(time_point now, jaus::message_sink out) {
        if (const auto size = fill_(code, {}, report_))
            part.changed(code, std::span<const std::byte>{report_}.first(*size), now, out);
    }

    core_subscriptions part;
};

} // namespace jauscat::net::detail
