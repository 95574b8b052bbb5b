// Joins header and body to a message, and splits a message.
#pragma once
#include <jauscat/schema/jaus/catalog.hpp>
#include <jauscat/schema/jaus/command_code.hpp>
#include <jauscat/schema/jaus/header.hpp>
#include <jauscat/wire/decode.hpp>
#include <jauscat/wire/encode.hpp>

#include <algorithm>
#include <array>
#include <concepts>

namespace jauscat::jaus {

/// Bytes of every message header.
inline constexpr std::size_t header_size = wire::max_size<header>;

/// Whether an address names one component: no octet is 0 (invalid) or 255 (all).
[[nodiscard]] constexpr bool names_one_component(const address& a) noexcept {
    const auto one = [](std::uint8_t octet) { return octet != 0 && octet != 255; };
    return one(a.subsystem) && one(a.node) && one(a.component) && one(a.instance);
}

/// Whether an address is that of a node manager: component 1, instance 1 of its node.
[[nodiscard]] constexpr bool is_node_manager(const address& a) noexcept { return a.component == 1 && a.instance == 1; }

/// Errors of joining and splitting messages.
enum class errc : std::uint8_t {
    ok,
    truncated,      ///< shorter than a header
    wrong_size,     ///< the header states another body size than there is
    wrong_version,  ///< the version field is not that of RA 3.2 and 3.3
    invalid_source, ///< an octet of the source is 0 or 255: it cannot be answered
    no_space,       ///< the output span is too small
    invalid_header, ///< a value of the header is wider than its bits
    invalid_body,   ///< a value of the body does not encode; wire::diagnose names it
    body_too_large, ///< more than 4080 bytes: needs a large data set, also in a header that states 4081 to 4095
};

/// The error in one line, for logs.
[[nodiscard]] constexpr std::string_view describe(errc error) noexcept {
    switch (error) {
    case errc::ok: return "ok";
    case errc::truncated: return "truncated: shorter than the 16-byte JAUS header";
    case errc::wrong_size: return "wrong size: the header's data size is not the number of bytes behind it";
    case errc::wrong_version: return "wrong version: the header is not of RA 3.2 or 3.3 (version 2)";
    case errc::invalid_source: return "invalid source: an octet of the source ID is 0 or 255";
    case errc::no_space: return "no space: the output buffer is too small";
    case errc::invalid_header: return "invalid header: a value is wider than its field";
    case errc::invalid_body: return "invalid body: a value is outside the limits of its field";
    case errc::body_too_large: return "body too large: more than 4080 bytes need a large data set";
    }
    return "unknown error";
}

/// Parts of a message; `body` points into the received bytes.
struct split_message {
    errc error{};                      ///< why it is no message; then the rest is empty
    jaus::header header{};             ///< as received
    std::span<const std::byte> body{}; ///< as received

