// Messages by name or code: what is known of them, and their bytes.
#pragma once
#include "errors.hpp"
#include "values.hpp"
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/jaus/message/framing.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/net/config/jausip.hpp>
#include <jauscat/sae/transport/jaus_id.hpp>
#include <jauscat/sae/transport/judp.hpp>
#include <jauscat/sae/transport/message.hpp>
#include <jauscat/schema/sae/message_id.hpp>
#include <jauscat/text/diagnosis_text.hpp>

#include <map>
#include <optional>
#include <pybind11/stl.h>
#include <utility>

namespace python {

namespace catalogue = jauscat::catalogue;
namespace jaus = jauscat::jaus;
namespace sae = jauscat::sae;
namespace wire = jauscat::wire;

enum class generation : std::uint8_t { ra, sae };

inline generation generation_of(std::string_view name) {
    if (name == "ra") return generation::ra;
    if (name == "sae") return generation::sae;
    throw py::value_error{"the generation is 'ra' or 'sae', not " + text::quoted(name)};
}
inline const catalogue::list& messages_of(generation which) {
    return which == generation::ra ? catalogue::ra_3_3() : catalogue::sae();
}

/// Characters and bytes as Python hands them over; valid while `data` is.
inline std::span<const std::byte> bytes_of(const py::bytes& data) {
    return std::as_bytes(std::span{std::string_view{data}});
}

/// What is known of a field.
struct field {
    std::string name{}, kind{}, unit{};
    py::object lowest = py::none{}, highest = py::none{}; ///< numbers
    std::map<std::uint64_t, std::string> names{};         ///< of enumerators or bits
    bool is_optional{};
    std::optional<unsigned> presence_bit{};
    std::optional<std::size_t> least{}, most{}; ///< elements, characters or bytes
    std::vector<field> fields{};                ///< of a record, an element, or the alternatives
};

std::vector<field> fields_of(const text::structure& type, std::size_t level);

/// Fills in what the form of a value says.
class field_filler {
  public:
    field_filler(field& to, std::size_t level) : to_{to}, level_{level} {}
    void fill(const text::form& how) {
        std::visit([this](const auto& is) { told(is); }, how.is);
    }

  private:
    void told(const text::integer_form& is) {
        using meaning = text::integer_form::meaning;
        to_.kind = is.what == meaning::enumeration ? "enumeration"
                   : is.what == meaning::flags     ? "flags"
                   : is.what == meaning::boolean   ? "boolean"
                                                   : "integer";
        to_.unit = is.unit;
        for (std::size_t i = 0; i != is.names.size(); ++i)
            if (!is.names[i].empty()) to_.names.emplace(i, is.names[i]);
        const std::uint64_t highest = ~std::uint64_t{} >> (64 - is.bits);
        to_.lowest = is.is_signed ? py::int_{-static_cast<std::int64_t>(highest >> 1U) - 1} : py::int_{0};
        to_.highest = py::int_{is.is_signed ? highest >> 1U : highest};
    }
    void told(const text::real_form& is) {
        to_.kind = "real";
        to_.unit = is.unit;
        to_.lowest = py::float_{-is.most};
        to_.highest = py::float_{is.most};
    }
    void told(const text::scaled_form& is) {
        to_.kind = "real";
        to_.unit = is.unit;
        to_.lowest = py::float_{is.min};
        to_.highest = py::float_{is.max};
    }
    void told(const text::octets_form& is) {
        to_.kind = is.characters ? "text" : "bytes";
        to_.least = is.least;
        to_.most = is.most;
    }
    void told(const text::structure_form& is) { record("record", is.of); }
    void told(const text::packed_form& is) { record("packed", is.of); }
    void told(const text::encoded_form& is) { record("message", is.of); }
    void told(const text::list_form& is) {
        list(is);
        to_.kind = "list";
    }
    void told(const text::tree_form& is) {
        list(is.nodes);
        to_.kind = "tree";
    }
    void told(const text::choice_form& is) {
        to_.kind = "choice";
        for (const text::choice_case& one : is.cases) alternative(std::to_string(one.tag), one.how);
    }
    void told(const text::variant_form& is) {
        to_.kind = "variant";
        for (const text::alternative& one : is.alternatives) alternative(std::string{one.name}, one.how);
    }

