// The same node written by hand for size alone: no structs, no names of fields, loops over what happens to be alike.
// Efforts are kept as the integers of the wire.
#include "by_hand.hpp"

namespace {

using namespace by_hand;

constexpr uint32_t effort_count = 12, wide_efforts = 6;

uint8_t buffer[header_size + firmware::largest_body];
uint32_t waiting;               // bytes in the buffer
jauscat::time_point heard;      // time of the last one
uint16_t efforts[effort_count]; // as on the wire
uint16_t efforts_known;         // presence vector of those that were commanded
uint32_t refused;

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

// ETHERCAT_MASTER_PACKET_SDO_DOWNLOAD_REQ_T to the card. All messages here are complete, so ulExt remains 0.
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
    const uint32_t present = load16(body) & ((1u << effort_count) - 1); // the other bits are ignored
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
    message[header_size] = ready;
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

void firmware::on_bytes(std::span<const std::byte> bytes, jauscat::time_point now) noexcept {
    on_time(now);
    heard = now;
    for (const std::byte byte : bytes) {
        buffer[waiting++] = static_cast<uint8_t>(byte);
        search(false);
    }
}

void firmware::on_time(jauscat::time_point now) noexcept {
    if (waiting != 0 && now - heard >= idle) search(true);
}
