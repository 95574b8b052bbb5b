// Objects of EtherCAT slaves as JAUS messages, under a translation table.
#pragma once
#include "record.hpp"
#include "sdo_reader.hpp"
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/schema/translation/index_bases.hpp>
#include <jauscat/translate/errc.hpp>

namespace jausdump {

enum class translation { none, seed, self_contained, sae };

/// The table that the master of a capture has used.
struct object_table {
    jausdump::translation table{};
    std::uint16_t index_base{jauscat::translation::seed_index_base};
    bool fixed_length{};      ///< data begin with their length and are filled up
    std::uint8_t subsystem{}; ///< of the slaves; 0: not known. The seed table does not carry it
};

/// A message, or why the object's data are none.
struct object_message {
    jauscat::translate::errc error{};
    std::vector<std::byte> bytes{};
};

/// Whether the object is a message of a component.
bool is_message(const object_transfer& object, const object_table& how);
object_message message_of(const object_transfer& object, const object_table& how);
/// Header and code of the object's message, without its content. Where its data are no message, what object and station
/// say: code, destination component and node; the rest is 0.
record head_of(const object_transfer& object, const object_table& how);

} // namespace jausdump
