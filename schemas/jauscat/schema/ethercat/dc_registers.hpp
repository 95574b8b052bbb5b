// Registers of a slave's distributed clock (0x0900 to 0x09FF): addresses and layouts. ETG.1000.4, clause 6;
// ET1100 data sheet, section II.
#pragma once

#include <jauscat/schema/ethercat/esc_registers.hpp>
#include <jauscat/wire/array.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>

// One line per field, as in the standard's tables.
// clang-format off
namespace jauscat::ethercat {

/// Size of the times of a slave's clock.
enum class clock_width : std::uint8_t { no_clock, bits_32, bits_64 };

struct dc_receive_times;
struct dc_time;
struct dc_time_32;
struct dc_offset;
struct dc_nanoseconds;
struct dc_difference;
struct dc_speed_difference;
struct dc_filters;
struct dc_receive_latch_mode;
struct dc_cyclic_control;
struct dc_activation;
struct dc_activation_status;
struct dc_sync_status;
struct dc_latch_control;
struct dc_latch_status;

/// By address. A clock of 32 bits has only the low half of a register of 8 bytes: see low_half.
namespace esc_registers {
inline constexpr esc_register distributed_clock{0x0900, 0x0100}; ///< all of them
/// Any write that begins here makes each port store the local time at which its frame has begun.
inline constexpr esc_register_of<ethercat::dc_receive_times> dc_receive_times{{0x0900, 16}};
/// Read: the reference clock's time when the frame began to pass. Written: what the slave compares its time with.
inline constexpr esc_register_of<dc_time> dc_system_time{{0x0910, 8}};
/// Local time of the last write to dc_receive_times, when its frame came to the processing unit.
inline constexpr esc_register_of<dc_time> dc_processing_time{{0x0918, 8}};
inline constexpr esc_register_of<ethercat::dc_offset> dc_offset{{0x0920, 8}}; ///< added to the local time
inline constexpr esc_register_of<dc_nanoseconds> dc_delay{{0x0928, 4}};       ///< of a frame from the reference clock
inline constexpr esc_register_of<ethercat::dc_difference> dc_difference{{0x092C, 4}}; ///< mean, from the reference
inline constexpr esc_register_of<esc_word> dc_speed_start{{0x0930, 2}}; ///< bandwidth; a write restarts the control
inline constexpr esc_register_of<ethercat::dc_speed_difference> dc_speed_difference{{0x0932, 2}}; ///< of the periods
inline constexpr esc_register_of<ethercat::dc_filters> dc_filters{{0x0934, 2}}; ///< in force from the next restart
inline constexpr esc_register_of<ethercat::dc_receive_latch_mode> dc_receive_latch_mode{{0x0936, 1}}; ///< ET1200 only
inline constexpr esc_register_of<ethercat::dc_cyclic_control> dc_cyclic_control{{0x0980, 1}}; ///< owner of the units
inline constexpr esc_register_of<ethercat::dc_activation> dc_activation{{0x0981, 1}};         ///< of the SYNC unit
inline constexpr esc_register_of<esc_word> dc_assign_activate{{0x0980, 2}}; ///< both of these: AssignActivate of an ESI
inline constexpr esc_register_of<esc_word> dc_pulse_length{{0x0982, 2}}; ///< in 10 ns; 0: until the slave acknowledges
inline constexpr esc_register_of<ethercat::dc_activation_status> dc_activation_status{{0x0984, 1}};
inline constexpr esc_register_of<dc_sync_status> dc_sync0_status{{0x098E, 1}};
inline constexpr esc_register_of<dc_sync_status> dc_sync1_status{{0x098F, 1}};
inline constexpr esc_register_of<dc_time> dc_start_time{{0x0990, 8}};         ///< system time of the first SYNC0
inline constexpr esc_register_of<dc_time> dc_next_sync1{{0x0998, 8}};         ///< its system time
inline constexpr esc_register_of<dc_nanoseconds> dc_sync0_cycle{{0x09A0, 4}}; ///< 0: SYNC0 comes once
inline constexpr esc_register_of<dc_nanoseconds> dc_sync1_cycle{{0x09A4, 4}}; ///< from SYNC0 to SYNC1; 0: together
inline constexpr esc_register_of<dc_latch_control> dc_latch0_control{{0x09A8, 1}};
inline constexpr esc_register_of<dc_latch_control> dc_latch1_control{{0x09A9, 1}};
inline constexpr esc_register_of<dc_latch_status> dc_latch0_status{{0x09AE, 1}};
inline constexpr esc_register_of<dc_latch_status> dc_latch1_status{{0x09AF, 1}};
inline constexpr esc_register_of<dc_time> dc_latch0_rise{{0x09B0, 8}}; ///< system time; a read clears the status
inline constexpr esc_register_of<dc_time> dc_latch0_fall{{0x09B8, 8}}; ///< system time; a read clears the status
inline constexpr esc_register_of<dc_time> dc_latch1_rise{{0x09C0, 8}}; ///< system time; a read clears the status
inline constexpr esc_register_of<dc_time> dc_latch1_fall{{0x09C8, 8}}; ///< system time; a read clears the status
inline constexpr esc_register_of<dc_nanoseconds> dc_buffer_change{{0x09F0, 4}};     ///< by the master; local time
inline constexpr esc_register_of<dc_nanoseconds> dc_pdi_buffer_start{{0x09F8, 4}};  ///< by the slave; local time
inline constexpr esc_register_of<dc_nanoseconds> dc_pdi_buffer_change{{0x09FC, 4}}; ///< by the slave; local time
} // namespace esc_registers

/// The low 4 bytes of a time: all that a clock of 32 bits has of it.
[[nodiscard]] constexpr esc_register_of<dc_time_32> low_half(const esc_register& time) noexcept {
    return {{time.address, 4}};
}

/// Local times at which a frame began to arrive at the ports, in ns; they wrap after 4.3 s.
struct dc_receive_times {
    std::array<std::uint32_t, 4> ports{}; ///< by port number

