// The node, made with JausCat: schemas decode and encode, a table translates, a dispatcher calls.
#pragma once
#include "node.hpp"
#include <jauscat/jaus/component/dispatcher.hpp>
#include <jauscat/jaus/message/copy_present.hpp>
#include <jauscat/jaus/message/requested_fields.hpp>
#include <jauscat/jaus/message/stream_framer.hpp>
#include <jauscat/schema/jaus/core.hpp>
#include <jauscat/schema/jaus/platform.hpp>
#include <jauscat/schema/translation/seed_table.hpp>
#include <jauscat/translate/translator.hpp>

namespace firmware {

namespace jaus = jauscat::jaus;

/// `Command` and `Report` are Set and Report Wrench Effort: as they are, in real percent, or raw, in the integers of
/// the wire, for a core without floating point.
template <class Command, class Report> class jauscat_node {
  public:
    void on_bytes(std::span<const std::byte> bytes, jauscat::time_point now) noexcept {
        framer_.on_bytes(bytes, now, taker());
    }
    void on_time(jauscat::time_point now) noexcept { framer_.on_time(now, taker()); }

  private:
    using header = jaus::header;
    using translator = jauscat::translate::translator<jauscat::translation::seed_table>;
    static constexpr jaus::address self{
        .instance = own_instance, .component = own_component, .node = own_node, .subsystem = own_subsystem};

    // One type of callable for both calls, so that the framer's search is in the image once.
    auto taker() noexcept {
        return [this](std::span<const std::byte> message) { on_message(message); };
    }

    void on_message(std::span<const std::byte> bytes) noexcept {
        header head{};
        static_cast<void>(jauscat::wire::decode_prefix(head, bytes)); // the framer has checked it
        if (head.destination != self) return;
        const bool done = obey(bytes, head);
        if (!done) ++refused_;
        if (head.ack_nak == jaus::ack_nak::request) {
            std::array<std::byte, jaus::header_size> message;
            send_answer(head, done ? jaus::ack_nak::ack : jaus::ack_nak::nak, head.command_code, message, 0);
        }
    }

    bool obey(std::span<const std::byte> bytes, const header& head) noexcept {
        if (head.data_flag != jaus::data_flag::only) return false; // a part of a message cannot be decoded
        jaus::dispatcher handlers{
            jaus::on<Command>([this](const header&, const Command& command) { jaus::copy_present(command, efforts_); }),
            jaus::on<jaus::query_wrench_effort>([this](const header& query, const auto& asked) {
                Report report = efforts_;
                jaus::keep_requested(report, asked.presence_vector);
                answer(query, report);
            }),
            jaus::on<jaus::query_component_status>([this](const header& query, const auto&) {
                answer(query, jaus::report_component_status{.primary_status_code = jaus::primary_status_code::ready,
                                                            .secondary_status_code = refused_});
            })};
        switch (handlers(head, bytes.subspan(jaus::header_size))) {
        case jaus::dispatched::handled:
            return head.command_code != jaus::command_code_of<Command> || hand_to_card(bytes);
        case jaus::dispatched::unknown: return hand_to_card(bytes);
        case jaus::dispatched::acknowledgement: return true;
        case jaus::dispatched::malformed: return false;
        }
        return false;
    }

    bool hand_to_card(std::span<const std::byte> message) noexcept {
        std::array<std::byte, translator::packet_size + translator::rest_size + largest_body> packet;
        const auto translated = translator::to_packet(message, packet);
        if (translated) send(line::card, *translated);
        return static_cast<bool>(translated);
    }

    void answer(const header& query, const auto& report) noexcept {
        std::array<std::byte, jaus::header_size + 32> message;
        const auto encoded = jauscat::wire::encode(report, std::span{message}.subspan(jaus::header_size));
        using report_type = std::remove_cvref_t<decltype(report)>;
        if (encoded)
            send_answer(query, jaus::ack_nak::none, jaus::command_code_of<report_type>, message, encoded->size());
    }

    // Puts the header of an answer in front of its body, and sends both.
    void send_answer(const header& request, jaus::ack_nak how, std::uint16_t command_code, std::span<std::byte> message,
                     std::size_t body_size) noexcept {
        header head = jaus::answer_to(request);
        head.ack_nak = how;
        head.command_code = command_code;
        head.data_size = static_cast<std::uint16_t>(body_size);
        if (jauscat::wire::encode(head, message)) send(line::jaus, message.first(jaus::header_size + body_size));
    }

    // Not in the object, which is all zeros at start and so needs no image in the code memory.
    static inline std::array<std::byte, jaus::header_size + largest_body> buffer_{};
    static inline constinit jaus::stream_framer framer_{buffer_, idle};

    Report efforts_{}; // a field that was never commanded is absent
    std::uint32_t refused_{};
};

} // namespace firmware
