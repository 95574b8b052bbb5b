#include "sae_messages.hpp"

#include "decoder.hpp"
#include <jauscat/catalogue/json.hpp>
#include <jauscat/schema/sae/message_id.hpp>
#include <jauscat/text/annotate.hpp>

#include <set>

namespace jausdump {

namespace {

namespace catalogue = jauscat::catalogue;

/// Where the compression fields are in a message that has them.
constexpr std::size_t compression_begin = 3, compression_size = wire::max_size<sae::compression_fields>;

/// The message again, from its header and the payload that was encoded from the decoded values.
std::string encoded_again(const record& message, std::span<const std::byte> payload) {
    const auto& sae = *message.sae;
    if (!sae.header) return text::detail::plain_hex(payload);
    auto head = *sae.header;
    const bool has_fields = head.compression != sae::compression::none;
    const std::size_t size = sae::transport_overhead + payload.size() + (has_fields ? compression_size : 0);
    if (size > 0xFFFF) return std::string{text::enumerator_name(sae::transport_errc::too_large)};
    head.size = static_cast<std::uint16_t>(size);
    std::vector<std::byte> again(sae::transport_header_size), number(sae::transport_trailer_size);
    // The values were decoded from such fields.
    static_cast<void>(wire::encode(head, again));
    static_cast<void>(wire::encode(sae::sequence_number{sae.sequence_number}, number));
    if (has_fields) {
        const auto fields = std::span{message.bytes}.subspan(compression_begin, compression_size);
        again.insert(again.begin() + compression_begin, fields.begin(), fields.end());
    }
    again.insert(again.end(), payload.begin(), payload.end());
    again.insert(again.end(), number.begin(), number.end());
    return text::detail::plain_hex(again);
}

fault fault_of(sae::transport_errc error) {
    return {.error = std::string{text::enumerator_name(error)}, .what = std::string{describe(error)}};
}

} // namespace

/// 256 packets of any size, messages of at most 1 MiB. A packet is dropped after 10 seconds, because numbers repeat.
struct sae_messages::fragments {
    static constexpr std::size_t count = 256;
    static constexpr jauscat::duration timeout = std::chrono::seconds{10};
    std::vector<sae::held_fragment> places = std::vector<sae::held_fragment>(count);
    std::vector<std::byte> parts = std::vector<std::byte>(count << 16), whole = std::vector<std::byte>(1 << 20);
    sae::fragment_reassembler reassembler{places, parts, whole, timeout};

