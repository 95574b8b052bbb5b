// A message of an SAE service: written, shown, and read as a peer of either version sends it.
// [includes]
#include <jauscat/schema/sae/message_id.hpp>
#include <jauscat/schema/sae/mobility/primitive_driver.hpp>
#include <jauscat/schema/sae/versions.hpp>
#include <jauscat/text/annotate.hpp>
#include <jauscat/text/print.hpp>
#include <jauscat/wire/wire.hpp>

#include <array>
#include <iostream>

namespace sae = jauscat::sae;
namespace mobility = jauscat::sae::mobility;
namespace text = jauscat::text;
namespace wire = jauscat::wire;
// [includes end]

int main() {
    // [use]
    const mobility::set_wrench_effort command{.propulsive_linear_effort_x = 50, .resistive_linear_effort_x = 0};
    std::array<std::byte, wire::max_size<mobility::set_wrench_effort>> buffer{};
    const auto payload = wire::encode(command, buffer);
    if (!payload) return std::cerr << describe(payload.error()) << '\n', 1;
    std::cout << text::annotate<mobility::set_wrench_effort>(*payload);
    // [use end]

    // [version]
    using messages = mobility::services::primitive_driver::messages;
    const auto print = [](std::span<const std::byte> received, sae::service_version version) {
        const auto message_id = sae::message_id_of(received);
        return message_id && sae::with_message(messages{}, version, *message_id, [&]<class Message>() {
                   Message message{};
                   if (const auto used = wire::decode(message, received))
                       std::cout << wire::type_name<Message>() << '\n' << text::to_text(message);
                   else
                       std::cout << text::to_text(wire::diagnose<Message>(received)) << '\n';
               });
    };
    // [version end]
    for (const std::size_t size : {payload->size(), payload->size() - 1})
        if (!print(payload->first(size), sae::service_version::v1_0)) std::cout << "no message of this service\n";
}