    void record(std::string_view kind, const text::structure* of) {
        to_.kind = kind;
        if (of != nullptr) to_.fields = fields_of(*of, level_ + 1);
    }
    void list(const text::list_form& is) {
        to_.least = is.least;
        to_.most = is.most;
        if (const auto* const record = std::get_if<text::structure_form>(&is.element->is); record != nullptr)
            to_.fields = fields_of(*record->of, level_ + 1);
        else
            alternative(std::string{is.field}, is.element);
    }
    void alternative(std::string name, const text::form* how) {
        field& one = to_.fields.emplace_back(field{.name = std::move(name), .kind = "empty"});
        if (how != nullptr && level_ != text::max_levels) field_filler{one, level_ + 1}.fill(*how);
    }

    field& to_;
    std::size_t level_;
};

inline std::vector<field> fields_of(const text::structure& type, std::size_t level) {
    std::vector<field> made;
    if (level == text::max_levels) return made;
    for (const text::member& one : type.members) {
        if (one.what != text::member::role::value) continue;
        field& last = made.emplace_back(
            field{.name = std::string{one.name}, .is_optional = one.optional, .presence_bit = one.presence_bit});
        field_filler{last, level}.fill(*one.how);
    }
    return made;
}

/// A message that was received, or that a body makes.
struct message {
    catalogue::entry type;
    generation of{};
    py::dict fields{};
    py::bytes body{};
    std::optional<std::uint64_t> presence_vector{};
    std::string source{}, destination{}; ///< empty: not known
    std::optional<std::uint16_t> sequence_number{};
    bool wants_acknowledgement{};
};

inline message to_message(const catalogue::any_message& from, generation of, std::span<const std::byte> body) {
    const auto& type = from.type().fields();
    message made{
        .type = from.type(), .of = of, .fields = value_writer{}.fields(type, from.object()), .body = to_bytes(body)};
    for (const text::member& one : type.members)
        if (one.what == text::member::role::presence_vector) made.presence_vector = one.number(from.object());
    return made;
}

/// A message that may be sent or received.
struct message_type {
    catalogue::entry entry;
    generation of{};

    /// `first_offset`: of the body in the bytes that an error is about.
    [[nodiscard]] message decode(std::span<const std::byte> body, std::size_t first_offset = 0) const {
        const auto made = entry.decode(body);
        if (made) return to_message(*made, of, body);
        const wire::diagnosis& why = made.error();
        raise(error_classes::all().decode, std::string{entry.name()} + ": " + text::to_text(why, first_offset),
              describe(why.error), {text::field_path(why), first_offset + why.offset});
    }
    [[nodiscard]] std::vector<std::byte> encode(const py::dict& fields) const {
        const auto in = input_of(fields);
        const auto made = catalogue::any_message::made_by(entry, 1024, [&](void* object, wire::arena& memory) {
            return text::from_input(in, entry.fields(), object, memory);
        });
        if (!made) refuse(made.error());
        return body_of(*made);
    }
    [[nodiscard]] std::vector<std::byte> from_text(std::string_view line) const {
        const auto made = entry.from_text(line);
        if (!made) refuse(made.error());
        return body_of(*made);
    }

