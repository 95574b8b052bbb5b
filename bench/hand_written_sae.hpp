// Six messages of SAE JAUS, from the message ID on, read and written by hand: memcpy and constant offsets, for
// little-endian machines. It checks what the codec checks: lengths, ranges, value sets, tags. Lists are in the
// library's arena. A size of zero says that the message was refused.
#pragma once
#include "hand_written.hpp"
#include <jauscat/schema/sae/core/discovery.hpp>
#include <jauscat/schema/sae/core/events.hpp>
#include <jauscat/schema/sae/core/management.hpp>
#include <jauscat/schema/sae/environment_sensing/still_image.hpp>
#include <jauscat/schema/sae/manipulator/manipulator_joint_force_torque_sensor.hpp>
#include <jauscat/schema/sae/mobility/primitive_driver.hpp>
#include <jauscat/wire/arena.hpp>

namespace hand_written::by_sae {

namespace sae = jauscat::sae;
using detail::load;
using detail::store;
using jauscat::wire::arena;

inline constexpr detail::scale<std::uint16_t, std::int32_t> effort{-100, 100};
inline constexpr detail::scale<std::uint8_t, std::int32_t> resistance{0, 100};
inline constexpr detail::scale<std::uint32_t, std::int64_t> torque{-1000, 1000}, force{-500, 500};

inline bool has_id(in_bytes in, std::uint16_t id) noexcept { return load<std::uint16_t>(in.data()) == id; }

// Plain: two fields.
inline std::size_t encode(const sae::core::report_status& m, out_bytes out) noexcept {
    if (static_cast<unsigned>(m.status) > 5 || out.size() < 7) return 0;
    store(out.data(), std::uint16_t{0x4002});
    store(out.data() + 2, m.status);
    store(out.data() + 3, m.reserved);
    return 7;
}
inline std::size_t decode(sae::core::report_status& m, in_bytes in, arena&) noexcept {
    if (in.size() != 7 || !has_id(in, 0x4002)) return 0;
    m.status = load<sae::core::status>(in.data() + 2);
    m.reserved = load<std::uint32_t>(in.data() + 3);
    return static_cast<unsigned>(m.status) > 5 ? 0 : 7;
}

// A presence vector; the rest is that of the RA's message.
inline std::size_t encode(const sae::mobility::set_wrench_effort& m, out_bytes out) noexcept {
    if (out.size() < 2) return 0;
    store(out.data(), std::uint16_t{0x0405});
    const std::size_t size = detail::encode_wrench<effort, resistance>(m, out.data() + 2, out.size() - 2);
    return size == 0 ? 0 : size + 2;
}
inline std::size_t decode(sae::mobility::set_wrench_effort& m, in_bytes in, arena&) noexcept {
    if (in.size() < 2 || !has_id(in, 0x0405)) return 0;
    const std::size_t size = detail::decode_wrench<effort, resistance>(m, in.data() + 2, in.size() - 2);
    return size == 0 ? 0 : size + 2;
}

// A list of lists.
inline std::size_t encode(const sae::core::query_services& m, out_bytes out) noexcept {
    std::size_t size = 3;
    for (const auto& node : m.node_list) size += 2 + node.component_list.size();
    if (m.node_list.empty() || m.node_list.size() > 255 || size > out.size()) return 0;
    std::byte* at = out.data();
    store(at, std::uint16_t{0x2B03});
    at[2] = static_cast<std::byte>(m.node_list.size());
    at += 3;
    for (const auto& node : m.node_list) {
        const std::size_t components = node.component_list.size();
        if (components == 0 || components > 255) return 0;
        at[0] = static_cast<std::byte>(node.node_rec.node_id);
        at[1] = static_cast<std::byte>(components);
        at += 2;
        for (const auto& component : node.component_list) *at++ = static_cast<std::byte>(component.component_id);
    }
    return size;
}
inline std::size_t decode(sae::core::query_services& m, in_bytes in, arena& memory) noexcept {
    if (in.size() < 3 || !has_id(in, 0x2B03)) return 0;
    const std::byte* at = in.data() + 2;
    const std::byte* const end = in.data() + in.size();
    const auto nodes = std::to_integer<std::size_t>(*at++);
    auto* const first = memory.allocate<sae::core::query_services_node_seq>(nodes);
    if (nodes == 0 || first == nullptr) return 0;
    for (std::size_t n = 0; n != nodes; ++n) {
        if (end - at < 2) return 0;
        first[n].node_rec.node_id = static_cast<sae::core::node_id>(at[0]);
        const auto components = std::to_integer<std::size_t>(at[1]);
        at += 2;
        if (components == 0 || static_cast<std::size_t>(end - at) < components) return 0;
        auto* const list = memory.allocate<sae::core::query_services_component_rec>(components);
        if (list == nullptr) return 0;
        for (std::size_t c = 0; c != components; ++c)
            list[c].component_id = static_cast<sae::core::component_id>(*at++);
        first[n].component_list = std::span<const sae::core::query_services_component_rec>{list, components};
    }
    m.node_list = std::span<const sae::core::query_services_node_seq>{first, nodes};
    return at == end ? in.size() : 0;
}

// A variant.
inline std::size_t encode(const sae::core::query_events& m, out_bytes out) noexcept {
    const std::size_t kind = m.query_events_var.index(), size = kind == 0 ? 5 : 4;
    if (out.size() < size) return 0;
    store(out.data(), std::uint16_t{0x21F0});
    out[2] = static_cast<std::byte>(kind);
    std::byte* const at = out.data() + 3;
    switch (kind) {
    case 0: store(at, std::get<0>(m.query_events_var).message_code); break;
    case 1: {
        const auto type = std::get<1>(m.query_events_var).event_type;
        if (static_cast<unsigned>(type) > 1) return 0;
        store(at, type);
        break;
    }
    case 2: store(at, std::get<2>(m.query_events_var).event_id); break;
    default:
        if (std::get<3>(m.query_events_var).all_events != 0) return 0;
        *at = std::byte{};
    }
    return size;
}
inline std::size_t decode(sae::core::query_events& m, in_bytes in, arena&) noexcept {
    if (in.size() < 4 || !has_id(in, 0x21F0)) return 0;
    const std::byte* const at = in.data() + 3;
    const auto kind = std::to_integer<unsigned>(in[2]);
    if (kind > 3 || in.size() != (kind == 0 ? 5U : 4U)) return 0;
    switch (kind) {
    case 0: m.query_events_var = sae::core::message_id_rec{load<std::uint16_t>(at)}; return 5;
    case 1:
        m.query_events_var = sae::core::event_type_rec{load<sae::core::event_type>(at)};
        return std::to_integer<unsigned>(*at) > 1 ? 0 : 4;
    case 2: m.query_events_var = sae::core::event_id_rec{load<std::uint8_t>(at)}; return 4;
    default: m.query_events_var = sae::core::all_events_rec{load<std::uint8_t>(at)}; return *at == std::byte{} ? 4 : 0;
    }
}

// Numbers whose scale an index selects.
inline std::size_t encode(const sae::manipulator::report_joint_force_torques& m, out_bytes out) noexcept {
    using form = sae::manipulator::joint_force_torque_form;
    const std::size_t joints = m.actuator_force_torque_list.size(), size = 3 + 5 * joints;
    if (joints > 255 || size > out.size()) return 0;
    std::byte* at = out.data();
    store(at, std::uint16_t{0x4605});
    at[2] = static_cast<std::byte>(joints);
    at += 3;
    for (const auto& joint : m.actuator_force_torque_list) {
        const auto& number = joint.joint_force_torque;
        store(at, number.index);
        const bool is_known = number.index == form::newton_meter || number.index == form::newton;
        if (!is_known || !(number.index == form::newton_meter ? torque : force).put(at + 1, number.value)) return 0;
        at += 5;
    }
    return size;
}
inline std::size_t decode(sae::manipulator::report_joint_force_torques& m, in_bytes in, arena& memory) noexcept {
    using form = sae::manipulator::joint_force_torque_form;
    if (in.size() < 3 || !has_id(in, 0x4605)) return 0;
    const auto joints = std::to_integer<std::size_t>(in[2]);
    if (in.size() != 3 + 5 * joints) return 0;
    auto* const first = memory.allocate<sae::manipulator::actuator_force_torque_rec>(joints);
    if (first == nullptr) return 0;
    const std::byte* at = in.data() + 3;
    for (std::size_t i = 0; i != joints; ++i, at += 5) {
        auto& number = first[i].joint_force_torque;
        number.index = load<form>(at);
        if (number.index != form::newton_meter && number.index != form::newton) return 0;
        static_cast<void>((number.index == form::newton_meter ? torque : force).get(number.value, at + 1));
    }
    m.actuator_force_torque_list = std::span<const sae::manipulator::actuator_force_torque_rec>{first, joints};
    return in.size();
}

// A blob: format, size, bytes.
inline std::size_t encode(const sae::environment_sensing::image_frame& m, out_bytes out) noexcept {
    if (static_cast<unsigned>(m.format) > 10 || m.data.size() > 2147483647 || out.size() < 5 + m.data.size()) return 0;
    store(out.data(), m.format);
    store(out.data() + 1, static_cast<std::uint32_t>(m.data.size()));
    if (!m.data.empty()) std::memcpy(out.data() + 5, m.data.data(), m.data.size());
    return 5 + m.data.size();
}
inline std::size_t decode(sae::environment_sensing::image_frame& m, in_bytes in, arena&) noexcept {
    if (in.size() < 5) return 0;
    m.format = load<sae::environment_sensing::image_frame_format>(in.data());
    const auto size = load<std::uint32_t>(in.data() + 1);
    if (size != in.size() - 5 || size > 2147483647 || static_cast<unsigned>(m.format) > 10) return 0;
    m.data = in.subspan(5);
    return in.size();
}

} // namespace hand_written::by_sae
