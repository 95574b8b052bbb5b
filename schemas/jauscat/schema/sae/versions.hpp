// Versions 1.0 and 1.1 of SAE core and mobility: which messages version 1.0 lacks, and which have other bytes there.
#pragma once
#include <jauscat/schema/jaus/message_list.hpp>
#include <jauscat/schema/sae/core.hpp>
#include <jauscat/schema/sae/mobility.hpp>
#include <jauscat/schema/sae_1_0/mobility.hpp>

#include <cstdint>
#include <type_traits>

namespace jauscat::sae {

/// Version of a service, as a peer names it in ReportServices.
enum class service_version : std::uint8_t { v1_0, v1_1 };

namespace detail {
template <class Message, class... Messages> constexpr bool is_listed(jaus::message_list<Messages...>) noexcept {
    return (std::is_same_v<Message, Messages> || ...);
}
/// Messages that came with version 1.1 of core, in services that 1.0 has, too.
using new_in_core_1_1 =
    jaus::message_list<core::query_service_list, core::report_service_list, core::create_command_event,
                       core::query_event_timeout, core::report_event_timeout, core::command_event>;
template <class Message> struct of_1_0 {
    using type = Message;
};
template <> struct of_1_0<mobility::set_local_vector> {
    using type = sae_1_0::mobility::set_local_vector;
};
template <> struct of_1_0<mobility::report_local_vector> {
    using type = sae_1_0::mobility::report_local_vector;
};
} // namespace detail

/// The type that version 1.0 has for a message of 1.1: another one where the bytes differ.
template <class Message> using in_1_0 = typename detail::of_1_0<Message>::type;

/// Whether version 1.0 is known to lack a message of 1.1: those of ListManager, and some of Discovery and Events.
template <class Message>
inline constexpr bool is_new_in_1_1 = detail::is_listed<Message>(detail::new_in_core_1_1{}) ||
                                      detail::is_listed<Message>(core::services::list_manager::messages{});

/// Calls `use.template operator()<Message>()` with the type that a peer of this version has for a message ID; false,
/// and no call, for an ID of no message of the list, or that version 1.0 lacks.
///
///     sae::with_message(sae::mobility::messages{}, sae::service_version::v1_0, id, [&]<class Message>() {
///         Message received{};
///         if (wire::decode(received, payload)) handle(received);
///     });
template <class... Messages>
constexpr bool with_message(jaus::message_list<Messages...>, service_version version, std::uint16_t message_id,
                            auto&& use) {
    const auto call = [&]<class Message>() {
        if (version == service_version::v1_1) {
            use.template operator()<Message>();
            return true;
        }
        if constexpr (is_new_in_1_1<Message>) {
            return false;
        } else {
            use.template operator()<in_1_0<Message>>();
            return true;
        }
    };
    return ((Messages::schema::message_id == message_id && call.template operator()<Messages>()) || ...);
}

} // namespace jauscat::sae