    [[nodiscard]] constexpr explicit operator bool() const noexcept { return error == errc::ok; }
};

/// Takes a received message apart and checks its header: errors truncated, wrong_version, wrong_size, body_too_large,
/// invalid_source.
[[nodiscard]] constexpr split_message split(std::span<const std::byte> bytes) noexcept {
    split_message m{};
    if (!wire::decode_prefix(m.header, bytes)) {
        m.error = errc::truncated;
        return m;
    }
    m.body = bytes.subspan(header_size);
    if (m.header.version != 2)
        m.error = errc::wrong_version;
    else if (m.header.data_size != m.body.size())
        m.error = errc::wrong_size;
    else if (m.body.size() > max_body_size)
        m.error = errc::body_too_large;
    else if (!names_one_component(m.header.source))
        m.error = errc::invalid_source;
    return m;
}

namespace detail {

constexpr wire::packed_size<errc> put_parts(header head, std::span<const std::byte> body,
                                            std::span<std::byte> out) noexcept {
    if (body.size() > max_body_size) return errc::body_too_large;
    if (out.size() < header_size + body.size()) return errc::no_space;
    head.data_size = static_cast<std::uint16_t>(body.size());
    const auto place = out.subspan(header_size, body.size());
    if (place.data() != body.data()) std::ranges::copy(body, place.begin());
    if (!wire::encode(head, out)) return errc::invalid_header;
    return header_size + body.size();
}
template <coded_message T>
constexpr wire::packed_size<errc> put_message(header head, const T& body, std::span<std::byte> out) noexcept {
    if (out.size() < header_size) return errc::no_space;
    const auto encoded = wire::encode(body, out.subspan(header_size));
    if (!encoded) return encoded.error() == wire::errc::no_space ? errc::no_space : errc::invalid_body;
    head.command_code = command_code_of<T>;
    return put_parts(head, *encoded, out);
}

} // namespace detail

/// The inverse of `split`: writes `head`, with the data size taken from `body`, and `body` to the front of `out`;
/// returns the message. `body` may lie where it goes to. Errors: no_space, body_too_large, invalid_header.
[[nodiscard, gnu::always_inline]] constexpr result<std::span<std::byte>, errc>
join(const header& head, std::span<const std::byte> body, std::span<std::byte> out) noexcept {
    return detail::put_parts(head, body, out).of(out);
}

/// Writes `head`, with command code and data size taken from `body`, and `body` to the front of `out`; returns the
/// message. Errors: no_space, body_too_large, invalid_body, invalid_header.
template <coded_message T>
[[nodiscard, gnu::always_inline]] constexpr result<std::span<std::byte>, errc>
make_message(const header& head, const T& body, std::span<std::byte> out) noexcept {
    return detail::put_message(head, body, out).of(out);
}

template <uncoded_type T>
constexpr result<std::span<std::byte>, errc> make_message(const header&, const T&, auto&&...) noexcept {
    refuse_uncoded_type<T>();
    return errc::invalid_body;
}

/// An acknowledgement has no body, for any command code. RA 3.3 part 2, ACK/NAK.
[[nodiscard]] constexpr bool is_acknowledgement(const header& head) noexcept {
    return head.ack_nak == ack_nak::ack || head.ack_nak == ack_nak::nak;
}

/// The header of an answer: source and destination exchanged, priority, version and sequence number kept.
[[nodiscard]] constexpr header answer_to(const header& request) noexcept {
    return {.priority = request.priority,
            .version = request.version,
            .destination = request.source,
            .source = request.destination,
            .sequence_number = request.sequence_number};
}
/// The same from `self`: a request may have been sent to all of a level, an answer comes from one component.
[[nodiscard]] constexpr header answer_to(const header& request, const address& self) noexcept {
    header head = answer_to(request);
    head.source = self;
    return head;
}

/// Writes the 16 bytes of an ACK or NAK (`how`) of the message with the header `request` to the front of `out`, and
/// returns them. Errors: no_space, invalid_header.
[[nodiscard]] constexpr result<std::span<std::byte>, errc> make_acknowledgement(const header& request, ack_nak how,
                                                                                std::span<std::byte> out) noexcept {
    if (out.size() < header_size) return errc::no_space;
    header head = answer_to(request);
    head.command_code = request.command_code;
    head.ack_nak = how;
    const auto encoded = wire::encode(head, out);
    if (!encoded) return errc::invalid_header;
    return *encoded;
}

/// Whether RA 3.3 leaves the code to private messages, D000h to FFFFh: their header says that they are experimental.
[[nodiscard]] constexpr bool is_private(std::uint16_t command_code) noexcept { return command_code >= 0xD000; }
namespace detail {
// Without the names, and without 0404h, which is last.
inline constexpr auto standard_codes = [] {
    std::array<std::uint16_t, catalog.size() - 1> codes{};
    std::ranges::transform(catalog.begin(), catalog.end() - 1, codes.begin(), &catalog_entry::command_code);
    return codes;
}();
} // namespace detail
/// Whether RA 3.3 has a message of this code. It has not Set Velocity State (0404h) of known peers.
[[nodiscard]] constexpr bool is_standard(std::uint16_t command_code) noexcept {
    return std::ranges::binary_search(detail::standard_codes, command_code);
}

/// The command code of the report that answers a query, 2000h above the query's; 0 for what is no query. RA 3.3 part 3.
[[nodiscard]] constexpr std::uint16_t report_code_of(std::uint16_t command_code) noexcept {
    const bool is_query = command_code >= 0x2000 && command_code < 0x4000;
    return is_query ? static_cast<std::uint16_t>(command_code + 0x2000) : std::uint16_t{};
}

} // namespace jauscat::jaus
