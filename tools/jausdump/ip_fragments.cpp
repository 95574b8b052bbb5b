#include "ip_fragments.hpp"

#include <algorithm>

namespace jausdump {

std::optional<std::vector<std::byte>> ip_fragments::add(const ipv4_header& ip, std::span<const std::byte> part) {
    const auto is_of_it = [&](const packet& one) {
        return one.first.identification == ip.identification && one.first.protocol == ip.protocol &&
               one.first.source == ip.source && one.first.destination == ip.destination;
    };
    auto found = std::ranges::find_if(packets_, is_of_it);
    if (found == packets_.end()) {
        if (packets_.size() == most) {
            given_up_ += packets_.front().fragments;
            packets_.pop_front();
        }
        packets_.push_back({.first = ip});
        found = packets_.end() - 1;
    }
    packet& all = *found;
    ++all.fragments;
    const std::size_t begin = std::size_t{ip.fragment_offset} * 8, end = begin + part.size();
    if (all.bytes.size() < end) {
        all.bytes.resize(end);
        all.has.resize(end);
    }
    for (std::size_t i = begin; i != end; ++i) {
        if (!all.has[i]) all.bytes[i] = part[i - begin];
        all.has[i] = true;
    }
    if (!ip.more_fragments) all.size = end;
    if (!all.size || *all.size > all.has.size() ||
        !std::all_of(all.has.begin(), all.has.begin() + static_cast<std::ptrdiff_t>(*all.size),
                     [](bool b) { return b; }))
        return std::nullopt;
    auto whole = std::move(all.bytes);
    whole.resize(*all.size);
    packets_.erase(found);
    return whole;
}

std::size_t ip_fragments::left_over() const {
    std::size_t count = given_up_;
    for (const auto& one : packets_) count += one.fragments;
    return count;
}

} // namespace jausdump