  private:
    [[nodiscard]] std::vector<std::byte> body_of(const catalogue::any_message& made) const {
        auto body = made.encode();
        if (!body)
            raise(error_classes::all().encode, std::string{entry.name()} + ": " + std::string{describe(body.error())});
        return *std::move(body);
    }
    [[noreturn]] void refuse(const text::error& why) const {
        raise(error_classes::all().encode, std::string{entry.name()} + ": " + why.message, describe(why.code),
              {why.field, {}});
    }
};

inline message_type find(const py::object& name, generation of) {
    const auto& known = messages_of(of);
    if (PyIndex_Check(name.ptr()) != 0) {
        if (const auto* const found = known.find(name.cast<std::uint16_t>()); found != nullptr) return {*found, of};
        const auto code = "command code " + text::hex_number(name.cast<std::uint16_t>(), 4);
        raise(error_classes::all().unknown_message, code + " is not known");
    }
    const auto found = known.find(std::string_view{name.cast<std::string>()});
    if (!found) raise(error_classes::all().unknown_message, found.error().message, describe(found.error().code));
    return {**found, of};
}

inline jaus::address address_of(std::string_view id) {
    const auto found = jauscat::net::parse_jausip(id);
    if (!found)
        throw py::value_error{"a JAUS ID is subsystem.node.component.instance, 0 to 255 each, not " + text::quoted(id)};
    return *found;
}
inline sae::jaus_id sae_id_of(std::string_view id) {
    const auto found = sae::parse_jaus_id(id);
    if (!found) throw py::value_error{"a JAUS ID of SAE is subsystem.node.component, not " + text::quoted(id)};
    return *found;
}

/// Header and body of a message of RA 3.3, without framing.
inline message decode_ra(std::span<const std::byte> bytes) {
    const auto parts = jaus::split(bytes);
    if (!parts) raise(error_classes::all().decode, std::string{describe(parts.error)}, describe(parts.error), {{}, 0});
    const auto* const known = catalogue::ra_3_3().find(parts.header.command_code);
    if (known == nullptr)
        raise(error_classes::all().unknown_message,
              "command code " + text::hex_number(parts.header.command_code, 4) + " is not known");
    if (jaus::is_acknowledgement(parts.header))
        raise(error_classes::all().decode, std::string{known->name()} + ": an acknowledgement, which has no body");
    auto made = message_type{*known, generation::ra}.decode(parts.body, jaus::header_size);
    made.source = jauscat::net::to_jausip(parts.header.source);
    made.destination = jauscat::net::to_jausip(parts.header.destination);
    made.sequence_number = parts.header.sequence_number;
    made.wants_acknowledgement = parts.header.ack_nak == jaus::ack_nak::request;
    return made;
}
/// A message of AS5669A that is not fragmented, without the medium's version byte.
inline message decode_sae(const sae::split_transport_message& parts) {
    if (!parts) raise(error_classes::all().decode, std::string{describe(parts.error)}, describe(parts.error), {{}, 0});
    const auto id = sae::message_id_of(parts.payload);
    if (sae::is_acknowledgement(parts.header) || !id || parts.header.fragment_flag != sae::fragment_flag::single)
        raise(error_classes::all().decode, "an acknowledgement or a fragment, which has no fields");
    auto made = find(py::int_{*id}, generation::sae).decode(parts.payload, wire::max_size<sae::transport_header>);
    made.source = sae::jaus_id_text{parts.header.source}.view();
    made.destination = sae::jaus_id_text{parts.header.destination}.view();
    made.sequence_number = parts.sequence_number;
    made.wants_acknowledgement = parts.header.acknowledgement == sae::acknowledgement::request;
    return made;
}

inline message decode(const py::bytes& data, std::string_view which) {
    const auto bytes = bytes_of(data);
    if (generation_of(which) == generation::ra) return decode_ra(bytes);
    const auto parts = sae::split(bytes);
    if (parts && !parts.rest.empty())
        raise(error_classes::all().decode, "trailing bytes behind the message", "trailing bytes",
              {{}, parts.bytes.size()});
    return decode_sae(parts);
}

/// The messages of a UDP datagram of either generation; empty where it is none.
inline std::vector<message> decode_datagram(const py::bytes& data) {
    const auto bytes = bytes_of(data);
    std::vector<message> made;
    if (sae::is_judp2(bytes)) {
        for (sae::datagram_reader messages{bytes}; messages.has_next();) made.push_back(decode_sae(messages.next()));
    } else if (jaus::form_of(bytes) != jaus::datagram_form::unknown) {
        for (auto one = jaus::remove_framing(bytes); !one.message.empty(); one = jaus::next_message(one))
            made.push_back(decode_ra(one.message));
    }
    return made;
}

/// What is beside the fields of a message.
struct head {
    std::string to{}, source{};
    bool acknowledge{};
    std::uint16_t sequence_number{};
};

inline std::vector<std::byte> encode(const message_type& type, const py::dict& fields, const head& how) {
    const auto body = type.encode(fields);
    std::vector<std::byte> bytes((type.of == generation::ra ? jaus::header_size : sae::transport_overhead) +
                                 body.size());
    const auto refuse = [](auto error) { raise(error_classes::all().encode, std::string{describe(error)}); };
    if (type.of == generation::ra) {
        const jaus::header ra{.ack_nak = how.acknowledge ? jaus::ack_nak::request : jaus::ack_nak::none,
                              .command_code = type.entry.command_code(),
                              .destination = address_of(how.to),
                              .source = address_of(how.source),
                              .sequence_number = how.sequence_number};
        const auto made = jaus::join(ra, body, bytes);
        if (!made) refuse(made.error());
        return bytes;
    }
    const sae::transport_header transport{.acknowledgement = how.acknowledge ? sae::acknowledgement::request
                                                                             : sae::acknowledgement::none,
                                          .destination = sae_id_of(how.to),
                                          .source = sae_id_of(how.source)};
    const auto made = sae::join(transport, body, how.sequence_number, bytes);
    if (!made) refuse(made.error());
    bytes.resize(made->size());
    return bytes;
}

} // namespace python
