// What is known of one message, before it is printed.
#pragma once
#include <jauscat/jaus/message/message.hpp>
#include <jauscat/sae/transport/message.hpp>
#include <jauscat/text/json.hpp>

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace jausdump {

namespace jaus = jauscat::jaus;
namespace sae = jauscat::sae;
namespace text = jauscat::text;
namespace wire = jauscat::wire;
using text::json;

/// Input that cannot be read.
struct input_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Origin of a message.
struct origin {
    std::string place{};                            ///< "line" or "packet"
    std::size_t number{};                           ///< of the line or packet, from 1
    std::optional<std::chrono::nanoseconds> time{}; ///< since 1970, UTC
    std::string from{}, to{};                       ///< "10.0.0.1:3794"; empty for a line
    std::string object{};                           ///< "0x1B15:26", of an EtherCAT slave; empty for UDP and a line
};

/// The side that ended an SDO transfer before its end, and the reason.
struct refusal {
    std::string by{};   ///< "slave" or "master"
    std::string what{}; ///< "SDO abort" or "mailbox error"
    std::string code{}; ///< "0x06090030"
    std::string text{}; ///< "value out of range"
};

/// What broke a message, or kept it from being decoded.
struct fault {
    std::string error{};               ///< name of the error
    std::string field{};               ///< path to the field; empty where none is at fault
    std::optional<std::size_t> byte{}; ///< of the message, header included, from 0
    std::string what{};                ///< readable text
};

/// Parts of a message of SAE JAUS.
struct sae_parts {
    std::optional<sae::transport_header> header{}; ///< empty for a payload alone
    std::uint16_t sequence_number{};
    std::optional<std::uint16_t> message_id{}; ///< empty where the payload does not begin with one
    std::size_t payload_begin{}, payload_size{};
};

enum class kind { decoded, acknowledgement, part, unknown, broken, refused };

struct record {
    jausdump::origin origin{};
    jausdump::kind kind{};
    std::vector<std::byte> bytes{};     ///< header and body
    std::optional<jaus::header> head{}; ///< of a message of the RA
    std::optional<sae_parts> sae{};     ///< of a message of SAE JAUS
    std::string name{"unknown"};        ///< the standard's
    json presence_vector{};
    json fields{};
    std::string text{};                  ///< the fields, a line each
    std::optional<std::string> hex{};    ///< encoded again
    std::optional<std::string> packet{}; ///< translated, or the error's name
    std::optional<fault> error{};
    std::optional<jausdump::refusal> refusal{}; ///< the message was refused, or not given
    std::vector<std::string> outside_values{};  ///< fields with values that the standard does not define
    std::uint32_t ignored_bits{};               ///< presence bits without a field
    std::size_t dropped{};  ///< bytes that the decoded values do not hold: of presence bits that the layout lacks
    std::string data_set{}; ///< what became of a packet of a large data set, or "reassembled"

    /// Of SAE JAUS the payload.
    [[nodiscard]] std::span<const std::byte> body() const {
        if (sae) return std::span{bytes}.subspan(sae->payload_begin, sae->payload_size);
        return std::span{bytes}.subspan(std::min(bytes.size(), jaus::header_size));
    }
    /// Command code or message ID.
    [[nodiscard]] std::optional<std::uint16_t> code() const {
        if (head) return head->command_code;
        return sae ? sae->message_id : std::nullopt;
    }
    /// Whether it has what identifies a message.
    [[nodiscard]] bool is_message() const { return head || (sae && (sae->header || sae->message_id)); }
};

} // namespace jausdump
