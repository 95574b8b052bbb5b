// The floor: the same messages, read and written by hand with memcpy, shifts and constant offsets, for little-endian
// machines. It checks what the codec checks (lengths, ranges, NaN, signed minima) and rounds the
// same way. A size of zero says that the message was refused.
#pragma once
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/schema/jaus/platform.hpp>

#include <bit>
#include <cstring>
#include <span>

namespace hand_written {

namespace jaus = jauscat::jaus;
using in_bytes = std::span<const std::byte>;
using out_bytes = std::span<std::byte>;

/// Set Wrench Effort with the integers on the wire.
struct raw_wrench_effort {
    std::optional<std::int16_t> propulsive_linear_effort_x{}, propulsive_linear_effort_y{},
        propulsive_linear_effort_z{}, propulsive_rotational_effort_x{}, propulsive_rotational_effort_y{},
        propulsive_rotational_effort_z{};
    std::optional<std::uint8_t> resistive_linear_effort_x{}, resistive_linear_effort_y{}, resistive_linear_effort_z{},
        resistive_rotational_effort_x{}, resistive_rotational_effort_y{}, resistive_rotational_effort_z{};
};

namespace detail {

inline void store(std::byte* out, auto value) noexcept { std::memcpy(out, &value, sizeof value); }
template <class T> T load(const std::byte* in) noexcept {
    T value;
    std::memcpy(&value, in, sizeof value);
    return value;
}

// One real value to its integer. Division, not multiplication by a reciprocal, which would miss ties.
template <class Raw, class Wide> struct scale {
    double min, max;
    static constexpr Wide top = static_cast<Wide>(std::numeric_limits<Raw>::max());
    static constexpr Wide bottom = std::is_signed_v<Raw> ? -top : Wide{0};
    static constexpr double steps = static_cast<double>(top - bottom);

    bool put(std::byte* out, double real) const noexcept {
        if (!(real >= min && real <= max)) return false;
        const double count = (real - min) * steps / (max - min) + 0.5;
        store(out, static_cast<Raw>(static_cast<Wide>(count) + bottom));
        return true;
    }
    template <class Optional> bool get(Optional& real, const std::byte* in) const noexcept {
        const Raw raw = load<Raw>(in);
        if constexpr (std::is_signed_v<Raw>) {
            if (raw == std::numeric_limits<Raw>::min()) return false;
        }
        const double span = (max - min) / steps, middle = std::is_signed_v<Raw> ? (max + min) / 2 : min;
        real = middle == 0 ? raw * span : raw * span + middle;
        return true;
    }
};
inline constexpr scale<std::int16_t, std::int32_t> effort{-100, 100}, angle{-jaus::pi, jaus::pi};
inline constexpr scale<std::uint8_t, std::int32_t> resistance{0, 100};
inline constexpr scale<std::uint16_t, std::int32_t> angle_error{0, jaus::pi};
inline constexpr scale<std::int32_t, std::int64_t> latitude{-90, 90}, longitude{-180, 180}, elevation{-10000, 35000};
inline constexpr scale<std::uint32_t, std::int64_t> position_error{0, 100};

// The integer itself, in the place of a scale.
struct plain {
    template <class T> bool put(std::byte* out, T value) const noexcept {
        store(out, value);
        return true;
    }
    template <class T> bool get(std::optional<T>& value, const std::byte* in) const noexcept {
        value = load<T>(in);
        return true;
    }
};
inline constexpr plain as_it_is{};

// Set bits of each number of six bits, and how many bytes the fields of a mask take.
inline constexpr auto set_bits = [] {
    std::array<std::uint8_t, 64> table{};
    for (unsigned i = 0; i != 64; ++i) table[i] = static_cast<std::uint8_t>(std::popcount(i));
    return table;
}();
inline std::size_t wrench_size(unsigned mask) noexcept {
    return 2u + 2u * set_bits[mask & 63] + set_bits[mask >> 6 & 63];
}
inline unsigned wrench_mask(const auto& m) noexcept {
    unsigned mask = 0, bit = 0;
    mask |= unsigned{m.propulsive_linear_effort_x.has_value()} << bit++;
    mask |= unsigned{m.propulsive_linear_effort_y.has_value()} << bit++;
    mask |= unsigned{m.propulsive_linear_effort_z.has_value()} << bit++;
    mask |= unsigned{m.propulsive_rotational_effort_x.has_value()} << bit++;
    mask |= unsigned{m.propulsive_rotational_effort_y.has_value()} << bit++;
    mask |= unsigned{m.propulsive_rotational_effort_z.has_value()} << bit++;
    mask |= unsigned{m.resistive_linear_effort_x.has_value()} << bit++;
    mask |= unsigned{m.resistive_linear_effort_y.has_value()} << bit++;
    mask |= unsigned{m.resistive_linear_effort_z.has_value()} << bit++;
    mask |= unsigned{m.resistive_rotational_effort_x.has_value()} << bit++;
    mask |= unsigned{m.resistive_rotational_effort_y.has_value()} << bit++;
    mask |= unsigned{m.resistive_rotational_effort_z.has_value()} << bit++;
    return mask;
}

template <const auto& Effort, const auto& Resistance>
std::size_t encode_wrench(const auto& __restrict m, std::byte* __restrict out, std::size_t space) noexcept {
    if (space < 20 && space < wrench_size(wrench_mask(m))) return 0;
    unsigned mask = 0;
    std::byte* at = out + 2;
    if (m.propulsive_linear_effort_x) {
        if (!Effort.put(at, *m.propulsive_linear_effort_x)) return 0;
        at += 2;
        mask |= 0x1;
    }
    if (m.propulsive_linear_effort_y) {
        if (!Effort.put(at, *m.propulsive_linear_effort_y)) return 0;
        at += 2;
        mask |= 0x2;
    }
    if (m.propulsive_linear_effort_z) {
        if (!Effort.put(at, *m.propulsive_linear_effort_z)) return 0;
        at += 2;
        mask |= 0x4;
    }
    if (m.propulsive_rotational_effort_x) {
        if (!Effort.put(at, *m.propulsive_rotational_effort_x)) return 0;
        at += 2;
        mask |= 0x8;
    }
    if (m.propulsive_rotational_effort_y) {
        if (!Effort.put(at, *m.propulsive_rotational_effort_y)) return 0;
        at += 2;
        mask |= 0x10;
    }
    if (m.propulsive_rotational_effort_z) {
        if (!Effort.put(at, *m.propulsive_rotational_effort_z)) return 0;
        at += 2;
        mask |= 0x20;
    }
    if (m.resistive_linear_effort_x) {
        if (!Resistance.put(at, *m.resistive_linear_effort_x)) return 0;
        at += 1;
        mask |= 0x40;
    }
    if (m.resistive_linear_effort_y) {
        if (!Resistance.put(at, *m.resistive_linear_effort_y)) return 0;
        at += 1;
        mask |= 0x80;
    }
    if (m.resistive_linear_effort_z) {
        if (!Resistance.put(at, *m.resistive_linear_effort_z)) return 0;
        at += 1;
        mask |= 0x100;
    }
    if (m.resistive_rotational_effort_x) {
        if (!Resistance.put(at, *m.resistive_rotational_effort_x)) return 0;
        at += 1;
        mask |= 0x200;
    }
    if (m.resistive_rotational_effort_y) {
        if (!Resistance.put(at, *m.resistive_rotational_effort_y)) return 0;
        at += 1;
        mask |= 0x400;
    }
    if (m.resistive_rotational_effort_z) {
        if (!Resistance.put(at, *m.resistive_rotational_effort_z)) return 0;
        at += 1;
        mask |= 0x800;
    }
    store(out, static_cast<std::uint16_t>(mask));
    return static_cast<std::size_t>(at - out);
}

template <const auto& Effort, const auto& Resistance>
std::size_t decode_wrench(auto& __restrict m, const std::byte* __restrict in, std::size_t size) noexcept {
    if (size < 2) return 0;
    const unsigned mask = load<std::uint16_t>(in) & 0xFFF; // the other bits are ignored
    if (size != wrench_size(mask)) return 0;
    const std::byte* at = in + 2;
    if (mask & 0x1) {
        if (!Effort.get(m.propulsive_linear_effort_x, at)) return 0;
        at += 2;
    } else {
        m.propulsive_linear_effort_x.reset();
    }
    if (mask & 0x2) {
        if (!Effort.get(m.propulsive_linear_effort_y, at)) return 0;
        at += 2;
    } else {
        m.propulsive_linear_effort_y.reset();
    }
    if (mask & 0x4) {
        if (!Effort.get(m.propulsive_linear_effort_z, at)) return 0;
        at += 2;
    } else {
        m.propulsive_linear_effort_z.reset();
    }
    if (mask & 0x8) {
        if (!Effort.get(m.propulsive_rotational_effort_x, at)) return 0;
        at += 2;
    } else {
        m.propulsive_rotational_effort_x.reset();
    }
    if (mask & 0x10) {
        if (!Effort.get(m.propulsive_rotational_effort_y, at)) return 0;
        at += 2;
    } else {
        m.propulsive_rotational_effort_y.reset();
    }
    if (mask & 0x20) {
        if (!Effort.get(m.propulsive_rotational_effort_z, at)) return 0;
        at += 2;
    } else {
        m.propulsive_rotational_effort_z.reset();
    }
    if (mask & 0x40) {
        if (!Resistance.get(m.resistive_linear_effort_x, at)) return 0;
        at += 1;
    } else {
        m.resistive_linear_effort_x.reset();
    }
    if (mask & 0x80) {
        if (!Resistance.get(m.resistive_linear_effort_y, at)) return 0;
        at += 1;
    } else {
        m.resistive_linear_effort_y.reset();
    }
    if (mask & 0x100) {
        if (!Resistance.get(m.resistive_linear_effort_z, at)) return 0;
        at += 1;
    } else {
        m.resistive_linear_effort_z.reset();
    }
    if (mask & 0x200) {
        if (!Resistance.get(m.resistive_rotational_effort_x, at)) return 0;
        at += 1;
    } else {
        m.resistive_rotational_effort_x.reset();
    }
    if (mask & 0x400) {
        if (!Resistance.get(m.resistive_rotational_effort_y, at)) return 0;
        at += 1;
    } else {
        m.resistive_rotational_effort_y.reset();
    }
    if (mask & 0x800) {
        if (!Resistance.get(m.resistive_rotational_effort_z, at)) return 0;
        at += 1;
    } else {
        m.resistive_rotational_effort_z.reset();
    }
    return size;
}

} // namespace detail

inline std::size_t encode(const jaus::set_wrench_effort& message, out_bytes out) noexcept {
    return detail::encode_wrench<detail::effort, detail::resistance>(message, out.data(), out.size());
}
inline std::size_t decode(jaus::set_wrench_effort& message, in_bytes in) noexcept {
    return detail::decode_wrench<detail::effort, detail::resistance>(message, in.data(), in.size());
}
inline std::size_t encode(const raw_wrench_effort& message, out_bytes out) noexcept {
    return detail::encode_wrench<detail::as_it_is, detail::as_it_is>(message, out.data(), out.size());
}
inline std::size_t decode(raw_wrench_effort& message, in_bytes in) noexcept {
    return detail::decode_wrench<detail::as_it_is, detail::as_it_is>(message, in.data(), in.size());
}

inline std::size_t encode(const jaus::header& __restrict h, out_bytes bytes) noexcept {
    std::byte* __restrict out = bytes.data();
    if (bytes.size() < 16) return 0;
    const auto ack_nak = static_cast<unsigned>(h.ack_nak), data_flag = static_cast<unsigned>(h.data_flag);
    if ((h.priority >> 4 | ack_nak >> 2 | h.version >> 6 | h.reserved >> 2 | h.data_size >> 12 | data_flag >> 4) != 0)
        return 0;
    detail::store(out, static_cast<std::uint16_t>(h.priority | ack_nak << 4 | unsigned{h.service_connection} << 6 |
                                                  unsigned{h.experimental} << 7 | unsigned{h.version} << 8 |
                                                  unsigned{h.reserved} << 14));
    detail::store(out + 2, h.command_code);
    std::memcpy(out + 4, &h.destination, 4); // in memory as on the wire
    std::memcpy(out + 8, &h.source, 4);
    detail::store(out + 12, static_cast<std::uint16_t>(h.data_size | data_flag << 12));
    detail::store(out + 14, h.sequence_number);
    return 16;
}
inline std::size_t decode(jaus::header& __restrict h, in_bytes bytes) noexcept {
    const std::byte* __restrict in = bytes.data();
    if (bytes.size() != 16) return 0;
    const unsigned properties = detail::load<std::uint16_t>(in);
    h.priority = properties & 15;
    h.ack_nak = static_cast<jaus::ack_nak>(properties >> 4 & 3);
    h.service_connection = (properties >> 6 & 1) != 0;
    h.experimental = (properties >> 7 & 1) != 0;
    h.version = properties >> 8 & 63;
    h.reserved = static_cast<std::uint8_t>(properties >> 14);
    h.command_code = detail::load<std::uint16_t>(in + 2);
    std::memcpy(&h.destination, in + 4, 4);
    std::memcpy(&h.source, in + 8, 4);
    const unsigned control = detail::load<std::uint16_t>(in + 12);
    h.data_size = control & 0xFFF;
    h.data_flag = static_cast<jaus::data_flag>(control >> 12);
    h.sequence_number = detail::load<std::uint16_t>(in + 14);
    return 16;
}

namespace detail {
inline std::size_t pose_size(unsigned mask) noexcept {
    return 2u + 4u * set_bits[mask & 15] + 2u * set_bits[mask >> 4 & 15] + 4u * (mask >> 8 & 1);
}
} // namespace detail

inline std::size_t encode(const jaus::report_global_pose& __restrict m, out_bytes bytes) noexcept {
    using namespace detail;
    std::byte* __restrict out = bytes.data();
    if (bytes.size() < 30) {
        unsigned present = 0, bit = 0;
        present |= unsigned{m.latitude.has_value()} << bit++;
        present |= unsigned{m.longitude.has_value()} << bit++;
        present |= unsigned{m.elevation.has_value()} << bit++;
        present |= unsigned{m.position_rms.has_value()} << bit++;
        present |= unsigned{m.roll.has_value()} << bit++;
        present |= unsigned{m.pitch.has_value()} << bit++;
        present |= unsigned{m.yaw.has_value()} << bit++;
        present |= unsigned{m.attitude_rms.has_value()} << bit++;
        present |= unsigned{m.time_stamp.has_value()} << bit++;
        if (bytes.size() < pose_size(present)) return 0;
    }
    unsigned mask = 0;
    std::byte* at = out + 2;
    if (m.latitude) {
        if (!latitude.put(at, *m.latitude)) return 0;
        at += 4;
        mask |= 0x1;
    }
    if (m.longitude) {
        if (!longitude.put(at, *m.longitude)) return 0;
        at += 4;
        mask |= 0x2;
    }
    if (m.elevation) {
        if (!elevation.put(at, *m.elevation)) return 0;
        at += 4;
        mask |= 0x4;
    }
    if (m.position_rms) {
        if (!position_error.put(at, *m.position_rms)) return 0;
        at += 4;
        mask |= 0x8;
    }
    if (m.roll) {
        if (!angle.put(at, *m.roll)) return 0;
        at += 2;
        mask |= 0x10;
    }
    if (m.pitch) {
        if (!angle.put(at, *m.pitch)) return 0;
        at += 2;
        mask |= 0x20;
    }
    if (m.yaw) {
        if (!angle.put(at, *m.yaw)) return 0;
        at += 2;
        mask |= 0x40;
    }
    if (m.attitude_rms) {
        if (!angle_error.put(at, *m.attitude_rms)) return 0;
        at += 2;
        mask |= 0x80;
    }
    if (m.time_stamp) {
        const auto& t = *m.time_stamp;
        if ((t.milliseconds >> 10 | t.seconds >> 6 | t.minutes >> 6 | t.hours >> 5 | t.day >> 5) != 0) return 0;
        store(at, std::uint32_t{t.milliseconds} | std::uint32_t{t.seconds} << 10 | std::uint32_t{t.minutes} << 16 |
                      std::uint32_t{t.hours} << 22 | std::uint32_t{t.day} << 27);
        at += 4;
        mask |= 0x100;
    }
    store(out, static_cast<std::uint16_t>(mask));
    return static_cast<std::size_t>(at - out);
}
/// As in the schema, unknown presence bits are tolerated, and then so are bytes behind the known fields.
inline std::size_t decode(jaus::report_global_pose& __restrict m, in_bytes bytes) noexcept {
    using namespace detail;
    const std::byte* __restrict in = bytes.data();
    if (bytes.size() < 2) return 0;
    const unsigned mask = load<std::uint16_t>(in);
    const auto size = pose_size(mask);
    if (bytes.size() < size || (bytes.size() > size && mask <= 0x1FF)) return 0;
    const std::byte* at = in + 2;
    if (mask & 0x1) {
        if (!latitude.get(m.latitude, at)) return 0;
        at += 4;
    } else {
        m.latitude.reset();
    }
    if (mask & 0x2) {
        if (!longitude.get(m.longitude, at)) return 0;
        at += 4;
    } else {
        m.longitude.reset();
    }
    if (mask & 0x4) {
        if (!elevation.get(m.elevation, at)) return 0;
        at += 4;
    } else {
        m.elevation.reset();
    }
    if (mask & 0x8) {
        if (!position_error.get(m.position_rms, at)) return 0;
        at += 4;
    } else {
        m.position_rms.reset();
    }
    if (mask & 0x10) {
        if (!angle.get(m.roll, at)) return 0;
        at += 2;
    } else {
        m.roll.reset();
    }
    if (mask & 0x20) {
        if (!angle.get(m.pitch, at)) return 0;
        at += 2;
    } else {
        m.pitch.reset();
    }
    if (mask & 0x40) {
        if (!angle.get(m.yaw, at)) return 0;
        at += 2;
    } else {
        m.yaw.reset();
    }
    if (mask & 0x80) {
        if (!angle_error.get(m.attitude_rms, at)) return 0;
        at += 2;
    } else {
        m.attitude_rms.reset();
    }
    if (mask & 0x100) {
        const auto word = load<std::uint32_t>(at);
        m.time_stamp = jaus::time_stamp{.milliseconds = static_cast<std::uint16_t>(word & 0x3FF),
                                        .seconds = static_cast<std::uint8_t>(word >> 10 & 63),
                                        .minutes = static_cast<std::uint8_t>(word >> 16 & 63),
                                        .hours = static_cast<std::uint8_t>(word >> 22 & 31),
                                        .day = static_cast<std::uint8_t>(word >> 27)};
    } else {
        m.time_stamp.reset();
    }
    return bytes.size();
}

} // namespace hand_written
