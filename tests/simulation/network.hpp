// Datagrams between processes: lost, doubled, delayed past others, and cut off.
#pragma once

#include "simulation/world.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace simulation {

/// A datagram on its way. `message` is the world's number for what it carries; a receiver under test cannot see it.
struct datagram {
    std::uint8_t from{}; ///< port
    std::uint8_t to{};   ///< port
    std::uint32_t message{};
    std::uint32_t size{};
    std::uint32_t place{}; ///< in the network's memory
    time arrived{};        ///< when the user's socket got it
    std::array<std::byte, 4128> bytes{};
    [[nodiscard]] std::span<const std::byte> content() const noexcept { return std::span{bytes}.first(size); }
};

/// Who is at a port.
class port_user {
  public:
    port_user() = default;
    port_user(const port_user&) = delete;
    port_user& operator=(const port_user&) = delete;
    virtual ~port_user() = default;
    /// True: the datagram is kept by the user, who gives it back.
    virtual bool arrives(datagram& one) = 0;
    [[nodiscard]] virtual std::uint8_t number() const noexcept = 0;
};

class network final : public actor {
  public:
    /// Datagrams may come this much later than those sent after them.
    static constexpr time longest_delay = std::chrono::milliseconds{300};

    explicit network(world& w) : world_{w} {}

    std::uint8_t add(port_user& user) {
        users_.push_back(&user);
        cut_.assign(users_.size() * users_.size(), {});
        pulse_.assign(users_.size() * users_.size(), {});
        component_.assign(users_.size() * users_.size(), {});
        disturbed_.assign(users_.size() * users_.size(), {});
        return static_cast<std::uint8_t>(users_.size() - 1);
    }
    [[nodiscard]] std::size_t size() const noexcept { return users_.size(); }
    void start() { world_.in(world_.faults.pause(fault::network_parted, mean_to_part), *this, to_part); }

