// The same node written by hand, in a fast and readable style: headers and messages are structs with named members,
// every field is stored and loaded by a line of its own, no library. The reference for JausCat's code size.
#pragma once
#include "by_hand.hpp"

#include <bit>
#include <span>

namespace by_hand {

struct header {
    uint8_t priority, ack_nak, service_connection, experimental, version, reserved;
    uint16_t command_code;
    uint32_t destination, source; // as on the wire: instance lowest
    uint16_t data_size;
    uint8_t data_flag;
    uint16_t sequence_number;
};

inline void load_header(header& head, const uint8_t* in) {
    const uint32_t properties = load16(in);
    head.priority = properties & 15;
    head.ack_nak = properties >> 4 & 3;
    head.service_connection = properties >> 6 & 1;
    head.experimental = properties >> 7 & 1;
    head.version = properties >> 8 & 63;
    head.reserved = static_cast<uint8_t>(properties >> 14);
    head.command_code = load16(in + 2);
    std::memcpy(&head.destination, in + 4, 4);
    std::memcpy(&head.source, in + 8, 4);
    const uint32_t control = load16(in + 12);
    head.data_size = control & 0xFFF;
    head.data_flag = static_cast<uint8_t>(control >> 12);
    head.sequence_number = load16(in + 14);
}
inline void store_header(const header& head, uint8_t* out) {
    store16(out, (head.priority & 15u) | (head.ack_nak & 3u) << 4 | (head.service_connection & 1u) << 6 |
                     (head.experimental & 1u) << 7 | (head.version & 63u) << 8 | (head.reserved & 3u) << 14);
    store16(out + 2, head.command_code);
    store32(out + 4, head.destination);
    store32(out + 8, head.source);
    store16(out + 12, (head.data_size & 0xFFFu) | (head.data_flag & 15u) << 12);
    store16(out + 14, head.sequence_number);
}

/// Efforts as the integers of the wire.
struct raw_values {
    using wide = int16_t;
    using narrow = uint8_t;
    static bool load(const uint8_t* in, wide& value) {
        value = static_cast<wide>(load16(in));
        return true;
    }
    static bool load(const uint8_t* in, narrow& value) {
        value = *in;
        return true;
    }
    static int16_t to_wide(wide value) { return value; }
    static uint8_t to_narrow(narrow value) { return value; }
};

/// Efforts in percent: -100 to 100 in 16 bits, 0 to 100 in 8 bits.
struct real_values {
    // Two types, so that each picks its own scale.
    struct wide {
        double percent;
    };
    struct narrow {
        double percent;
    };
    static bool load(const uint8_t* in, wide& value) {
        const auto raw = static_cast<int16_t>(load16(in));
        value.percent = raw * (200.0 / 65534.0);
        return raw != -32768;
    }
    static bool load(const uint8_t* in, narrow& value) {
        value.percent = *in * (100.0 / 255.0);
        return true;
    }
    static int16_t to_wide(wide value) {
        double v = value.percent;
        v = v > -100.0 ? v : -100.0;
        v = v < 100.0 ? v : 100.0;
        return static_cast<int16_t>(static_cast<std::int32_t>((v + 100.0) * (65534.0 / 200.0) + 0.5) - 32767);
    }
    static uint8_t to_narrow(narrow value) {
        double v = value.percent;
        v = v > 0.0 ? v : 0.0;
        v = v < 100.0 ? v : 100.0;
        return static_cast<uint8_t>(static_cast<std::int32_t>(v * (255.0 / 100.0) + 0.5));
    }
};

/// Set and Report Wrench Effort. A member counts when its bit of the presence vector is set.
template <class Values> struct wrench_effort {
    uint16_t presence_vector;
    typename Values::wide propulsive_linear_x, propulsive_linear_y, propulsive_linear_z;
    typename Values::wide propulsive_rotational_x, propulsive_rotational_y, propulsive_rotational_z;
    typename Values::narrow resistive_linear_x, resistive_linear_y, resistive_linear_z;
    typename Values::narrow resistive_rotational_x, resistive_rotational_y, resistive_rotational_z;
};

template <class Values> bool load_efforts(wrench_effort<Values>& efforts, const uint8_t* in, uint32_t size) {
    if (size < 2) return false;
    const uint32_t present = load16(in) & 0xFFF; // the other bits are ignored
    const auto wide = static_cast<uint32_t>(std::popcount(present & 0x3Fu));
    const auto narrow = static_cast<uint32_t>(std::popcount(present >> 6));
    if (size != 2 + 2 * wide + narrow) return false;
    efforts.presence_vector = static_cast<uint16_t>(present);
    in += 2;
    if ((present & 1u << 0) != 0) {
        if (!Values::load(in, efforts.propulsive_linear_x)) return false;
        in += 2;
    }
    if ((present & 1u << 1) != 0) {
        if (!Values::load(in, efforts.propulsive_linear_y)) return false;
        in += 2;
    }
    if ((present & 1u << 2) != 0) {
        if (!Values::load(in, efforts.propulsive_linear_z)) return false;
        in += 2;
    }
    if ((present & 1u << 3) != 0) {
        if (!Values::load(in, efforts.propulsive_rotational_x)) return false;
        in += 2;
    }
    if ((present & 1u << 4) != 0) {
        if (!Values::load(in, efforts.propulsive_rotational_y)) return false;
        in += 2;
    }
    if ((present & 1u << 5) != 0) {
        if (!Values::load(in, efforts.propulsive_rotational_z)) return false;
        in += 2;
    }
    if ((present & 1u << 6) != 0) {
        if (!Values::load(in, efforts.resistive_linear_x)) return false;
        in += 1;
    }
    if ((present & 1u << 7) != 0) {
        if (!Values::load(in, efforts.resistive_linear_y)) return false;
        in += 1;
    }
    if ((present & 1u << 8) != 0) {
        if (!Values::load(in, efforts.resistive_linear_z)) return false;
        in += 1;
    }
    if ((present & 1u << 9) != 0) {
        if (!Values::load(in, efforts.resistive_rotational_x)) return false;
        in += 1;
    }
    if ((present & 1u << 10) != 0) {
        if (!Values::load(in, efforts.resistive_rotational_y)) return false;
        in += 1;
    }
    if ((present & 1u << 11) != 0) {
        if (!Values::load(in, efforts.resistive_rotational_z)) return false;
        in += 1;
    }
    return true;
}
template <class Values> uint32_t store_efforts(const wrench_effort<Values>& efforts, uint8_t* out) {
    const uint32_t present = efforts.presence_vector;
    uint8_t* at = out;
    store16(at, present);
    at += 2;
    if ((present & 1u << 0) != 0) {
        store16(at, static_cast<uint16_t>(Values::to_wide(efforts.propulsive_linear_x)));
        at += 2;
    }
    if ((present & 1u << 1) != 0) {
        store16(at, static_cast<uint16_t>(Values::to_wide(efforts.propulsive_linear_y)));
        at += 2;
    }
    if ((present & 1u << 2) != 0) {
        store16(at, static_cast<uint16_t>(Values::to_wide(efforts.propulsive_linear_z)));
        at += 2;
    }
    if ((present & 1u << 3) != 0) {
        store16(at, static_cast<uint16_t>(Values::to_wide(efforts.propulsive_rotational_x)));
        at += 2;
    }
    if ((present & 1u << 4) != 0) {
        store16(at, static_cast<uint16_t>(Values::to_wide(efforts.propulsive_rotational_y)));
        at += 2;
    }
    if ((present & 1u << 5) != 0) {
        store16(at, static_cast<uint16_t>(Values::to_wide(efforts.propulsive_rotational_z)));
        at += 2;
    }
    if ((present & 1u << 6) != 0) *at++ = Values::to_narrow(efforts.resistive_linear_x);
    if ((present & 1u << 7) != 0) *at++ = Values::to_narrow(efforts.resistive_linear_y);
    if ((present & 1u << 8) != 0) *at++ = Values::to_narrow(efforts.resistive_linear_z);
    if ((present & 1u << 9) != 0) *at++ = Values::to_narrow(efforts.resistive_rotational_x);
    if ((present & 1u << 10) != 0) *at++ = Values::to_narrow(efforts.resistive_rotational_y);
    if ((present & 1u << 11) != 0) *at++ = Values::to_narrow(efforts.resistive_rotational_z);
    return static_cast<uint32_t>(at - out);
}
// Puts what `from` carries into `to`.
template <class Values> void copy_present(const wrench_effort<Values>& from, wrench_effort<Values>& to) {
    const uint32_t present = from.presence_vector;
    to.presence_vector = static_cast<uint16_t>(to.presence_vector | present);
    if ((present & 1u << 0) != 0) to.propulsive_linear_x = from.propulsive_linear_x;
    if ((present & 1u << 1) != 0) to.propulsive_linear_y = from.propulsive_linear_y;
    if ((present & 1u << 2) != 0) to.propulsive_linear_z = from.propulsive_linear_z;
    if ((present & 1u << 3) != 0) to.propulsive_rotational_x = from.propulsive_rotational_x;
    if ((present & 1u << 4) != 0) to.propulsive_rotational_y = from.propulsive_rotational_y;
    if ((present & 1u << 5) != 0) to.propulsive_rotational_z = from.propulsive_rotational_z;
    if ((present & 1u << 6) != 0) to.resistive_linear_x = from.resistive_linear_x;
    if ((present & 1u << 7) != 0) to.resistive_linear_y = from.resistive_linear_y;
    if ((present & 1u << 8) != 0) to.resistive_linear_z = from.resistive_linear_z;
    if ((present & 1u << 9) != 0) to.resistive_rotational_x = from.resistive_rotational_x;
    if ((present & 1u << 10) != 0) to.resistive_rotational_y = from.resistive_rotational_y;
    if ((present & 1u << 11) != 0) to.resistive_rotational_z = from.resistive_rotational_z;
}

template <class Values> class node {
  public:
    void on_bytes(std::span<const std::byte> bytes, jauscat::time_point now) {
        on_time(now);
        heard_ = now;
        while (!bytes.empty()) {
            const std::size_t room = sizeof buffer - waiting_;
            const std::size_t count = bytes.size() < room ? bytes.size() : room;
            std::memcpy(buffer + waiting_, bytes.data(), count);
            waiting_ += count;
            bytes = bytes.subspan(count);
            search(false);
        }
    }
    void on_time(jauscat::time_point now) {
        if (waiting_ != 0 && now - heard_ >= firmware::idle) search(true);
    }

  private:
    static constexpr uint32_t self = firmware::own_subsystem << 24 | firmware::own_node << 16 |
                                     firmware::own_component << 8 | firmware::own_instance;

    static bool possible(const header& head) {
        const uint32_t from = head.source;
        for (uint32_t shift = 0; shift != 32; shift += 8)
            if ((from >> shift & 255) == 0 || (from >> shift & 255) == 255) return false;
        return head.version == 2 && head.reserved == 0 && head.data_size <= firmware::largest_body &&
               (head.data_flag & (head.data_flag - 1)) == 0;
    }

    void search(bool no_more) {
        uint32_t at = 0;
        while (waiting_ - at >= header_size) {
            header head;
            load_header(head, buffer + at);
            const uint32_t size = header_size + head.data_size;
            const bool may_be = possible(head);
            if (may_be && waiting_ - at >= size) {
                on_message(head, buffer + at);
                at += size;
            } else if (may_be && !no_more) {
                break;
            } else {
                ++at;
            }
        }
        if (no_more) at = waiting_;
        waiting_ -= at;
        std::memmove(buffer, buffer + at, waiting_);
    }

    void on_message(const header& head, const uint8_t* message) {
        if (head.destination != self) return;
        const bool done = obey(head, message);
        if (!done) ++refused_;
        if (head.ack_nak == ack_request) {
            uint8_t answer[header_size];
            send_answer(head, done ? ack : nak, head.command_code, answer, 0);
        }
    }

    bool obey(const header& head, const uint8_t* message) {
        if (head.data_flag != 0) return false;
        if (head.ack_nak >= nak && head.data_size == 0) return true;
        const uint8_t* body = message + header_size;
        switch (head.command_code) {
        case set_wrench_effort: {
            wrench_effort<Values> commanded;
            if (!load_efforts(commanded, body, head.data_size)) return false;
            copy_present(commanded, efforts_);
            return hand_to_card(head, message);
        }
        case query_wrench_effort: {
            if (head.data_size != 2) return false;
            wrench_effort<Values> report = efforts_;
            report.presence_vector = report.presence_vector & load16(body);
            uint8_t answer[header_size + 20];
            send_answer(head, 0, report_wrench_effort, answer, store_efforts(report, answer + header_size));
            return true;
        }
        case query_component_status: {
            if (head.data_size != 0) return false;
            uint8_t answer[header_size + 5];
            answer[header_size] = ready;
            store32(answer + header_size + 1, refused_);
            send_answer(head, 0, report_component_status, answer, 5);
            return true;
        }
        default: return hand_to_card(head, message);
        }
    }

    // Puts the header of an answer in front of a body of `body_size` bytes, and sends both.
    static void send_answer(const header& request, uint32_t how, uint32_t code, uint8_t* answer, uint32_t body_size) {
        const header head{.priority = request.priority,
                          .ack_nak = static_cast<uint8_t>(how),
                          .service_connection = 0,
                          .experimental = 0,
                          .version = 2,
                          .reserved = 0,
                          .command_code = static_cast<uint16_t>(code),
                          .destination = request.source,
                          .source = request.destination,
                          .data_size = static_cast<uint16_t>(body_size),
                          .data_flag = 0,
                          .sequence_number = request.sequence_number};
        store_header(head, answer);
        send(firmware::line::jaus, answer, header_size + body_size);
    }

    // ETHERCAT_MASTER_PACKET_SDO_DOWNLOAD_REQ_T. All messages here are complete, so ulExt remains 0.
    static bool hand_to_card(const header& head, const uint8_t* message) {
        const uint32_t rank = rank_of(head.command_code), body = head.data_size;
        if (rank == 0) return false;
        uint8_t packet[packet_size + rest_size + firmware::largest_body];
        std::memset(packet, 0, packet_size);
        store32(packet + 0, head.destination >> 24);                // ulDest: subsystem
        store32(packet + 8, head.destination & 255);                // ulDestId: instance
        store32(packet + 16, 16 + rest_size + body);                // ulLen
        store32(packet + 28, 0x00650008);                           // ulCmd
        store32(packet + 40, head.destination >> 16 & 255);         // ulNodeId: node
        store32(packet + 44, 6900 + (head.destination >> 8 & 255)); // ulIndex: component
        store32(packet + 48, rank);                                 // ulSubIndex
        store32(packet + 52, rest_size + body);                     // ulDataCnt
        std::memcpy(packet + 56, message, 2);                       // properties
        std::memcpy(packet + 58, message + 8, 4);                   // source
        std::memcpy(packet + 62, message + 14, 2 + body);           // sequence number, body
        send(firmware::line::card, packet, packet_size + rest_size + body);
        return true;
    }

    static inline uint8_t buffer[header_size + firmware::largest_body];
    jauscat::time_point heard_{};
    uint32_t waiting_{}, refused_{};
    wrench_effort<Values> efforts_{};
};

} // namespace by_hand
