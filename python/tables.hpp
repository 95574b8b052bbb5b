// JAUS messages as objects of EtherCAT slaves, by the mapping tables.
#pragma once
#include "errors.hpp"
#include "messages.hpp"
#include <jauscat/schema/translation/sae_table.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/translate/translator.hpp>

namespace python {

namespace translate = jauscat::translate;
namespace tables = jauscat::translation;

/// A message as an SDO download, and the Hilscher packet that requests it.
struct packet {
    std::uint32_t node{}, index{}, subindex{};
    py::bytes data{}, bytes{};
};

/// The parts of a packet. Tables of other index bases differ in the index alone: it is moved by `offset`.
template <class Fields>
std::pair<Fields, std::vector<std::byte>> moved(std::span<const std::byte> bytes, std::uint32_t offset) {
    Fields fields{};
    const auto size = wire::decode_prefix(fields, bytes);
    if (!size) raise(error_classes::all().translate, std::string{describe(translate::errc::truncated)});
    fields.ul_index += offset;
    std::vector<std::byte> made(bytes.begin(), bytes.end());
    static_cast<void>(wire::encode(fields, made));
    return {fields, std::move(made)};
}

inline void refuse(translate::errc why) { raise(error_classes::all().translate, std::string{describe(why)}); }

/// Calls use.template operator()<Table>(its index base).
auto with_table(std::string_view name, auto&& use) {
    if (name == "seed") return use.template operator()<tables::seed_table>(tables::seed_index_base);
    if (name == "self-contained") return use.template operator()<tables::self_contained_table>(tables::seed_index_base);
    if (name == "sae") return use.template operator()<tables::sae_table>(tables::manufacturer_index_base);
    throw py::value_error{"the table is 'seed', 'self-contained' or 'sae', not " + text::quoted(name)};
}

inline packet to_packet(const py::bytes& message, std::string_view table, std::optional<std::uint32_t> index_base) {
    return with_table(table, [&]<class Table>(std::uint32_t base) {
        using translator = translate::translator<Table>;
        std::vector<std::byte> bytes(translator::max_packet_size);
        const auto made = translator::to_packet(bytes_of(message), bytes);
        if (!made) refuse(made.error());
        const auto [fields, all] = moved<typename Table::packet_type>(*made, index_base.value_or(base) - base);
        return packet{.node = fields.ul_node_id,
                      .index = fields.ul_index,
                      .subindex = fields.ul_sub_index,
                      .data = to_bytes(std::span{all}.subspan(translator::packet_size)),
                      .bytes = to_bytes(all)};
    });
}

inline py::bytes from_packet(const py::bytes& bytes, std::string_view table, std::optional<std::uint32_t> index_base) {
    return with_table(table, [&]<class Table>(std::uint32_t base) {
        using translator = translate::translator<Table>;
        const auto all = moved<typename Table::packet_type>(bytes_of(bytes), base - index_base.value_or(base)).second;
        std::vector<std::byte> message(translator::max_message_size);
        const auto made = translator::from_packet(all, message);
        if (!made) refuse(made.error());
        return to_bytes(*made);
    });
}

} // namespace python
