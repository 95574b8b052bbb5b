// Explains a refused translation: row, field and value. It applies the rows once more, so that the translator returns
// only an error code.
#pragma once
#include <jauscat/translate/translator.hpp>

#include <limits>
#include <string_view>

namespace jauscat::translate {

/// The row that refuses a message or a packet.
struct diagnosis {
    /// Stands for: no row refuses, the error is of a size.
    static constexpr std::size_t no_row = std::numeric_limits<std::size_t>::max();

    errc error{};
    std::size_t row = no_row;  ///< of the table, from 0
    std::string_view parent{}; ///< the structure around the field, such as "destination"; empty if there is none
    std::string_view field{};  ///< the name of the field whose value is refused
    std::uint64_t value{};     ///< its value; signed ones in two's complement
    wire::errc codec{};        ///< process images: why the field does not decode or encode; ok if a row refuses it

    friend constexpr bool operator==(const diagnosis&, const diagnosis&) = default;
};

namespace detail {

template <class Path> constexpr void blame(diagnosis& found, const auto& object) noexcept {
    found.parent = Path::parent();
    found.field = Path::field();
    if constexpr (requires { Path::of(object).last(); }) // an element of a message for a process image
        found.value = static_cast<std::uint64_t>(Path::of(object).last());
    else
        found.value = static_cast<std::uint64_t>(Path::of(object));
}
// The field on the side that is read; where the row has none there, that on the other side.
template <class Read, class... More>
constexpr void blame(path_list<Read, More...>, auto, diagnosis& found, const auto& read, const auto&) noexcept {
    blame<Read>(found, read);
}
template <class Other, class... More>
constexpr void blame(path_list<>, path_list<Other, More...>, diagnosis& found, const auto&,
                     const auto& other) noexcept {
    blame<Other>(found, other);
}
constexpr void blame(path_list<>, path_list<>, diagnosis&, const auto&, const auto&) noexcept {}

template <class Row> struct states_size {
    using uses = typename Row::uses;
};
template <class Row>
requires requires { typename Row::states_body_size; }
struct states_size<Row> {
    using uses = path_list<typename Row::states_body_size>;
};
template <class Row>
requires requires { typename Row::checks_in_rest; }
struct states_size<Row> {
    using uses = path_list<typename Row::checks_in_rest>;
};

/// Finds the first row that refuses `read` with the error.
template <bool ToPacket, class... Rows>
constexpr void find_row(row_list<Rows...>, diagnosis& found, const auto& read, auto& written, sizes s) noexcept {
    std::size_t row = 0;
    const auto refuses = [&]<class Row>(const Row*) {
        const errc error = [&] {
            if constexpr (ToPacket)
                return Row::to_packet(read, written, s);
            else
                return Row::from_packet(read, written, s);
        }();
        if (error != found.error) return ++row, false;
        using uses = typename states_size<Row>::uses;
        using writes = typename Row::writes;
        found.row = row;
        blame(std::conditional_t<ToPacket, uses, writes>{}, std::conditional_t<ToPacket, writes, uses>{}, found, read,
              written);
        return true;
    };
    static_cast<void>((refuses(static_cast<const Rows*>(nullptr)) || ...));
}

} // namespace detail

/// Explains `error` that `translator<Table>::to_packet` returned for `message`: the first row that refuses it with this
/// error. `row` is no_row for errors of sizes (truncated, too_large, no_space).
template <class Table>
[[nodiscard]] constexpr diagnosis diagnose_to_packet(errc error, std::span<const std::byte> message) noexcept {
    diagnosis found{.error = error};
    typename Table::header_type header{};
    typename Table::packet_type packet{};
    if (error == errc::ok || !wire::decode_prefix(header, message)) return found;
    const std::size_t body = message.size() - translator<Table>::header_size;
    detail::find_row<true>(typename Table::rows{}, found, header, packet, {body, body + Table::overhead});
    return found;
}

/// Explains `error` that `translator<Table>::from_packet` returned for `packet`, likewise.
template <class Table>
[[nodiscard]] constexpr diagnosis diagnose_from_packet(errc error, std::span<const std::byte> packet) noexcept {
    diagnosis found{.error = error};
    typename Table::packet_type fields{};
    typename Table::header_type header{};
    const auto used = wire::decode_prefix(fields, packet);
    if (error == errc::ok || !used) return found;
    const std::size_t data = Table::data_count_row::counts_data::of(fields);
    if (data < Table::overhead || data > packet.size() - *used) return found;
    detail::find_row<false>(typename Table::rows{}, found, fields, header, {data - Table::overhead, data});
    return found;
}

} // namespace jauscat::translate
