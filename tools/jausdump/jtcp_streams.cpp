#include "jtcp_streams.hpp"

#include <algorithm>

namespace jausdump {

namespace {

constexpr std::size_t most_streams = 256, most_waiting = 256;
constexpr std::size_t first_size = 1 + sae::transport_header_size; ///< the version and a header

bool begins_message(std::span<const std::byte> part) {
    sae::transport_header head{};
    return wire::decode_prefix(head, part) && head.message_type == 0 && head.size >= sae::transport_overhead &&
           names_one_component(head.source);
}
bool begins_stream(std::span<const std::byte> part) {
    return !part.empty() && part[0] == sae::transport_version && begins_message(part.subspan(1));
}

} // namespace

jtcp_streams::stream& jtcp_streams::stream_of(const origin& from) {
    const auto found =
        std::ranges::find_if(streams_, [&](const stream& one) { return one.from == from.from && one.to == from.to; });
    if (found != streams_.end()) return *found;
    if (streams_.size() == most_streams) {
        end(streams_.front());
        streams_.pop_front();
    }
    return streams_.emplace_back(stream{.from = from.from, .to = from.to});
}

void jtcp_streams::on_segment(const tcp_segment& segment, const origin& from) {
    stream& s = stream_of(from);
    auto part = segment.payload;
    std::uint32_t number = segment.sequence_number;
    if (segment.synchronises) {
        ++number;                                   // SYN counts as one
        if (!s.has_beginning || s.base != number) { // else it is repeated
            end(s);
            s = stream{.from = from.from,
                       .to = from.to,
                       .next = number,
                       .base = number,
                       .has_beginning = true,
                       .begins = true};
        }
    }
    if (part.empty()) return;
    if (!s.next) s.next = s.base = number;
    const auto distance = static_cast<std::int32_t>(number - *s.next);
    if (distance > 0) {
        s.waiting.try_emplace(number - s.base, held_segment{{part.begin(), part.end()}, from});
        if (s.waiting.size() > most_waiting) skip_gap(s);
        return;
    }
    const auto repeated = static_cast<std::size_t>(-static_cast<std::int64_t>(distance));
    if (repeated >= part.size()) return;
    take(s, part.subspan(repeated), from);
    take_waiting(s);
}

void jtcp_streams::take_waiting(stream& s) {
    while (!s.waiting.empty()) {
        const auto first = s.waiting.begin();
        const std::uint32_t number = s.base + first->first;
        const auto distance = static_cast<std::int32_t>(number - *s.next);
        if (distance > 0) return;
        const auto held = std::move(first->second);
        s.waiting.erase(first);
        const auto repeated = static_cast<std::size_t>(-static_cast<std::int64_t>(distance));
        if (repeated < held.bytes.size()) take(s, std::span{held.bytes}.subspan(repeated), held.origin);
    }
}

void jtcp_streams::take(stream& s, std::span<const std::byte> bytes, const origin& from) {
    s.next = *s.next + static_cast<std::uint32_t>(bytes.size());
    s.last = from;
    if (s.reader) return read(s, bytes, from);
    if (s.begins) {
        s.front.insert(s.front.end(), bytes.begin(), bytes.end());
        if (s.front.size() < first_size) return;
        const auto front = std::exchange(s.front, {});
        s.begins = begins_stream(front);
        if (!s.begins) return listener_.skipped("TCP: not a stream of JTCP");
        s.buffer.resize(0xFFFF);
        s.reader.emplace(s.buffer);
        return read(s, front, from);
    }
    const bool has_version = begins_stream(bytes);
    if (!has_version && !begins_message(bytes)) return listener_.skipped("TCP: not the beginning of a JTCP message");
    s.buffer.resize(0xFFFF);
    s.reader.emplace(s.buffer);
    if (!has_version) read(s, std::array{sae::transport_version}, from);
    read(s, bytes, from);
}

void jtcp_streams::read(stream& s, std::span<const std::byte> bytes, const origin& from) {
    s.reader->on_bytes(bytes, [&](const sae::split_transport_message& message) {
        if (message.error != sae::transport_errc::wrong_size) listener_.message(message, message.bytes, from);
    });
    // The next message is found where a segment begins with one.
    if (s.reader->error() != sae::transport_errc::ok) lose_message(s, s.reader->error());
}

void jtcp_streams::lose_message(stream& s, sae::transport_errc why) {
    listener_.message({.error = why}, {}, s.last);
    s.reader.reset();
    s.begins = false;
}

void jtcp_streams::skip_gap(stream& s) {
    s.front.clear();
    if (s.reader || s.begins) lose_message(s, sae::transport_errc::truncated);
    s.next = s.base + s.waiting.begin()->first;
    take_waiting(s);
}

void jtcp_streams::end(stream& s) {
    while (!s.waiting.empty()) skip_gap(s);
    if (!s.front.empty()) listener_.skipped("TCP: not a stream of JTCP");
    if (s.reader && s.reader->is_inside_message()) lose_message(s, sae::transport_errc::truncated);
}

void jtcp_streams::finish() {
    for (stream& s : streams_) end(s);
    streams_.clear();
}

} // namespace jausdump
