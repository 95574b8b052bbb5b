// The node in SAE JAUS: frames of JSerial, three messages of the Primitive Driver in the integers of the wire, and the
// table of SAE JAUS. It
//   - obeys SetWrenchEffort: keeps the efforts, and hands the SDO download packet of the message to the card;
//   - hands every other message of SAE JAUS to the card, but QueryWrenchEffort, which it answers;
//   - acknowledges, positively or negatively, where the sender asks for it.
#include "node.hpp"
#include <jauscat/jaus/message/copy_present.hpp>
#include <jauscat/jaus/message/requested_fields.hpp>
#include <jauscat/sae/transport/jserial.hpp>
#include <jauscat/schema/sae/message_id.hpp>
#include <jauscat/schema/sae/mobility/primitive_driver.hpp>
#include <jauscat/schema/translation/sae_table.hpp>
#include <jauscat/translate/translator.hpp>
#include <jauscat/wire/raw.hpp>

namespace {

using namespace firmware;
namespace jaus = jauscat::jaus;
namespace mobility = jauscat::sae::mobility;
namespace sae = jauscat::sae;
namespace wire = jauscat::wire;
using command = wire::raw<mobility::set_wrench_effort>;
using report = wire::raw<mobility::report_wrench_effort>;
using translator = jauscat::translate::translator<jauscat::translation::sae_table>;

constexpr sae::jaus_id self{.component = own_component, .node = own_node, .subsystem = own_subsystem};
constexpr std::size_t largest_message = sae::transport_overhead + sizeof(std::uint16_t) + largest_body;

class sae_node {
  public:
    void on_bytes(std::span<const std::byte> bytes) noexcept {
        reader_.on_bytes(bytes, [this](const sae::serial_frame& frame) {
            if (frame) on_message(frame.message);
        });
    }

  private:
    void on_message(std::span<const std::byte> bytes) noexcept {
        const auto message = sae::split(bytes);
        if (!message || message.header.destination != self || sae::is_acknowledgement(message.header)) return;
        const bool done = obey(message);
        if (message.header.acknowledgement == sae::acknowledgement::request)
            answer(message, done ? sae::acknowledgement::ack : sae::acknowledgement::nak, {});
    }

    bool obey(const sae::split_transport_message& message) noexcept {
        if (message.header.fragment_flag != sae::fragment_flag::single) return false;
        const auto id = sae::message_id_of(message.payload);
        if (id == mobility::query_wrench_effort::schema::message_id) {
            mobility::query_wrench_effort query{};
            if (!wire::decode(query, message.payload)) return false;
            report efforts = efforts_;
            jaus::keep_requested(efforts, query.presence_vector);
            std::array<std::byte, 32> payload;
            const auto encoded = wire::encode(efforts, payload);
            if (encoded) answer(message, sae::acknowledgement::none, *encoded);
            return static_cast<bool>(encoded);
        }
        if (id == mobility::set_wrench_effort::schema::message_id) {
            command efforts{};
            if (!wire::decode(efforts, message.payload)) return false;
            jaus::copy_present(efforts, efforts_);
        }
        return hand_to_card(message.bytes);
    }

    static bool hand_to_card(std::span<const std::byte> message) noexcept {
        std::array<std::byte, translator::packet_size + largest_message> packet;
        const auto translated = translator::to_packet(message, packet);
        if (translated) send(line::card, *translated);
        return static_cast<bool>(translated);
    }

    static void answer(const sae::split_transport_message& request, sae::acknowledgement how,
                       std::span<const std::byte> payload) noexcept {
        std::array<std::byte, 64> message;
        std::array<std::byte, sae::max_serial_frame_size(message.size())> frame;
        const auto joined =
            sae::join(sae::acknowledgement_of(request.header, self, how), payload, request.sequence_number, message);
        if (!joined) return;
        if (const auto framed = sae::put_serial_frame(*joined, frame)) send(line::jaus, *framed);
    }

    static inline std::array<std::byte, largest_message> buffer_{};
    static inline constinit sae::jserial_reader reader_{buffer_};
    report efforts_{}; // a field that was never commanded is absent
};

constinit sae_node node;

} // namespace

void firmware::on_bytes(std::span<const std::byte> bytes, jauscat::time_point) noexcept { node.on_bytes(bytes); }
void firmware::on_time(jauscat::time_point) noexcept {} // the markers of frames tell where a message begins
