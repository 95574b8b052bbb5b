// The node in SAE JAUS written by hand: structs with named members, each field loaded and stored by a line of its own.
// It has the library's lists of message IDs.
#include "by_hand.hpp"
#include <jauscat/schema/translation/sae_ranks.hpp>

#include <algorithm>

namespace {

using namespace by_hand;
namespace tables = jauscat::translation;

enum : uint16_t { sae_set_wrench_effort = 0x0405, sae_query_wrench_effort = 0x2405, sae_report_wrench_effort = 0x4405 };
constexpr uint32_t head_size = 12, overhead = 14, largest_message = overhead + 2 + firmware::largest_body;

struct wrench_effort {
    uint16_t present; // bits in wire order
    uint16_t propulsive_linear_x, propulsive_linear_y, propulsive_linear_z;
    uint16_t propulsive_rotational_x, propulsive_rotational_y, propulsive_rotational_z;
    uint8_t resistive_linear_x, resistive_linear_y, resistive_linear_z;
    uint8_t resistive_rotational_x, resistive_rotational_y, resistive_rotational_z;
};
wrench_effort efforts;

uint16_t checksum(uint16_t sum, uint8_t byte) {
    uint32_t changed = (byte ^ sum) & 0xFFu;
    changed = (changed ^ changed << 4) & 0xFF;
    return static_cast<uint16_t>(static_cast<uint32_t>(sum >> 8) ^ changed << 8 ^ changed << 3 ^ changed >> 4);
}

// Segment and rank of a message ID; rank 0: none.
struct place {
    uint32_t segment, rank;
};
template <std::size_t Size> bool find(const std::array<uint16_t, Size>& ids, uint16_t id, uint32_t& rank) {
    const auto at = std::lower_bound(ids.begin(), ids.end(), id);
    if (at == ids.end() || *at != id) return false;
    rank = static_cast<uint32_t>(at - ids.begin() + 1);
    return true;
}
place place_of(uint16_t id) {
    uint32_t rank = 0;
    if (find(tables::sae_core_ids, id, rank)) return {0, rank};
    if (find(tables::sae_mobility_ids, id, rank)) return {1, rank};
    if (find(tables::sae_environment_sensing_ids, id, rank)) return {2, rank};
    if (find(tables::sae_manipulator_ids, id, rank)) return {3, rank};
    if (find(tables::sae_ugv_ids, id, rank)) return {4, rank};
    return {0, 0};
}

struct frame_writer {
    uint8_t bytes[6 + 2 * (3 + 4 + 64)];
    uint32_t size;
    uint16_t sum;
    void marker(uint8_t which) {
        bytes[size++] = 0x10;
        bytes[size++] = which;
    }
    void byte(uint8_t value) {
        sum = checksum(sum, value);
        bytes[size++] = value;
        if (value == 0x10) bytes[size++] = value;
    }
    void number(uint32_t value) {
        byte(static_cast<uint8_t>(value));
        byte(static_cast<uint8_t>(value >> 8));
    }
};

void answer(const uint8_t* request, uint32_t request_size, uint32_t how, const uint8_t* payload, uint32_t size) {
    uint8_t message[64];
    message[0] = 0;
    store16(message + 1, overhead + size);
    message[3] = static_cast<uint8_t>((request[3] & 0x03) | how << 4);
    std::memcpy(message + 4, request + 8, 4); // destination
    message[8] = firmware::own_component;
    message[9] = firmware::own_node;
    store16(message + 10, firmware::own_subsystem);
    if (size != 0) std::memcpy(message + head_size, payload, size);
    std::memcpy(message + head_size + size, request + request_size - 2, 2); // sequence number
    frame_writer frame{};
    frame.sum = 0xFFFF;
    frame.marker(1);
    frame.byte(2);
    frame.number(overhead + size);
    frame.marker(2);
    frame.number(frame.sum);
    for (uint32_t i = 0; i != overhead + size; ++i) frame.byte(message[i]);
    const uint16_t sum = frame.sum;
    frame.marker(3);
    frame.number(sum);
    send(firmware::line::jaus, frame.bytes, frame.size);
}

// ETHERCAT_MASTER_PACKET_SDO_DOWNLOAD_REQ_T to the card.
bool hand_to_card(const uint8_t* message, uint32_t size) {
    const place at = place_of(load16(message + head_size));
    if (at.rank == 0) return false;
    const uint32_t data = size - 7;
    uint8_t packet[packet_size + largest_message];
    std::memset(packet, 0, packet_size);
    store32(packet + 0, 0x20);                                      // ulDest
    store32(packet + 16, 16 + data);                                // ulLen
    store32(packet + 28, 0x00650008);                               // ulCmd
    store32(packet + 40, message[5]);                               // ulNodeId: node
    store32(packet + 44, 0x2000u + 256u * at.segment + message[4]); // ulIndex: component
    store32(packet + 48, at.rank);                                  // ulSubIndex
    store32(packet + 52, data);                                     // ulDataCnt
    packet[56] = message[3];                                        // properties
    std::memcpy(packet + 57, message + 6, 6);                       // subsystem, source
    std::memcpy(packet + 63, message + 14, size - 14);              // fields, sequence number
    send(firmware::line::card, packet, packet_size + data);
    return true;
}

bool set_efforts(const uint8_t* at, const uint8_t* end) {
    if (end - at < 2) return false;
    wrench_effort read;
    read.present = load16(at) & 0xFFF; // the other bits are ignored
    at += 2;
    bool good = true;
    const auto wide = [&](uint32_t bit, uint16_t& field) {
        if (!good || (read.present >> bit & 1) == 0) return;
        good = end - at >= 2;
        if (good) field = load16(at);
        at += 2;
    };
    const auto narrow = [&](uint32_t bit, uint8_t& field) {
        if (!good || (read.present >> bit & 1) == 0) return;
        good = end != at;
        if (good) field = *at;
        ++at;
    };
    wide(0, read.propulsive_linear_x);
    wide(1, read.propulsive_linear_y);
    wide(2, read.propulsive_linear_z);
    wide(3, read.propulsive_rotational_x);
    wide(4, read.propulsive_rotational_y);
    wide(5, read.propulsive_rotational_z);
    narrow(6, read.resistive_linear_x);
    narrow(7, read.resistive_linear_y);
    narrow(8, read.resistive_linear_z);
    narrow(9, read.resistive_rotational_x);
    narrow(10, read.resistive_rotational_y);
    narrow(11, read.resistive_rotational_z);
    if (!good || at != end) return false;
    const auto keep = [&](uint32_t bit, auto& field, auto value) {
        if ((read.present >> bit & 1) != 0) field = value;
    };
    keep(0, efforts.propulsive_linear_x, read.propulsive_linear_x);
    keep(1, efforts.propulsive_linear_y, read.propulsive_linear_y);
    keep(2, efforts.propulsive_linear_z, read.propulsive_linear_z);
    keep(3, efforts.propulsive_rotational_x, read.propulsive_rotational_x);
    keep(4, efforts.propulsive_rotational_y, read.propulsive_rotational_y);
    keep(5, efforts.propulsive_rotational_z, read.propulsive_rotational_z);
    keep(6, efforts.resistive_linear_x, read.resistive_linear_x);
    keep(7, efforts.resistive_linear_y, read.resistive_linear_y);
    keep(8, efforts.resistive_linear_z, read.resistive_linear_z);
    keep(9, efforts.resistive_rotational_x, read.resistive_rotational_x);
    keep(10, efforts.resistive_rotational_y, read.resistive_rotational_y);
    keep(11, efforts.resistive_rotational_z, read.resistive_rotational_z);
    efforts.present = static_cast<uint16_t>(efforts.present | read.present);
    return true;
}

void report_efforts(const uint8_t* query, uint32_t size) {
    uint8_t payload[32];
    const uint16_t present = load16(query + head_size + 2) & efforts.present;
    store16(payload, sae_report_wrench_effort);
    store16(payload + 2, present);
    uint8_t* at = payload + 4;
    const auto wide = [&](uint32_t bit, uint16_t field) {
        if ((present >> bit & 1) == 0) return;
        store16(at, field);
        at += 2;
    };
    const auto narrow = [&](uint32_t bit, uint8_t field) {
        if ((present >> bit & 1) != 0) *at++ = field;
    };
    wide(0, efforts.propulsive_linear_x);
    wide(1, efforts.propulsive_linear_y);
    wide(2, efforts.propulsive_linear_z);
    wide(3, efforts.propulsive_rotational_x);
    wide(4, efforts.propulsive_rotational_y);
    wide(5, efforts.propulsive_rotational_z);
    narrow(6, efforts.resistive_linear_x);
    narrow(7, efforts.resistive_linear_y);
    narrow(8, efforts.resistive_linear_z);
    narrow(9, efforts.resistive_rotational_x);
    narrow(10, efforts.resistive_rotational_y);
    narrow(11, efforts.resistive_rotational_z);
    answer(query, size, 0, payload, static_cast<uint32_t>(at - payload));
}

bool obey(const uint8_t* message, uint32_t size) {
    if ((message[3] & 0xC0) != 0 || size < overhead + 2) return false; // a part of a message; no message ID
    switch (load16(message + head_size)) {
    case sae_query_wrench_effort:
        if (size != overhead + 4) return false;
        report_efforts(message, size);
        return true;
    case sae_set_wrench_effort:
        return set_efforts(message + head_size + 2, message + size - 2) && hand_to_card(message, size);
    default: return hand_to_card(message, size);
    }
}

void on_message(const uint8_t* message, uint32_t size) {
    if (size < overhead || load16(message + 1) != size || message[0] != 0) return;
    if (message[4] != firmware::own_component || message[5] != firmware::own_node ||
        load16(message + 6) != firmware::own_subsystem)
        return;
    if (message[8] == 0 || message[8] == 255 || message[9] == 0 || message[9] == 255 || load16(message + 10) == 0 ||
        load16(message + 10) == 0xFFFF)
        return; // from no component
    const uint32_t how = message[3] >> 4 & 3;
    if (how > ack_request) return; // an acknowledgement
    const bool done = obey(message, size);
    if (how == ack_request) answer(message, size, done ? ack : nak, nullptr, 0);
}

enum class state : uint8_t { outside, head, head_sum, message, sum };
uint8_t head[5], message[largest_message];
state now_in;
uint32_t received, length;
uint16_t sum;
uint8_t low_byte;
bool after_dle, has_low_byte;

void on_marker(uint8_t which) {
    if (which == 1) {
        now_in = state::head;
        received = 0;
        sum = 0xFFFF;
    } else if (which == 2 && now_in == state::head && (received == 3 || received == 5) && (head[0] & 0x0F) == 2) {
        length = load16(head + 1);
        now_in = state::head_sum;
        has_low_byte = false;
    } else if (which == 3 && now_in == state::message && received == length) {
        now_in = state::sum;
        has_low_byte = false;
    } else {
        now_in = state::outside;
    }
}
bool ends_sum(uint8_t byte) {
    if (has_low_byte) return true;
    has_low_byte = true;
    low_byte = byte;
    return false;
}
void on_data(uint8_t byte) {
    switch (now_in) {
    case state::outside: return;
    case state::head:
        if (received == sizeof head) {
            now_in = state::outside;
            return;
        }
        head[received++] = byte;
        sum = checksum(sum, byte);
        return;
    case state::head_sum:
        if (!ends_sum(byte)) return;
        if ((low_byte | byte << 8) != sum || length < overhead || length > largest_message) {
            now_in = state::outside;
            return;
        }
        sum = checksum(checksum(sum, low_byte), byte);
        received = 0;
        now_in = state::message;
        return;
    case state::message:
        if (received == length) {
            now_in = state::outside;
            return;
        }
        message[received++] = byte;
        sum = checksum(sum, byte);
        return;
    case state::sum:
        if (!ends_sum(byte)) return;
        now_in = state::outside;
        if ((low_byte | byte << 8) == sum) on_message(message, length);
        return;
    }
}

} // namespace

void firmware::on_bytes(std::span<const std::byte> bytes, jauscat::time_point) noexcept {
    for (const std::byte one : bytes) {
        const auto byte = std::to_integer<uint8_t>(one);
        if (after_dle) {
            after_dle = false;
            if (byte != 0x10)
                on_marker(byte);
            else if (now_in == state::outside)
                after_dle = true; // the first one may be noise in front of a frame
            else
                on_data(byte);
        } else if (byte == 0x10) {
            after_dle = true;
        } else {
            on_data(byte);
        }
    }
}
void firmware::on_time(jauscat::time_point) noexcept {}
