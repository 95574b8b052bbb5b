// The functions of supersede.
#pragma once
#include <jauscat/bridge/supersede.hpp>

namespace jauscat::bridging {

JAUSCAT_CONSTEXPR bool is_superseding(std::uint16_t command_code) noexcept {
    return std::ranges::find(superseding_commands, command_code) != superseding_commands.end();
}

JAUSCAT_CONSTEXPR std::optional<std::size_t> merge(std::uint16_t command_code, std::span<const std::byte> older,
                                                   std::span<const std::byte> newer,
                                                   std::span<std::byte> out) noexcept {
    switch (command_code) {
    case jaus::command_code_of<jaus::set_wrench_effort>:
        return detail::merge_fields<jaus::set_wrench_effort>(older, newer, out);
    case jaus::command_code_of<jaus::set_global_vector>:
        return detail::merge_fields<jaus::set_global_vector>(older, newer, out);
    case jaus::command_code_of<jaus::set_local_vector>:
        return detail::merge_fields<jaus::set_local_vector>(older, newer, out);
    case jaus::command_code_of<jaus::set_camera_pose>:
        return detail::merge_fields<jaus::set_camera_pose>(older, newer, out);
    default: // all fields are mandatory
        if (newer.size() > out.size()) return std::nullopt;
        std::ranges::copy(newer, out.begin());
        return newer.size();
    }
}

} // namespace jauscat::bridging
