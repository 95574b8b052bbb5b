// Text for the error codes of drives, object 603Fh and CoE emergencies (IEC 61800-7-201, annex).
#pragma once
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string_view>

namespace jauscat::cia402 {

namespace detail {

struct error_text {
    std::uint16_t code;
    std::string_view text;
};

inline constexpr error_text error_texts[]{
    {0x0000, "no error"},
    {0x1000, "generic error"},
    {0x2000, "current"},
    {0x2100, "current, device input side"},
    {0x2110, "short circuit or earth leakage, device input side"},
    {0x2120, "earth leakage, device input side"},
    {0x2130, "short circuit, device input side"},
    {0x2200, "current inside the device"},
    {0x2210, "over current inside the device"},
    {0x2220, "continuous over current inside the device"},
    {0x2230, "short circuit or earth leakage inside the device"},
    {0x2240, "earth leakage inside the device"},
    {0x2250, "short circuit inside the device"},
    {0x2300, "current, device output side"},
    {0x2310, "continuous over current, device output side"},
    {0x2320, "short circuit or earth leakage, device output side"},
    {0x2330, "earth leakage, device output side"},
    {0x2340, "short circuit, device output side"},
    {0x3000, "voltage"},
    {0x3100, "mains voltage"},
    {0x3110, "mains over-voltage"},
    {0x3120, "mains under-voltage"},
    {0x3130, "mains phase failure"},
    {0x3140, "mains frequency"},
    {0x3200, "DC link voltage"},
    {0x3210, "DC link over-voltage"},
    {0x3220, "DC link under-voltage"},
    {0x3230, "load error"},
    {0x3300, "output voltage"},
    {0x3310, "output over-voltage"},
    {0x3320, "armature circuit"},
    {0x3330, "field circuit"},
    {0x4000, "temperature"},
    {0x4100, "ambient temperature"},
    {0x4110, "ambient temperature too high"},
    {0x4120, "ambient temperature too low"},
    {0x4200, "device temperature"},
    {0x4210, "device temperature too high"},
    {0x4220, "device temperature too low"},
    {0x4300, "drive temperature"},
    {0x4310, "drive temperature too high"},
    {0x4320, "drive temperature too low"},
    {0x4400, "supply temperature"},
    {0x4410, "supply temperature too high"},
    {0x4420, "supply temperature too low"},
    {0x5000, "device hardware"},
    {0x5100, "supply of the device"},
    {0x5110, "supply, low voltage"},
    {0x5120, "supply of the intermediate circuit"},
    {0x5200, "control hardware"},
    {0x5300, "operating unit"},
    {0x5400, "power section"},
    {0x5410, "output stages"},
    {0x5420, "chopper"},
    {0x5430, "input stages"},
    {0x5440, "contactor"},
    {0x5450, "fuse"},
    {0x5500, "data storage"},
    {0x5510, "working memory"},
    {0x5520, "program memory"},
    {0x5530, "non-volatile data memory"},
    {0x6000, "device software"},
    {0x6010, "software reset by the watchdog"},
    {0x6100, "internal software"},
    {0x6200, "user software"},
    {0x6300, "data record"},
    {0x6310, "loss of parameters"},
    {0x6320, "parameter error"},
    {0x7000, "additional modules"},
    {0x7100, "power module"},
    {0x7110, "brake chopper"},
    {0x7120, "motor"},
    {0x7121, "motor blocked"},
    {0x7122, "motor error, or wrong commutation"},
    {0x7123, "motor tilted"},
    {0x7200, "measurement circuit"},
    {0x7300, "sensor"},
    {0x7310, "speed sensor"},
    {0x7320, "position sensor"},
    {0x7400, "computation circuit"},
    {0x7500, "communication module"},
    {0x7600, "external data storage"},
    {0x8000, "monitoring"},
    {0x8100, "communication"},
    {0x8130, "node guarding, or heartbeat"},
    {0x8200, "protocol error"},
    {0x8210, "PDO not processed: wrong length"},
    {0x8300, "torque control"},
    {0x8311, "excess torque"},
    {0x8312, "difficult start-up"},
    {0x8313, "standstill torque"},
    {0x8321, "insufficient torque"},
    {0x8331, "torque fault"},
    {0x8400, "velocity controller"},
    {0x8500, "position controller"},
    {0x8600, "positioning controller"},
    {0x8611, "following error"},
    {0x8612, "reference limit"},
    {0x8700, "synchronisation controller"},
    {0x8800, "winding controller"},
    {0x8900, "process data monitoring"},
    {0x8A00, "control monitoring"},
    {0x9000, "external error"},
    {0xF000, "additional functions"},
    {0xFF00, "manufacturer-specific"},
};

} // namespace detail

/// The text of the code, or of the group that it is in; print the number beside it.
[[nodiscard]] constexpr std::string_view describe_error_code(std::uint16_t code) noexcept {
    for (const unsigned digits : {0xFFFFU, 0xFFF0U, 0xFF00U, 0xF000U}) {
        const auto group = static_cast<std::uint16_t>(code & digits);
        if (group == 0 && code != 0) break;
        const auto* const found = std::ranges::find(detail::error_texts, group, &detail::error_text::code);
        if (found != std::end(detail::error_texts)) return found->text;
    }
    return "unknown error code";
}

} // namespace jauscat::cia402
