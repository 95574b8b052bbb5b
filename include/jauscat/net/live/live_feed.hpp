// What a node hands to the live view: its messages and its state.
#pragma once
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/net/live/detail/sample_ring.hpp>
#include <jauscat/net/live/live_state.hpp>
#include <jauscat/net/now.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

namespace jauscat::net {

/// How the program got a message.
enum class live_way : std::uint8_t {
    received,
    sent,
    seen, ///< between others
};

/// A message of SAE JAUS. A JAUS ID of SAE: the number `subsystem << 16 | node << 8 | component`.
struct live_sae_message {
    std::uint16_t message_id{}; ///< 0 of an acknowledgement, which has none
    std::uint32_t from{}, to{};
    std::span<const std::byte> message{};        ///< header, payload, and what follows
    std::size_t payload_begin{}, payload_size{}; ///< in `message`
    bool is_whole{true};                         ///< not a packet of several
    jaus::ack_nak acknowledgement{};             ///< has the same values in SAE JAUS
};

/// The messages of one thread, such as that of a node, for a live_server. A message is copied only while a viewer is
/// there, into memory of fixed size: what comes faster than the server reads it is not shown, and counted. No function
/// waits for the server.
class live_feed {
  public:
    live_feed() = default;
    live_feed(const live_feed&) = delete;
    live_feed& operator=(const live_feed&) = delete;

    /// A viewer is there.
    [[nodiscard]] bool is_watched() const noexcept { return is_watched_.load(std::memory_order_relaxed); }

    // For the one thread.

    void message(live_way way, const jaus::header& head, std::span<const std::byte> body) noexcept {
        if (is_watched()) put(way, head, body);
    }
    /// Header and body.
    void message(live_way way, std::span<const std::byte> whole) noexcept {
        jaus::header head{};
        if (is_watched() && wire::decode_prefix(head, whole)) put(way, head, whole.subspan(jaus::header_size));
    }
    void message(live_way way, const live_sae_message& one) noexcept {
        if (is_watched()) put(way, one);
    }
    /// To be called some ten times a second while `is_watched`.
    void set_state(live_state state) {
        const std::scoped_lock lock{mutex_};
        std::swap(state_, state);
        is_new_ = true;
    }

    // For the server.

    void set_watched(bool is_watched) noexcept { is_watched_.store(is_watched, std::memory_order_relaxed); }
    [[nodiscard]] detail::sample_ring& samples() noexcept { return samples_; }
    /// The state, if it was set since the last call.
    [[nodiscard]] std::optional<live_state> take_state() {
        const std::scoped_lock lock{mutex_};
        if (!std::exchange(is_new_, false)) return {};
        return std::move(state_);
    }

  private:
    static std::uint32_t packed(const jaus::address& id) noexcept {
        return std::uint32_t{id.subsystem} << 24U | std::uint32_t{id.node} << 16U | std::uint32_t{id.component} << 8U |
               id.instance;
    }
    void put(live_way way, const jaus::header& head, std::span<const std::byte> body) noexcept {
        auto* const to = samples_.begin_write();
        if (to == nullptr) return;
        if (!wire::encode(head, to->bytes)) return;
        to->from = packed(head.source);
        to->to = packed(head.destination);
        to->code = head.command_code;
        to->is_sae = false;
        to->acknowledgement = static_cast<std::uint8_t>(head.ack_nak);
        to->size = jaus::header_size + body.size();
        const auto kept = std::min(body.size(), detail::live_sample::capacity - jaus::header_size);
        to->has_body = head.data_flag == jaus::data_flag::only && kept == body.size() &&
                       !(body.empty() && jaus::is_acknowledgement(head));
        std::ranges::copy(body.first(kept), to->bytes.begin() + jaus::header_size);
        to->body_begin = jaus::header_size;
        to->body_end = to->kept = static_cast<std::uint16_t>(jaus::header_size + kept);
        end(*to, way);
    }
    void put(live_way way, const live_sae_message& one) noexcept {
        auto* const to = samples_.begin_write();
        if (to == nullptr) return;
        to->from = one.from;
        to->to = one.to;
        to->code = one.message_id;
        to->is_sae = true;
        to->acknowledgement = static_cast<std::uint8_t>(one.acknowledgement);
        to->has_body = one.is_whole;
        to->size = one.message.size();
        const auto kept = std::min(one.message.size(), detail::live_sample::capacity);
        std::ranges::copy(one.message.first(kept), to->bytes.begin());
        to->kept = static_cast<std::uint16_t>(kept);
        to->body_begin = static_cast<std::uint16_t>(std::min(one.payload_begin, kept));
        to->body_end = static_cast<std::uint16_t>(std::min(one.payload_begin + one.payload_size, kept));
        if (one.payload_begin + one.payload_size > kept) to->has_body = false;
        end(*to, way);
    }
    void end(detail::live_sample& sample, live_way way) noexcept {
        sample.way = static_cast<std::uint8_t>(way);
        sample.at = now();
        samples_.end_write();
    }

    std::atomic<bool> is_watched_{};
    detail::sample_ring samples_{};
    std::mutex mutex_{};
    live_state state_{};
    bool is_new_{};
};

} // namespace jauscat::net
