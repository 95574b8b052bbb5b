// Bits of presence vectors that stand for no field. Some peers set all bits.
#pragma once
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/event.hpp>
#include <jauscat/wire/decode.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <ranges>
#include <span>

namespace jauscat::jaus {

/// Where a message of RA 3.3 has a presence vector, or a query that of the report it asks for.
struct presence_vector_place {
    std::uint16_t command_code{}; ///< of the message
    std::uint8_t offset{};        ///< bytes of the body before the vector
    std::uint8_t size{};          ///< bytes of the vector
    std::uint32_t fields{};       ///< bits that stand for a field
};

/// All of them, by command code. Two vectors are left out because their bits are not all known: that of Query Mission
/// Status, and in Query Vector Knowledge Store Objects that of the report, which is behind the message's own.
inline constexpr std::array presence_vectors = std::to_array<presence_vector_place>({
    // clang-format off
    {0x0011, 0, 1, 0x3}, // set_time
    {0x01F0, 0, 1, 0xFF}, // create_event
    {0x01F1, 0, 1, 0xFF}, // update_event
    {0x01F2, 0, 1, 0x3}, // cancel_event
    {0x01F3, 0, 1, 0x1}, // confirm_event_request
    {0x01F4, 0, 1, 0x1}, // reject_event_request
    {0x0404, 0, 2, 0x1FF}, // set_velocity_state
    {0x0405, 0, 2, 0xFFF}, // set_wrench_effort
    {0x0406, 0, 1, 0xF}, // set_discrete_devices
    {0x0407, 0, 1, 0x1F}, // set_global_vector
    {0x040C, 0, 1, 0xF}, // set_global_waypoint
    {0x040D, 0, 1, 0xF}, // set_local_waypoint
    {0x040F, 0, 1, 0x3}, // set_global_path_segment
    {0x0410, 0, 1, 0x3}, // set_local_path_segment
    {0x0801, 0, 1, 0x3F}, // set_camera_pose
    {0x0805, 0, 2, 0x7FF}, // set_camera_capabilities
    {0x0806, 0, 1, 0x7}, // set_camera_format_options
    {0x0A20, 0, 1, 0x1}, // create_vector_knowledge_store_objects
    {0x0A25, 0, 1, 0x7F}, // delete_vector_knowledge_store_objects
    {0x2011, 0, 1, 0x3}, // query_time
    {0x21F0, 0, 1, 0x7}, // query_events
    {0x2400, 0, 4, 0x1FFFFF}, // query_platform_specifications
    {0x2401, 0, 1, 0x1F}, // query_platform_operational_data
    {0x2402, 0, 2, 0x1FF}, // query_global_pose
    {0x2403, 0, 2, 0x1FF}, // query_local_pose
    {0x2404, 0, 2, 0x1FF}, // query_velocity_state
    {0x2405, 0, 2, 0xFFF}, // query_wrench_effort
    {0x2406, 0, 1, 0xF}, // query_discrete_devices
    {0x2407, 0, 1, 0x1F}, // query_global_vector
    {0x240F, 2, 1, 0x3}, // query_global_path_segment
    {0x2410, 2, 1, 0x3}, // query_local_path_segment
    {0x2800, 0, 2, 0x3FF}, // query_camera_pose
    {0x2802, 0, 1, 0xFF}, // query_relative_object_position
    {0x2805, 0, 2, 0x7FFF}, // query_camera_capabilities
    {0x2806, 0, 1, 0x7F}, // query_camera_format_options
    {0x2A23, 0, 1, 0x7F}, // query_vector_knowledge_store_objects
    {0x4011, 0, 1, 0x3}, // report_time
    {0x4400, 0, 4, 0x1FFFFF}, // report_platform_specifications
    {0x4401, 0, 1, 0x1F}, // report_platform_operational_data
    {0x4402, 0, 2, 0x1FF}, // report_global_pose
    {0x4403, 0, 2, 0x1FF}, // report_local_pose
    {0x4404, 0, 2, 0x1FF}, // report_velocity_state
    {0x4405, 0, 2, 0xFFF}, // report_wrench_effort
    {0x4406, 0, 1, 0xF}, // report_discrete_devices
    {0x4407, 0, 1, 0x1F}, // report_global_vector
    {0x440C, 0, 1, 0xF}, // report_global_waypoint
    {0x440D, 0, 1, 0xF}, // report_local_waypoint
    {0x440F, 0, 1, 0x3}, // report_global_path_segment
    {0x4410, 0, 1, 0x3}, // report_local_path_segment
    {0x4800, 0, 2, 0x3FF}, // report_camera_pose
    {0x4802, 0, 1, 0xFF}, // report_relative_object_position
    {0x4805, 0, 2, 0x7FFF}, // report_camera_capabilities
    {0x4806, 0, 1, 0x7F}, // report_camera_format_options
    {0x4A23, 0, 1, 0x1}, // report_vector_knowledge_store_objects
    {0x4D00, 0, 1, 0x1F}, // report_payload_interface
    // clang-format on
});

namespace detail {
/// The first place of this code, or of the next higher one.
[[nodiscard]] constexpr const presence_vector_place* first_vector(std::uint16_t command_code) noexcept {
    return std::ranges::lower_bound(presence_vectors, command_code, {}, &presence_vector_place::command_code);
}
[[nodiscard]] constexpr std::uint32_t bits_without_field(std::uint16_t command_code,
                                                         std::span<const std::byte> body) noexcept {
    const auto* const end = presence_vectors.data() + presence_vectors.size();
    for (const auto* place = first_vector(command_code); place != end && place->command_code == command_code; ++place) {
        if (body.size() < std::size_t{place->offset} + place->size) return 0;
        std::uint32_t vector = 0;
        for (std::size_t i = 0; i != place->size; ++i)
            vector |= std::to_integer<std::uint32_t>(body[place->offset + i]) << 8 * i;
        if ((vector & ~place->fields) != 0) return vector & ~place->fields;
    }
    return 0;
}
} // namespace detail

/// The bits of a message's presence vector that stand for no field, and are ignored; 0: none. Create Service Connection
/// has the vector of the report that it names, a request for an event that of its query, an event that of its report.
[[nodiscard]] constexpr std::uint32_t ignored_presence_bits(std::uint16_t command_code,
                                                            std::span<const std::byte> body) noexcept {
    if (const auto bits = detail::bits_without_field(command_code, body); bits != 0) return bits;
    const auto in = [&]<class T>(T message, auto bits_of) {
        return wire::decode(message, body) ? bits_of(message) : std::uint32_t{};
    };
    const auto of_query = [](const auto& request) {
        constexpr int from_report_to_query = 0x2000;
        return detail::bits_without_field(static_cast<std::uint16_t>(request.message_code - from_report_to_query),
                                          request.query_message_body.value_or(wire::blob{}));
    };
    switch (command_code) {
    case command_code_of<create_service_connection>:
        return in(create_service_connection{}, [](const create_service_connection& request) {
            const auto* const of_report = detail::first_vector(request.command_code);
            return of_report != presence_vectors.data() + presence_vectors.size() &&
                           of_report->command_code == request.command_code
                       ? request.requested_presence_vector & ~of_report->fields
                       : 0;
        });
    case command_code_of<create_event>: return in(create_event{}, of_query);
    case command_code_of<update_event>: return in(update_event{}, of_query);
    case command_code_of<event>:
        return in(event{}, [](const event& sent) {
            return detail::bits_without_field(sent.message_code, sent.report_message_body);
        });
    default: return 0;
    }
}

} // namespace jauscat::jaus
