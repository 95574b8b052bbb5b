#include "web/messages.hpp"

#include "jausdump/sae_messages.hpp"
#include <jauscat/catalogue/json.hpp>
#include <jauscat/catalogue/ra_3_3.hpp>
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/sae/transport/message.hpp>
#include <jauscat/schema/sae/message_id.hpp>
#include <jauscat/text/jaus.hpp>
#include <jauscat/wire/diagnose.hpp>

namespace page {

namespace {

namespace catalogue = jauscat::catalogue;
namespace jaus = jauscat::jaus;
namespace sae = jauscat::sae;
namespace text = jauscat::text;
namespace wire = jauscat::wire;

const catalogue::list& messages_of(generation of) {
    return of == generation::sae ? catalogue::sae() : catalogue::ra_3_3();
}
std::string name_of(const catalogue::entry& message, generation of) {
    return of == generation::sae ? jausdump::sae_name(message) : text::message_name(message.command_code());
}

json error_of(std::string message, const std::string& field = {}) {
    json made{{"error", std::move(message)}};
    if (!field.empty()) made["field"] = field;
    return made;
}
json error_of(const text::error& why, const std::string& place) {
    return error_of(why.message, why.field.empty() ? place : place + "." + why.field);
}
json error_of(const wire::diagnosis& why, std::size_t first_offset) {
    return {{"error", std::string{text::enumerator_name(why.error)}},
            {"field", text::field_path(why)},
            {"byte", first_offset + why.offset},
            {"text", text::to_text(why, first_offset)}};
}

/// The header of `given` fields; the others as in `head`.
template <class Header> jauscat::result<Header, text::error> header_of(const json& given, const Header& head) {
    json fields = text::to_json(head);
    fields.update(given, true);
    std::array<std::byte, 64> none{};
    wire::arena memory{none};
    Header made{};
    const auto read = text::from_json(fields, made, memory);
    if (!read) return read.error();
    return made;
}

json made(const jauscat::result<std::span<std::byte>, jaus::errc>& message) {
    if (!message) return error_of(std::string{describe(message.error())});
    return {{"hex", text::detail::plain_hex(*message)}};
}

json ra_message(const json& given, std::uint16_t code, std::span<const std::byte> body) {
    auto head = header_of(given, jaus::header{});
    if (!head) return error_of(head.error(), "header");
    head->command_code = code;
    std::vector<std::byte> out(jaus::header_size + body.size());
    return made(jaus::join(*head, body, out));
}

json sae_message(const json& given, std::uint16_t number, std::span<const std::byte> payload) {
    const auto head = header_of(given, sae::transport_header{});
    if (!head) return error_of(head.error(), "header");
    std::vector<std::byte> out(1 + sae::transport_overhead + payload.size());
    out[0] = std::byte{2}; // the version of AS5669A in a datagram
    const auto message = sae::join(*head, payload, number, std::span{out}.subspan(1));
    if (!message) return error_of(std::string{describe(message.error())});
    return {{"hex", text::detail::plain_hex(out)}};
}

/// The value with integers that JavaScript would round as text.
json exact(json value) {
    constexpr std::int64_t most = std::int64_t{1} << 53U;
    if (value.is_structured())
        for (json& inner : value) inner = exact(std::move(inner));
    else if (value.is_number_unsigned()
                 ? value.get<std::uint64_t>() > std::uint64_t{most}
                 : value.is_number_integer() && (value.get<std::int64_t>() > most || value.get<std::int64_t>() < -most))
        return value.dump();
    return value;
}

/// The parts of a body before the one that does not decode.
std::vector<text::annotated_part> parts_before(const catalogue::entry& type, std::span<const std::byte> body,
                                               const wire::diagnosis& why) {
    constexpr std::size_t most = 0xFFFF;
    if (why.error == wire::errc::trailing_bytes) return type.annotated(body.first(why.offset)).parts;
    std::vector<std::byte> filled{body.begin(), body.end()}; // with zeros, so that it decodes
    for (auto lack = why; lack.error == wire::errc::truncated && filled.size() < most; lack = type.diagnose(filled))
        filled.resize(filled.size() + std::max<std::size_t>(lack.needed - lack.available, 1));
    auto parts = type.annotated(filled).parts;
    std::erase_if(parts, [&](const auto& part) { return part.offset + part.size > why.offset; });
    return parts;
}

} // namespace

json all_messages() {
    json all = json::array();
    for (const auto of : {generation::ra, generation::sae})
        for (const auto& one : messages_of(of))
            all.push_back({{"generation", of == generation::sae ? "sae" : "ra"},
                           {"code", one.command_code()},
                           {"name", name_of(one, of)},
                           {"type", std::string{one.name()}},
                           {"report", one.report()},
                           {"least", one.min_size()},
                           {"most", one.max_size() == wire::unbounded || one.takes_rest() ? json(nullptr)
                                                                                          : json(one.max_size())}});
    return all;
}

json forms(generation of, std::uint16_t code) {
    const auto* const message = messages_of(of).find(code);
    if (message == nullptr) return error_of("no message has this code");
    json forms{{"fields", form_of(message->fields())}};
    if (of == generation::sae) {
        forms["header"] = form_of(text::describe<sae::transport_header>());
        forms["defaults"] = text::to_json(sae::transport_header{});
    } else {
        forms["header"] = form_of(text::describe<jaus::header>());
        forms["defaults"] = text::to_json(jaus::header{});
    }
    return forms;
}

json made_of(const json& request) {
    const auto of = generation_of(request.at("generation").get<std::string>());
    const auto code = request.at("code").get<std::uint16_t>();
    const auto* const type = messages_of(of).find(code);
    if (type == nullptr) return error_of("no message has this code");
    const auto message = catalogue::from_json(*type, request.at("fields"));
    if (!message) return error_of(message.error(), "fields");
    const auto body = message->encode();
    if (!body) return error_of(std::string{wire::describe(body.error())});
    if (of == generation::sae)
        return sae_message(request.at("header"), request.value("sequence_number", std::uint16_t{}), *body);
    return ra_message(request.at("header"), code, *body);
}

json taken_apart(std::span<const std::byte> message, generation of, bool is_payload) {
    json told{{"parts", json::array()}, {"generation", of == generation::sae ? "sae" : "ra"}};
    const auto add = [&](const std::vector<text::annotated_part>& read, std::size_t offset, const char* place) {
        append_parts(told["parts"], read, offset, place);
    };
    std::span<const std::byte> body;
    std::size_t begin = 0;
    std::uint16_t code{};
    if (of == generation::ra) {
        add(parts_of<jaus::header>(message), 0, "header");
        jaus::header head{};
        if (!wire::decode_prefix(head, message))
            return told["error"] = error_of(wire::diagnose<jaus::header>(message), 0), told;
        told["header"] = text::to_json(head);
        code = head.command_code;
        begin = jaus::header_size;
        body = message.subspan(begin);
        if (body.empty() && jaus::is_acknowledgement(head)) {
            told["code"] = code;
            told["name"] = text::message_name(code) + " (acknowledgement)";
            return told;
        }
    } else if (is_payload) {
        body = message;
    } else {
        const auto split = sae::split(message);
        const std::size_t more = split.header.compression == sae::compression::none ? 0 : 2;
        if (message.size() < sae::transport_header_size + more) {
            told["error"] = error_of(wire::diagnose<sae::transport_header>(message), 0);
            return told;
        }
        std::vector<std::byte> plain{message.begin(), message.end()};
        plain.erase(plain.begin() + 3, plain.begin() + 3 + static_cast<std::ptrdiff_t>(more));
        json header = json::array();
        append_parts(header, parts_of<sae::transport_header>(plain), 0, "header");
        for (json& part : header) {
            const auto offset = part.at("offset").get<std::size_t>();
            if (offset == 3 && more != 0) // between size and properties
                add(parts_of<sae::compression_fields>(message.subspan(3)), 3, "header");
            if (offset >= 3) part["offset"] = offset + more;
            told["parts"].push_back(std::move(part));
        }
        told["header"] = text::to_json(split.header);
        if (!split) {
            told["error"] = error_of(std::string{describe(split.error)});
            told["error"]["text"] = std::string{describe(split.error)};
            if (split.bytes.empty()) return told;
        }
        told["sequence_number"] = split.sequence_number;
        begin = sae::transport_header_size + more;
        body = split.payload;
    }
    const auto end = [&] {
        if (of == generation::ra || is_payload) return;
        const std::size_t at = begin + body.size();
        auto read = parts_of<sae::sequence_number>(message.subspan(at));
        for (auto& part : read)
            for (auto& field : part.fields) field.path = "sequence_number";
        add(read, at, "sequence");
    };
    if (of == generation::sae) {
        const auto id = sae::message_id_of(body);
        if (!id) return end(), told;
        code = *id;
    }
    told["code"] = code;
    const auto* const type = messages_of(of).find(code);
    if (type == nullptr) return end(), told;
    told["name"] = name_of(*type, of);
    told["type"] = std::string{type->name()};
    const auto decoded = type->decode(body);
    const auto parts = type->annotated(body).parts;
    add(parts.empty() && !decoded ? parts_before(*type, body, decoded.error()) : parts, begin, "body");
    if (!decoded && !told.contains("error")) told["error"] = error_of(decoded.error(), begin);
    if (decoded) {
        told["presence_vector"] = catalogue::presence_vector_of(*decoded);
        told["fields"] = exact(catalogue::to_json(*decoded));
        if (const auto again = decoded->encode()) told["body"] = text::detail::plain_hex(*again);
    }
    end();
    return told;
}

} // namespace page
