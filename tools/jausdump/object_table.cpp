#include "object_table.hpp"

#include <jauscat/bridge/sae_delivery.hpp>
#include <jauscat/schema/translation/sae_table.hpp>
#include <jauscat/schema/translation/self_contained_table.hpp>
#include <jauscat/translate/fixed_length.hpp>

namespace jausdump {

namespace {

namespace bridging = jauscat::bridging;
namespace translate = jauscat::translate;
namespace translation_tables = jauscat::translation;

constexpr unsigned segment_size = 256; // indices of the table of SAE JAUS

unsigned distance_from_base(const object_transfer& object, const object_table& how) {
    return static_cast<unsigned>(object.index) - how.index_base;
}
bool is_sae(const object_table& how) { return how.table == translation::sae; }

/// The component of the object; 0 or more than 255 for other objects.
unsigned component_of(const object_transfer& object, const object_table& how) {
    const unsigned distance = distance_from_base(object, how);
    const bool is_in_segment = is_sae(how) && distance < segment_size * translation_tables::sae_segments::count;
    return is_in_segment ? distance % segment_size : distance;
}

/// The JAUS node of a slave; 0 where its station address is none.
std::uint8_t node_of(const slave_address& slave) {
    return slave.station() < 255 ? static_cast<std::uint8_t>(slave.station()) : std::uint8_t{};
}

template <class Table>
object_message translated(const object_transfer& object, std::span<const std::byte> data, const object_table& how) {
    using delivery = bridging::delivery<Table>;
    object_message message{.bytes = std::vector<std::byte>(delivery::translator::max_message_size)};
    const auto node = node_of(object.slave);
    const bridging::object_access access{
        .station = node,
        .index = static_cast<std::uint16_t>(translation_tables::seed_index_base + component_of(object, how)),
        .subindex = object.subindex,
        .data = data};
    const auto restored = delivery::message_of(access, {.subsystem = how.subsystem, .station = node}, message.bytes);
    message.error = restored.error();
    message.bytes.resize(restored ? restored->size() : 0);
    return message;
}

object_message sae_message_of(const object_transfer& object, const object_table& how) {
    using delivery = bridging::sae_delivery<translation_tables::sae_table>;
    object_message message{.bytes = std::vector<std::byte>(delivery::translator::max_message_size)};
    const auto restored =
        delivery::message_of({.station = node_of(object.slave),
                              .index = static_cast<std::uint16_t>(translation_tables::manufacturer_index_base +
                                                                  distance_from_base(object, how)),
                              .subindex = object.subindex,
                              .data = object.data},
                             message.bytes);
    message.error = restored.error();
    message.bytes.resize(restored ? restored->size() : 0);
    return message;
}

jaus::header header_of(const object_transfer& object, const object_table& how) {
    const auto& codes = translation_tables::ra_command_codes;
    const std::size_t place = object.subindex - 1u;
    jaus::header head{};
    head.command_code = place < codes.size() ? codes[place] : std::uint16_t{};
    head.destination = {.component = static_cast<std::uint8_t>(component_of(object, how)),
                        .node = node_of(object.slave),
                        .subsystem = how.subsystem};
    return head;
}

/// The same of a message of SAE JAUS.
sae_parts sae_parts_of(const object_transfer& object, const object_table& how) {
    sae_parts parts{.header = sae::transport_header{}};
    parts.header->destination = {.component = static_cast<std::uint8_t>(component_of(object, how)),
                                 .node = node_of(object.slave)};
    std::uint16_t id{};
    if (translation_tables::sae_segments::find(distance_from_base(object, how) / segment_size, object.subindex, id))
        parts.message_id = id;
    return parts;
}

} // namespace

bool is_message(const object_transfer& object, const object_table& how) {
    const auto component = component_of(object, how);
    return component >= 1 && component <= 255 && object.subindex != 0 && !object.complete_access;
}

object_message message_of(const object_transfer& object, const object_table& how) {
    if (is_sae(how)) return sae_message_of(object, how);
    std::span<const std::byte> data{object.data};
    if (how.fixed_length) {
        translate::data_length length{};
        const auto used = wire::decode_prefix(length, data);
        if (!used) return {.error = translate::errc::truncated};
        if (length.bytes > data.size() - *used) return {.error = translate::errc::wrong_size};
        data = data.subspan(*used, length.bytes);
    }
    return how.table == translation::seed ? translated<translation_tables::seed_table>(object, data, how)
                                          : translated<translation_tables::self_contained_table>(object, data, how);
}

record head_of(const object_transfer& object, const object_table& how) {
    const auto message = message_of(object, how);
    record made{};
    if (is_sae(how)) {
        made.sae = sae_parts_of(object, how);
        if (const auto split = sae::split(message.bytes)) {
            made.sae->header = split.header;
            made.sae->sequence_number = split.sequence_number;
        }
    } else {
        jaus::header head{};
        made.head = wire::decode_prefix(head, message.bytes) ? head : header_of(object, how);
    }
    return made;
}

} // namespace jausdump