    /// Messages of which packets are held that are older than the timeout at `now`; without it, of all packets.
    [[nodiscard]] std::size_t incomplete(std::optional<jauscat::time_point> now) const {
        std::set<std::string> ends; // of one message, or of several between the same two
        std::size_t firsts = 0;
        for (const auto& one : places) {
            if (!one.is_used || (now && *now - one.received_at < timeout)) continue;
            ends.insert(std::string{sae::jaus_id_text{one.source}.view()} + " " +
                        std::string{sae::jaus_id_text{one.destination}.view()});
            firsts += one.flag == sae::fragment_flag::first ? 1 : 0;
        }
        return std::max(ends.size(), firsts);
    }
};

sae_messages::sae_messages(sae_options how, std::function<void(const record&)> tell, std::function<void()> lost)
    : how_{how},
      messages_{how.mobility_1_0 ? catalogue::list{catalogue::sae_mobility_1_0(), catalogue::sae()} : catalogue::sae()},
      tell_{std::move(tell)},
      lost_{std::move(lost)} {}
sae_messages::~sae_messages() = default;

/// Takes ID and name from the payload. That of a packet behind the first one has none.
void sae_messages::identify(record& message) const {
    auto& sae = *message.sae;
    sae.message_id = sae::message_id_of(message.body());
    message.name = name_of(sae.message_id);
}

std::string sae_messages::name_of(std::optional<std::uint16_t> message_id) const {
    const auto* const known = message_id ? messages_.find(*message_id) : nullptr;
    return known != nullptr ? sae_name(*known) : "unknown";
}

void sae_messages::on_payload(std::span<const std::byte> payload, const origin& from) {
    record message{.origin = from, .bytes = {payload.begin(), payload.end()}};
    message.sae = sae_parts{.payload_size = payload.size()};
    identify(message);
    decode(message);
    tell_(message);
}

void sae_messages::on_messages(std::span<const std::byte> part, const origin& from) {
    do {
        const auto message = sae::split(part);
        on_message(message, message.bytes.empty() ? part : message.bytes, from);
        part = message.rest;
    } while (!part.empty());
}

void sae_messages::on_message(const sae::split_transport_message& message, std::span<const std::byte> part,
                              const origin& from) {
    record made{.origin = from, .bytes = {part.begin(), part.end()}};
    made.sae = sae_parts{.sequence_number = message.sequence_number};
    auto& sae = *made.sae;
    if (part.size() >= sae::transport_header_size) sae.header = message.header;
    if (!message.bytes.empty()) {
        sae.payload_size = message.payload.size();
        sae.payload_begin = message.bytes.size() - sae::transport_trailer_size - message.payload.size();
    }
    const bool continues = message.header.fragment_flag == sae::fragment_flag::middle ||
                           message.header.fragment_flag == sae::fragment_flag::last;
    if (continues)
        made.name = "packet";
    else if (message.error != sae::transport_errc::compressed)
        identify(made);
    if (!message) {
        made.kind = kind::broken;
        made.error = fault_of(message.error);
        return tell_(made);
    }
    if (message.header.fragment_flag != sae::fragment_flag::single && !message.payload.empty()) return add_packet(made);
    decode(made);
    tell_(made);
}

void sae_messages::decode(record& message) const {
    const auto& sae = *message.sae;
    const auto payload = message.body();
    if (payload.empty() && sae.header && is_acknowledgement(*sae.header)) {
        message.kind = kind::acknowledgement;
        message.name = "acknowledgement";
        if (how_.reencode) message.hex = encoded_again(message, {});
        return;
    }
    if (!sae.message_id) {
        message.kind = kind::broken;
        message.error = fault_of(sae::transport_errc::no_message_id);
        message.error->byte = sae.payload_begin;
        return;
    }
    const auto* const known = messages_.find(*sae.message_id);
    if (known == nullptr) {
        message.kind = kind::unknown;
        message.error =
            fault{.error = "unknown_message_id",
                  .field = "message_id",
                  .byte = sae.payload_begin,
                  .what = "unknown: message ID " + text::hex_number(*sae.message_id, 4) + " is in no known service"};
        return;
    }
    const auto decoded = known->decode(payload, wire::tolerate_values);
    if (!decoded) {
        const auto& why = decoded.error();
        message.kind = kind::broken;
        message.error = fault{.error = std::string{text::enumerator_name(why.error)},
                              .field = text::field_path(why),
                              .byte = sae.payload_begin + why.offset,
                              .what = text::to_text(why, sae.payload_begin)};
        return;
    }
    message.outside_values = decoded->outside_values();
    if (how_.text) {
        message.text = decoded->to_text(text_indent);
    } else {
        message.presence_vector = catalogue::presence_vector_of(*decoded);
        message.fields = catalogue::to_json(*decoded);
    }
    if (!how_.reencode) return;
    const auto again = decoded->encode(wire::tolerate_values);
    message.hex = again ? encoded_again(message, *again) : std::string{text::enumerator_name(again.error())};
}

void sae_messages::add_packet(record& message) {
    if (!fragments_) fragments_ = std::make_unique<fragments>();
    const jauscat::time_point now{message.origin.time.value_or(jauscat::duration{})};
    for (auto count = fragments_->incomplete(now); count != 0; --count) lost_();
    const auto& header = *message.sae->header;
    const auto result = fragments_->reassembler.on_packet(header, message.body(), message.sae->sequence_number, now);
    message.kind = kind::part;
    message.data_set = text::enumerator_name(result.outcome);
    if (result.outcome == sae::fragment_outcome::no_capacity || result.outcome == sae::fragment_outcome::too_large) {
        message.kind = kind::broken;
        message.error = fault{.error = message.data_set, .what = std::string{describe(result.outcome)}};
    }
    tell_(message);
    if (result.outcome != sae::fragment_outcome::whole) return;

    // The size of a message of several packets need not fit the header: there are no such bytes on a wire.
    auto head = header;
    const std::size_t size = sae::transport_overhead + result.payload.size();
    head.fragment_flag = sae::fragment_flag::single;
    head.compression = sae::compression::none;
    head.size = static_cast<std::uint16_t>(size <= 0xFFFF ? size : 0);
    record whole{.origin = message.origin, .data_set = "reassembled"};
    whole.sae = sae_parts{.header = head,
                          .sequence_number = result.first_number,
                          .payload_begin = sae::transport_header_size,
                          .payload_size = result.payload.size()};
    whole.bytes.resize(sae::transport_header_size + result.payload.size() + sae::transport_trailer_size);
    static_cast<void>(wire::encode(head, whole.bytes));
    std::ranges::copy(result.payload, whole.bytes.begin() + sae::transport_header_size);
    static_cast<void>(wire::encode(sae::sequence_number{result.first_number},
                                   std::span{whole.bytes}.last(sae::transport_trailer_size)));
    identify(whole);
    decode(whole);
    tell_(whole);
}

void sae_messages::finish() {
    if (!fragments_) return;
    for (auto count = fragments_->incomplete({}); count != 0; --count) lost_();
}

} // namespace jausdump
