// The functions of peer_table.
#pragma once
#include <jauscat/sae/transport/peer_table.hpp>

namespace jauscat::sae {

JAUSCAT_CONSTEXPR peer_table::peer_table(std::span<known_peer> places, duration timeout) noexcept
    : places_{places}, timeout_{timeout} {}

JAUSCAT_CONSTEXPR bool peer_table::fix(const jaus_id& id, endpoint_key endpoint) noexcept {
    known_peer* place = nullptr;
    for (known_peer& p : places_)
        if (p.is_used ? p.id == id : place == nullptr) place = &p;
    if (place == nullptr) return false;
    *place = {.is_used = true, .is_fixed = true, .id = id, .endpoint = endpoint, .heard_at = place->heard_at};
    return true;
}

JAUSCAT_CONSTEXPR learnt peer_table::on_packet(const jaus_id& id, endpoint_key endpoint, time_point now) noexcept {
    known_peer* free = nullptr;
    known_peer* silent = nullptr;
    std::size_t of_endpoint = 0;
    for (known_peer& p : places_) {
        if (!p.is_used) {
            free = &p;
            continue;
        }
        if (p.id == id) {
            if (p.is_fixed && p.endpoint != endpoint) return learnt::wrong_endpoint;
            const bool is_moved = p.endpoint != endpoint;
            p.endpoint = endpoint;
            p.heard_at = now;
            return is_moved ? learnt::moved : learnt::known;
        }
        if (p.endpoint == endpoint) ++of_endpoint;
        if (!p.is_fixed && now - p.heard_at >= timeout_ && (silent == nullptr || p.heard_at < silent->heard_at))
            silent = &p;
    }
    if (free == nullptr) free = silent;
    if (free == nullptr || of_endpoint >= jaus::peer_share(places_.size())) return learnt::no_capacity;
    *free = {.is_used = true, .is_fixed = false, .id = id, .endpoint = endpoint, .heard_at = now};
    return learnt::added;
}

JAUSCAT_CONSTEXPR void peer_table::forget(endpoint_key endpoint) noexcept {
    for (known_peer& p : places_)
        if (p.is_used && !p.is_fixed && p.endpoint == endpoint) p = {};
}

JAUSCAT_CONSTEXPR const known_peer* peer_table::find(const jaus_id& id) const noexcept {
    for (const known_peer& p : places_)
        if (p.is_used && p.id == id) return &p;
    return nullptr;
}

} // namespace jauscat::sae
