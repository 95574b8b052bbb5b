// What a row of a translation table needs.
#pragma once
#include <jauscat/translate/errc.hpp>
#include <jauscat/translate/path.hpp>

#include <concepts>
#include <cstddef>

namespace jauscat::translate {

/// Sizes of a message on both sides of a table.
struct sizes {
    std::size_t body{}; ///< bytes behind the JAUS header
    std::size_t data{}; ///< bytes of the packet's data: what `rest` keeps of the header, then the body
};

namespace detail {

template <class List> inline constexpr bool is_path_list = false;
template <class... Paths> inline constexpr bool is_path_list<path_list<Paths...>> = true;

template <class Row> concept has_uses = is_path_list<typename Row::uses>;
template <class Row> concept has_writes = is_path_list<typename Row::writes>;
template <class Row, class Message, class Packet>
concept has_to_packet = requires(const Message& message, Packet& packet, sizes s) {
    { Row::to_packet(message, packet, s) } noexcept -> std::same_as<errc>;
};
template <class Row, class Message, class Packet>
concept has_from_packet = requires(const Packet& packet, Message& message, sizes s) {
    { Row::from_packet(packet, message, s) } noexcept -> std::same_as<errc>;
};

} // namespace detail

/// A row of a table between `Message` and `Packet`. In a `table` these are the message header and the packet, in an
/// `image_table` the message, with integers as on the wire, and the image. Needed, both functions static and noexcept:
/// - `uses`: a path_list of the message fields that the row takes out of `rest`;
/// - `writes`: a path_list of the packet fields that it fills;
/// - `to_packet(const auto& message, auto& packet, sizes)` returns an errc;
/// - `from_packet(const auto& packet, auto& message, sizes)`, the reverse, returns an errc.
///
/// Optional, for a row that does the work of one of the library's: `states_body_size`, `counts_data`, `checks_in_rest`,
/// `says_presence` and `counts_messages` (types, the field's path), `carries_rest`, `gives_index` and `gives_subindex`
/// (constants), `keep`.
template <class Row, class Message, class Packet>
concept row = detail::has_uses<Row> && detail::has_writes<Row> && detail::has_to_packet<Row, Message, Packet> &&
              detail::has_from_packet<Row, Message, Packet>;

namespace detail {

// Does not compile for a row that lacks an operation, and says which.
template <class Row, class Message, class Packet> consteval bool require_row() noexcept {
    static_assert(has_uses<Row>, "table: a row has no path_list `uses`");
    static_assert(has_writes<Row>, "table: a row has no path_list `writes`");
    static_assert(has_to_packet<Row, Message, Packet>,
                  "table: a row has no static to_packet(const auto& message, auto& packet, sizes) noexcept that returns"
                  " an errc");
    static_assert(has_from_packet<Row, Message, Packet>,
                  "table: a row has no static from_packet(const auto& packet, auto& message, sizes) noexcept that"
                  " returns an errc");
    return row<Row, Message, Packet>;
}

} // namespace detail

} // namespace jauscat::translate
