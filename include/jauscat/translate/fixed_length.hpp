// The option `fixed_length` of a table: every object has one size, and the data are padded to it. For slaves that take
// and give an object only at its exact size, and abort another one with 06070010.
#pragma once
#include <jauscat/translate/table.hpp>
#include <jauscat/wire/code_index.hpp>
#include <jauscat/wire/schema.hpp>

#include <array>
#include <cstdint>

namespace jauscat::translate {

/// Length prefix of padded data: 2 bytes, little endian.
struct data_length {
    std::uint16_t bytes{}; ///< real bytes behind it; zeros fill the object up after them
};

} // namespace jauscat::translate

template <> struct jauscat::wire::schema<jauscat::translate::data_length> {
    using T = translate::data_length;
    using type = layout<field<&T::bytes, u16le>>;
};

namespace jauscat::translate {

/// `Table` with objects of fixed length. The packet's data are then
///
///     bytes 0 and 1   n, the real length: what `Table` alone would have as data, little endian
///     n bytes         the data as under `Table`: its rest, then the body
///     zeros           up to the object's size
///
/// and ulDataCnt is the object's size: 2 + the table's rest + the largest body of the message, or all of `max_data` for
/// a message without a limit. Commands and reports, both directions: a packet of another size is refused
/// (`wrong_size`), a body longer than its message allows does not fit (`too_large`). The padding is not checked.
///
/// `Messages` are those that have objects, or one list of them such as jaus::messages: the sizes are derived from their
/// schemas. A message that is not among them is refused (`unknown_command_code`).
///
///     using table = translate::fixed_length<translation::seed_table, jaus::message_list<jaus::set_wrench_effort>>;
///
/// Off by default: the two bytes and the padding cost time on the wire, and slaves whose objects vary need neither.
template <class Table, class... Messages> struct fixed_length : Table {
    static_assert(!has_fixed_length<Table>, "fixed_length: the table has the option already");
    static_assert(Table::max_data <= 0xFFFF, "fixed_length: the length in front of the data has 16 bits");
    /// Bytes of the packet's data that are not the body.
    static constexpr std::size_t overhead = Table::overhead + wire::max_size<data_length>;
    static constexpr std::array<std::uint16_t, sizeof...(Messages)> codes{code_of<Messages>...};
    /// The objects' sizes, beside their messages' codes.
    static constexpr std::array<std::size_t, sizeof...(Messages)> object_sizes{
        largest_data<typename Table::header_type, Messages, overhead, Table::max_data>...};

    /// Bytes of the object of the message with this header; 0 for a message without one.
    [[nodiscard]] static constexpr std::size_t object_size(const typename Table::header_type& header) noexcept {
        const std::size_t place = wire::code_index<codes>::find(Table::subindex_row::from::of(header));
        return place == wire::code_index<codes>::npos ? 0 : object_sizes[place];
    }
};

template <class Table, template <class...> class List, class... Messages>
requires(!wire::message<List<Messages...>>)
struct fixed_length<Table, List<Messages...>> : fixed_length<Table, Messages...> {};

} // namespace jauscat::translate
