#include "web/capture.hpp"

#include "support/hex_line.hpp"
#include <jauscat/catalogue/sae.hpp>
#include <jauscat/jaus/message/framing.hpp>
#include <jauscat/schema/sae/message_id.hpp>

#include <array>

namespace page {

namespace {

namespace jaus = jauscat::jaus;
namespace sae = jauscat::sae;
namespace text = jauscat::text;

jausdump::options options_for(std::function<void(const jausdump::record&)> receiver, bool payload = false) {
    jausdump::options made{};
    made.format = jausdump::format::json_lines;
    made.sae = payload;
    made.receiver = std::move(receiver);
    return made;
}

/// Whether a line that is no datagram is a payload of SAE JAUS.
bool is_payload(std::span<const std::byte> bytes) {
    if (jaus::form_of(bytes) != jaus::datagram_form::unknown) return false;
    const auto id = sae::message_id_of(bytes);
    return id && jauscat::catalogue::sae().find(*id) != nullptr;
}

} // namespace

capture::capture(const jausdump::object_table& table)
    : dump_{options_for([this](const auto& message) { add(message); })},
      ring_{table,
            {.message =
                 [this, is_sae = table.table == jausdump::translation::sae](auto message, const auto& from) {
                     is_sae ? dump_.on_sae_messages(message, from) : dump_.on_object(message, from);
                 },
             .unreadable = [this](auto data, auto error,
                                  const auto& from) { dump_.on_unreadable_object(data, error, from); },
             .refused = [this](jausdump::record message) { dump_.on_refused(std::move(message)); },
             .lost = [this] { ++skipped_["incomplete SDO transfer of a message"]; },
             .skipped = [this](const std::string& reason) { ++skipped_[reason]; }}},
      streams_{{.message = [this](const auto& message, auto part,
                                  const auto& from) { dump_.on_sae_message(message, part, from); },
                .skipped = [this](const std::string& reason) { ++skipped_[reason]; }}},
      packets_{{.datagram =
                    [this](auto payload, const auto& from) {
                        const std::size_t before = messages_.size();
                        dump_.on_datagram(payload, from);
                        if (messages_.size() == before) ++skipped_["datagram that is no JAUS message"];
                    },
                .tcp = [this](const auto& segment, const auto& from) { streams_.on_segment(segment, from); },
                .ethercat = [this](auto frame, const auto& from) { ring_.read(frame, from); },
                .skipped = [this](const std::string& reason) { ++skipped_[reason]; }}} {}

void capture::on_line(const std::string& line, std::size_t number) {
    const auto read = example::read_hex_line(line);
    const std::size_t before = messages_.size();
    if (read.error.empty() && is_payload(read.bytes)) {
        if (!payloads_) payloads_.emplace(options_for([this](const auto& message) { add(message); }, true));
        payloads_->on_line(line, number);
    } else {
        dump_.on_line(line, number);
    }
    if (messages_.size() != before || line.find_first_not_of(" \t\r") == std::string::npos) return;
    const auto form = jaus::foreign_form(read.bytes);
    ++skipped_["line " + std::to_string(number) + " is " + std::string{form.empty() ? "no message" : form}];
}

void capture::add(const jausdump::record& message) {
    json made = json::parse(jausdump::to_json_line(message));
    constexpr std::array kinds{"decoded", "acknowledgement", "part", "unknown", "broken", "refused"};
    made["kind"] = kinds[static_cast<std::size_t>(message.kind)];
    made["bytes"] = text::detail::plain_hex(message.bytes);
    made["is_payload"] = message.sae && !message.sae->header;
    messages_.push_back(std::move(made));
}

json capture::finish() {
    packets_.finish();
    streams_.finish();
    ring_.finish();
    return {{"messages", std::move(messages_)}, {"skipped", skipped_}};
}

} // namespace page
