// Why an axis fails or refuses a request.
#pragma once

#include <jauscat/schema/ethercat/cia402.hpp>

#include <cstdint>
#include <optional>
#include <string_view>

namespace jauscat::cia402 {

enum class axis_errc : std::uint8_t {
    ok,
    drive_fault,      ///< the drive reports a fault
    step_timeout,     ///< the drive does not take the next state in time
    enable_lost,      ///< the drive left operation enabled without a request
    mode_refused,     ///< the drive does not show the mode in time
    not_following,    ///< the drive does not follow its target in time (cyclic synchronous position, bit 12)
    not_acknowledged, ///< the drive does not take a set-point in time (profile position)
    not_reached,      ///< the motor does not get to the target in time
    homing_failed,    ///< the drive reports a homing error
    reset_refused,    ///< the fault is there after all attempts to reset it
    inputs_lost,      ///< the drive's inputs are not current
    not_enabled,      ///< request refused: the axis is not enabled
    wrong_mode,       ///< request refused: the mode has no such target
    has_failed,       ///< request refused: an error has to be reset first
};

/// The error with its detail.
struct axis_error {
    axis_errc code{};
    std::optional<cia402::state> state{}; ///< the drive's state then; nothing: its statusword stands for none
    std::uint16_t drive_code{};           ///< 603Fh, with `drive_fault`
    friend constexpr bool operator==(const axis_error&, const axis_error&) = default;
};

/// The error in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(axis_errc error) noexcept {
    switch (error) {
    case axis_errc::ok: return "ok";
    case axis_errc::drive_fault: return "drive fault: see its error code (603Fh)";
    case axis_errc::step_timeout: return "timeout: the drive does not take the next state";
    case axis_errc::enable_lost: return "the drive left operation enabled without a request";
    case axis_errc::mode_refused: return "the drive does not take the mode of operation";
    case axis_errc::not_following: return "the drive does not follow its target position";
    case axis_errc::not_acknowledged: return "the drive does not acknowledge the set-point";
    case axis_errc::not_reached: return "the motor does not reach the target";
    case axis_errc::homing_failed: return "homing failed";
    case axis_errc::reset_refused: return "the fault is still there after all attempts to reset it";
    case axis_errc::inputs_lost: return "the drive's inputs are not current: it is not in OP or not reachable";
    case axis_errc::not_enabled: return "refused: the axis is not enabled";
    case axis_errc::wrong_mode: return "refused: the mode of operation has no such target";
    case axis_errc::has_failed: return "refused: the axis has failed, reset it first";
    }
    return "unknown error";
}

[[nodiscard]] constexpr std::string_view describe(const axis_error& error) noexcept { return describe(error.code); }

} // namespace jauscat::cia402
