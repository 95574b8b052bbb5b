// The same node written by hand, with byte arithmetic and no library: the floor that JausCat's code size is measured
// against. Efforts are kept as the integers of the wire.
#include "node.hpp"

#include <cstdint>
#include <cstring>

namespace {

using std::uint16_t;
using std::uint32_t;
using std::uint8_t;

// RA 3.3's command codes in ascending order: the place is the subindex. 0404h is experimental and stands behind them.
constexpr uint16_t command_codes[] = {
    0x0001, 0x0002, 0x0003, 0x0004, 0x0005, 0x0006, 0x0007, 0x0008, 0x0009, 0x000A, 0x000B, 0x000C, 0x000D, 0x000E,
    0x000F, 0x0010, 0x0011, 0x01F0, 0x01F1, 0x01F2, 0x01F3, 0x01F4, 0x0200, 0x0201, 0x0202, 0x0405, 0x0406, 0x0407,
    0x0408, 0x040A, 0x040C, 0x040D, 0x040F, 0x0410, 0x0601, 0x0602, 0x0603, 0x0604, 0x0605, 0x0606, 0x0607, 0x0608,
    0x0801, 0x0802, 0x0805, 0x0806, 0x0A20, 0x0A21, 0x0A24, 0x0A25, 0x0D01, 0x0E00, 0x0E01, 0x0E02, 0x0E03, 0x0E04,
    0x0E05, 0x0E06, 0x2001, 0x2002, 0x200D, 0x2011, 0x21F0, 0x2200, 0x2201, 0x2202, 0x2400, 0x2401, 0x2402, 0x2403,
    0x2404, 0x2405, 0x2406, 0x2407, 0x2408, 0x240A, 0x240B, 0x240C, 0x240D, 0x240E, 0x240F, 0x2410, 0x2600, 0x2601,
    0x2602, 0x2603, 0x2604, 0x2605, 0x2800, 0x2801, 0x2802, 0x2804, 0x2805, 0x2806, 0x2807, 0x2A21, 0x2A22, 0x2A23,
    0x2B00, 0x2B01, 0x2B02, 0x2B03, 0x2D00, 0x2D01, 0x2E00, 0x2E01, 0x4001, 0x4002, 0x400D, 0x4011, 0x41F0, 0x41F1,
    0x4200, 0x4201, 0x4202, 0x4400, 0x4401, 0x4402, 0x4403, 0x4404, 0x4405, 0x4406, 0x4407, 0x4408, 0x440A, 0x440B,
    0x440C, 0x440D, 0x440E, 0x440F, 0x4410, 0x4600, 0x4601, 0x4602, 0x4603, 0x4604, 0x4605, 0x4800, 0x4801, 0x4802,
    0x4804, 0x4805, 0x4806, 0x4807, 0x4A20, 0x4A21, 0x4A22, 0x4A23, 0x4A24, 0x4B00, 0x4B01, 0x4B02, 0x4B03, 0x4D00,
    0x4D01, 0x4E00, 0x4E01,
};
constexpr uint32_t code_count = sizeof command_codes / sizeof command_codes[0];
constexpr uint16_t experimental_code = 0x0404;

enum : uint16_t {
    set_wrench_effort = 0x0405,
    query_component_status = 0x2002,
    query_wrench_effort = 0x2405,
    report_component_status = 0x4002,
    report_wrench_effort = 0x4405,
};
enum : uint8_t { ack_request = 1, nak = 2, ack = 3 };
constexpr uint32_t header_size = 16, packet_size = 56, rest_size = 8, effort_count = 12, wide_efforts = 6;

uint8_t buffer[header_size + firmware::largest_body];
uint32_t waiting;               // bytes in the buffer
std::chrono::nanoseconds heard; // when the last one came
uint16_t efforts[effort_count]; // as on the wire
uint16_t efforts_known;         // presence vector of those that were commanded
uint32_t refused;

uint16_t load16(const uint8_t* from) { return static_cast<uint16_t>(from[0] | from[1] << 8); }
void store16(uint8_t* to, uint32_t value) {
    to[0] = static_cast<uint8_t>(value);
    to[1] = static_cast<uint8_t>(value >> 8);
}
void store32(uint8_t* to, uint32_t value) {
    store16(to, value);
    store16(to + 2, value >> 16);
}

void send(firmware::line to, const uint8_t* bytes, uint32_t size) {
    firmware::send(to, {reinterpret_cast<const std::byte*>(bytes), size});
}

// Starts an answer: source and destination exchanged, priority and sequence number kept.
void make_header(uint8_t* out, const uint8_t* request, uint32_t how, uint32_t code, uint32_t body_size) {
    out[0] = static_cast<uint8_t>((request[0] & 0x0F) | how << 4);
    out[1] = 2;
    store16(out + 2, code);
    std::memcpy(out + 4, request + 8, 4);
    std::memcpy(out + 8, request + 4, 4);
    store16(out + 12, body_size);
    std::memcpy(out + 14, request + 14, 2);
}

// The rank of a command code from 1, or 0.
uint32_t rank_of(uint16_t code) {
    if (code == experimental_code) return code_count + 1;
    uint32_t low = 0, high = code_count;
    while (low != high) {
        const uint32_t middle = (low + high) / 2;
        if (command_codes[middle] < code)
            low = middle + 1;
        else
            high = middle;
    }
    return low != code_count && command_codes[low] == code ? low + 1 : 0;
}

// ETHERCAT_MASTER_PACKET_SDO_DOWNLOAD_REQ_T to the card. Only whole messages come here, so ulExt stays 0.
bool hand_to_card(const uint8_t* message, uint32_t body_size) {
    const uint32_t rank = rank_of(load16(message + 2));
    if (rank == 0) return false;
    uint8_t packet[packet_size + rest_size + firmware::largest_body];
    std::memset(packet, 0, packet_size);
    store32(packet + 0, message[7]);                       // ulDest: subsystem
    store32(packet + 8, message[4]);                       // ulDestId: instance
    store32(packet + 16, 16 + rest_size + body_size);      // ulLen
    store32(packet + 28, 0x00650008);                      // ulCmd
    store32(packet + 40, message[6]);                      // ulNodeId: node
    store32(packet + 44, 6900u + message[5]);              // ulIndex: component
    store32(packet + 48, rank);                            // ulSubIndex
    store32(packet + 52, rest_size + body_size);           // ulDataCnt
    std::memcpy(packet + 56, message, 2);                  // properties
    std::memcpy(packet + 58, message + 8, 4);              // source
    std::memcpy(packet + 62, message + 14, 2 + body_size); // sequence number, body
    send(firmware::line::card, packet, packet_size + rest_size + body_size);
    return true;
}

bool set_efforts(const uint8_t* body, uint32_t size) {
    if (size < 2) return false;
    const uint16_t present = load16(body);
    if (present >> effort_count != 0) return false;
    uint16_t commanded[effort_count];
    uint32_t at = 2;
    for (uint32_t i = 0; i != effort_count; ++i) {
        if ((present >> i & 1) == 0) continue;
        const uint32_t width = i < wide_efforts ? 2 : 1;
        if (size - at < width) return false;
        commanded[i] = width == 2 ? load16(body + at) : body[at];
        at += width;
    }
    if (at != size) return false;
    for (uint32_t i = 0; i != effort_count; ++i)
        if ((present >> i & 1) != 0) efforts[i] = commanded[i];
    efforts_known = static_cast<uint16_t>(efforts_known | present);
    return true;
}

void report_efforts(const uint8_t* query) {
    uint8_t message[header_size + 20];
    const uint16_t present = load16(query + header_size) & efforts_known;
    uint8_t* out = message + header_size;
    store16(out, present);
    out += 2;
    for (uint32_t i = 0; i != effort_count; ++i) {
        if ((present >> i & 1) == 0) continue;
        *out++ = static_cast<uint8_t>(efforts[i]);
        if (i < wide_efforts) *out++ = static_cast<uint8_t>(efforts[i] >> 8);
    }
    const auto size = static_cast<uint32_t>(out - message);
    make_header(message, query, 0, report_wrench_effort, size - header_size);
    send(firmware::line::jaus, message, size);
}

void report_status(const uint8_t* query) {
    uint8_t message[header_size + 5];
    make_header(message, query, 0, report_component_status, 5);
    message[header_size] = 1; // ready
    store32(message + header_size + 1, refused);
    send(firmware::line::jaus, message, sizeof message);
}

bool obey(const uint8_t* message, uint32_t body_size) {
    if (message[13] >> 4 != 0) return false;                     // a part of a message
    if ((message[0] & 0x20) != 0 && body_size == 0) return true; // an acknowledgement
    switch (load16(message + 2)) {
    case set_wrench_effort: return set_efforts(message + header_size, body_size) && hand_to_card(message, body_size);
    case query_wrench_effort:
        if (body_size != 2) return false;
        report_efforts(message);
        return true;
    case query_component_status:
        if (body_size != 0) return false;
        report_status(message);
        return true;
    default: return hand_to_card(message, body_size);
    }
}

void on_message(const uint8_t* message, uint32_t body_size) {
    if (message[4] != firmware::own_instance || message[5] != firmware::own_component ||
        message[6] != firmware::own_node || message[7] != firmware::own_subsystem)
        return;
    const bool done = obey(message, body_size);
    if (!done) ++refused;
    if ((message[0] >> 4 & 3) == ack_request) {
        uint8_t answer[header_size];
        make_header(answer, message, done ? ack : nak, load16(message + 2), 0);
        send(firmware::line::jaus, answer, sizeof answer);
    }
}

bool possible_header(const uint8_t* head) {
    const uint8_t flag = head[13] >> 4;
    if (head[1] != 2 || (flag & (flag - 1)) != 0 || (load16(head + 12) & 0xFFF) > firmware::largest_body) return false;
    for (uint32_t i = 8; i != 12; ++i)
        if (head[i] == 0 || head[i] == 255) return false;
    return true;
}

void search(bool no_more) {
    uint32_t at = 0;
    while (waiting - at >= header_size) {
        const uint8_t* head = buffer + at;
        const uint32_t body_size = load16(head + 12) & 0xFFF;
        const bool possible = possible_header(head);
        if (possible && waiting - at >= header_size + body_size) {
            on_message(head, body_size);
            at += header_size + body_size;
        } else if (possible && !no_more) {
            break;
        } else {
            ++at;
        }
    }
    if (no_more) at = waiting;
    waiting -= at;
    std::memmove(buffer, buffer + at, waiting);
}

} // namespace

void firmware::on_bytes(std::span<const std::byte> bytes, std::chrono::nanoseconds now) noexcept {
    on_time(now);
    heard = now;
    for (const std::byte byte : bytes) {
        buffer[waiting++] = static_cast<uint8_t>(byte);
        search(false);
    }
}

void firmware::on_time(std::chrono::nanoseconds now) noexcept {
    if (waiting != 0 && now - heard >= idle) search(true);
}
