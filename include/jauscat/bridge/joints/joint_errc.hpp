// Why a group of joints refuses a message.
#pragma once
#include <cstdint>
#include <string_view>

namespace jauscat::bridging {

enum class joint_errc : std::uint8_t {
    ok,
    unknown_message, ///< no joint message, or one that the process data do not serve
    malformed,       ///< truncated, or a value that is not legal
    wrong_count,     ///< the message has another number of joints
    in_emergency,    ///< a command in an emergency
    has_failed,      ///< a command while an axis has failed
    not_current,     ///< a report without current feedback of an axis
    no_space,        ///< the buffer is too small for the report
};

[[nodiscard]] constexpr std::string_view describe(joint_errc error) noexcept {
    switch (error) {
    case joint_errc::ok: return "ok";
    case joint_errc::unknown_message: return "no joint message";
    case joint_errc::malformed: return "malformed joint message";
    case joint_errc::wrong_count: return "the message has another number of joints than the arm";
    case joint_errc::in_emergency: return "refused: emergency";
    case joint_errc::has_failed: return "refused: an axis has failed, reset it first";
    case joint_errc::not_current: return "no current feedback of an axis";
    case joint_errc::no_space: return "the buffer is too small for the report";
    }
    return "unknown error";
}

} // namespace jauscat::bridging