    void send(std::uint8_t from, std::uint8_t to, std::span<const std::byte> content, std::uint32_t message) {
        if (content.size() > sizeof datagram::bytes) return;
        tell(deed::sends, from, to, content, message);
        world_.sees("a datagram", content);
        if (is_cut(from, to) || strikes(fault::datagram_lost, 10'000)) {
            disturbed_[from * users_.size() + to] = world_.now();
            return tell(deed::loses, from, to, content, message);
        }
        put(from, to, content, message);
        if (!strikes(fault::datagram_doubled, 10'000)) return;
        disturbed_[from * users_.size() + to] = world_.now();
        tell(deed::doubles, from, to, content, message);
        put(from, to, content, message);
    }
    /// While it is, nothing is lost, doubled or delayed.
    void set_calm(bool is_calm) noexcept { is_calm_ = is_calm; }
    void give_back(const datagram& one) { free_.push_back(one.place); }

    /// Since when nothing gets from one port to the other, if that is so.
    [[nodiscard]] std::optional<time> cut_since(std::uint8_t from, std::uint8_t to) const noexcept {
        return is_cut(from, to) ? std::optional{cut(from, to).since} : std::nullopt;
    }

    /// When the last heartbeat got from one port to the other.
    [[nodiscard]] time pulse_heard(std::uint8_t from, std::uint8_t to) const noexcept {
        return pulse_[from * users_.size() + to];
    }
    /// The same for any message of a component other than the node manager, but for queries of a heartbeat.
    [[nodiscard]] time component_heard(std::uint8_t from, std::uint8_t to) const noexcept {
        return component_[from * users_.size() + to];
    }

    /// When a datagram between two ports, in either direction, was last lost, doubled or late.
    [[nodiscard]] time disturbed_at(std::uint8_t a, std::uint8_t b) const noexcept {
        return std::max(disturbed_[a * users_.size() + b], disturbed_[b * users_.size() + a]);
    }

    void on_event(std::uint8_t what, std::uint32_t argument) override {
        switch (what) {
        case delivery: return deliver(*all_[argument]);
        case to_part: return part();
        default: return join(static_cast<std::uint8_t>(argument >> 8U), static_cast<std::uint8_t>(argument));
        }
    }

  private:
    enum : std::uint8_t { delivery, to_part, to_join };
    static constexpr time mean_to_part = std::chrono::seconds{2};

    static constexpr std::uint16_t pulse_code = 0x4202, pulse_query = 0x2202;

    [[nodiscard]] static std::uint16_t word(std::span<const std::byte> message, std::size_t at) noexcept {
        if (message.size() < at + 2) return 0;
        return static_cast<std::uint16_t>(std::to_integer<unsigned>(message[at]) |
                                          std::to_integer<unsigned>(message[at + 1]) << 8U);
    }
    [[nodiscard]] static std::uint16_t code_of(std::span<const std::byte> message) noexcept { return word(message, 2); }

    // To node managers, or to all.
    [[nodiscard]] static bool is_pulse(std::span<const std::byte> message) noexcept {
        if (code_of(message) != pulse_code) return false;
        const auto component = std::to_integer<unsigned>(message[5]);
        return component == 1 || component == 255;
    }
    // A node asks for heartbeats in the name of a component that may hang.
    [[nodiscard]] static bool is_of_component(std::span<const std::byte> message) noexcept {
        return message.size() > 9 && std::to_integer<unsigned>(message[9]) != 1 && code_of(message) != pulse_query;
    }

    struct cut_state {
        unsigned depth{};
        time since{};
    };
    [[nodiscard]] const cut_state& cut(std::uint8_t from, std::uint8_t to) const noexcept {
        return cut_[from * users_.size() + to];
    }
    [[nodiscard]] bool is_cut(std::uint8_t from, std::uint8_t to) const noexcept { return cut(from, to).depth != 0; }

    void tell(deed what, std::uint8_t from, std::uint8_t to, std::span<const std::byte> content, std::uint32_t message,
              std::uint32_t value = 0) {
        world_.tell({.what = what,
                     .who = users_[from]->number(),
                     .whom = users_[to]->number(),
                     .code = code_of(content),
                     .number = word(content, 14),
                     .message = message,
                     .value = value});
    }
    [[nodiscard]] bool strikes(fault kind, unsigned per_million) {
        return !is_calm_ && world_.faults.strikes(kind, per_million);
    }
    void put(std::uint8_t from, std::uint8_t to, std::span<const std::byte> content, std::uint32_t message) {
        time delay = world_.faults.random(fault::datagram_delayed)
                         .between(std::chrono::microseconds{100}, std::chrono::microseconds{400});
        if (strikes(fault::datagram_delayed, 10'000)) {
            delay = world_.faults.random(fault::datagram_delayed).between(std::chrono::milliseconds{1}, longest_delay);
            disturbed_[from * users_.size() + to] = world_.now() + delay;
            tell(deed::delays, from, to, content, message,
                 static_cast<std::uint32_t>(delay / std::chrono::milliseconds{1}));
        }
        const auto place = free_place();
        datagram& one = *all_[place];
        one.from = from;
        one.to = to;
        one.message = message;
        one.size = static_cast<std::uint32_t>(content.size());
        std::ranges::copy(content, one.bytes.begin());
        world_.in(delay, *this, delivery, place);
    }
    std::uint32_t free_place() {
        if (free_.empty()) {
            free_.push_back(static_cast<std::uint32_t>(all_.size()));
            all_.push_back(std::make_unique<datagram>());
            all_.back()->place = free_.back();
        }
        const auto place = free_.back();
        free_.pop_back();
        return place;
    }
    void deliver(datagram& one) {
        if (is_pulse(one.content())) pulse_[one.from * users_.size() + one.to] = world_.now();
        if (is_of_component(one.content())) component_[one.from * users_.size() + one.to] = world_.now();
        one.arrived = world_.now();
        if (!users_[one.to]->arrives(one)) give_back(one);
    }

    void part() {
        auto& random = world_.faults.random(fault::network_parted);
        world_.in(world_.faults.pause(fault::network_parted, mean_to_part), *this, to_part);
        if (users_.size() < 2 || !strikes(fault::network_parted, 100'000)) return;
        const auto a = static_cast<std::uint8_t>(random.below(users_.size()));
        const auto b = static_cast<std::uint8_t>((a + 1 + random.below(users_.size() - 1)) % users_.size());
        set_cut(a, b);
        const time until = random.between(std::chrono::milliseconds{20}, std::chrono::seconds{6});
        world_.in(until, *this, to_join, unsigned{a} << 8U | b);
        if (random.below(3) == 0) return; // one way only
        set_cut(b, a);
        world_.in(until, *this, to_join, unsigned{b} << 8U | a);
    }
    void set_cut(std::uint8_t from, std::uint8_t to) {
        auto& c = cut_[from * users_.size() + to];
        if (c.depth++ == 0) c.since = world_.now();
        world_.tell({.what = deed::parts, .who = users_[from]->number(), .whom = users_[to]->number()});
    }
    void join(std::uint8_t from, std::uint8_t to) {
        --cut_[from * users_.size() + to].depth;
        world_.tell({.what = deed::joins, .who = users_[from]->number(), .whom = users_[to]->number()});
    }

    world& world_;
    bool is_calm_{};
    std::vector<port_user*> users_{};
    std::vector<cut_state> cut_{};
    std::vector<time> pulse_{}, component_{}, disturbed_{};
    std::vector<std::unique_ptr<datagram>> all_{};
    std::vector<std::uint32_t> free_{};
};

} // namespace simulation
