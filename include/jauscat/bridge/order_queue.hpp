// Queue of messages to a slave: FIFO; keeps only the newest motion command of each sender and code.
#pragma once
#include <jauscat/base/compilation.hpp>
#include <jauscat/base/time.hpp>
#include <jauscat/bridge/supersede.hpp>
#include <jauscat/jaus/message/message.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace jauscat::bridging {

class component;

/// A message that waits for its slave: a place in the memory of an order_queue.
struct order {
    jaus::header header{};  ///< unchanged
    component* unit{};      ///< the component that the message is for
    deadline expires{};     ///< refused if it still waits then
    std::uint16_t size{};   ///< bytes of the body
    std::uint64_t number{}; ///< order of arrival; 0: the place is free
};

/// Whether a message requests a report, and so moves nothing.
[[nodiscard]] JAUSCAT_CONSTEXPR bool is_query(const jaus::header& head) noexcept;

/// The memory of an order_queue: `Orders` messages of at most `Size` bytes of body.
template <std::size_t Orders = 16, std::size_t Size = 1532> struct order_memory {
    std::array<order, Orders> orders{};
    std::array<std::byte, Orders * Size> bodies{};
};

/// Result of queueing a message.
enum class queued : std::uint8_t {
    last,      ///< behind all others
    merged,    ///< merged into an older command of the same sender and code, which it replaces
    full,      ///< not queued: no free place, or only reserved ones
    too_large, ///< not queued: the body does not fit a place
};

/// Messages that wait for a slave: of commands that set something only the newest of a sender.
class order_queue {
  public:
    using bytes = std::span<const std::byte>;

    /// The memory must outlive this.
    template <std::size_t Orders, std::size_t Size>
    constexpr explicit order_queue(order_memory<Orders, Size>& memory) noexcept
        : orders_{memory.orders}, bodies_{memory.bodies} {}

    /// Queues a message. Where it supersedes a waiting command of the same sender, `superseded(const header&)` gets the
    /// older one's header; fields that only the older one carries are kept. `reserved` places stay free for others.
    [[nodiscard]] constexpr queued push(const order& message, bytes body, auto&& superseded, std::size_t reserved = 0) {
        if (body.size() > share()) return queued::too_large;
        if (order* const older = superseded_by(message)) {
            const auto place = body_place(*older);
            const auto size = merge(message.header.command_code, place.first(older->size), body, place);
            if (size) {
                superseded(std::as_const(older->header));
                older->header = message.header;
                older->expires = message.expires;
                older->size = static_cast<std::uint16_t>(*size);
                return queued::merged;
            }
        }
        const auto free = std::ranges::find(orders_, std::uint64_t{}, &order::number);
        if (free == orders_.end() || orders_.size() - size() <= reserved) return queued::full;
        *free = message;
        free->size = static_cast<std::uint16_t>(body.size());
        free->number = ++last_number_;
        std::ranges::copy(body, body_place(*free).begin());
        return queued::last;
    }

    /// The oldest message for which `wanted(const order&)` holds; nullptr where there is none.
    [[nodiscard]] constexpr const order* first(auto&& wanted) const {
        const order* found = nullptr;
        for (const order& each : orders_)
            if (each.number != 0 && wanted(each) && (found == nullptr || each.number < found->number)) found = &each;
        return found;
    }
    [[nodiscard]] JAUSCAT_CONSTEXPR bytes body(const order& message) const noexcept;
    /// Frees the place of a message of this queue.
    JAUSCAT_CONSTEXPR void remove(const order& message) noexcept { orders_[index(message)].number = 0; }
    /// Removes each message for which `unwanted(const order&)` holds; `dropped(const order&)` gets it.
    constexpr void remove_if(auto&& unwanted, auto&& dropped) {
        for (order& each : orders_) {
            if (each.number == 0 || !unwanted(std::as_const(each))) continue;
            const order gone = each;
            each.number = 0;
            dropped(gone);
        }
    }
    /// When the first of the waiting messages expires.
    [[nodiscard]] JAUSCAT_CONSTEXPR std::optional<time_point> next_expiry() const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR bool has_one_of(const component& unit) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::size_t size() const noexcept;

  private:
    [[nodiscard]] constexpr std::size_t share() const noexcept { return bodies_.size() / orders_.size(); }
    [[nodiscard]] JAUSCAT_CONSTEXPR std::size_t index(const order& of) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR std::span<std::byte> body_place(const order& of) const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR const order* earliest() const noexcept;
    [[nodiscard]] JAUSCAT_CONSTEXPR order* superseded_by(const order& newer) const noexcept;

    std::span<order> orders_;
    std::span<std::byte> bodies_;
    std::uint64_t last_number_{};
};

} // namespace jauscat::bridging

#ifndef JAUSCAT_SEPARATE_COMPILATION
#    include <jauscat/bridge/impl/order_queue.ipp>
#endif
