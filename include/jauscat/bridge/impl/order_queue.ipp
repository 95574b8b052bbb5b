// The functions of order_queue.
#pragma once
#include <jauscat/bridge/order_queue.hpp>

namespace jauscat::bridging {

JAUSCAT_CONSTEXPR bool is_query(const jaus::header& head) noexcept {
    return jaus::report_code_of(head.command_code) != 0;
}

JAUSCAT_CONSTEXPR order_queue::bytes order_queue::body(const order& message) const noexcept {
    return body_place(message).first(message.size);
}

JAUSCAT_CONSTEXPR std::optional<time_point> order_queue::next_expiry() const noexcept {
    const order* const found = earliest();
    return found == nullptr ? std::nullopt : std::optional{found->expires.at()};
}

JAUSCAT_CONSTEXPR bool order_queue::has_one_of(const component& unit) const noexcept {
    return std::ranges::any_of(orders_, [&](const order& each) { return each.number != 0 && each.unit == &unit; });
}

JAUSCAT_CONSTEXPR std::size_t order_queue::size() const noexcept {
    return static_cast<std::size_t>(std::ranges::count_if(orders_, [](const order& each) { return each.number != 0; }));
}

JAUSCAT_CONSTEXPR std::size_t order_queue::index(const order& of) const noexcept {
    return static_cast<std::size_t>(&of - orders_.data());
}

JAUSCAT_CONSTEXPR std::span<std::byte> order_queue::body_place(const order& of) const noexcept {
    return bodies_.subspan(index(of) * share(), share());
}

JAUSCAT_CONSTEXPR const order* order_queue::earliest() const noexcept {
    const order* found = nullptr;
    for (const order& each : orders_)
        if (each.number != 0 && (found == nullptr || each.expires < found->expires)) found = &each;
    return found;
}

JAUSCAT_CONSTEXPR order* order_queue::superseded_by(const order& newer) const noexcept {
    if (!is_superseding(newer.header.command_code)) return nullptr;
    const auto found = std::ranges::find_if(orders_, [&](const order& each) {
        return each.number != 0 && each.unit == newer.unit && each.header.source == newer.header.source &&
               each.header.command_code == newer.header.command_code;
    });
    return found == orders_.end() ? nullptr : &*found;
}

} // namespace jauscat::bridging
