// A translation table: rows between a message header and a packet, checked at compile time.
#pragma once
#include <jauscat/translate/rows.hpp>
#include <jauscat/wire/raw.hpp>

#include <algorithm>
#include <array>

namespace jauscat::translate {

namespace detail {

/// Some consecutive bytes of the message header.
struct byte_range {
    std::size_t offset{}, size{};
};
template <std::size_t Capacity> struct byte_ranges {
    std::array<byte_range, Capacity> range{};
    std::size_t count{};
    std::size_t bytes{};
    bool splits_carrier{};

    constexpr void add(std::size_t offset, std::size_t size) {
        bytes += size;
        if (count != 0 && range[count - 1].offset + range[count - 1].size == offset)
            range[count - 1].size += size;
        else
            range[count++] = {offset, size};
    }
};

// Adds what the fields in `Used` leave of an item to `found`, and moves `offset` past the item.
template <class Used, class Within, class Item> struct collect_rest {
    static constexpr void into(auto& found, std::size_t& offset) {
        using paths = typename Within::template prefixed<typename leaves<Item>::type>;
        constexpr std::size_t used = paths::template found_in<Used>;
        if (used == 0)
            found.add(offset, Item::max_size);
        else if (used != paths::size)
            found.splits_carrier = true;
        offset += Item::max_size;
    }
};
template <class Used, class Within, class... Items> struct collect_rest<Used, Within, wire::layout<Items...>> {
    static constexpr void into(auto& found, std::size_t& offset) {
        (collect_rest<Used, Within, Items>::into(found, offset), ...);
    }
};
struct outermost {
    template <class Paths> using prefixed = Paths;
};
template <class Within, auto Member> struct inside {
    template <class Paths> using prefixed = typename Within::template prefixed<typename Paths::template within<Member>>;
};
template <class Used, class Within, auto Member> struct collect_rest<Used, Within, wire::nested<Member>> {
    static constexpr void into(auto& found, std::size_t& offset) {
        collect_rest<Used, inside<Within, Member>, typename wire::nested<Member>::inner>::into(found, offset);
    }
};

// Kinds of rows.
struct states_body_size {
    template <class Row> static constexpr bool is = requires { typename Row::states_body_size; };
};
struct counts_data {
    template <class Row> static constexpr bool is = requires { typename Row::counts_data; };
};
struct checks_in_rest { // fields that are in the rest, and are checked when the header is whole
    template <class Row>
    static constexpr bool is = [] {
        if constexpr (requires { typename Row::states_body_size; })
            return Row::uses::size == 0;
        else
            return requires { typename Row::checks_in_rest; };
    }();
};
struct carries_rest {
    template <class Row> static constexpr bool is = requires { Row::carries_rest; };
};
struct gives_index {
    template <class Row> static constexpr bool is = requires { Row::gives_index; };
};
struct gives_subindex {
    template <class Row> static constexpr bool is = requires { Row::gives_subindex; };
};

template <class Kind, class... Rows>
inline constexpr std::size_t rows_of_kind = (std::size_t{Kind::template is<Rows>} + ... + 0);
// The first row of a kind among `Rows`; void if there is none.
template <class Kind, class... Rows> struct row_of_kind {
    using type = void;
};
template <class Kind, class Row, class... Rows>
struct row_of_kind<Kind, Row, Rows...>
    : std::conditional_t<Kind::template is<Row>, std::type_identity<Row>, row_of_kind<Kind, Rows...>> {};

} // namespace detail

template <class... Rows> struct row_list {};

/// A table between the message header `Header` and the packet `Packet`, with at most `MaxData` bytes of data.
template <wire::fixed_message Header, wire::fixed_message Packet, std::size_t MaxData, class... Rows> struct table {
    using header_type = Header;
    using packet_type = Packet;
    using rows = row_list<Rows...>;
    /// Most bytes of data in one packet.
    static constexpr std::size_t max_data = MaxData;

    static_assert((detail::require_row<Rows, Header, Packet>() && ...));
    using used = joined_paths<typename Rows::uses...>;
    using written = joined_paths<typename Rows::writes...>;
    static_assert(used::template found_in<paths_of<Header>> == used::size &&
                      written::template found_in<paths_of<Packet>> == written::size,
                  "table: a row names a field that the message or the packet does not have");
    static_assert(used::distinct, "table: a message field is used by two rows");
    static_assert(written::distinct, "table: a packet field is written by two rows");
    static_assert(!written::distinct || paths_of<Packet>::template each_once_in<written>,
                  "table: a packet field is not written by any row");
    static_assert(detail::rows_of_kind<detail::carries_rest, Rows...> == 1 ||
                      paths_of<Header>::template each_once_in<used>,
                  "table: a message field is used by no row, and there is no row `rest` to carry it");
    static_assert(detail::rows_of_kind<detail::states_body_size, Rows...> == 1,
                  "table: exactly one row must say which message field states the body's size");
    static_assert(detail::rows_of_kind<detail::counts_data, Rows...> == 1,
                  "table: exactly one row must say which packet field counts the data");

    using body_size_row = typename detail::row_of_kind<detail::states_body_size, Rows...>::type;
    using data_count_row = typename detail::row_of_kind<detail::counts_data, Rows...>::type;
    static_assert(MaxData <= std::numeric_limits<typename data_count_row::counts_data::type>::max(),
                  "table: the packet field that counts the data is too narrow for the largest data");
    /// The rows that determine the object of a message; void if the packet is not for an object dictionary.
    using index_row = typename detail::row_of_kind<detail::gives_index, Rows...>::type;
    using subindex_row = typename detail::row_of_kind<detail::gives_subindex, Rows...>::type;

    /// The bytes of the header that travel in the packet's data, in wire order.
    static constexpr auto rest = [] {
        detail::byte_ranges<paths_of<Header>::size + 1> found{};
        std::size_t offset = 0;
        detail::collect_rest<used, detail::outermost, wire::layout_of<Header>>::into(found, offset);
        return found;
    }();
    static_assert(!rest.splits_carrier,
                  "table: rest would split an integer that bit-fields share; use all of its fields or none");
    /// Bytes of the packet's data that are not the body.
    static constexpr std::size_t overhead = rest.bytes;

    [[gnu::always_inline]] static constexpr errc to_packet(const Header& header, Packet& packet, sizes s) noexcept {
        errc error = errc::ok;
        static_cast<void>((((error = Rows::to_packet(header, packet, s)) == errc::ok) && ...));
        return error;
    }
    /// Whether rows check fields that are in the rest.
    static constexpr bool checks_rest = detail::rows_of_kind<detail::checks_in_rest, Rows...> != 0;
    /// Applies these rows to a header that is whole.
    [[gnu::always_inline]] static constexpr errc check_rest(const Header& header, const Packet& packet,
                                                            sizes s) noexcept {
        errc error = errc::ok;
        const auto passes = [&]<class Row>(const Row*) {
            if constexpr (detail::checks_in_rest::is<Row>) error = Row::to_packet(header, packet, s);
            return error == errc::ok;
        };
        static_cast<void>((passes(static_cast<const Rows*>(nullptr)) && ...));
        return error;
    }
    /// Fills in what the rows make of `header`, and leaves alone what they cannot translate.
    static constexpr void prefill(const Header& header, Packet& packet, sizes s) noexcept {
        (static_cast<void>(Rows::to_packet(header, packet, s)), ...);
    }
    [[gnu::always_inline]] static constexpr errc from_packet(const Packet& packet, Header& header, sizes s) noexcept {
        errc error = errc::ok;
        static_cast<void>((((error = Rows::from_packet(packet, header, s)) == errc::ok) && ...));
        return error;
    }
};

/// Whether the table has the option fixed_length: the data of each message have one size.
template <class Table>
inline constexpr bool has_fixed_length =
    requires(const typename Table::header_type& header) { Table::object_size(header); };

/// Most bytes behind `Header` in a message of the type `T`; wire::unbounded if it has no limit, or takes what follows
/// it. To be specialised for a header that is not right in front of what the schema of `T` describes.
template <class Header, wire::message T>
inline constexpr std::size_t largest_body = wire::layout_of<T>::to_the_end ? wire::unbounded : wire::max_size<T>;

/// The code of a message, or of the message of a raw, which its schema states: `command_code`, or the `message_id` of
/// SAE.
template <class T>
inline constexpr std::uint16_t code_of = [] {
    if constexpr (wire::raw_object<T>)
        return code_of<typename T::raw_of>;
    else if constexpr (requires { wire::schema<T>::message_id; })
        return wire::schema<T>::message_id;
    else
        return wire::schema<T>::command_code;
}();

/// Most bytes of data that the message `T` takes where the table adds `Overhead` and a packet carries `MaxData`: all of
/// `MaxData` for a message that has no limit, or takes what follows it.
template <class Header, wire::message T, std::size_t Overhead, std::size_t MaxData>
inline constexpr std::size_t largest_data = std::min(wire::total_size(Overhead, largest_body<Header, T>), MaxData);

} // namespace jauscat::translate
