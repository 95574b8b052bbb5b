// The functions of the module. Each takes JSON in the memory that `jauscat_memory` lends, and returns JSON: text that
// ends with a zero, valid until the next call.
#include "support/hex_line.hpp"
#include "web/capture.hpp"
#include "web/messages.hpp"
#include <jauscat/schema/ethercat/frame.hpp>
#include <jauscat/schema/ethercat/hilscher.hpp>

#include <emscripten.h>
#include <optional>
#include <sstream>

namespace {

namespace jaus = jauscat::jaus;
namespace wire = jauscat::wire;
using page::json;

std::vector<std::byte> memory;
std::string answer;
std::optional<page::capture> capture;

const char* answered(const json& told) {
    answer = told.dump(-1, ' ', false, json::error_handler_t::replace);
    return answer.c_str();
}
/// Answers a request that is `size` bytes of JSON; what is thrown is an error of the page.
template <class Function> const char* answer_to(std::size_t size, Function function) {
    try {
        const auto* const text = reinterpret_cast<const char*>(memory.data());
        return answered(function(json::parse(text, text + size)));
    } catch (const std::exception& error) {
        return answered({{"error", error.what()}});
    }
}

/// How frames of a request are read.
jausdump::object_table table_of(const json& request) {
    const json& frames = request.at("frames");
    const auto name = frames.at("table").get<std::string>();
    return {.table = name == "seed"  ? jausdump::translation::seed
                     : name == "sae" ? jausdump::translation::sae
                                     : jausdump::translation::self_contained,
            .index_base = frames.at("base").get<std::uint16_t>()};
}

bool is_packet(std::span<const std::byte> bytes) {
    jauscat::hilscher::sdo_download_request packet{};
    const auto size = wire::decode_prefix(packet, bytes);
    return size && packet.head.ul_cmd == jauscat::hilscher::packet_command::sdo_download_req;
}
bool is_frame(std::span<const std::byte> bytes) {
    jauscat::ethercat::ethernet_header head{};
    return wire::decode_prefix(head, bytes) && head.ether_type == jauscat::ethercat::ether_type_ethercat;
}

/// The bytes of a text with line breaks inside one message: a dump with offsets in front, or wrapped lines.
std::optional<std::string> joined(const std::string& text) {
    std::istringstream lines{text};
    std::string all;
    bool is_dump = true;
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        const auto first = line.find_first_not_of(" \t");
        const auto end = line.find_first_not_of("0123456789abcdefABCDEF", first);
        const bool has_offset = end != std::string::npos && end - first >= 4 && end - first <= 8 &&
                                (line.compare(end, 2, "  ") == 0 || line[end] == ':');
        const auto digits = has_offset ? line.find_first_not_of(" :\t", end) : std::string::npos;
        is_dump = is_dump && digits != std::string::npos;
        if (!is_dump) break;
        ++count;
        // What stands behind the bytes, after spaces or a bar, is their characters.
        const auto behind = std::min(line.find(line[end] == ':' ? "  " : "   ", digits), line.find('|', digits));
        all += line.substr(digits, behind == std::string::npos ? behind : behind - digits) + " ";
    }
    if (is_dump && count != 0) return all;
    std::string flat = text;
    std::replace(flat.begin(), flat.end(), '\n', ' ');
    const auto read = example::read_hex_line(flat);
    jaus::header head{};
    const auto message = jaus::remove_framing(read.bytes).message;
    const bool is_one = read.error.empty() && wire::decode_prefix(head, message) && head.version == 2 &&
                        head.data_size == message.size() - jaus::header_size;
    if (is_one || is_packet(read.bytes) || jaus::form_of(read.bytes) == jaus::datagram_form::judp2) return flat;
    return std::nullopt;
}

json read_lines(const json& request) {
    auto text = request.at("text").get<std::string>();
    if (const auto one = joined(text)) text = *one;
    page::capture lines{table_of(request)};
    std::istringstream in{text};
    std::size_t number = 0;
    json packet;
    for (std::string line; std::getline(in, line);) {
        ++number;
        const auto bytes = example::read_hex_line(line);
        if (bytes.error.empty() && is_packet(bytes.bytes)) {
            packet = page::message_of_packet(bytes.bytes, request.at("table"), request.at("base"));
            if (packet.contains("hex"))
                lines.on_line((packet.at("generation").get<std::string>() == "sae" ? "02" : "") +
                                  packet.at("hex").get<std::string>(),
                              number);
        } else if (bytes.error.empty() && is_frame(bytes.bytes)) {
            lines.on_frame(bytes.bytes);
        } else {
            lines.on_line(line, number);
        }
    }
    json told = lines.finish();
    if (!packet.is_null()) told["packet"] = packet;
    return told;
}

std::vector<std::byte> bytes_of(const json& request) {
    return example::read_hex_line(request.at("hex").get<std::string>()).bytes;
}

json show_message(const json& request) {
    const auto bytes = bytes_of(request);
    const auto of = page::generation_of(request.at("generation"));
    json told = page::taken_apart(bytes, of, request.value("is_payload", false));
    if (request.contains("table"))
        told["stages"] = page::stages(bytes, told.at("parts"), request.at("table"), request.at("base"));
    return told;
}

} // namespace

extern "C" {

/// Memory for the next request or packet.
EMSCRIPTEN_KEEPALIVE void* jauscat_memory(std::size_t size) {
    memory.resize(size);
    return memory.data();
}
/// {"messages", "tables"}.
EMSCRIPTEN_KEEPALIVE const char* jauscat_catalogue() {
    return answered({{"messages", page::all_messages()}, {"tables", page::tables()}});
}
/// {"generation", "code"}: the forms of a message.
EMSCRIPTEN_KEEPALIVE const char* jauscat_forms(std::size_t size) {
    return answer_to(size, [](const json& request) {
        return page::forms(page::generation_of(request.at("generation")), request.at("code").get<std::uint16_t>());
    });
}
/// {"text", "table", "base", "frames": {"table", "base"}}: the messages of pasted text.
EMSCRIPTEN_KEEPALIVE const char* jauscat_read(std::size_t size) { return answer_to(size, read_lines); }
/// {"hex", "generation", "is_payload", "table", "base"}: parts, fields, stages.
EMSCRIPTEN_KEEPALIVE const char* jauscat_show(std::size_t size) { return answer_to(size, show_message); }
/// {"generation", "code", "header", "fields"}: the bytes of a message.
EMSCRIPTEN_KEEPALIVE const char* jauscat_make(std::size_t size) { return answer_to(size, page::made_of); }

/// A capture begins, is read packet by packet, and ends: {"frames": {"table", "base"}}, then {"messages", "skipped"}.
EMSCRIPTEN_KEEPALIVE const char* jauscat_capture_begin(std::size_t size) {
    return answer_to(size, [](const json& request) {
        capture.emplace(table_of(request));
        return json::object();
    });
}
EMSCRIPTEN_KEEPALIVE int jauscat_capture_packet(int link_type, double seconds, double nanoseconds, std::size_t size) {
    if (!capture || !jausdump::has_link_type(link_type)) return 0;
    const auto time = std::chrono::seconds{static_cast<std::int64_t>(seconds)} +
                      std::chrono::nanoseconds{static_cast<std::int64_t>(nanoseconds)};
    capture->on_packet(link_type, time, std::span<const std::byte>{memory}.first(size));
    return 1;
}
EMSCRIPTEN_KEEPALIVE const char* jauscat_capture_end() {
    json told = capture ? capture->finish() : json::object();
    capture.reset();
    return answered(told);
}

} // extern "C"