    struct schema : wire::items { using type = layout<array<&dc_receive_times::ports, u32le>>; };
};

/// A time in ns, as the local clock counts it, or since 2000-01-01 00:00 for a system time.
struct dc_time {
    std::uint64_t value{};

    struct schema : wire::items { using type = layout<field<&dc_time::value, u64le>>; };
};
/// The low half of a dc_time.
struct dc_time_32 {
    std::uint32_t value{};

    struct schema : wire::items { using type = layout<field<&dc_time_32::value, u32le>>; };
};

/// From the local time to the system time, in ns.
struct dc_offset {
    std::int64_t value{};

    struct schema : wire::items { using type = layout<field<&dc_offset::value, i64le>>; };
};

/// A span of time, in ns.
struct dc_nanoseconds {
    std::uint32_t value{};

    struct schema : wire::items { using type = layout<field<&dc_nanoseconds::value, u32le>>; };
};

/// Difference between the slave's time and the one it received, in ns: not in two's complement.
struct dc_difference {
    std::uint32_t magnitude{}; ///< up to 7FFFFFFFh
    bool behind{};             ///< the slave's time is the smaller one

    /// As a signed number of ns.
    [[nodiscard]] constexpr std::int32_t value() const noexcept {
        const auto size = static_cast<std::int32_t>(magnitude & 0x7FFFFFFF);
        return behind ? -size : size;
    }
    /// From a signed number of ns.
    [[nodiscard]] static constexpr dc_difference of(std::int32_t ns) noexcept {
        if (ns >= 0) return {static_cast<std::uint32_t>(ns), false};
        return {ns == INT32_MIN ? 0x7FFFFFFFu : static_cast<std::uint32_t>(-ns), true};
    }

    struct schema : wire::items {
        using T = dc_difference;
        using type = layout<
            bit_fields<u32le,
                bit_field<&T::magnitude, 31>,
                bit_field<&T::behind, 1>>>;
    };
};

/// Deviation of the local clock's period from that of the reference clock. Its unit depends on dc_speed_start `s`:
/// a value d changes the speed by d / (5 (s + d + 2) (s - d + 2)).
struct dc_speed_difference {
    std::int16_t value{};

    struct schema : wire::items { using type = layout<field<&dc_speed_difference::value, i16le>>; };
};

/// Depths of the filters of the control.
struct dc_filters {
    std::uint8_t difference{}; ///< of dc_difference
    std::uint8_t speed{};      ///< of dc_speed_difference

    struct schema : wire::items {
        using T = dc_filters;
        using type = layout<
            field<&T::difference, u8>,
            field<&T::speed, u8>>;
    };
};

struct dc_receive_latch_mode {
    bool reverse{}; ///< frames enter at another port than 0

    struct schema : wire::items {
        using T = dc_receive_latch_mode;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::reverse, 1>,
                reserved<7>>>;
    };
};

/// Owners of the SYNC and latch units: the slave's application, or the master where false.
struct dc_cyclic_control {
    bool sync_by_pdi{};
    bool latch0_by_pdi{};
    bool latch1_by_pdi{};

    struct schema : wire::items {
        using T = dc_cyclic_control;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::sync_by_pdi, 1>,
                reserved<3>,
                bit_field<&T::latch0_by_pdi, 1>,
                bit_field<&T::latch1_by_pdi, 1>,
                reserved<2>>>;
    };
};

/// What of the SYNC unit is on.
struct dc_activation {
    bool on{};                ///< the unit
    bool sync0{};             ///< it makes SYNC0
    bool sync1{};             ///< it makes SYNC1
    bool on_by_start_time{};  ///< a write of the start time sets `on`
    bool extend_start{};      ///< a start time of 4 bytes is extended to 8
    bool check_start{};       ///< a start time that is not in the near future begins at once
    bool near_future_short{}; ///< the near future is 2.1 s, else half the range of the time
    bool test_pulse{};        ///< one pulse on the signals that are on

    struct schema : wire::items {
        using T = dc_activation;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::on, 1>,
                bit_field<&T::sync0, 1>,
                bit_field<&T::sync1, 1>,
                bit_field<&T::on_by_start_time, 1>,
                bit_field<&T::extend_start, 1>,
                bit_field<&T::check_start, 1>,
                bit_field<&T::near_future_short, 1>,
                bit_field<&T::test_pulse, 1>>>;
    };
};

struct dc_activation_status {
    bool sync0_pending{};  ///< the first SYNC0 has not come yet
    bool sync1_pending{};  ///< the first SYNC1 has not come yet
    bool start_not_near{}; ///< the start time was not in the near future when the unit was switched on

    struct schema : wire::items {
        using T = dc_activation_status;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::sync0_pending, 1>,
                bit_field<&T::sync1_pending, 1>,
                bit_field<&T::start_not_near, 1>,
                reserved<5>>>;
    };
};

/// State of a SYNC signal, for the slave to acknowledge where the pulse length is 0.
struct dc_sync_status {
    bool active{};

    struct schema : wire::items {
        using T = dc_sync_status;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::active, 1>,
                reserved<7>>>;
    };
};

/// Whether a latch takes the first event of a kind only, until it is read; else each one.
struct dc_latch_control {
    bool first_rise{};
    bool first_fall{};

    struct schema : wire::items {
        using T = dc_latch_control;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::first_rise, 1>,
                bit_field<&T::first_fall, 1>,
                reserved<6>>>;
    };
};

/// Events that a latch holds.
struct dc_latch_status {
    bool rise{};
    bool fall{};
    bool pin{}; ///< its level

    struct schema : wire::items {
        using T = dc_latch_status;
        using type = layout<
            bit_fields<u8,
                bit_field<&T::rise, 1>,
                bit_field<&T::fall, 1>,
                bit_field<&T::pin, 1>,
                reserved<5>>>;
    };
};

} // namespace jauscat::ethercat
